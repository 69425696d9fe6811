// The option join_gaps of the interface without templates: all that the soup has follows.

#include "soups.h"

#include <quadrille/compiled.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace quadrille;
using test::Soup;

SoupPoints arrays_of(const Soup& soup) {
  SoupPoints points;
  for (const auto& p : soup.points)
    points.push_back(p.coordinates);
  return points;
}

auto topology_of(const SoupResult& result) {
  Soup soup{{}, result.triangles};
  for (const auto& p : result.points)
    soup.points.push_back({p});
  return test::topology_of(soup);
}

Soup two_cubes(int n, const test::Position& shift) {
  return test::joined(test::cube(n), test::cube(n), shift);
}

/// Two cubes with the height y as a value of points, of corners with seams along all edges, and of
/// corners without seams, and a label for each cube.
struct LabelledCubes {
  SoupPoints points;
  SoupTriangles triangles, own_corners;
  std::vector<double> values, own_values;
  std::vector<std::uint32_t> labels;

  explicit LabelledCubes(const Soup& soup) : points(arrays_of(soup)), triangles(soup.triangles) {
    for (const auto& p : points)
      values.push_back(p[1]);
    for (std::size_t face = 0; face < triangles.size(); ++face) {
      labels.push_back(face < triangles.size() / 2 ? 1 : 2);
      auto& corners = own_corners.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) {
        corners[i] = static_cast<std::uint32_t>(own_values.size());
        own_values.push_back(points[triangles[face][i]][1]);
      }
    }
  }

  SoupView view() const {
    SoupChannelView channel{
        .kind = SoupChannelView::Kind::attributes, .components = 1, .values = values};
    SoupView soup{points, triangles, labels, {channel}};
    channel.triangles = triangles;
    soup.channels.push_back(channel);
    channel.values = own_values;
    channel.triangles = own_corners;
    soup.channels.push_back(channel);
    return soup;
  }
};

/// At a bridge, a corner at one side may have a value of the other side.
void require_heights(const SoupResult& result, double margin, double margin_at_bridge) {
  for (const auto& triangle : result.triangles) {
    const auto face = static_cast<std::size_t>(&triangle - result.triangles.data());
    const auto is_left = [&](std::uint32_t v) { return result.points[v][0] <= 1.02; };
    const bool is_bridge = is_left(triangle[0]) != is_left(triangle[1]) ||
                           is_left(triangle[0]) != is_left(triangle[2]);
    for (std::size_t i = 0; i < 3; ++i) {
      const double y = result.points[triangle[i]][1];
      CHECK(result.channels[0].values[triangle[i]] == Approx(y).margin(margin));
      for (std::size_t c = 1; c < 3; ++c)
        CHECK(result.channels[c].values[result.channels[c].triangles[face][i]] ==
              Approx(y).margin(is_bridge ? margin_at_bridge : margin));
    }
  }
}

} // namespace

TEST_CASE("Values, labels and maps follow the joins") {
  const LabelledCubes cubes(two_cubes(6, {{1.05, 0, 0}}));
  const SoupResult result = simplified_soup(cubes.view(), {.faces = 100, .join_gaps = 0.1});
  CHECK(result.report.joined_gaps == 1);
  CHECK(result.report.open_gaps == 0);
  CHECK(result.report.components_before == 2);
  CHECK(result.report.components_after == 1);
  CHECK(result.report.faces_before == cubes.triangles.size());
  CHECK(result.report.vertices_before == cubes.points.size());
  CHECK(result.triangles.size() == 100);
  const auto topology = topology_of(result);
  CHECK(topology.is_closed());
  CHECK(topology.is_manifold);
  CHECK(topology.components == 1);
  CHECK(topology.genus() == 0);
  CHECK(std::set(result.labels.begin(), result.labels.end()) == std::set<std::uint32_t>{1, 2});
  for (std::size_t face = 0; face < result.triangles.size(); ++face)
    CHECK(result.labels[face] == cubes.labels[result.input_faces[face]]);
  REQUIRE(result.vertex_map.size() == cubes.points.size());
  for (std::size_t v = 0; v < cubes.points.size(); ++v) // the middle of a wall that has gone
    if (const auto& [x, y, z] = cubes.points[v]; (x == 1 || x == 1.05) && y == 0.5 && z == 0.5)
      CHECK(result.vertex_map[v] >= result.points.size());
  require_heights(result, 0.17, 0.17);
}

TEST_CASE("Values of points that are added where a large face is near in part lie between others") {
  const LabelledCubes cubes(two_cubes(1, {{1.05, 0.3, 0.41}}));
  const SoupResult result = simplified_soup(cubes.view(), {.faces = 100000, .join_gaps = 0.1});
  CHECK(result.report.joined_gaps == 1);
  CHECK(result.triangles.size() > 100);
  require_heights(result, 1e-12, 0.15);
}

TEST_CASE("Gaps stay at fixed points and at triangles that are not selected") {
  const LabelledCubes cubes(two_cubes(4, {{1.05, 0, 0}}));
  SoupOptions options{.faces = 80, .join_gaps = 0.1};
  options.importance.assign(cubes.points.size(), 1.);
  options.tolerance.assign(cubes.points.size(), 0.2);
  CHECK(simplified_soup(cubes.view(), options).report.joined_gaps == 1);
  options.fixed.assign(cubes.points.size(), true);
  CHECK(simplified_soup(cubes.view(), options).report.joined_gaps == 0);
  options.fixed.clear();
  options.selected.assign(cubes.triangles.size(), true);
  for (std::size_t face = 0; face < cubes.triangles.size() / 2; ++face)
    options.selected[face] = false;
  CHECK(simplified_soup(cubes.view(), options).report.joined_gaps == 0);
}

TEST_CASE("A soup is made manifold before gaps are joined, and handles are cut after that") {
  // Two blocks that touch at an edge, and a plate with a narrow tunnel beside one of them.
  const Soup input = test::surface_of_cubes(14, 9, 6, [](int x, int y, int) {
    return (x < 4 && y < 4) || (x >= 4 && x < 8 && y >= 4 && y < 8) ||
           (x >= 9 && x < 13 && y >= 3 && !(x == 10 && y == 5));
  });
  const SoupResult result =
      simplified_soup({arrays_of(input), input.triangles},
                      {.faces = 150, .manifold = true, .join_gaps = 1, .simplified_topology = 1.5});
  CHECK(result.report.joined_gaps == 1);
  CHECK(result.report.open_gaps == 1); // at the edge
  CHECK(result.report.cut_handles == 1);
  CHECK(topology_of(result).components == 2);
  CHECK(topology_of(result).genus() == 0);
}

TEST_CASE("Joins reject what joins, too") {
  const Soup input = two_cubes(1, {{1.05, 0, 0}});
  const SoupPoints points = arrays_of(input);
  CHECK_THROWS_WITH(
      simplified_soup({points, input.triangles}, {.topology = Topology::free, .join_gaps = 1}),
      Catch::Contains("join_gaps") && Catch::Contains("free topology"));
  CHECK_THROWS_WITH(simplified_soup({points, input.triangles}, {.join_gaps = -1}),
                    Catch::Contains("is no length"));
}
