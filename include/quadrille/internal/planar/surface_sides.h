#ifndef QUADRILLE_INTERNAL_PLANAR_SURFACE_SIDES_H
#define QUADRILLE_INTERNAL_PLANAR_SURFACE_SIDES_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/memory/array.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The directed sides of triangles, where side 3f + k leads to corner k of face f, and the edges on
/// which they lie. It takes O(n log n) for n triangles.
///
/// Two sides that run against each other along an edge that has no others are *mates*. A triangle
/// that names a vertex twice has no sides.
class SurfaceSides {
public:
  using Triangle = TriangleComplex::Triangle;

  explicit SurfaceSides(const Array<Triangle>& triangles)
      : triangles_(triangles), mate_(3 * triangles.size(), none) {
    for (Index f = 0; f < triangles.size(); ++f)
      if (is_triangle(f))
        for (Index s = 3 * f; s < 3 * f + 3; ++s)
          sorted_.push_back({key(s), s});
    std::sort(sorted_.begin(), sorted_.end());
    for_each_edge([&](std::span<const Keyed> sides) {
      if (sides.size() == 2 && from(sides[0].second) == to(sides[1].second)) {
        mate_[sides[0].second] = sides[1].second;
        mate_[sides[1].second] = sides[0].second;
      }
    });
  }

  std::size_t size() const { return mate_.size(); }
  std::size_t face_count() const { return triangles_.size(); }
  const Triangle& corners(Index face) const { return triangles_[face]; }
  /// Does the face have three different vertices?
  bool is_triangle(Index face) const {
    const auto& [a, b, c] = triangles_[face];
    return a != b && b != c && c != a;
  }

  Index mate(Index side) const { return mate_[side]; } ///< or none
  Index to(Index side) const { return triangles_[side / 3][side % 3]; }
  Index from(Index side) const { return to(before(side)); }

  static Index face(Index side) { return side / 3; }
  static Index after(Index side) { return side % 3 == 2 ? side - 2 : side + 1; }
  static Index before(Index side) { return side % 3 == 0 ? side + 2 : side - 1; }

  using Keyed = std::pair<std::uint64_t, Index>; ///< the two vertices of a side, and the side

  /// Calls visit(sides) for the sides of each edge, a span of Keyed, by ascending vertices.
  template <class Visit>
  void for_each_edge(Visit visit) const {
    for (std::size_t begin = 0; begin < sorted_.size();) {
      std::size_t end = begin + 1;
      while (end < sorted_.size() && sorted_[end].first == sorted_[begin].first)
        ++end;
      visit(std::span(sorted_).subspan(begin, end - begin));
      begin = end;
    }
  }

private:
  std::uint64_t key(Index side) const {
    const auto [low, high] = std::minmax({from(side), to(side)});
    return std::uint64_t{low} << 32 | high;
  }

  const Array<Triangle>& triangles_;
  std::vector<Index> mate_;
  std::vector<Keyed> sorted_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_PLANAR_SURFACE_SIDES_H
