#ifndef QUADRILLE_INTERNAL_CORE_BASE_READ_SURFACE_H
#define QUADRILLE_INTERNAL_CORE_BASE_READ_SURFACE_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/points.h>
#include <quadrille/quadric_form.h>
#include <quadrille/triangle_soup.h>

#include <CGAL/boost/graph/properties.h>
#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <ranges>
#include <stdexcept>
#include <string>
#include <utility>

/// Surfaces of the user's, read. Errors begin with the name of the caller.

namespace quadrille::internal {

/// By what names a complaint about indices calls things.
struct IndexWords {
  const char* caller;
  const char* name = "point"; ///< the word for the thing that an index stands for
  const char* of_what = "";
};

/// The three indices of a face, which are below `count`: of points, or of something else that the
/// face names. Throws std::invalid_argument, with not_three() if they are not three.
template <class Triple, class NotThree>
std::array<Index, 3> read_indices(const Triple& triple, std::size_t face, std::size_t count,
                                  const IndexWords& words, NotThree not_three) {
  const auto reject = [&](const std::string& what) {
    throw std::invalid_argument(std::string(words.caller) + ": face " + std::to_string(face) +
                                what);
  };
  if (std::ranges::size(triple) != 3)
    reject(not_three());
  std::array<Index, 3> indices;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!std::in_range<Index>(triple[i]) || std::cmp_greater_equal(triple[i], count))
      reject(std::string(" names ") + words.name + " " + std::to_string(triple[i]) + " of " +
             std::to_string(count) + words.of_what);
    indices[i] = static_cast<Index>(triple[i]);
  }
  return indices;
}

/// A graph of which a constant one can be read.
template <class G>
concept ReadableGraph = requires(const G& g) {
  vertices(g);
  halfedges(g);
  faces(g);
};

/// The two halves of a polygon soup: points, and triples of indices into them.
template <class Points, class Triangles>
concept ReadableSoup =
    std::ranges::input_range<const Points> && std::ranges::input_range<const Triangles> &&
    std::ranges::random_access_range<std::ranges::range_reference_t<const Triangles>>;

/// The corners of a face of a mesh, the face-th one, as number_of(vertex) numbers them. Throws
/// std::invalid_argument if they are not three.
template <class Mesh, class NumberOf>
std::array<Index, 3> read_face(const char* caller, const Mesh& mesh,
                               typename boost::graph_traits<Mesh>::face_descriptor f,
                               std::size_t face, NumberOf number_of) {
  const auto first = halfedge(f, mesh), second = next(first, mesh), third = next(second, mesh);
  if (next(third, mesh) != first)
    throw std::invalid_argument(
        std::string(caller) + ": face " + std::to_string(face) +
        " is not a triangle; CGAL::Polygon_mesh_processing::triangulate_faces triangulates it");
  return {number_of(target(first, mesh)), number_of(target(second, mesh)),
          number_of(target(third, mesh))};
}

/// The corners of a triangle of a soup, the face-th one. Throws std::invalid_argument if they are
/// not three, or not below `points`.
template <class Triangle>
std::array<Index, 3> read_triangle(const char* caller, const Triangle& triangle, std::size_t face,
                                   std::size_t points) {
  return read_indices(triangle, face, points, {caller}, [] {
    return " is not a triangle; CGAL::Polygon_mesh_processing::triangulate_polygons "
           "triangulates it";
  });
}

/// Throws std::length_error where indices of 32 bits do not number a surface.
inline void require_numbers(const char* caller, std::size_t points, std::size_t triangles) {
  if (points >= none || triangles >= none)
    throw std::length_error(std::string(caller) + ": " + std::to_string(points) + " points and " +
                            std::to_string(triangles) +
                            " triangles do not fit into 32-bit indices");
}

/// Returns the position of the vertex with the index `vertex`. Throws std::invalid_argument if it
/// is not finite.
template <class Point>
Vector<3> read_point(const char* caller, const Point& p, std::size_t vertex) {
  const Vector<3> position = position_of(p);
  if (!is_finite(position))
    throw std::invalid_argument(std::string(caller) + ": vertex " + std::to_string(vertex) +
                                " is not finite");
  return position;
}

/// A surface, with the numbers that its vertices and faces have in their order: a model of CGAL's
/// FaceListGraph with a vertex_point map. Throws std::invalid_argument for a face that is not a
/// triangle, and a vertex that is not finite.
template <ReadableGraph Mesh>
TriangleSoup<> read_surface(const char* caller, const Mesh& mesh) {
  TriangleSoup<> surface;
  const auto points = get(CGAL::vertex_point, mesh);
  const auto number = get(CGAL::dynamic_vertex_property_t<Index>(), mesh);
  for (const auto v : vertices(mesh)) {
    put(number, v, static_cast<Index>(surface.points.size()));
    surface.points.push_back(read_point(caller, get(points, v), surface.points.size()));
  }
  for (const auto f : faces(mesh))
    surface.triangles.push_back(read_face(caller, mesh, f, surface.triangles.size(),
                                          [&](auto v) { return get(number, v); }));
  require_numbers(caller, surface.points.size(), surface.triangles.size());
  return surface;
}

/// A polygon soup. Throws std::invalid_argument also for a triangle that names a point which is not
/// there.
template <class Points, class Triangles>
requires ReadableSoup<Points, Triangles> TriangleSoup<>
read_surface(const char* caller, const Points& points, const Triangles& triangles) {
  TriangleSoup<> surface;
  for (const auto& p : points)
    surface.points.push_back(read_point(caller, p, surface.points.size()));
  for (const auto& triangle : triangles)
    surface.triangles.push_back(
        read_triangle(caller, triangle, surface.triangles.size(), surface.points.size()));
  require_numbers(caller, surface.points.size(), surface.triangles.size());
  return surface;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_BASE_READ_SURFACE_H
