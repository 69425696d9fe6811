#ifndef QUADRILLE_INTERNAL_CORE_COMPLEX_EDGE_BALANCE_H
#define QUADRILLE_INTERNAL_CORE_COMPLEX_EDGE_BALANCE_H

#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Calls visit(v, w) for each edge that does not have as many faces in one direction as in the
/// other, and returns how many such edges there are. If there are none, the surface is closed and
/// oriented, and every point that is not on it has a winding number. The time is linear, except for
/// the sorting of the edges at each vertex.
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

/// Counts these edges without visiting them.
inline std::size_t count_unbalanced_edges(const TriangleComplex& complex) {
  return for_each_unbalanced_edge(complex, [](Index, Index) {});
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_COMPLEX_EDGE_BALANCE_H
