// make_manifold: what touches itself at vertices and edges is cut into sheets, and stays where it
// is.

#include "meshes.h"
#include "soups.h"

#include <quadrille/manifold.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

using quadrille::make_manifold;
using quadrille::ManifoldChanges;
using test::Position;
using test::Soup;
using test::Triangle;

using Points = std::vector<std::array<double, 3>>;

Points arrays_of(const Soup& soup) {
  Points points;
  for (const Position& p : soup.points)
    points.push_back(p.coordinates);
  return points;
}

ManifoldChanges cut(Soup& soup) {
  Points points = arrays_of(soup);
  const ManifoldChanges changes = make_manifold(points, soup.triangles);
  soup.points.clear();
  for (const auto& p : points)
    soup.points.push_back({p});
  return changes;
}

/// Cuts a closed surface, and checks what must hold of any.
ManifoldChanges check(const Soup& input) {
  Soup soup = input;
  const ManifoldChanges changes = cut(soup);
  const auto topology = test::topology_of(soup);
  CAPTURE(topology);
  CHECK(topology.is_manifold);
  CHECK(topology.is_closed());
  CHECK(topology.is_oriented);
  CHECK(test::volume(soup) == Approx(test::volume(input)));
  CHECK(soup.points.size() == input.points.size() + changes.split_vertices + changes.split_edges);
  CHECK(changes.origins.size() == changes.split_vertices + changes.split_edges);
  CHECK(changes.triangles.size() == soup.triangles.size());
  CHECK(soup.triangles.size() == input.triangles.size() + 2 * changes.split_edges);
  CHECK(std::equal(input.points.begin(), input.points.end(), soup.points.begin()));
  for (std::size_t i = 0; i < changes.origins.size(); ++i) {
    const auto& [a, b] = changes.origins[i];
    CHECK(soup.points[input.points.size() + i] == 0.5 * soup.points[a] + 0.5 * soup.points[b]);
  }
  return changes;
}

/// Two cubes, the second somewhere beside the first.
Soup two_cubes(int dx, int dy, int dz) {
  return test::surface_of_cubes(2, 2, 2, [=](int x, int y, int z) {
    return (x == 0 && y == 0 && z == 0) || (x == dx && y == dy && z == dz);
  });
}

/// Triangles with duplicates, also wound the other way, edges of many faces, and equal corners.
Soup random_triangles(std::uint64_t seed) {
  test::Random random(seed);
  Soup soup;
  const std::uint32_t points = 3 + random.below(10);
  for (std::uint32_t i = 0; i < points; ++i)
    soup.points.push_back({{random(0, 1), random(0, 1), random(0, 1)}});
  for (std::uint32_t face = 1 + random.below(60); face > 0; --face) {
    Triangle triangle{random.below(points), random.below(points), random.below(points)};
    const std::uint32_t kind = random.below(10);
    if (kind < 6 && !soup.triangles.empty()) {
      const Triangle& other = soup.triangles[random.below(soup.triangles.size())];
      triangle = {other[0], other[1], kind < 2 ? other[2] : triangle[2]};
      if (kind % 2 == 0)
        std::swap(triangle[0], triangle[1]);
    }
    soup.triangles.push_back(triangle);
  }
  return soup;
}

} // namespace

TEST_CASE("What touches in a vertex or along an edge comes apart") {
  const auto in_vertex = check(two_cubes(1, 1, 1));
  CHECK(in_vertex.split_vertices == 1);
  CHECK(in_vertex.split_edges == 0);
  const auto in_edge = check(two_cubes(1, 1, 0));
  CHECK(in_edge.split_vertices == 2);
  CHECK(in_edge.split_edges == 0);
  CHECK(check(two_cubes(1, 0, 0)).origins.empty());
}

TEST_CASE("Sheets with both ends of an edge in common get apart in its middle") {
  // Two cubes touch along an edge, and others join them round each end of it.
  const Soup ring = test::surface_of_cubes(
      2, 2, 3, [](int x, int y, int z) { return z == 1 ? x == y : x == 0 || y == 1; });
  const auto changes = check(ring);
  CHECK(changes.split_vertices == 0);
  CHECK(changes.split_edges == 1);
}

TEST_CASE("Random cubes become manifold") {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    test::Random random(seed);
    const double share = random(0.1, 0.9);
    std::vector<bool> is_solid;
    for (int i = 0; i < 6 * 6 * 6; ++i)
      is_solid.push_back(random(0, 1) < share);
    check(test::surface_of_cubes(6, 6, 6, [&](int x, int y, int z) {
      return is_solid[static_cast<std::size_t>((x * 6 + y) * 6 + z)];
    }));
  }
}

TEST_CASE("Random triangles become manifold, and stay where they are") {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    INFO("seed " << seed);
    const Soup input = random_triangles(seed);
    Soup soup = input;
    const ManifoldChanges changes = cut(soup);
    CHECK(test::topology_of(soup).is_manifold);
    CHECK(!test::topology_of(soup).has_collapsed_faces);
    // What is cut once has no need of it again.
    Soup again = soup;
    CHECK(cut(again).origins.empty());
    CHECK(test::is_identical(again, soup));
    // The fragments of a triangle have its area together, and look where it does.
    std::vector<Position> area(input.triangles.size());
    std::vector<double> size(input.triangles.size());
    for (std::size_t face = 0; face < soup.triangles.size(); ++face) {
      const Position of_fragment = test::area_vector(soup, soup.triangles[face]);
      area[changes.triangles[face]] += of_fragment;
      size[changes.triangles[face]] += std::sqrt(squared_length(of_fragment));
    }
    for (std::size_t face = 0; face < input.triangles.size(); ++face) {
      const Triangle& t = input.triangles[face];
      const bool is_degenerate = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
      const Position whole = is_degenerate ? Position{} : test::area_vector(input, t);
      CHECK(squared_length(area[face] - whole) < 1e-24);
      CHECK(size[face] == Approx(std::sqrt(squared_length(whole))).margin(1e-12));
    }
  }
}

TEST_CASE("What is manifold stays as it is") {
  const Soup closed = test::torus(12, 8), open = test::open_cylinder(8, 3);
  for (const Soup& input : {closed, open}) {
    Soup soup = input;
    CHECK(cut(soup).origins.empty());
    CHECK(test::is_identical(soup, input));
  }
  // Faces that are wound against their neighbours are neighbours still.
  Soup against = closed;
  for (std::size_t face = 0; face < against.triangles.size(); face += 3)
    std::swap(against.triangles[face][0], against.triangles[face][1]);
  const Soup input = against;
  CHECK(cut(against).origins.empty());
  CHECK(test::is_identical(against, input));
}

TEST_CASE("Of three faces at an edge one is left over, and degenerate ones go") {
  Soup book{{{{0, 0, 0}}, {{0, 0, 1}}, {{1, 0, 0}}, {{-1, 1, 0}}, {{-1, -1, 0}}},
            {{{0, 1, 2}}, {{1, 0, 3}}, {{1, 0, 4}}, {{3, 3, 4}}}};
  const auto changes = cut(book);
  CHECK(changes.triangles == std::vector<std::size_t>{0, 1, 2});
  CHECK(changes.split_vertices == 2);
  CHECK(test::topology_of(book).is_manifold);
  CHECK(test::topology_of(book).components == 2);
}

TEST_CASE("What no soup may have is refused, and the soup unchanged") {
  const Soup input = test::tetrahedron();
  Soup soup = input;
  soup.triangles.push_back({0, 1, 9});
  Points points = arrays_of(soup);
  CHECK_THROWS_AS(make_manifold(points, soup.triangles), std::invalid_argument);
  CHECK(points.size() == input.points.size());
  CHECK(soup.triangles.size() == input.triangles.size() + 1);
}
