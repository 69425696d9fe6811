#ifndef QUADRILLE_INTERNAL_LEVELS_BYTES_H
#define QUADRILLE_INTERNAL_LEVELS_BYTES_H

#include <quadrille/internal/core/base/checksum.h>
#include <quadrille/internal/core/base/little_endian.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#ifdef QUADRILLE_WITH_ZSTD
#include <zstd.h>
#endif

/// \file
/// Converts numbers to bytes of a file, little-endian on every machine, with checksums and, if the
/// macro QUADRILLE_WITH_ZSTD is defined, compressed by zstd.

namespace quadrille::internal {

using Bytes = std::vector<unsigned char>;

inline constexpr bool has_zstd =
#ifdef QUADRILLE_WITH_ZSTD
    true;
#else
    false;
#endif

template <class T>
concept Number = std::is_arithmetic_v<T>;

/// Appends numbers to bytes.
class ByteWriter {
public:
  template <Number T>
  void put(T value) {
    append_little_endian(bytes_, value);
  }
  /// Appends an array of numbers: all first bytes, then all second bytes, and so on, since similar
  /// bytes compress well.
  template <Number T>
  void put_array(const std::vector<T>& array) {
    const std::size_t begin = bytes_.size();
    bytes_.resize(begin + array.size() * sizeof(T));
    for (std::size_t i = 0; i < array.size(); ++i) {
      const auto bytes = little_endian<unsigned char>(array[i]);
      for (std::size_t b = 0; b < sizeof(T); ++b)
        bytes_[begin + b * array.size() + i] = bytes[b];
    }
  }
  void put_text(const std::string& text) {
    put(static_cast<std::uint32_t>(text.size()));
    bytes_.insert(bytes_.end(), text.begin(), text.end());
  }
  const Bytes& bytes() const { return bytes_; }
  Bytes take() { return std::move(bytes_); }

private:
  Bytes bytes_;
};

/// Reads numbers from bytes. Throws std::runtime_error if there are not enough bytes.
class ByteReader {
public:
  explicit ByteReader(std::span<const unsigned char> bytes) : bytes_(bytes) {}

  std::size_t left() const { return bytes_.size(); }
  template <Number T>
  T get() {
    return little_endian_at<T>(take(sizeof(T)).data());
  }
  template <Number T>
  std::vector<T> get_array(std::size_t count) {
    if (count > left() / sizeof(T))
      throw std::runtime_error("it ends too early");
    const std::span<const unsigned char> from = take(count * sizeof(T));
    std::vector<T> array(count);
    for (std::size_t i = 0; i < count; ++i) {
      std::array<unsigned char, sizeof(T)> raw;
      for (std::size_t b = 0; b < sizeof(T); ++b)
        raw[b] = from[b * count + i];
      array[i] = little_endian_at<T>(raw.data());
    }
    return array;
  }
  std::string get_text() {
    const std::span<const unsigned char> text = take(get<std::uint32_t>());
    return {text.begin(), text.end()};
  }

private:
  std::span<const unsigned char> take(std::size_t count) {
    if (count > bytes_.size())
      throw std::runtime_error("it ends too early");
    const auto taken = bytes_.first(count);
    bytes_ = bytes_.subspan(count);
    return taken;
  }

  std::span<const unsigned char> bytes_;
};

inline std::uint32_t checksum_of(const Bytes& bytes) {
  Checksum checksum;
  checksum.add(bytes.data(), bytes.size());
  return static_cast<std::uint32_t>(checksum.value());
}

/// Returns compressed bytes. Throws std::runtime_error without zstd.
inline Bytes compressed([[maybe_unused]] const Bytes& bytes) {
#ifdef QUADRILLE_WITH_ZSTD
  Bytes packed(ZSTD_compressBound(bytes.size()));
  const std::size_t size =
      ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), 3);
  if (ZSTD_isError(size))
    throw std::runtime_error(ZSTD_getErrorName(size));
  packed.resize(size);
  return packed;
#else
  throw std::runtime_error("compression needs zstd: define QUADRILLE_WITH_ZSTD and link zstd");
#endif
}
/// Returns the bytes that were compressed to `packed`.
inline Bytes decompressed([[maybe_unused]] const Bytes& packed, [[maybe_unused]] std::size_t size) {
#ifdef QUADRILLE_WITH_ZSTD
  if (ZSTD_getFrameContentSize(packed.data(), packed.size()) != size)
    throw std::runtime_error("the size of a block does not match the directory");
  Bytes bytes(size);
  const std::size_t got = ZSTD_decompress(bytes.data(), size, packed.data(), packed.size());
  if (ZSTD_isError(got) || got != size)
    throw std::runtime_error("a block cannot be decompressed");
  return bytes;
#else
  throw std::runtime_error(
      "it is compressed, and reading it needs zstd: define QUADRILLE_WITH_ZSTD and link "
      "zstd");
#endif
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_LEVELS_BYTES_H
