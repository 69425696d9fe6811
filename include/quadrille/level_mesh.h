#ifndef QUADRILLE_LEVEL_MESH_H
#define QUADRILLE_LEVEL_MESH_H

#include <quadrille/internal/core/adapter/face_linker.h>
#include <quadrille/internal/core/adapter/umbrellas.h>
#include <quadrille/internal/core/base/points.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/levels.h>
#include <quadrille/quadric_form.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <vector>

namespace quadrille {

/// Converts a level to a mesh, whose former contents are removed. `mesh` models CGAL's
/// MutableFaceGraph. Its vertices and faces are in the order of the level's points and triangles;
/// where the level is not manifold, vertices are duplicated and follow after these. Returns the
/// level's point for each vertex of the mesh, in this order. It takes linear time.
template <class Mesh>
std::vector<std::uint32_t> to_mesh(const Level& level, Mesh& mesh) {
  using Traits = boost::graph_traits<Mesh>;
  using Halfedge = typename Traits::halfedge_descriptor;
  using internal::Index;
  internal::Array<internal::Side> sides;
  for (const auto& [a, b, c] : level.triangles)
    for (const internal::Side& side : {internal::Side{c, a}, {a, b}, {b, c}})
      sides.push_back(side);
  internal::Umbrellas umbrellas;
  umbrellas.build(sides, level.points.size(), [](Index, Index) { return true; });

  std::vector<std::uint32_t> points_of_vertices(level.points.size());
  for (std::uint32_t v = 0; v < points_of_vertices.size(); ++v)
    points_of_vertices[v] = v;
  for (Index duplicated : umbrellas.duplicates())
    points_of_vertices.push_back(duplicated);

  CGAL::clear(mesh);
  auto points = get(CGAL::vertex_point, mesh);
  using Point = typename boost::property_traits<decltype(points)>::value_type;
  std::vector<typename Traits::vertex_descriptor> vertices;
  for (std::uint32_t v : points_of_vertices) {
    vertices.push_back(add_vertex(mesh));
    put(points, vertices.back(), internal::point_at<Point>(Vector<3>{level.points[v]}));
  }
  internal::Array<typename Traits::face_descriptor> faces;
  for (std::size_t f = 0; f < level.triangles.size(); ++f)
    faces.push_back(add_face(mesh));
  internal::Array<Halfedge> halfedges;
  for (Index side = 0; side < sides.size(); ++side) {
    const Index mate = umbrellas.mate(side);
    halfedges.push_back(mate != internal::none && mate < side ? opposite(halfedges[mate], mesh)
                                                              : halfedge(add_edge(mesh), mesh));
  }
  internal::Array<typename Traits::edge_descriptor> others(num_edges(mesh));
  internal::FaceLinker<Mesh>(mesh, umbrellas, faces, halfedges)
      .link([&](Index corner) { return vertices[umbrellas.vertex(corner)]; }, others);
  return points_of_vertices;
}

} // namespace quadrille

#endif // QUADRILLE_LEVEL_MESH_H
