#ifndef QUADRILLE_EXAMPLES_WEB_MISSING_IN_LIBCXX_13_H
#define QUADRILLE_EXAMPLES_WEB_MISSING_IN_LIBCXX_13_H

/// \file
/// What the C++20 library of emscripten 3.1.6, which is libc++ 13, does not have and Quadrille
/// calls: std::bit_cast, and std::to_chars of a double. It is included before all else
/// (`-include`), and is empty where the library has them.

#include <version>

#include <array>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <type_traits>

// Names that the standard gives to its library may be added to it here, since that library lacks
// them.
namespace std {

#ifndef __cpp_lib_bit_cast
template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  static_assert(sizeof(To) == sizeof(From) && is_trivially_copyable_v<To> &&
                is_trivially_copyable_v<From>);
  return __builtin_bit_cast(To, from);
}
#endif

#if !defined(__cpp_lib_to_chars)
/// The shortest text from which the same number is read; of two that are as short, the one without
/// an exponent.
inline to_chars_result to_chars(char* first, char* last, double x) {
  array<char, 400> scientific, fixed;
  int digits = 0; // behind the first one
  do
    snprintf(scientific.data(), scientific.size(), "%.*e", digits, x);
  while (digits++ < 17 && strtod(scientific.data(), nullptr) != x && x == x);
  --digits;
  const char* text = scientific.data();
  if (const char* e = strchr(text, 'e')) {
    const int behind = digits - atoi(e + 1);
    snprintf(fixed.data(), fixed.size(), "%.*f", behind > 0 ? behind : 0, x);
    if (strlen(fixed.data()) <= strlen(text))
      text = fixed.data();
  }
  const size_t length = strlen(text);
  if (static_cast<size_t>(last - first) < length)
    return {last, errc::value_too_large};
  memcpy(first, text, length);
  return {first + length, errc()};
}
#endif

} // namespace std

#endif
