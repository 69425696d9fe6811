#ifndef QUADRILLE_EXAMPLES_NEAREST_VERTICES_H
#define QUADRILLE_EXAMPLES_NEAREST_VERTICES_H

#include <quadrille/compiled.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace quadrille_examples {

/// Of the vertices that have become each point that is left, the nearest, the first of equal ones.
/// `images` is what quadrille::parameters::vertex_to_vertex_map was given, and `nearest` has what
/// those get that no vertex has become: zeros, if it is empty.
template <class Point>
std::vector<std::uint32_t>
nearest_vertices(const std::vector<Point>& before, const std::vector<std::size_t>& images,
                 const std::vector<Point>& left, std::vector<std::uint32_t> nearest = {}) {
  nearest.resize(left.size());
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

/// The same of what quadrille::simplified_soup has made of a soup. Of an added point, the one from
/// which it comes.
inline std::vector<std::uint32_t> nearest_inputs(const quadrille::SoupPoints& points,
                                                 const quadrille::SoupResult& result) {
  const quadrille::PreparedSurface& prepared = result.prepared;
  if (prepared.points.empty())
    return nearest_vertices(points, result.vertex_map, result.points);
  std::vector<std::uint32_t> nearest =
      nearest_vertices(prepared.points, prepared.vertex_map, result.points);
  for (std::uint32_t& v : nearest)
    if (v >= points.size())
      v = prepared.origins[v - points.size()];
  return nearest;
}

} // namespace quadrille_examples

#endif
