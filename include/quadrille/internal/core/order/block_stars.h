#ifndef QUADRILLE_INTERNAL_CORE_ORDER_BLOCK_STARS_H
#define QUADRILLE_INTERNAL_CORE_ORDER_BLOCK_STARS_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/ranges.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/memory/array.h>

#include <algorithm>
#include <bit>
#include <cstddef>

namespace quadrille::internal {

/// Decides which stars are inside a block, and which vertices a pass has contracted. Vertices whose
/// numbers have all but their last bits in common are in one block; eight blocks at a time are
/// joined into one. A star inside a block stays there while others are contracted that are inside
/// of it.
class BlockStars {
public:
  static constexpr std::size_t joined_blocks = 8;

  explicit BlockStars(Arena* arena) : joins_needed_(arena) {}

  /// For blocks of 2^bits vertices. No vertex has been contracted.
  void measure(const TriangleComplex& complex, int bits, Threads threads) {
    joins_ = 0;
    joins_needed_.assign(complex.vertex_capacity(), 0);
    for_each_range(threads, joins_needed_.size(), [&](const auto& range, std::size_t) {
      complex.for_each_face_at(range, [&](const TriangleComplex::Triangle& corners) {
        const auto [p, q, r] = corners;
        const Index differing = ((p ^ q) | (p ^ r)) >> bits;
        const auto joins = (std::bit_width(differing) + bits_a_join - 1) / bits_a_join;
        if (joins > 0)
          for (Index v : corners)
            if (range.contains(v))
              joins_needed_[v] = (std::max)(joins_needed_[v], static_cast<unsigned char>(joins));
      });
    });
  }

  void join() { ++joins_; }
  /// Is the star of a vertex inside of its block? Not if it is touched.
  bool is_inside(Index v) const { return joins_needed_[v] <= joins_; }
  /// Are the stars of both ends of a pair inside of one block, the same? Not if one is touched.
  bool are_inside(Index v, Index w) const {
    return (std::max)(joins_needed_[v], joins_needed_[w]) <= joins_;
  }

  void touch(Index v) { joins_needed_[v] = touched; } ///< it has been contracted
  bool is_touched(Index v) const { return joins_needed_[v] == touched; }

private:
  static constexpr int bits_a_join = std::bit_width(joined_blocks) - 1;
  static constexpr unsigned char touched = 255;

  int joins_ = 0;
  // How many joins bring all faces at a vertex into one block, or `touched`.
  Array<unsigned char> joins_needed_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ORDER_BLOCK_STARS_H
