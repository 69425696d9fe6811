#ifndef QUADRILLE_INTERNAL_CONTRACTION_PARTS_H
#define QUADRILLE_INTERNAL_CONTRACTION_PARTS_H

#include <quadrille/internal/complex/topology_count.h>
#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/memory/array.h>
#include <quadrille/internal/surface/geometry.h>
#include <quadrille/internal/surface/scale.h>
#include <quadrille/vector.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

namespace quadrille::internal {

/// A part of a surface, what no vertex connects with the rest, as it was in the input: a sphere
/// around the centre of its bounding box.
template <std::size_t N>
struct Part {
  Vector<N> low, high;
  Vector<N> centre{};
  double squared_radius = 0; ///< in all dimensions, in the engine's unit
  double radius = 0;         ///< in space, in the mesh's unit
  double size = 0;           ///< the diagonal of the box in space, in the mesh's unit
  bool is_fixed = false;     ///< is any of its vertices?
};

/// Which vertices belong to which part. Contractions of edges keep that.
template <std::size_t N>
class Parts {
public:
  Parts() = default;
  /// In linear time. Parts are numbered in the order of their first vertices.
  Parts(const TriangleComplex& complex, const Geometry<N>& geometry, const Scale<N>& scale)
      : part_(component_roots(complex)) {
    number(complex);
    for_each_vertex([&](Part<N>& part, Index v) {
      for (std::size_t i = 0; i < N; ++i) {
        part.low[i] = (std::min)(part.low[i], geometry.position(v)[i]);
        part.high[i] = (std::max)(part.high[i], geometry.position(v)[i]);
      }
      part.is_fixed |= geometry.is_fixed(v);
    });
    for (Part<N>& part : parts_) {
      part.centre = 0.5 * part.low + 0.5 * part.high;
      part.size =
          scale.length_of_mesh(std::sqrt(squared_distance(space(part.low), space(part.high))));
    }
    for_each_vertex([&](Part<N>& part, Index v) {
      const Vector<N>& p = geometry.position(v);
      part.squared_radius = (std::max)(part.squared_radius, squared_distance(p, part.centre));
      const double squared = squared_distance(space(p), space(part.centre));
      part.radius = (std::max)(part.radius, scale.length_of_mesh(std::sqrt(squared)));
    });
  }

  /// Of the input; none where parts may not vanish.
  std::size_t size() const { return parts_.size(); }
  const Part<N>& operator[](Index part) const { return parts_[part]; }
  /// The part of a vertex; `none` where it had no faces.
  Index of(Index v) const { return part_[v]; }
  /// Is it certain that the part of a vertex stays?
  bool stays(Index v) const { return parts_.empty() || parts_[part_[v]].is_fixed; }

  static constexpr bool is_seldom_there = true;
  static auto vertex_columns(auto& self) { return std::tie(self.part_); }

private:
  // From the vertices that stand for parts to numbers.
  void number(const TriangleComplex& complex) {
    Array<Index> number(part_.size(), none);
    Part<N> empty;
    empty.low.coordinates.fill((std::numeric_limits<double>::max)());
    empty.high.coordinates.fill(std::numeric_limits<double>::lowest());
    for (Index v = 0; v < part_.size(); ++v) {
      const Index root = part_[v];
      part_[v] = none;
      if (!complex.has_faces(v))
        continue;
      if (number[root] == none) {
        number[root] = static_cast<Index>(parts_.size());
        parts_.push_back(empty);
      }
      part_[v] = number[root];
    }
  }

  template <class Visit>
  void for_each_vertex(Visit visit) {
    for (Index v = 0; v < part_.size(); ++v)
      if (part_[v] != none)
        visit(parts_[part_[v]], v);
  }

  Array<Index> part_; // of each vertex
  std::vector<Part<N>> parts_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CONTRACTION_PARTS_H
