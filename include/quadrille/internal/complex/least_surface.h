#ifndef QUADRILLE_INTERNAL_COMPLEX_LEAST_SURFACE_H
#define QUADRILLE_INTERNAL_COMPLEX_LEAST_SURFACE_H

#include <quadrille/internal/complex/link_condition.h>
#include <quadrille/internal/complex/topology_count.h>
#include <quadrille/internal/complex/triangle_complex.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace quadrille::internal {

struct SurfaceSize {
  std::size_t faces = 0, vertices = 0;
  std::size_t parts = 1;
};

/// What bounds the size of a part of a surface whose topology and fixed vertices are kept.
struct PartTally {
  std::size_t faces = 0, vertices = 0, fixed = 0;
  bool is_closed = true; // and a manifold
  bool has_backs = true; // do all faces have one?

  /// It has no fewer faces and vertices. Of a closed part with Euler characteristic χ these are
  /// V = ⌈(7 + √(49 − 24 χ)) / 2⌉ and 2 (V − χ): a vertex has at most V − 1 neighbours (Heawood
  /// 1890). Of another one they are those of a triangle, and a face for every two fixed vertices.
  SurfaceSize least() const {
    if (!is_closed)
      return {(std::max<std::size_t>)(1, fixed / 2), (std::max<std::size_t>)(3, fixed)};
    const double euler = static_cast<double>(vertices) - static_cast<double>(faces) / 2;
    const double heawood = std::ceil((7 + std::sqrt(49 - 24 * euler)) / 2);
    const double most = (std::max)(heawood, static_cast<double>(fixed));
    return {static_cast<std::size_t>(2 * (most - euler)), static_cast<std::size_t>(most)};
  }
};

/// A surface of the same topology, with the same fixed vertices, has no fewer faces and vertices.
/// Parts of which no vertex stays may vanish and do not count. In linear time.
template <class IsFixed, class Stays>
SurfaceSize least_surface(const TriangleComplex& complex, const LinkCondition& link_condition,
                          IsFixed is_fixed, Stays stays) {
  const Array<Index> root = component_roots(complex);
  std::vector<PartTally> parts(root.size());
  for (Index v = 0; v < root.size(); ++v)
    if (complex.has_faces(v) && stays(v)) {
      PartTally& part = parts[root[v]];
      ++part.vertices;
      part.fixed += is_fixed(v);
      part.is_closed &= link_condition.is_interior(v);
    }
  for (Index face = 0; face < complex.face_capacity(); ++face)
    if (!complex.is_removed(face)) {
      PartTally& part = parts[root[complex.vertices(face)[0]]];
      ++part.faces;
      part.has_backs &= complex.backs().has(face);
    }
  SurfaceSize size{0, 0, 0};
  for (const PartTally& part : parts)
    if (part.vertices > 0) {
      const SurfaceSize least = part.least();
      size.faces += part.has_backs ? 2 * least.faces : least.faces;
      size.vertices += least.vertices;
      size.parts += least.parts;
    }
  return size;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_COMPLEX_LEAST_SURFACE_H
