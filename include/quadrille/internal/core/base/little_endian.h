#ifndef QUADRILLE_INTERNAL_CORE_BASE_LITTLE_ENDIAN_H
#define QUADRILLE_INTERNAL_CORE_BASE_LITTLE_ENDIAN_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <string_view>

/// \file
/// Numbers in binary files, of which the lowest byte is the first, on every machine.

namespace quadrille::internal {

template <class Byte = char, class Number>
std::array<Byte, sizeof(Number)> little_endian(Number number) {
  auto bytes = std::bit_cast<std::array<Byte, sizeof(Number)>>(number);
  if constexpr (std::endian::native == std::endian::big)
    std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

/// The number that begins at `bytes`.
template <class Number>
Number little_endian_at(const void* bytes) {
  std::array<char, sizeof(Number)> raw;
  std::memcpy(raw.data(), bytes, raw.size());
  if constexpr (std::endian::native == std::endian::big)
    std::reverse(raw.begin(), raw.end());
  return std::bit_cast<Number>(raw);
}

template <class Number>
Number little_endian_at(std::string_view bytes, std::size_t offset) {
  return little_endian_at<Number>(bytes.data() + offset);
}

/// Appends a number to a container of bytes.
template <class Bytes, class Number>
void append_little_endian(Bytes& bytes, Number number) {
  const auto raw = little_endian<typename Bytes::value_type>(number);
  const std::size_t size = bytes.size();
  bytes.resize(size + raw.size());
  std::memcpy(bytes.data() + size, raw.data(), raw.size());
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_BASE_LITTLE_ENDIAN_H
