#ifndef QUADRILLE_TEST_SNAPSHOT_H
#define QUADRILLE_TEST_SNAPSHOT_H

#include "meshes.h"

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

/// \file
/// Is a surface as it was?

namespace test {

/// Points by their bits, and the corners of each face, all in the order of the surface.
struct Snapshot {
  std::vector<std::array<std::uint64_t, 3>> points;
  std::vector<std::vector<std::size_t>> faces;

  friend bool operator==(const Snapshot&, const Snapshot&) = default;

  void add(const Point& p) {
    points.push_back({std::bit_cast<std::uint64_t>(p.x()), std::bit_cast<std::uint64_t>(p.y()),
                      std::bit_cast<std::uint64_t>(p.z())});
  }
};

template <class M>
Snapshot snapshot(const M& mesh) {
  Snapshot result;
  std::map<typename boost::graph_traits<M>::vertex_descriptor, std::size_t> number;
  for (const auto v : vertices(mesh)) {
    number[v] = number.size();
    result.add(get(get(CGAL::vertex_point, mesh), v));
  }
  for (const auto f : faces(mesh)) {
    std::vector<std::size_t>& corners = result.faces.emplace_back();
    auto h = halfedge(f, mesh);
    do { // in a broken mesh it may never come back
      corners.push_back(number.at(target(h, mesh)));
      h = next(h, mesh);
    } while (h != halfedge(f, mesh) && corners.size() <= number.size());
  }
  return result;
}

/// A soup has `points` and `triangles`.
template <class S>
requires requires(const S& soup) {
  soup.triangles;
}
Snapshot snapshot(const S& soup) {
  Snapshot result;
  for (const Point& p : soup.points)
    result.add(p);
  for (const auto& t : soup.triangles)
    result.faces.emplace_back(t.begin(), t.end());
  return result;
}

/// Of a soup there is nothing to say.
template <class Surface>
bool is_sound(const Surface& surface) {
  if constexpr (requires { surface.triangles; })
    return true;
  else
    return CGAL::is_valid_polygon_mesh(surface);
}

} // namespace test

#endif // QUADRILLE_TEST_SNAPSHOT_H
