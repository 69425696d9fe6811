#ifndef QUADRILLE_INTERNAL_VERIFY_CHECKED_SURFACE_H
#define QUADRILLE_INTERNAL_VERIFY_CHECKED_SURFACE_H

#include <quadrille/internal/base/points.h>
#include <quadrille/vector.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace quadrille::internal {

using ExactKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Corners = std::array<std::size_t, 3>;

/// A surface as verify() sees it: points, and faces of three different ones of them.
struct CheckedSurface {
  std::vector<ExactKernel::Point_3> points;
  std::vector<Corners> faces;

  void add_point(const Vector<3>& p) {
    if (!is_finite(p))
      throw std::invalid_argument("quadrille::verify: a coordinate is not finite");
    points.emplace_back(p[0], p[1], p[2]);
  }
  template <class Vertices>
  void add_face(const Vertices& vertices) {
    Corners corners{};
    std::size_t count = 0;
    for (const auto vertex : vertices) {
      const auto v = static_cast<std::size_t>(vertex);
      if (v >= points.size())
        throw std::out_of_range("quadrille::verify: a triangle names a point that does not exist");
      if (count < 3)
        corners[count] = v;
      ++count;
    }
    if (count != 3)
      throw std::invalid_argument("quadrille::verify: a face is not a triangle");
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
      faces.push_back(corners);
  }

  ExactKernel::Triangle_3 triangle(std::size_t face) const {
    const auto& [a, b, c] = faces[face];
    return {points[a], points[b], points[c]};
  }
  CGAL::Bbox_3 box() const {
    CGAL::Bbox_3 box;
    for (const Corners& corners : faces)
      for (std::size_t v : corners)
        box += points[v].bbox();
    return box;
  }
};

/// Of a model of CGAL's FaceListGraph with a vertex_point map.
template <class Mesh>
CheckedSurface checked_surface(const Mesh& mesh) {
  CheckedSurface surface;
  const auto position = get(CGAL::vertex_point, mesh);
  const auto number = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
  for (const auto v : vertices(mesh)) {
    put(number, v, surface.points.size());
    surface.add_point(position_of(get(position, v)));
  }
  std::vector<std::size_t> corners;
  for (const auto f : faces(mesh)) {
    corners.clear();
    for (const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      corners.push_back(get(number, v));
    surface.add_face(corners);
  }
  return surface;
}

/// Of a polygon soup. Of faces on the same three vertices, as the sides of a sheet are, both count.
template <class Points, class Triangles>
CheckedSurface checked_surface(const Points& points, const Triangles& triangles) {
  CheckedSurface surface;
  for (const auto& p : points)
    surface.add_point(position_of(p));
  for (const auto& triangle : triangles)
    surface.add_face(triangle);
  return surface;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VERIFY_CHECKED_SURFACE_H
