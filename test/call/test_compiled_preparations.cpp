// Options of the interface without templates that prepare a soup: manifold and simplified_topology.
// All that the soup has follows.

#include "soups.h"

#include <quadrille/compiled.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
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
  CHECK_THAT(complaint({.split_vertices = true}), Catch::Contains("split_vertices"));
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
  CHECK(cuts({.preset = SoupOptions::Preset::generated, .faces = 60, .split_vertices = true}) == 0);
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

  const SoupResult smooth =
      simplified_soup(soup, {.preset = SoupOptions::Preset::voxels, .faces = 200});
  const double edge = (2 + std::sqrt(2)) / 3; // each square is cut along a diagonal
  const SoupResult own_smooth = simplified_soup(soup, {.faces = 200,
                                                       .topology = Topology::components_may_vanish,
                                                       .manifold = true,
                                                       .simplified_topology = 1.5 * edge,
                                                       .voxel_size = 0.9 * edge});
  CHECK(smooth.report.cut_handles == own_smooth.report.cut_handles);
  REQUIRE(smooth.points.size() == own_smooth.points.size());
  for (std::size_t i = 0; i < smooth.points.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      CHECK(smooth.points[i][axis] == Approx(own_smooth.points[i][axis]).margin(1e-9));
}

TEST_CASE("A preset finds no length in a surface without edges") {
  const SoupPoints points(3);
  const SoupTriangles triangles{{0, 1, 2}};
  for (const auto preset : {SoupOptions::Preset::voxels, SoupOptions::Preset::print})
    CHECK_NOTHROW(simplified_soup({points, triangles, {}, {}}, {.preset = preset}));
}
