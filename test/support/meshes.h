#ifndef QUADRILLE_TEST_MESHES_H
#define QUADRILLE_TEST_MESHES_H

#include "soups.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

/// \file
/// The soups of soups.h as meshes and back.

namespace test {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

template <class P>
P to_point(const Position& p) {
  using FT = typename CGAL::Kernel_traits<P>::Kernel::FT;
  return P(FT(p[0]), FT(p[1]), FT(p[2]));
}

template <class P>
Position to_position(const P& p) {
  return {{CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])}};
}

/// A model of Debian's libcgal-demo, by its name. Throws std::runtime_error if it cannot be read.
Mesh read_model(const std::string& name);

inline std::vector<Point> points_of(const Soup& soup) {
  std::vector<Point> points;
  for (const Position& p : soup.points)
    points.push_back(to_point<Point>(p));
  return points;
}

/// A soup as `simplify` takes it.
struct PointSoup {
  std::vector<Point> points;
  std::vector<Triangle> triangles;

  explicit PointSoup(const Soup& soup) : points(points_of(soup)), triangles(soup.triangles) {}
};

/// A manifold and oriented soup as a mesh: vertex i is point i, face i is triangle i.
template <class M>
M make_mesh(const Soup& soup) {
  M mesh;
  const auto points = get(CGAL::vertex_point, mesh);
  using P = typename boost::property_traits<decltype(points)>::value_type;
  std::vector<typename boost::graph_traits<M>::vertex_descriptor> vertices;
  for (const Position& p : soup.points) {
    vertices.push_back(add_vertex(mesh));
    put(points, vertices.back(), to_point<P>(p));
  }
  for (const auto& [a, b, c] : soup.triangles) {
    const std::array corners{vertices[a], vertices[b], vertices[c]};
    if (CGAL::Euler::add_face(corners, mesh) == boost::graph_traits<M>::null_face())
      throw std::logic_error("this soup is no mesh");
  }
  return mesh;
}

inline Mesh make_mesh(const Soup& soup) {
  return make_mesh<Mesh>(soup);
}

/// The vertices and faces of a mesh, in its order; faces begin anywhere.
template <class M>
Soup to_soup(const M& mesh) {
  Soup soup;
  const auto points = get(CGAL::vertex_point, mesh);
  std::map<typename boost::graph_traits<M>::vertex_descriptor, std::uint32_t> number;
  for (const auto v : vertices(mesh)) {
    number[v] = static_cast<std::uint32_t>(soup.points.size());
    soup.points.push_back(to_position(get(points, v)));
  }
  for (const auto f : faces(mesh)) {
    const auto h = halfedge(f, mesh);
    soup.triangles.push_back({number.at(target(h, mesh)), number.at(target(next(h, mesh), mesh)),
                              number.at(target(next(next(h, mesh), mesh), mesh))});
  }
  return soup;
}

inline Soup to_soup(const PointSoup& soup) {
  Soup result{{}, soup.triangles};
  for (const Point& p : soup.points)
    result.points.push_back(to_position(p));
  return result;
}

/// Holds CGAL's own checks, and that every triangle is one by its halfedges.
template <class M>
bool is_valid_triangle_mesh(const M& mesh) {
  return CGAL::is_valid_polygon_mesh(mesh) && CGAL::is_triangle_mesh(mesh);
}

/// A triangle that begins with its lowest vertex.
inline Triangle canonical(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

/// The same faces between the same points, up to `tolerance` in position, in any order?
inline bool is_same_surface(const Soup& a, const Soup& b, double tolerance) {
  if (a.points.size() != b.points.size() || a.triangles.size() != b.triangles.size())
    return false;
  std::vector<std::uint32_t> match; // of each point of a, the nearest of b
  for (const Position& p : a.points) {
    const auto nearest =
        std::min_element(b.points.begin(), b.points.end(), [&](const auto& q, const auto& r) {
          return squared_distance(p, q) < squared_distance(p, r);
        });
    if (squared_distance(p, *nearest) > tolerance * tolerance)
      return false;
    match.push_back(static_cast<std::uint32_t>(nearest - b.points.begin()));
  }
  std::multiset<Triangle> faces_of_a, faces_of_b;
  for (const auto& [i, j, k] : a.triangles)
    faces_of_a.insert(canonical({match[i], match[j], match[k]}));
  for (const Triangle& t : b.triangles)
    faces_of_b.insert(canonical(t));
  return faces_of_a == faces_of_b;
}

} // namespace test

#endif // QUADRILLE_TEST_MESHES_H
