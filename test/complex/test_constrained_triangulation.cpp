// The library's constrained Delaunay triangulation, against CGAL's.
#include <quadrille/internal/core/surface/constrained_triangulation.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace {

using quadrille::internal::ConstrainedTriangulation;
using quadrille::internal::Index;

using Point = ConstrainedTriangulation::Point;
using Points = std::vector<Point>;
using Lines = std::vector<std::pair<Index, Index>>;
using Triangles = std::set<std::array<Index, 3>>;

// From the least corner on.
std::array<Index, 3> turned(std::array<Index, 3> t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

// Nothing where there is no triangulation with these lines as edges.
std::optional<Triangles> own(const Points& points, const Lines& lines) {
  ConstrainedTriangulation triangulation;
  if (!triangulation.insert(points))
    return std::nullopt;
  for (const auto& [a, b] : lines)
    if (!triangulation.constrain(a, b))
      return std::nullopt;
  Triangles result;
  for (const auto& t : triangulation.triangles())
    if (!t.is_infinite())
      result.insert(turned(t.corners));
  return result;
}

std::optional<Triangles> of_cgal(const Points& points, const Lines& lines) {
  using Kernel = ConstrainedTriangulation::Kernel;
  using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
      Kernel,
      CGAL::Triangulation_data_structure_2<
          CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>,
          CGAL::Constrained_triangulation_face_base_2<Kernel>>,
      CGAL::No_constraint_intersection_requiring_constructions_tag>;
  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> vertices;
  for (const Point& point : points) {
    vertices.push_back(triangulation.insert(point));
    vertices.back()->info() = static_cast<Index>(vertices.size() - 1);
  }
  if (triangulation.dimension() != 2 || triangulation.number_of_vertices() != points.size())
    return std::nullopt;
  try {
    for (const auto& [a, b] : lines) {
      if (a == b)
        return std::nullopt;
      triangulation.insert_constraint(vertices[a], vertices[b]);
      if (!triangulation.is_edge(vertices[a], vertices[b]))
        return std::nullopt;
    }
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    return std::nullopt;
  }
  Triangles result;
  for (const auto face : triangulation.finite_face_handles())
    result.insert(
        turned({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()}));
  return result;
}

} // namespace

TEST_CASE("Points on a grid have the triangles that CGAL gives them, and so do others") {
  std::mt19937_64 generator(1);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(generator() % n); };
  std::size_t refused = 0, made = 0;
  for (int trial = 0; trial < 600; ++trial) {
    const std::size_t size = std::array{5u, 30u, 1'000'000u}[static_cast<std::size_t>(trial % 3)];
    const std::size_t count = 1 + below(trial % 10 == 0 ? 120 : 16);
    Points points; // of a small grid, many lie on lines and on circles; some coincide
    std::set<std::pair<std::size_t, std::size_t>> taken;
    for (std::size_t i = 0; i < count; ++i)
      if (const auto x = below(size), y = below(size);
          taken.insert({x, y}).second || (trial % 50 == 0 && below(20) == 0))
        points.emplace_back(0.1 * static_cast<double>(x), 0.1 * static_cast<double>(y));
    Lines lines;
    for (std::size_t i = below(6); i > 0; --i)
      lines.emplace_back(below(points.size()), below(points.size()));
    const auto expected = of_cgal(points, lines);
    CAPTURE(trial);
    CHECK(own(points, lines) == expected);
    ++(expected ? made : refused);
  }
  CHECK(made > 200);
  CHECK(refused > 100);
}

TEST_CASE("Few points, points on a line and points at one place have no triangulation") {
  CHECK_FALSE(own({}, {}));
  CHECK_FALSE(own({{0, 0}}, {}));
  CHECK_FALSE(own({{0, 0}, {1, 1}}, {}));
  CHECK_FALSE(own({{0, 0}, {1, 1}, {3, 3}, {2, 2}}, {}));
  CHECK_FALSE(own({{0, 0}, {1, 0}, {0, 1}, {1, 0}}, {}));
  CHECK(own({{0, 0}, {0, 0.5}, {0, 1}, {1, 0}}, {}) ==
        of_cgal({{0, 0}, {0, 0.5}, {0, 1}, {1, 0}}, {}));
}
