#ifndef QUADRILLE_INTERNAL_ATTRIBUTES_WEDGE_NORMALS_H
#define QUADRILLE_INTERNAL_ATTRIBUTES_WEDGE_NORMALS_H

#include <quadrille/internal/attributes/wedge_table.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/vector.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace quadrille::internal {

/// Of each wedge, the sum of the unit normals of its faces, weighted by their angles there. Source:
/// Thürmer and Wüthrich, Computing Vertex Normals from Polygonal Facets, 1998.
template <class Positions>
std::vector<Vector<3>> wedge_normals(const WedgeTable& table, std::size_t wedges,
                                     const Positions& positions, const TriangleComplex& complex) {
  std::vector<Vector<3>> sums(wedges);
  for (Index face = 0; face < complex.face_capacity(); ++face) {
    if (complex.is_removed(face))
      continue;
    const auto& v = complex.vertices(face);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector<3> one = positions[v[(i + 1) % 3]] - positions[v[i]];
      const Vector<3> other = positions[v[(i + 2) % 3]] - positions[v[i]];
      const Vector<3> normal = cross(one, other);
      const double length = std::sqrt(squared_length(normal));
      if (length > 0)
        sums[table.at(face, i, v[i])] += (std::atan2(length, dot(one, other)) / length) * normal;
    }
  }
  return sums;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ATTRIBUTES_WEDGE_NORMALS_H
