// Polygons of files that are read by parts, against those that are read into memory.
#include "../../examples/products/mesh_io/mesh/triangulate.h"

#include <quadrille/internal/file/polygon_cut.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace {

using quadrille::Vector;
using quadrille::internal::PolygonCut;
using quadrille_examples::Point;
using quadrille_examples::PolygonTriangulation;

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

// In an order of their own, from the least corner on.
Triangles sorted(Triangles triangles) {
  for (auto& t : triangles)
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

Triangles in_memory(const std::vector<Vector<3>>& corners) {
  std::vector<Point> points;
  for (const Vector<3>& p : corners)
    points.emplace_back(p[0], p[1], p[2]);
  Triangles triangles;
  REQUIRE(PolygonTriangulation(points).append_to(triangles));
  return triangles;
}

/// Around a center, on a plane that is tilted and not quite flat.
std::vector<Vector<3>> star(std::size_t corners, double depth, std::mt19937_64& generator) {
  std::uniform_real_distribution<double> random(0, 1);
  std::vector<Vector<3>> result;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = 6.283185307 * (static_cast<double>(i) + 0.8 * random(generator)) /
                         static_cast<double>(corners);
    const double radius = 1 - depth * random(generator);
    const double x = radius * std::cos(angle), y = radius * std::sin(angle);
    result.push_back({{1e3 + x, 2 * y, 0.7 * x + 0.2 * y + 0.01 * random(generator)}});
  }
  return result;
}

} // namespace

TEST_CASE("Polygons are cut as in memory, convex or not") {
  std::mt19937_64 generator(1);
  for (const double depth : {0.0, 0.5, 0.95})
    for (std::size_t corners = 4; corners < 40; ++corners) {
      INFO(corners << " corners, depth " << depth);
      std::vector<Vector<3>> polygon = star(corners, depth, generator);
      CHECK(sorted(PolygonCut::triangles(polygon)) == sorted(in_memory(polygon)));
      std::reverse(polygon.begin(), polygon.end());
      CHECK(sorted(PolygonCut::triangles(polygon)) == sorted(in_memory(polygon)));
    }
}

TEST_CASE("Corners on a line make no triangle without area") {
  const std::vector<Vector<3>> polygon{{{0, 0, 0}}, {{1, 0, 0}}, {{2, 0, 0}}, {{3, 0, 0}},
                                       {{3, 1, 0}}, {{3, 2, 0}}, {{0, 2, 0}}};
  const Triangles triangles = PolygonCut::triangles(polygon);
  REQUIRE(triangles.size() == 5);
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const double area = cross(polygon[b] - polygon[a], polygon[c] - polygon[a])[2] / 2;
    CHECK(area > 0);
    sum += area;
  }
  CHECK(sum == Approx(6));
}

TEST_CASE("What crosses itself, is flat or is no number becomes a fan") {
  const Triangles fan{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
  CHECK(PolygonCut::triangles({{{0, 0, 0}}, {{4, 0, 0}}, {{1, 3, 0}}, {{2, -2, 0}}, {{3, 3, 0}}}) ==
        fan);
  CHECK(PolygonCut::triangles({{{0, 0, 0}}, {{1, 0, 0}}, {{2, 0, 0}}, {{3, 0, 0}}, {{4, 0, 0}}}) ==
        fan);
  CHECK(PolygonCut::triangles(
            {{{0, 0, 0}}, {{NAN, 0, 0}}, {{2, 1, 0}}, {{1, 3, 0}}, {{0, 1, 0}}}) == fan);
}
