#ifndef QUADRILLE_EXAMPLES_MESH_IO_NUMBER_TEXT_H
#define QUADRILLE_EXAMPLES_MESH_IO_NUMBER_TEXT_H

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

} // namespace quadrille_examples

#endif
