#ifndef QUADRILLE_EXAMPLES_MESH_IO_LITTLE_ENDIAN_H
#define QUADRILLE_EXAMPLES_MESH_IO_LITTLE_ENDIAN_H

/// \file
/// Numbers in binary files, of which the lowest byte is the first.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>

namespace quadrille_examples {

template <class Value>
Value little_endian_at(std::string_view bytes, std::size_t offset) {
  std::array<char, sizeof(Value)> raw;
  std::memcpy(raw.data(), bytes.data() + offset, raw.size());
  if constexpr (std::endian::native == std::endian::big)
    std::reverse(raw.begin(), raw.end());
  return std::bit_cast<Value>(raw);
}

template <class Value>
void append_little_endian(std::string& bytes, Value value) {
  auto raw = std::bit_cast<std::array<char, sizeof(Value)>>(value);
  if constexpr (std::endian::native == std::endian::big)
    std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

} // namespace quadrille_examples

#endif
