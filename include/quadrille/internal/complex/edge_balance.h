#ifndef QUADRILLE_INTERNAL_COMPLEX_EDGE_BALANCE_H
#define QUADRILLE_INTERNAL_COMPLEX_EDGE_BALANCE_H

#include <quadrille/internal/complex/star.h>
#include <quadrille/internal/complex/triangle_complex.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// How many edges have not as many faces that run along them in one direction as in the other. If
/// none has, the surface is closed and oriented, and every point beside it has a winding number. In
/// linear time, but for the sorting of the edges at each vertex.
inline std::size_t count_unbalanced_edges(const TriangleComplex& complex) {
  std::size_t count = 0;
  std::vector<std::pair<Index, int>> edges; // the other end, and in which direction a face runs
  for (Index v = 0; v < complex.vertex_capacity(); ++v) {
    edges.clear();
    complex.for_each_corner(v, [&](Index face, Index i) {
      const StarFace f = star_face_at(complex, face, i);
      if (v < f.second)
        edges.emplace_back(f.second, 1);
      if (v < f.third)
        edges.emplace_back(f.third, -1);
    });
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0; i < edges.size();) {
      const Index other = edges[i].first;
      int sum = 0;
      for (; i < edges.size() && edges[i].first == other; ++i)
        sum += edges[i].second;
      count += sum != 0;
    }
  }
  return count;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_COMPLEX_EDGE_BALANCE_H
