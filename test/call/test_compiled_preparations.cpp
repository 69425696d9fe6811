// Options of the interface without templates that prepare a soup: manifold and simplified_topology.
// All that the soup has follows.

#include "soups.h"

#include <quadrille/compiled.h>
#include <quadrille/compiled/presets.h>
#include <quadrille/compiled/voxel_lattice.h>
#include <quadrille/levels.h>
#include <quadrille/record.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
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

/// A plate with a narrow tunnel and a wide one.
Soup two_tunnels() {
  return test::surface_of_cubes(20, 16, 4, [](int x, int y, int) {
    return !(x == 4 && y == 4) && (x < 10 || x >= 15 || y < 6 || y >= 11);
  });
}

} // namespace

TEST_CASE("Values, labels and maps follow the cuts") {
  const Soup input = two_tunnels();
  const SoupPoints points = arrays_of(input);
  std::vector<double> values, corner_values;
  for (const auto& p : points)
    values.push_back(p[0]);
  SoupTriangles corners;
  std::vector<std::uint32_t> labels;
  for (const auto& t : input.triangles) {
    labels.push_back(points[t[0]][0] < 11 ? 1 : 2);
    corners.push_back(t);
  }
  SoupView soup{points, input.triangles, labels, {}};
  for (const bool has_triangles : {false, true}) {
    SoupChannelView channel{
        .kind = SoupChannelView::Kind::attributes, .components = 1, .values = values};
    if (has_triangles)
      channel.triangles = corners;
    soup.channels.push_back(channel);
  }
  const SoupResult result = simplified_soup(soup, {.faces = 120, .simplified_topology = 1.5});
  CHECK(result.report.cut_handles == 1);
  CHECK(result.report.faces_before == input.triangles.size());
  CHECK(result.report.vertices_before == points.size());
  CHECK(result.triangles.size() == 120);
  CHECK(topology_of(result).genus() == 1);
  CHECK(result.vertex_map.size() == points.size());
  for (std::size_t f = 0; f < result.triangles.size(); ++f) {
    REQUIRE(result.input_faces[f] < input.triangles.size());
    CHECK(result.labels[f] == labels[result.input_faces[f]]);
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = result.points[result.triangles[f][i]][0];
      CHECK(result.channels[0].values[result.triangles[f][i]] == Approx(x).margin(0.75));
      CHECK(result.channels[1].values[result.channels[1].triangles[f][i]] ==
            Approx(x).margin(0.75));
    }
  }
}

TEST_CASE("Options of points and triangles follow the cuts") {
  const Soup input = two_tunnels();
  const SoupPoints points = arrays_of(input);
  SoupOptions options{.faces = 60, .simplified_topology = 1.5};
  options.importance.assign(points.size(), 1.);
  options.fixed.assign(points.size(), false);
  options.selected.assign(input.triangles.size(), true);
  CHECK(simplified_soup({points, input.triangles}, options).report.cut_handles == 1);
  options.importance.clear();
  options.tolerance.assign(points.size(), 0.4);
  options.fixed.clear();
  CHECK(simplified_soup({points, input.triangles}, options).report.cut_handles == 1);
  for (std::size_t v = 0; v < points.size(); ++v)
    options.fixed.push_back(points[v][0] < 6);
  CHECK(simplified_soup({points, input.triangles}, options).report.cut_handles == 0);
}

namespace {

/// The value of each corner of each triangle, as values of their own.
SoupChannelView channel_of_corners(const SoupTriangles& triangles, std::vector<double>& values,
                                   SoupTriangles& corners, const auto& value_at) {
  for (std::uint32_t f = 0; f < triangles.size(); ++f) {
    corners.push_back({3 * f, 3 * f + 1, 3 * f + 2});
    for (const std::uint32_t v : triangles[f])
      values.push_back(value_at(f, v));
  }
  return {.kind = SoupChannelView::Kind::attributes,
          .components = 1,
          .values = values,
          .triangles = corners};
}

double linear(const std::array<double, 3>& p) {
  return p[0] + 3 * p[1] - 2 * p[2];
}

/// Have all corners the value of such a function at their points? Copies at cuts, which lie a
/// sixteenth of an edge aside, have that of their originals.
void check_linear(const SoupResult& result) {
  const SoupChannel& channel = result.channels[0];
  for (std::size_t f = 0; f < result.triangles.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(channel.values[channel.triangles[f][i]] ==
            Approx(linear(result.points[result.triangles[f][i]])).margin(0.3));
}

} // namespace

TEST_CASE("Points in the middle of a cap or an edge have values in between") {
  const Soup plate = two_tunnels();
  const Soup touching = test::surface_of_cubes(4, 4, 4, [](int x, int y, int z) {
    return (x == 1 && y == 1) || (x == 2 && y == 2) || (x == 1 && y == 2 && z == 0);
  }); // two posts that have edges in common, and are joined below
  for (const Soup& input : {plate, touching}) {
    const SoupPoints points = arrays_of(input);
    std::vector<double> values;
    SoupTriangles corners;
    SoupView soup{points, input.triangles, {}, {}};
    soup.channels.push_back(
        channel_of_corners(input.triangles, values, corners,
                           [&](std::uint32_t, std::uint32_t v) { return linear(points[v]); }));
    const SoupResult result =
        simplified_soup(soup, {.ratio = 1., .manifold = true, .simplified_topology = 1.5});
    CHECK(result.points.size() > points.size());
    check_linear(result);
    soup.channels[0].triangles = {}; // values of points
    values.clear();
    for (const auto& p : points)
      values.push_back(linear(p));
    soup.channels[0].values = values;
    SoupResult of_points =
        simplified_soup(soup, {.ratio = 1., .manifold = true, .simplified_topology = 1.5});
    if (of_points.channels[0].triangles.empty())
      of_points.channels[0].triangles = of_points.triangles;
    check_linear(of_points);
  }
}

TEST_CASE("A cap next to a seam lies in the charts of its neighbours") {
  const Soup input = two_tunnels();
  const SoupPoints points = arrays_of(input);
  std::vector<double> values;
  SoupTriangles corners;
  SoupView soup{points, input.triangles, {}, {}};
  const auto chart = [&](std::uint32_t f, std::uint32_t) {
    const auto& [a, b, c] = input.triangles[f];
    return points[a][0] + points[b][0] + points[c][0] < 13.5 ? 1. : 5.;
  };
  soup.channels.push_back(channel_of_corners(input.triangles, values, corners, chart));
  const SoupResult result = simplified_soup(soup, {.ratio = 1., .simplified_topology = 1.5});
  std::size_t closing = 0, of_first_chart = 0;
  for (std::size_t f = input.triangles.size(); f < result.triangles.size(); ++f) {
    ++closing;
    const auto& of_corners = result.channels[0].triangles[f];
    for (const std::uint32_t value : of_corners)
      CHECK(result.channels[0].values[value] == result.channels[0].values[of_corners[0]]);
    CHECK(result.channels[0].values[of_corners[0]] == chart(result.input_faces[f], 0));
    of_first_chart += result.channels[0].values[of_corners[0]] == 1;
  }
  CHECK(closing == 8);
  CHECK(of_first_chart > 0);
  CHECK(of_first_chart < closing);
}

TEST_CASE("Limits and records begin with the surface after the cuts") {
  const Soup input = two_tunnels();
  const SoupPoints points = arrays_of(input);
  const SoupView soup{points, input.triangles, {}, {}};
  Levels levels;
  SoupOptions options{.error = 0.1, .simplified_topology = 1.5};
  options.recorder = record_into(levels);
  const SoupResult result = simplified_soup(soup, options);
  CHECK(result.report.cut_handles == 1);
  CHECK(result.report.cut_distance >= 0.5); // from the middle of a square to its sides
  CHECK(result.report.cut_distance <= 0.7); // and copies lie aside
  CHECK(result.report.distance_bound <= 0.1);
  CHECK(result.prepared.triangles.size() == input.triangles.size() + 8);
  CHECK(result.prepared.points.size() == points.size() + 6); // four copies, and two in the middle
  CHECK(result.prepared.vertex_map.size() == result.prepared.points.size());
  REQUIRE(result.prepared.origins.size() == 6);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      CHECK(result.prepared.points[points.size() + i][k] ==
            Approx(points[result.prepared.origins[i]][k]).margin(0.1));
  CHECK(levels.finest().faces == result.prepared.triangles.size());
  CHECK(levels.coarsest().faces == result.triangles.size());
  CHECK(simplified_soup(soup, {.error = 0.1}).prepared.points.empty());
}

TEST_CASE("Points that are split at seams are one for a preparation") {
  const Soup input = two_tunnels();
  SoupPoints points; // of each triangle its own
  SoupTriangles triangles;
  std::vector<double> values; // constant within each half
  for (const auto& t : input.triangles) {
    const auto first = static_cast<std::uint32_t>(points.size());
    triangles.push_back({first, first + 1, first + 2});
    double sum = 0;
    for (const std::uint32_t v : t) {
      points.push_back(input.points[v].coordinates);
      sum += points.back()[0];
    }
    values.insert(values.end(), 3, sum < 13.5 ? 1. : 5.);
  }
  SoupView soup{points, triangles, {}, {}};
  soup.channels.push_back(
      {.kind = SoupChannelView::Kind::attributes, .components = 1, .values = values});
  const SoupResult result = simplified_soup(
      soup, {.faces = 200, .manifold = true, .simplified_topology = 1.5, .split_vertices = true});
  CHECK(result.report.cut_handles == 1);
  CHECK(result.triangles.size() == 200);
  CHECK(result.vertex_map.empty());
  CHECK(result.channels[0].triangles.empty());
  REQUIRE(result.channels[0].values.size() == result.points.size());
  std::map<std::array<double, 3>, std::uint32_t> places;
  SoupResult joined = result; // by places
  for (auto& t : joined.triangles)
    for (std::uint32_t& v : t)
      v = places.try_emplace(result.points[v], v).first->second;
  CHECK(topology_of(joined).genus() == 1);
  CHECK(topology_of(joined).is_closed());
  CHECK(places.size() < result.points.size()); // at the seam
  CHECK(2 * places.size() > result.points.size());
}

TEST_CASE("Levels that are to have the indices of the input have no preparations") {
  const Soup input = two_tunnels();
  const SoupPoints points = arrays_of(input);
  const SoupView soup{points, input.triangles, {}, {}};
  for (const SoupOptions& asked : {SoupOptions{.manifold = true}, {.simplified_topology = 1.}})
    CHECK_THROWS_WITH(internal::options_of_levels(asked, soup),
                      Catch::Contains("indices of the input"));
  const SoupOptions left =
      internal::options_of_levels({.preset = SoupOptions::Preset::generated}, soup);
  CHECK(!left.manifold);
  CHECK(!left.simplified_topology);
  CHECK(left.topology == Topology::components_may_vanish);
}

TEST_CASE("A soup is made manifold before its handles are cut") {
  const Soup input = test::surface_of_cubes(12, 12, 3, [](int x, int y, int) {
    return !(x == 4 && y == 4) && !(x == 5 && y == 5); // two tunnels that touch at an edge
  });
  const SoupPoints points = arrays_of(input);
  const SoupResult result = simplified_soup(
      {points, input.triangles}, {.faces = 100, .manifold = true, .simplified_topology = 3.});
  CHECK(topology_of(result).is_manifold);
  CHECK(topology_of(result).is_closed());
  CHECK(result.report.cut_handles == 1); // one wide tunnel, once the blocks come apart
  CHECK(result.report.non_manifold_edges == 0);
}

TEST_CASE("Preparations refuse what would undo them") {
  const Soup input = two_tunnels();
  const SoupPoints points = arrays_of(input);
  const auto complaint = [&](SoupOptions options) -> std::string {
    options.simplified_topology = 1;
    try {
      simplified_soup({points, input.triangles}, options);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  CHECK(complaint({}) == "");
  CHECK_THAT(complaint({.topology = Topology::free}), Catch::Contains("free topology"));
  CHECK_THAT(complaint({.pairs_closer_than = 1.}), Catch::Contains("pairs"));
  CHECK_THAT(complaint({.keep_solid = true}), Catch::Contains("both sides of a cut touch"));
}

TEST_CASE("A preset stands for options that are left at their defaults") {
  const Soup input = two_tunnels();
  const SoupPoints points = arrays_of(input);
  const SoupView soup{points, input.triangles, {}, {}};
  const auto cuts = [&](const SoupOptions& options) {
    return simplified_soup(soup, options).report.cut_handles;
  };
  CHECK(cuts({.preset = SoupOptions::Preset::generated, .faces = 60}) == 1);
  CHECK(cuts({.preset = SoupOptions::Preset::cad, .faces = 60}) == 0);
  CHECK(cuts({.preset = SoupOptions::Preset::generated, .faces = 60, .simplified_topology = 0.1}) ==
        0);
  CHECK(cuts({.preset = SoupOptions::Preset::generated, .faces = 60, .topology = Topology::free}) ==
        0);
  const SoupResult named = simplified_soup(
      soup,
      {.preset = SoupOptions::Preset::print, .faces = 60, .cost = SoupOptions::Cost::edge_length});
  const SoupResult own = simplified_soup(soup, {.faces = 60,
                                                .cost = SoupOptions::Cost::edge_length,
                                                .topology = Topology::components_may_vanish,
                                                .manifold = true,
                                                .keep_planes = 129});
  CHECK(named.points == own.points);
  CHECK(named.triangles == own.triangles);
  CHECK(named.report.kept_planes == 2);
}

TEST_CASE("Coordinates lie on a lattice, or on none") {
  const auto step_of = [](std::vector<double> coordinates) {
    const auto lattice = internal::lattice_of(std::move(coordinates));
    return lattice ? lattice->step : 0;
  };
  CHECK(step_of({7, 2, 5, 2, 11}) == Approx(1)); // half of the least difference
  CHECK(step_of({1000.29999, 1000.59998, 1001.5}) == Approx(0.3).epsilon(1e-3));
  CHECK(step_of({0, 1, 2.3, 3.1}) == 0);
  CHECK(step_of({4, 4}) == 0);
  CHECK(step_of({0, 1, HUGE_VAL}) == 0);
  CHECK(step_of({}) == 0);
}

TEST_CASE("The preset of voxels finds their size") {
  const Soup blocks = two_tunnels();
  const auto check_size = [](const SoupPoints& points, const SoupTriangles& triangles,
                             double size) {
    CAPTURE(size);
    const SoupView soup{points, triangles, {}, {}};
    const SoupResult by_preset =
        simplified_soup(soup, {.preset = SoupOptions::Preset::voxels, .faces = 200});
    const SoupResult own = simplified_soup(soup, {.faces = 200,
                                                  .topology = Topology::components_may_vanish,
                                                  .manifold = true,
                                                  .simplified_topology = 1.7 * size,
                                                  .voxel_size = size});
    CHECK(by_preset.report.cut_handles == own.report.cut_handles);
    REQUIRE(by_preset.points.size() == own.points.size());
    for (std::size_t i = 0; i < own.points.size(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        CHECK(by_preset.points[i][axis] == Approx(own.points[i][axis]).margin(1e-6 * size));
  };
  const auto stretched = [](SoupPoints points, std::array<double, 3> sides) {
    for (auto& p : points)
      for (std::size_t axis = 0; axis < 3; ++axis)
        p[axis] = static_cast<double>(static_cast<float>(3.7 + sides[axis] * p[axis]));
    return points;
  };
  const SoupPoints points = arrays_of(blocks);
  check_size(points, blocks.triangles, 1);
  check_size(stretched(points, {0.7, 0.7, 2.1}), blocks.triangles, 0.7);
  check_size(stretched(points, {3, 1.1, 1.1}), blocks.triangles, 1.1);
  SoupOptions flat;
  flat.error = 1e-9;
  flat.placement =
      SoupOptions::Placement::endpoint; // optimal ones leave vertices anywhere in flats
  const SoupResult merged = simplified_soup({points, blocks.triangles}, flat);
  REQUIRE(merged.triangles.size() < 200);
  check_size(merged.points, merged.triangles, 1);

  SoupPoints rough = points;
  for (std::size_t i = 0; i < rough.size(); ++i)
    rough[i][i % 3] += 0.01 * std::sin(double(i));
  double edges = 0;
  for (const auto& t : blocks.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      edges += std::sqrt(
          squared_distance(test::Position{rough[t[i]]}, test::Position{rough[t[(i + 1) % 3]]}));
  check_size(rough, blocks.triangles,
             0.9 * edges / (3 * static_cast<double>(blocks.triangles.size())));
}

TEST_CASE("A preset finds no length in a surface without edges") {
  const SoupPoints points(3);
  const SoupTriangles triangles{{0, 1, 2}};
  for (const auto preset : {SoupOptions::Preset::voxels, SoupOptions::Preset::print})
    CHECK_NOTHROW(simplified_soup({points, triangles, {}, {}}, {.preset = preset}));
}
