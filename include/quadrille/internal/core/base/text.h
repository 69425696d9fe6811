#ifndef QUADRILLE_INTERNAL_CORE_BASE_TEXT_H
#define QUADRILLE_INTERNAL_CORE_BASE_TEXT_H

#include <array>
#include <charconv>
#include <string>

namespace quadrille::internal {

/// Returns the shortest text that distinguishes a number from all others.
inline std::string text_of(double x) {
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), x).ptr};
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_BASE_TEXT_H
