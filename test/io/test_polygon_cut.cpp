// Polygons of files, which become triangles.
#include <quadrille/internal/core/surface/polygon_cut.h>

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

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

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

TEST_CASE("Polygons are covered once, convex or not") {
  std::mt19937_64 generator(1);
  for (const double depth : {0.0, 0.5, 0.95})
    for (std::size_t corners = 5; corners < 40; ++corners) {
      INFO(corners << " corners, depth " << depth);
      std::vector<Vector<3>> polygon = star(corners, depth, generator);
      for (const double side : {1.0, -1.0}) {
        Vector<3> outline{}, covered{};
        for (std::size_t i = 0; i < corners; ++i)
          outline =
              outline + cross(polygon[i] - polygon[0], polygon[(i + 1) % corners] - polygon[0]);
        std::uint64_t fans = 0;
        const Triangles triangles = PolygonCut::triangles(polygon, &fans);
        CHECK(triangles.size() == corners - 2);
        CHECK(fans == 0);
        for (const auto& [a, b, c] : triangles) {
          const Vector<3> area = cross(polygon[b] - polygon[a], polygon[c] - polygon[a]);
          CHECK(side * area[2] > 0);
          covered = covered + area;
        }
        CHECK(covered[2] == Approx(outline[2]));
        std::reverse(polygon.begin(), polygon.end());
      }
    }
}

TEST_CASE("A polygon of 20,000 corners takes no longer than it must") {
  std::mt19937_64 generator(2);
  std::uint64_t fans = 0;
  CHECK(PolygonCut::triangles(star(20'000, 0.3, generator), &fans).size() == 19'998);
  CHECK(fans == 0);
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
