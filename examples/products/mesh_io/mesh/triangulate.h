#ifndef QUADRILLE_EXAMPLES_MESH_IO_TRIANGULATE_H
#define QUADRILLE_EXAMPLES_MESH_IO_TRIANGULATE_H

#include "indexed_mesh.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// Cuts one polygon, convex or not, into triangles. A quadrilateral, which need not be flat, is cut
/// along the diagonal that folds it less; a larger polygon by a constrained Delaunay triangulation
/// in the coordinate plane that it faces most. The triangles are of corner numbers.
class PolygonTriangulation {
public:
  using Triangle = std::array<std::uint32_t, 3>;

  /// The polygon has three corners or more.
  explicit PolygonTriangulation(const std::vector<Point>& corners) : outline_(outline(corners)) {}

  /// Appends the triangles; false if the projected outline crosses or touches itself, or is flat,
  /// so that there is no telling inside from outside.
  bool append_to(std::vector<Triangle>& triangles) const {
    if (outline_.size() == 4)
      return append_quadrilateral(triangles);
    Triangulation triangulation;
    try {
      if (!insert(project(outline_), triangulation))
        return false;
    } catch (const Triangulation::Intersection_of_constraints_exception&) {
      return false;
    }
    mark_outside(triangulation);
    return append_inside(triangulation, triangles);
  }

private:
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
  using FaceInfo = CGAL::Triangulation_face_base_with_info_2<bool, Kernel>; // lies outside?
  using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, FaceInfo>;
  using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
  using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
      Kernel, Structure, CGAL::No_constraint_intersection_requiring_constructions_tag>;

  /// The corners, moved to the origin and scaled by a power of two to a size of about one, so that
  /// no area over- or underflows.
  static std::vector<Point> outline(const std::vector<Point>& corners) {
    const Point& origin = corners[0];
    double size = 0;
    for (const Point& p : corners)
      for (int axis = 0; axis < 3; ++axis)
        size = std::max(size, std::abs(p[axis] - origin[axis]));
    const int exponent = size > 0 && std::isfinite(size) ? -std::ilogb(size) : 0;
    const auto local = [&](const Point& p, int axis) {
      return std::scalbn(p[axis] - origin[axis], exponent);
    };
    std::vector<Point> result;
    for (const Point& p : corners)
      result.emplace_back(local(p, 0), local(p, 1), local(p, 2));
    return result;
  }

  /// The product of the normals is the larger, the flatter the pair of triangles and the better
  /// their shapes; it is negative for the diagonal outside of a quadrilateral that is not convex.
  bool append_quadrilateral(std::vector<Triangle>& triangles) const {
    const auto normal = [this](std::size_t a, std::size_t b, std::size_t c) {
      return CGAL::cross_product(outline_[b] - outline_[a], outline_[c] - outline_[a]);
    };
    if (normal(0, 1, 2) * normal(0, 2, 3) >= normal(1, 2, 3) * normal(1, 3, 0))
      triangles.insert(triangles.end(), {{0, 1, 2}, {0, 2, 3}});
    else
      triangles.insert(triangles.end(), {{1, 2, 3}, {1, 3, 0}});
    return true;
  }

  /// Along the axis that is closest to the normal, and so that the outline runs counter-clockwise.
  static std::vector<Kernel::Point_2> project(const std::vector<Point>& outline) {
    CGAL::Simple_cartesian<double>::Vector_3 normal = CGAL::NULL_VECTOR; // Newell's
    for (std::size_t i = 0; i < outline.size(); ++i)
      normal += CGAL::cross_product(outline[i] - CGAL::ORIGIN,
                                    outline[(i + 1) % outline.size()] - CGAL::ORIGIN);
    int along = 0;
    for (int axis = 1; axis < 3; ++axis)
      along = std::abs(normal[axis]) > std::abs(normal[along]) ? axis : along;
    const int turn = normal[along] < 0 ? 2 : 1;
    std::vector<Kernel::Point_2> result;
    for (const Point& p : outline)
      result.emplace_back(p[(along + turn) % 3], p[(along + 2 * turn) % 3]);
    return result;
  }

  /// All points before the outline, so that they go in by a spatial sort. False if two coincide.
  static bool insert(const std::vector<Kernel::Point_2>& outline, Triangulation& triangulation) {
    std::vector<std::pair<Kernel::Point_2, std::uint32_t>> numbered;
    for (const Kernel::Point_2& point : outline)
      numbered.emplace_back(point, static_cast<std::uint32_t>(numbered.size()));
    triangulation.insert(numbered.begin(), numbered.end());
    if (triangulation.number_of_vertices() < outline.size())
      return false;
    std::vector<Triangulation::Vertex_handle> vertices(outline.size());
    for (const auto vertex : triangulation.finite_vertex_handles())
      vertices[vertex->info()] = vertex;
    for (std::size_t i = 0; i < vertices.size(); ++i)
      triangulation.insert_constraint(vertices[i], vertices[(i + 1) % vertices.size()]);
    return triangulation.dimension() == 2;
  }

  /// Everything that can be reached from infinity without crossing the outline.
  static void mark_outside(Triangulation& triangulation) {
    for (const auto face : triangulation.all_face_handles())
      face->info() = false;
    std::vector<Triangulation::Face_handle> reached = {triangulation.infinite_face()};
    while (!reached.empty()) {
      const Triangulation::Face_handle face = reached.back();
      reached.pop_back();
      if (std::exchange(face->info(), true))
        continue;
      for (int i = 0; i < 3; ++i)
        if (!face->is_constrained(i))
          reached.push_back(face->neighbor(i));
    }
  }

  bool append_inside(const Triangulation& triangulation, std::vector<Triangle>& triangles) const {
    const std::size_t before = triangles.size();
    const auto corner = [](const auto face, int i) { return face->vertex(i)->info(); };
    for (const auto face : triangulation.finite_face_handles())
      if (!face->info())
        triangles.push_back({corner(face, 0), corner(face, 1), corner(face, 2)});
    if (triangles.size() - before == outline_.size() - 2)
      return true;
    triangles.resize(before);
    return false;
  }

  std::vector<Point> outline_;
};

} // namespace quadrille_examples

#endif
