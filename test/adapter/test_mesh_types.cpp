// Every kind of mesh, with every kernel, is simplified as any other.
#include "mesh_types.h"
#include "soups.h"

#include <catch2/catch.hpp>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_items_with_id_3.h>

#include <quadrille/distance.h>
#include <quadrille/simplify.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory_resource>
#include <type_traits>
#include <vector>

using namespace quadrille;

namespace {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using WithIds = CGAL::Polyhedron_3<Epick, CGAL::Polyhedron_items_with_id_3>;

// A point as linear algebra has them: coordinates by index, and by name to be read.
struct Vector3 {
  std::array<double, 3> coordinates;

  double& operator[](std::size_t i) { return coordinates[i]; }
  double operator[](std::size_t i) const { return coordinates[i]; }
  double x() const { return coordinates[0]; }
  double y() const { return coordinates[1]; }
  double z() const { return coordinates[2]; }
};

} // namespace

TEMPLATE_TEST_CASE("Every mesh is simplified to a valid one of as many faces", "",
                   CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>, test::Mesh,
                   CGAL::Surface_mesh<Epick::Point_3>,
                   CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>,
                   test::Polyhedron, WithIds, test::CellComplex, test::PolyMesh,
                   test::FloatPolyMesh, test::FloatTriMesh) {
  for (const test::Soup& soup : {test::random_closed(1), test::random_with_boundaries(1)}) {
    TestType mesh = test::convert<TestType>(soup);
    if constexpr (std::is_same_v<TestType, WithIds>)
      CGAL::set_halfedgeds_items_id(mesh);
    const Report report = simplify<Quadric, OptimalPlacement>(mesh, FaceRatio{0.5});
    std::size_t faces_left = 0;
    for ([[maybe_unused]] auto f : faces(mesh))
      ++faces_left;
    CHECK(faces_left == report.faces_after);
    CHECK(2 * report.faces_after <= soup.triangles.size() + 1);
    CHECK(CGAL::is_valid_polygon_mesh(mesh));
    CHECK(CGAL::is_triangle_mesh(mesh));
  }
}

TEMPLATE_TEST_CASE("Points of a soup may be three numbers by index", "", (std::array<double, 3>),
                   Vector3) {
  test::PointSoup expected(test::random_with_boundaries(1)), soup = expected;
  std::vector<TestType> points;
  for (const test::Point& p : soup.points)
    points.push_back({{p.x(), p.y(), p.z()}});
  simplify(expected.points, expected.triangles, FaceRatio{0.2});
  simplify(points, soup.triangles, FaceRatio{0.2});
  REQUIRE(points.size() == expected.points.size());
  for (std::size_t v = 0; v < points.size(); ++v)
    CHECK(test::Point(points[v][0], points[v][1], points[v][2]) == expected.points[v]);
  CHECK(soup.triangles == expected.triangles);
  const SurfaceDistance d = surface_distance(points, soup.triangles, expected.points,
                                             expected.triangles, {.samples = 1000});
  CHECK(d.hausdorff < 1e-9); // points of faces are rounded
}

TEST_CASE("Points of floats by index get the nearest floats") {
  const test::PointSoup soup(test::random_with_boundaries(1));
  std::vector<std::array<float, 3>> points;
  std::vector<test::Point> doubles;
  for (const test::Point& p : soup.points) {
    points.push_back(
        {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())});
    doubles.emplace_back(points.back()[0], points.back()[1], points.back()[2]);
  }
  auto triangles = soup.triangles, expected = triangles;
  simplify(points, triangles, FaceRatio{0.2});
  simplify(doubles, expected, FaceRatio{0.2});
  REQUIRE(points.size() == doubles.size());
  for (std::size_t v = 0; v < points.size(); ++v)
    CHECK(points[v] == std::array{static_cast<float>(doubles[v].x()),
                                  static_cast<float>(doubles[v].y()),
                                  static_cast<float>(doubles[v].z())});
}

TEST_CASE("Soups may lie in containers of any kind, with an allocator of their own") {
  const test::Soup soup = test::random_with_boundaries(1);
  test::PointSoup plain(soup);
  simplify<Quadric, OptimalPlacement>(plain.points, plain.triangles, FaceRatio{0.2});
  const auto check = [&](auto points, auto triangles) {
    for (const test::Position& p : soup.points)
      points.push_back(test::to_point<test::Point>(p));
    for (const auto& [a, b, c] : soup.triangles)
      triangles.push_back({a, b, c});
    simplify<Quadric, OptimalPlacement>(points, triangles, FaceRatio{0.2});
    REQUIRE(points.size() == plain.points.size());
    REQUIRE(triangles.size() == plain.triangles.size());
    CHECK(std::equal(points.begin(), points.end(), plain.points.begin()));
    for (std::size_t f = 0; f < triangles.size(); ++f)
      CHECK(std::equal(triangles[f].begin(), triangles[f].end(), plain.triangles[f].begin()));
  };
  std::pmr::monotonic_buffer_resource pool;
  std::pmr::unsynchronized_pool_resource other_pool;
  check(std::pmr::vector<test::Point>(&pool),
        std::pmr::vector<std::array<std::uint32_t, 3>>(&other_pool));
  check(std::pmr::vector<test::Point>(&pool),
        std::pmr::vector<std::pmr::vector<std::uint32_t>>(&pool));
  check(std::deque<test::Point>(), std::deque<std::vector<std::uint32_t>>());
}
