#ifndef QUADRILLE_INTERNAL_CORE_BASE_CHECKSUM_H
#define QUADRILLE_INTERNAL_CORE_BASE_CHECKSUM_H

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace quadrille::internal {

/// A checksum of 64 bits, over bytes in blocks of any size, at some gigabytes a second. Each step
/// is a bijection of the state for given bytes, so that a single changed word is always found. It
/// is no protection against malice.
class Checksum {
public:
  void add(const void* bytes, std::size_t size) {
    const char* from = static_cast<const char*>(bytes);
    size_ += size;
    while (size > 0 && filled_ > 0)
      add_byte(*from++), --size;
    for (; size >= 8; size -= 8, from += 8) {
      std::uint64_t word;
      std::memcpy(&word, from, 8);
      mix(word);
    }
    while (size-- > 0)
      add_byte(*from++);
  }

  std::uint64_t value() const {
    Checksum end = *this;
    end.mix(end.word_);
    end.mix(size_);
    std::uint64_t x = end.state_;
    x = (x ^ (x >> 32)) * 0x9FB21C651E98DF25U;
    return x ^ (x >> 28);
  }

private:
  // Bytes that are no whole word yet.
  void add_byte(char byte) {
    word_ |= std::uint64_t{static_cast<unsigned char>(byte)} << (8 * filled_);
    if (++filled_ == 8) {
      mix(word_);
      filled_ = 0;
      word_ = 0;
    }
  }
  void mix(std::uint64_t word) {
    state_ = std::rotl(state_ ^ word, 27) * 0x9E3779B185EBCA87U + 0x165667B19E3779F9U;
  }

  std::uint64_t state_ = 0x27D4EB2F165667C5U, word_ = 0, size_ = 0;
  unsigned filled_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_BASE_CHECKSUM_H
