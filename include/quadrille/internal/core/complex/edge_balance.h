#ifndef QUADRILLE_INTERNAL_CORE_COMPLEX_EDGE_BALANCE_H
#define QUADRILLE_INTERNAL_CORE_COMPLEX_EDGE_BALANCE_H

#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Calls visit(v, w) for each edge that has not as many faces that run along it in one direction as
/// in the other, and tells how many there are. If none has, the surface is closed and oriented, and
/// every point beside it has a winding number. In linear time, but for the sorting of the edges at
/// each vertex.
template <class Visit>
std::size_t for_each_unbalanced_edge(const TriangleComplex& complex, Visit visit) {
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
      if (sum == 0)
        continue;
      visit(v, other);
      ++count;
    }
  }
  return count;
}

/// The same without looking at them.
inline std::size_t count_unbalanced_edges(const TriangleComplex& complex) {
  return for_each_unbalanced_edge(complex, [](Index, Index) {});
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_COMPLEX_EDGE_BALANCE_H
