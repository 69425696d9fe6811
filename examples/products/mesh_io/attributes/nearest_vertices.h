#ifndef QUADRILLE_EXAMPLES_NEAREST_VERTICES_H
#define QUADRILLE_EXAMPLES_NEAREST_VERTICES_H

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace quadrille_examples {

/// Of the vertices that have become each point that is left, the nearest, the first of equal ones.
/// `images` is what quadrille::parameters::vertex_to_vertex_map was given.
template <class Point>
std::vector<std::uint32_t> nearest_vertices(const std::vector<Point>& before,
                                            const std::vector<std::size_t>& images,
                                            const std::vector<Point>& left) {
  std::vector<std::uint32_t> nearest(left.size());
  std::vector<double> distances(left.size(), std::numeric_limits<double>::infinity());
  for (std::size_t v = 0; v < images.size(); ++v) {
    if (images[v] >= left.size()) // it has vanished
      continue;
    const Point &p = before[v], &q = left[images[v]];
    const double distance = std::hypot(double{p[0]} - double{q[0]}, double{p[1]} - double{q[1]},
                                       double{p[2]} - double{q[2]});
    if (distance < distances[images[v]]) {
      distances[images[v]] = distance;
      nearest[images[v]] = static_cast<std::uint32_t>(v);
    }
  }
  return nearest;
}

} // namespace quadrille_examples

#endif
