#ifndef QUADRILLE_INTERNAL_FILE_ID_SET_H
#define QUADRILLE_INTERNAL_FILE_ID_SET_H

#include <quadrille/internal/file/rows.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace quadrille::internal {

/// A set of numbers below a limit, with one bit for each number.
class IdSet {
public:
  explicit IdSet(std::uint64_t limit) : words_(static_cast<std::size_t>(limit / 64 + 1)) {}

  void add(VertexId id) { words_[id / 64] |= std::uint64_t{1} << (id % 64); }
  bool has(VertexId id) const { return (words_[id / 64] >> (id % 64) & 1U) != 0; }
  const std::vector<std::uint64_t>& words() const { return words_; }

private:
  std::vector<std::uint64_t> words_;
};

/// Returns how many numbers of a set are below a given one: these are the numbers of the vertices
/// in the output.
class IdRanks {
public:
  explicit IdRanks(const IdSet& ids) : ids_(ids), before_(ids.words().size() / 8 + 1) {
    for (std::size_t i = 0; i < ids.words().size(); ++i) {
      if (i % 8 == 0)
        before_[i / 8] = size_;
      size_ += static_cast<std::uint64_t>(std::popcount(ids.words()[i]));
    }
  }

  std::uint64_t size() const { return size_; } ///< the size of the set
  std::uint64_t operator()(VertexId id) const {
    const std::size_t word = id / 64;
    std::uint64_t rank = before_[word / 8];
    for (std::size_t i = word / 8 * 8; i < word; ++i)
      rank += static_cast<std::uint64_t>(std::popcount(ids_.words()[i]));
    const std::uint64_t below = ids_.words()[word] & ((std::uint64_t{1} << (id % 64)) - 1);
    return rank + static_cast<std::uint64_t>(std::popcount(below));
  }

private:
  const IdSet& ids_;
  std::vector<std::uint64_t> before_; // one entry for each 512 numbers
  std::uint64_t size_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_ID_SET_H
