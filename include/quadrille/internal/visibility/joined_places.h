#ifndef QUADRILLE_INTERNAL_VISIBILITY_JOINED_PLACES_H
#define QUADRILLE_INTERNAL_VISIBILITY_JOINED_PLACES_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/triangle_soup.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace quadrille::internal {

/// Makes triangles that touch at the same place name the same point: the first one there. A surface
/// is then connected across seams.
inline void join_places(TriangleSoup<>& surface) {
  const auto& points = surface.points;
  std::vector<Index> order(points.size()), first(points.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    const auto &p = points[a].coordinates, &q = points[b].coordinates;
    return p != q ? p < q : a < b;
  });
  for (std::size_t i = 0; i < order.size(); ++i)
    first[order[i]] = i > 0 && points[order[i - 1]].coordinates == points[order[i]].coordinates
                          ? first[order[i - 1]]
                          : order[i];
  for (auto& triangle : surface.triangles)
    for (Index& v : triangle)
      v = first[v];
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VISIBILITY_JOINED_PLACES_H
