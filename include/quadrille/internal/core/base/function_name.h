#ifndef QUADRILLE_INTERNAL_CORE_BASE_FUNCTION_NAME_H
#define QUADRILLE_INTERNAL_CORE_BASE_FUNCTION_NAME_H

#include <stdexcept>
#include <string>
#include <string_view>

/// Errors name the function that the user has called.

namespace quadrille::internal {

/// Throws what is being handled, with another name where `simplify` is named.
template <class Error>
[[noreturn]] void throw_in_name_of(const std::string& function, const Error& error) {
  constexpr std::string_view simplify = "quadrille::simplify:";
  const std::string_view text = error.what();
  if (text.substr(0, simplify.size()) != simplify)
    throw;
  throw Error("quadrille::" + function + ":" + std::string(text.substr(simplify.size())));
}

/// Runs code that `simplify` uses as well: its exceptions name `function` instead.
template <class Run>
auto in_name_of(const char* function, Run run) {
  try {
    return run();
  } catch (const std::invalid_argument& error) {
    throw_in_name_of(function, error);
  } catch (const std::length_error& error) {
    throw_in_name_of(function, error);
  }
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_BASE_FUNCTION_NAME_H
