// Lines along which three sheets or more meet: where topology is kept they are simplified along
// themselves.

#include "meshes.h"
#include "soups.h"

#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <vector>

namespace {

using namespace quadrille;
using test::PointSoup;
using test::Position;
using test::Soup;

/// Sheets of n × n squares that meet along one line, x = bend · sin(πz), y = 0.
Soup sheets_at_a_line(std::uint32_t sheets, std::uint32_t n, double bend) {
  Soup soup;
  const auto at = [&](std::uint32_t sheet, std::uint32_t i, std::uint32_t j) {
    const double angle = 2 * std::numbers::pi * sheet / sheets, r = double(i) / n,
                 z = double(j) / n;
    return Position{
        {r * std::cos(angle) + bend * std::sin(std::numbers::pi * z), r * std::sin(angle), z}};
  };
  for (std::uint32_t j = 0; j <= n; ++j)
    soup.points.push_back(at(0, 0, j));
  for (std::uint32_t sheet = 0; sheet < sheets; ++sheet) {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (std::uint32_t i = 1; i <= n; ++i)
      for (std::uint32_t j = 0; j <= n; ++j)
        soup.points.push_back(at(sheet, i, j));
    const auto number = [&](std::uint32_t i, std::uint32_t j) {
      return i == 0 ? j : first + (i - 1) * (n + 1) + j;
    };
    for (std::uint32_t i = 0; i < n; ++i)
      for (std::uint32_t j = 0; j < n; ++j) {
        soup.triangles.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1)});
        soup.triangles.push_back({number(i, j), number(i + 1, j + 1), number(i, j + 1)});
      }
  }
  return soup;
}

/// How many faces the edges have that are not on borders: 2 inside of a sheet.
std::map<std::array<std::uint32_t, 2>, std::size_t> edges_of(const Soup& soup) {
  std::map<std::array<std::uint32_t, 2>, std::size_t> edges;
  for (const auto& t : soup.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      ++edges[{std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])}];
  return edges;
}

/// The places along the line, in order of z, if its edges are one path of so many sheets each.
std::vector<Position> line_of(const Soup& soup, std::size_t sheets) {
  std::map<std::uint32_t, std::size_t> degree;
  std::size_t count = 0;
  for (const auto& [edge, faces] : edges_of(soup)) {
    if (faces <= 2)
      continue;
    CHECK(faces == sheets);
    ++degree[edge[0]], ++degree[edge[1]], ++count;
  }
  CHECK(degree.size() == count + 1);
  std::vector<Position> line;
  std::size_t ends = 0;
  for (const auto& [v, of_v] : degree) {
    CHECK(of_v <= 2);
    ends += of_v == 1;
    line.push_back(soup.points[v]);
  }
  CHECK(ends == 2);
  std::sort(line.begin(), line.end(), [](const auto& p, const auto& q) { return p[2] < q[2]; });
  return line;
}

/// No two edges are of the same cost.
Soup roughened(Soup soup) {
  test::Random random(1);
  for (Position& p : soup.points)
    for (std::size_t i = 0; i < 3; ++i)
      p[i] += random(0, 0.01);
  return soup;
}

/// Vertices and faces are counted backwards, and in other steps.
Soup renumbered(const Soup& soup, std::uint32_t step) {
  const auto n = static_cast<std::uint32_t>(soup.points.size());
  const auto number = [&](std::uint32_t v) { return (n - 1 - v) * step % n; };
  Soup result = soup;
  for (std::uint32_t v = 0; v < n; ++v)
    result.points[number(v)] = soup.points[v];
  for (test::Triangle& t : result.triangles)
    t = {number(t[0]), number(t[1]), number(t[2])};
  std::reverse(result.triangles.begin(), result.triangles.end());
  return result;
}

/// The corners of all faces, in order.
std::vector<Position> places_of(const Soup& soup) {
  std::vector<Position> places;
  for (const test::Triangle& t : soup.triangles)
    for (const std::uint32_t v : t)
      places.push_back(soup.points[v]);
  std::sort(places.begin(), places.end(),
            [](const Position& p, const Position& q) { return p.coordinates < q.coordinates; });
  return places;
}

template <class... Arguments>
Soup simplified(const Soup& input, const Arguments&... arguments) {
  PointSoup soup(input);
  const Report report = simplify(soup.points, soup.triangles, Topology::kept, arguments...);
  CHECK(is_target_reached(report.stop));
  Soup result{{}, soup.triangles};
  for (const auto& p : soup.points)
    result.points.push_back({{p.x(), p.y(), p.z()}});
  return result;
}

} // namespace

TEMPLATE_TEST_CASE("Straight walls at a line go down to two faces each, without loss", "", Quadric,
                   MemorylessQuadric, ThinFeatureQuadric) {
  for (std::uint32_t sheets : {3u, 4u, 5u}) {
    CAPTURE(sheets);
    const Soup input = sheets_at_a_line(sheets, 12, 0);
    const Soup result = simplified(input, TestType{}, FaceCount{2 * sheets});
    CHECK(result.triangles.size() == 2 * sheets);
    CHECK(result.points.size() == 2 * sheets + 2);
    const std::vector<Position> line = line_of(result, sheets);
    REQUIRE(line.size() == 2);
    CHECK(line[0] == Position{});
    CHECK(line[1] == Position{{0, 0, 1}});
    double area = 0;
    for (const test::Triangle& t : result.triangles)
      area += std::sqrt(squared_length(test::area_vector(result, t)));
    CHECK(area == Approx(sheets));
    for (const Position& p : result.points) // the corners of the walls
      CHECK(std::abs(std::hypot(p[0], p[1]) - 0.5) == Approx(0.5));
  }
}

TEMPLATE_TEST_CASE("A bent line keeps its shape, its ends and its sheets", "", Quadric,
                   MemorylessQuadric, ThinFeatureQuadric) {
  for (std::uint32_t sheets : {3u, 4u}) {
    const Soup input = sheets_at_a_line(sheets, 24, 0.3);
    for (bool is_relaxed : {false, true}) {
      CAPTURE(sheets, is_relaxed);
      const Soup result = is_relaxed
                              ? simplified(input, TestType{}, FaceRatio{0.02}, RelaxedOrder{})
                              : simplified(input, TestType{}, FaceRatio{0.02});
      const std::vector<Position> line = line_of(result, sheets);
      CHECK(line.size() < 16); // of 25
      CHECK(line.size() > 2);
      CHECK(squared_distance(line.front(), Position{}) < 1e-6);
      CHECK(squared_distance(line.back(), Position{{0, 0, 1}}) < 1e-6);
      for (const Position& p : line) {
        CHECK(p[0] == Approx(0.3 * std::sin(std::numbers::pi * p[2])).margin(0.02));
        CHECK(std::abs(p[1]) < 0.005);
      }
      CHECK(test::topology_of(result).components == 1);
    }
  }
}

TEMPLATE_TEST_CASE("Numbers of vertices and faces do not matter at a line", "", Quadric,
                   MemorylessQuadric) {
  for (std::uint32_t sheets : {3u, 4u, 5u}) {
    CAPTURE(sheets);
    const Soup input = roughened(sheets_at_a_line(sheets, 15, 0.3));
    const auto places = places_of(simplified(input, TestType{}, FaceRatio{0.1}));
    for (const std::uint32_t step : {1u, 17u, 101u}) { // none has a factor in common with n
      const auto others =
          places_of(simplified(renumbered(input, step), TestType{}, FaceRatio{0.1}));
      REQUIRE(others.size() == places.size());
      for (std::size_t i = 0; i < places.size(); ++i)
        CHECK(squared_distance(places[i], others[i]) < 1e-20);
    }
  }
}
