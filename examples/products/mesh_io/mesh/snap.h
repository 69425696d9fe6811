#ifndef QUADRILLE_EXAMPLES_MESH_IO_SNAP_H
#define QUADRILLE_EXAMPLES_MESH_IO_SNAP_H

#include "indexed_mesh.h"

#include <CGAL/squared_distance_3.h>

#include <boost/container_hash/hash.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace quadrille_examples {

/// Moves points to the place of an earlier one that stays and is no further than `tolerance`, which
/// is above 0, of several to the first. So no point moves further than that, and those that stay
/// are further from each other. Expected time O(n) where few points share a cube of that size.
inline void snap_points(std::vector<Point>& points, double tolerance) {
  using Cell = std::array<double, 3>; // whole numbers
  std::unordered_map<Cell, std::vector<std::size_t>, boost::hash<Cell>> staying;
  const auto cell_of = [&](const Point& p) {
    return Cell{std::floor(p.x() / tolerance), std::floor(p.y() / tolerance),
                std::floor(p.z() / tolerance)};
  };
  const auto first_near = [&](std::size_t v) {
    const Cell cell = cell_of(points[v]);
    std::size_t first = v;
    for (int i = 0; i < 27; ++i) {
      const auto found =
          staying.find({cell[0] + i % 3 - 1, cell[1] + i / 3 % 3 - 1, cell[2] + i / 9 - 1});
      if (found == staying.end())
        continue;
      for (const std::size_t u : found->second)
        if (u < first && CGAL::squared_distance(points[u], points[v]) <= tolerance * tolerance)
          first = u;
    }
    return first;
  };
  for (std::size_t v = 0; v < points.size(); ++v) {
    const std::size_t first = first_near(v);
    if (first == v)
      staying[cell_of(points[v])].push_back(v);
    else
      points[v] = points[first];
  }
}

} // namespace quadrille_examples

#endif
