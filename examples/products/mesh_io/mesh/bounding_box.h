#ifndef QUADRILLE_EXAMPLES_BOUNDING_BOX_H
#define QUADRILLE_EXAMPLES_BOUNDING_BOX_H

/// \file
/// What is asked of a soup before it is simplified.

#include "indexed_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace quadrille_examples {

inline double coordinate(const Point& point, std::size_t k) {
  return point[static_cast<int>(k)];
}
template <class Number>
double coordinate(const std::array<Number, 3>& point, std::size_t k) {
  return static_cast<double>(point[k]);
}

/// Of the box of the points that triangles use; 0 if there is none.
double diagonal(const auto& points, const auto& triangles) {
  std::array<double, 3> low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (const auto& triangle : triangles)
    for (const std::uint32_t corner : triangle)
      for (std::size_t k = 0; k < 3; ++k) {
        const double x = coordinate(points[corner], k);
        low[k] = std::min(low[k], x);
        high[k] = std::max(high[k], x);
      }
  return triangles.empty() ? 0 : std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}

/// Of each of `count` points, whether it is on an edge of one triangle only.
std::vector<bool> boundary_points(std::size_t count, const auto& triangles) {
  using Edge = std::array<std::uint32_t, 2>;
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (const auto& [a, b, c] : triangles)
    for (const auto& [p, q] : {Edge{a, b}, Edge{b, c}, Edge{c, a}})
      edges.push_back({std::min(p, q), std::max(p, q)});
  std::sort(edges.begin(), edges.end());
  std::vector<bool> is_on_boundary(count);
  for (auto edge = edges.begin(); edge != edges.end();) {
    const auto next = std::find_if(edge, edges.end(), [&](const Edge& e) { return e != *edge; });
    if (next - edge == 1)
      is_on_boundary[(*edge)[0]] = is_on_boundary[(*edge)[1]] = true;
    edge = next;
  }
  return is_on_boundary;
}

} // namespace quadrille_examples

#endif
