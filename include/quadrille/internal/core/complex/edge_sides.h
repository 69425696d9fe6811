#ifndef QUADRILLE_INTERNAL_CORE_COMPLEX_EDGE_SIDES_H
#define QUADRILLE_INTERNAL_CORE_COMPLEX_EDGE_SIDES_H

#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The edges at a vertex, each with its faces.
class EdgeSides {
public:
  using Side = std::pair<Index, Index>; ///< the other end of an edge, one of its faces

  void clear() { sides_.clear(); }
  void add(Index other, Index face) { sides_.push_back({other, face}); }
  /// A face at the vertex, which is a side of two edges.
  void add(const StarFace& f) {
    add(f.second, f.face);
    add(f.third, f.face);
  }
  /// Instead of all that is there, what a vertex has.
  void gather(const TriangleComplex& complex, Index v) {
    clear();
    complex.for_each_corner(v, [&](Index face, Index i) { add(star_face_at(complex, face, i)); });
  }

  /// Gathers the edges to vertices with higher numbers only.
  void gather_above(const TriangleComplex& complex, Index v) {
    clear();
    complex.for_each_corner(v, [&](Index face, Index i) {
      const StarFace f = star_face_at(complex, face, i);
      for (Index other : {f.second, f.third})
        if (other > v)
          add(other, face);
    });
  }

  /// Calls visit(other, sides) for each edge, in the order of the other ends.
  template <class Visit>
  void for_each(Visit visit) {
    const auto key = [](const Side& side) { return std::uint64_t{side.first} << 32 | side.second; };
    std::sort(sides_.begin(), sides_.end(),
              [key](const Side& a, const Side& b) { return key(a) < key(b); });
    for (auto side = sides_.begin(); side != sides_.end();) {
      auto end = side + 1;
      while (end != sides_.end() && end->first == side->first)
        ++end;
      visit(side->first, std::span<const Side>(&*side, static_cast<std::size_t>(end - side)));
      side = end;
    }
  }

private:
  std::vector<Side> sides_;
};

/// Calls visit(v, w, sides) for each edge of a surface, once, in the order of its lower ends.
template <class Visit>
void for_each_edge(const TriangleComplex& complex, Visit visit) {
  EdgeSides edges;
  for (Index v = 0; v < complex.vertex_capacity(); ++v) {
    edges.gather_above(complex, v);
    edges.for_each([&](Index w, const auto& sides) { visit(v, w, sides); });
  }
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_COMPLEX_EDGE_SIDES_H
