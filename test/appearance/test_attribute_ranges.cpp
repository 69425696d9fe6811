// What is written back stays in the range of its type: colours, integers, normals.
#include "meshes.h"
#include "soups.h"

#include <CGAL/Simple_cartesian.h>
#include <quadrille/attribute_quadric.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace {

using namespace quadrille;
using test::Point;
using test::points_of;
using test::Position;
using test::Soup;

// A wavy sheet, of which half is of one colour and half of another: the best colour of a vertex at
// the step lies beyond both.
Soup wavy_sheet() {
  return test::mapped(test::grid(40, 40), [](const Position& p) {
    return Position{{p[0], p[1], 0.05 * std::sin(9 * p[0]) * std::cos(7 * p[1])}};
  });
}

template <class T>
std::vector<std::array<T, 3>> two_colors(const std::vector<Point>& points, T low, T high) {
  std::vector<std::array<T, 3>> colors;
  for (const Point& p : points) {
    const bool is_left = p.x() + 0.3 * std::sin(20 * p.y()) < 0.5;
    colors.push_back({is_left ? low : high, is_left ? high : low, low});
  }
  return colors;
}

// What is left of the colours of the sheet, of `low` and `high`.
std::vector<std::array<double, 3>> simplified_colors(double low, double high) {
  Soup soup = wavy_sheet();
  std::vector<Point> points = points_of(soup);
  auto colors = two_colors(points, low, high);
  simplify<ColorQuadric, OptimalPlacement>(
      points, soup.triangles, FaceRatio{0.05},
      CGAL::parameters::vertex_color_map(CGAL::make_property_map(colors)));
  colors.resize(points.size());
  return colors;
}

} // namespace

TEST_CASE("Colours stay between the least and the greatest") {
  std::size_t at_the_end = 0;
  for (const auto& color : simplified_colors(0, 1))
    for (double x : color) {
      CHECK(x >= 0);
      CHECK(x <= 1);
      at_the_end += x == 1;
    }
  CHECK(at_the_end > 0);
}

TEST_CASE("Colours of any other range stay in that") {
  for (const auto& color : simplified_colors(5, 10))
    for (double x : color) {
      CHECK(x >= 5);
      CHECK(x <= 10);
    }
}

TEST_CASE("Colours of eight bits do not wrap around") {
  Soup soup = wavy_sheet();
  std::vector<Point> points = points_of(soup);
  std::vector<Point> same = points;
  auto triangles = soup.triangles;
  auto bytes = two_colors<std::uint8_t>(points, 0, 255);
  auto numbers = two_colors<double>(points, 0, 255);
  const auto run = [](auto& p, auto& t, auto& c) {
    simplify<ColorQuadric, OptimalPlacement>(
        p, t, FaceRatio{0.05}, CGAL::parameters::vertex_color_map(CGAL::make_property_map(c)));
  };
  run(points, soup.triangles, bytes);
  run(same, triangles, numbers);
  REQUIRE(points.size() == same.size());
  for (std::size_t v = 0; v < points.size(); ++v)
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(std::abs(bytes[v][i] - numbers[v][i]) <= 0.5);
}

TEST_CASE("Numbers without a kind keep to the range of their type alone") {
  Soup soup = wavy_sheet();
  std::vector<Point> points = points_of(soup);
  auto values = two_colors<std::int8_t>(points, -128, 127);
  simplify<AttributeQuadric<3>, OptimalPlacement>(
      points, soup.triangles, FaceRatio{0.05},
      quadrille::parameters::vertex_attribute_map(CGAL::make_property_map(values)));
  std::size_t wrong = 0; // the third attribute is the same everywhere
  for (std::size_t v = 0; v < points.size(); ++v)
    wrong += values[v][2] > -120;
  CHECK(wrong == 0);
}

TEST_CASE("Normals have length 1") {
  Soup soup = test::sphere(5);
  std::vector<Point> points = points_of(soup);
  std::vector<CGAL::Simple_cartesian<double>::Vector_3> normals;
  for (const Point& p : points)
    normals.push_back(p - CGAL::ORIGIN);
  simplify<NormalQuadric, OptimalPlacement>(
      points, soup.triangles, FaceRatio{0.05},
      CGAL::parameters::vertex_normal_map(CGAL::make_property_map(normals)));
  for (std::size_t v = 0; v < points.size(); ++v) {
    CHECK(normals[v].squared_length() == Approx(1).epsilon(1e-12));
    CHECK(normals[v] * (points[v] - CGAL::ORIGIN) > 0.99);
  }
}

TEST_CASE("Attributes that cannot be compared with positions are refused, those that can are not") {
  const Soup ball = test::sphere(3);
  const auto simplified = [&](double scale, double low, double high,
                              const AttributeQuadric<1>& cost = {}) {
    std::vector<Point> points =
        points_of(test::mapped(ball, [&](const Position& p) { return scale * p; }));
    std::vector<double> values;
    for (std::size_t v = 0; v < points.size(); ++v)
      values.push_back(v % 2 == 0 ? low : high);
    const std::vector<double> before = values;
    auto triangles = ball.triangles;
    try {
      simplify(points, triangles, cost, FaceCount{60},
               parameters::vertex_attribute_map(CGAL::make_property_map(values)));
    } catch (const std::invalid_argument& error) {
      CHECK(values == before);
      CHECK(triangles == ball.triangles);
      CHECK_THAT(error.what(), Catch::Contains("attribute 0, from "));
      return false;
    }
    CHECK(triangles.size() <= 60);
    for (double value : values)
      CHECK(std::isfinite(value));
    return true;
  };
  CHECK(simplified(1, 0, 1e300));
  CHECK(simplified(1, -1e-290, 1e-290));
  CHECK(simplified(1e-200, 0, 255));
  CHECK(simplified(1e200, 0, 255));
  CHECK(simplified(1, 7, 7));
  CHECK_FALSE(simplified(1, -1e308, 1e308));
  CHECK_FALSE(simplified(1e-200, 0, 1e300));
  CHECK_FALSE(simplified(1, 0, 1e-320));
  CHECK_FALSE(simplified(1e-200, 1e300, 1e300));
  CHECK_FALSE(simplified(1, 0, 1, {.importance = 1e300}));
  CHECK(simplified(1, 0, 1, {.importance = 1e4}));
}

TEST_CASE("Integers of 64 bits do not wrap around") {
  const auto check = []<class Integer>(Integer low, Integer high, Integer least, Integer greatest) {
    Soup soup = wavy_sheet();
    std::vector<Point> points = points_of(soup);
    std::vector<Integer> values;
    for (const Point& p : points)
      values.push_back(p.x() + 0.3 * std::sin(20 * p.y()) < 0.5 ? low : high);
    simplify<AttributeQuadric<1>, OptimalPlacement>(
        points, soup.triangles, FaceRatio{0.05},
        parameters::vertex_attribute_map(CGAL::make_property_map(values)));
    for (std::size_t v = 0; v < points.size(); ++v) {
      CHECK(values[v] >= least);
      CHECK(values[v] <= greatest);
    }
  };
  constexpr auto top = std::numeric_limits<std::int64_t>::max();
  constexpr auto above = std::numeric_limits<std::uint64_t>::max();
  check(std::int64_t{0}, top, -top / 4, top);
  check(-top, top, -top - 1, top);
  check(above - above / 4, above, above / 2, above);
  check(std::uint64_t{0}, above, std::uint64_t{0}, above);
}
