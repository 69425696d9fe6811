#ifndef QUADRILLE_EXAMPLES_WEB_MISSING_IN_LIBCXX_13_H
#define QUADRILLE_EXAMPLES_WEB_MISSING_IN_LIBCXX_13_H

/// \file
/// What the C++20 library of emscripten 3.1.6, which is libc++ 13, does not have and Quadrille
/// calls: std::bit_cast, and std::to_chars and std::from_chars of a double. It is included before
/// all else
/// (`-include`), and is empty where the library has them.

#include <version>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <system_error>
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

/// A number in decimal digits, without a sign but minus.
inline from_chars_result from_chars(const char* first, const char* last, double& x) {
  const string_view all(first, static_cast<size_t>(last - first));
  const size_t sign = all.starts_with('-') ? 1 : 0;
  const string text(all.substr(0, all.find_first_not_of("0123456789+-.eEinfatyINFATY")));
  if (text.size() == sign || text.find_first_of("+-") == sign)
    return {first, errc::invalid_argument};
  char* end = nullptr;
  const double number = strtod(text.c_str(), &end);
  if (end == text.c_str())
    return {first, errc::invalid_argument};
  const char* const stop = first + (end - text.c_str());
  const bool is_finite_text = text[sign] != 'i' && text[sign] != 'I';
  if ((is_finite_text && (number == HUGE_VAL || number == -HUGE_VAL)) ||
      (number == 0 && text.find_first_of("123456789") < static_cast<size_t>(end - text.c_str())))
    return {stop, errc::result_out_of_range};
  x = number;
  return {stop, errc()};
}
#endif

} // namespace std

#endif
