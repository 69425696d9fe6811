#ifndef QUADRILLE_EXAMPLES_MESH_IO_NUMBER_TEXT_H
#define QUADRILLE_EXAMPLES_MESH_IO_NUMBER_TEXT_H

#include "mesh/colors.h"

#include <array>
#include <charconv>
#include <string>

namespace quadrille_examples {

/// Appends the shortest text that reads back as exactly `value`, in every locale.
template <class Number>
void append_number(std::string& text, Number value) {
  std::array<char, 32> buffer;
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  text.append(buffer.data(), result.ptr);
}

/// Appends the numbers, each with a blank before it.
template <class... Numbers>
void append_numbers(std::string& text, Numbers... values) {
  ((text += ' ', append_number(text, values)), ...);
}

/// Appends a number of a colour as a fraction of full intensity.
inline void append_fraction(std::string& text, double channel, const ColorType& type) {
  if (type.is_single || (type.is_whole && type.full == 255)) // as short as bytes need
    append_number(text, static_cast<float>(channel) / static_cast<float>(type.full));
  else
    append_number(text, channel / type.full);
}

} // namespace quadrille_examples

#endif
