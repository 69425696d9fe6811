// vertex_is_shared_map and what goes with it, on meshes and soups.
#include "meshes.h"
#include "soups.h"

#include <quadrille/channels.h>
#include <quadrille/distance_limits.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/simplify.h>

#include <boost/property_map/function_property_map.hpp>
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using test::Mesh;
using test::Point;
using test::Position;
using test::Soup;

Soup terrain() {
  return test::mapped(test::with_noise(test::grid(40, 20), 7, 0.002), [](const Position& p) {
    return Position{{2 * p[0], p[1], 0.1 * std::sin(9 * p[0]) * std::cos(6 * p[1])}};
  });
}

struct Half {
  Soup soup;
  std::vector<bool> is_shared;
  std::vector<std::array<std::size_t, 2>> boundaries; // between shared points
};

// The faces whose middle is left or right of a line that is not straight.
std::array<Half, 2> halves(const Soup& soup) {
  std::array<Soup, 2> sides;
  std::array<std::set<std::uint32_t>, 2> used;
  std::map<std::array<std::uint32_t, 2>, int> faces;
  for (Soup& side : sides)
    side.points = soup.points;
  for (const auto& t : soup.triangles) {
    const Position m = soup.points[t[0]] + soup.points[t[1]] + soup.points[t[2]];
    const bool is_right = m[0] > 3 + 0.5 * std::sin(3 * m[1]);
    sides[is_right].triangles.push_back(t);
    used[is_right].insert(t.begin(), t.end());
    for (std::size_t i = 0; i < 3; ++i)
      ++faces[{std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])}];
  }
  std::array<Half, 2> result;
  for (std::size_t side = 0; side < 2; ++side) {
    std::map<std::uint32_t, std::size_t> number;
    for (std::uint32_t v : used[side]) {
      number.emplace(v, number.size());
      result[side].is_shared.push_back(used[1 - side].count(v) > 0);
    }
    for (const auto& [edge, count] : faces)
      if (count == 1 && number.count(edge[0]) && number.count(edge[1]) &&
          result[side].is_shared[number[edge[0]]] && result[side].is_shared[number[edge[1]]])
        result[side].boundaries.push_back({number[edge[0]], number[edge[1]]});
    result[side].soup = without_isolated_points(sides[side]);
  }
  return result;
}

// With points in the order in which triangles name them.
Half as_met(const Half& half) {
  Half result;
  std::map<std::size_t, std::uint32_t> number;
  for (test::Triangle t : half.soup.triangles) {
    for (std::uint32_t& v : t) {
      const auto [at, is_new] =
          number.try_emplace(v, static_cast<std::uint32_t>(result.soup.points.size()));
      if (is_new) {
        result.soup.points.push_back(half.soup.points[v]);
        result.is_shared.push_back(half.is_shared[v]);
      }
      v = at->second;
    }
    result.soup.triangles.push_back(t);
  }
  for (const auto& [v, w] : half.boundaries)
    result.boundaries.push_back({number[v], number[w]});
  return result;
}

CGAL::Bbox_3 box_of(const Soup& soup) {
  CGAL::Bbox_3 box;
  for (const Position& p : soup.points)
    box += CGAL::Bbox_3(p[0], p[1], p[2], p[0], p[1], p[2]);
  return box;
}

// Both halves side by side, with one point for each place.
Soup sewn(const Soup& a, const Soup& b) {
  Soup result;
  std::map<std::array<double, 3>, std::uint32_t> number;
  for (const Soup* soup : {&a, &b})
    for (const auto& t : soup->triangles) {
      test::Triangle corners;
      for (std::size_t i = 0; i < 3; ++i) {
        const Position& p = soup->points[t[i]];
        const auto [at, is_new] = number.try_emplace(
            {p[0], p[1], p[2]}, static_cast<std::uint32_t>(result.points.size()));
        if (is_new)
          result.points.push_back(p);
        corners[i] = at->second;
      }
      result.triangles.push_back(corners);
    }
  return result;
}

auto map_of(const std::vector<bool>& values) {
  return boost::make_function_property_map<std::size_t>(
      [&values](std::size_t i) -> bool { return values[i]; });
}

constexpr double limit = 1e-8;

Report simplify_half(Soup& soup, const Half& half, const CGAL::Bbox_3& box) {
  return simplify<MemorylessQuadric>(
      soup.points, soup.triangles, CostLimit{limit},
      parameters::vertex_is_shared_map(
          map_of(half.is_shared),
          parameters::boundary_edges(half.boundaries, parameters::bounding_box(box))));
}

} // namespace

TEST_CASE("Two halves of a soup fit after each has been simplified by itself") {
  const Soup whole = terrain();
  const CGAL::Bbox_3 box = box_of(whole);
  auto pieces = halves(whole);
  REQUIRE(pieces[0].boundaries == pieces[1].boundaries);
  std::array<Soup, 2> left{pieces[0].soup, pieces[1].soup};
  for (std::size_t side = 0; side < 2; ++side) {
    const Report report = simplify_half(left[side], pieces[side], box);
    CHECK(left[side].triangles.size() < pieces[side].soup.triangles.size() / 2);
    CHECK(report.stop == StopReason::target_met);
  }
  const Soup result = sewn(left[0], left[1]);
  CHECK(is_same_topology(topology_of(result), topology_of(whole)));
}

TEST_CASE("The halves of a mesh are left as those of a soup") {
  const Soup whole = terrain();
  const CGAL::Bbox_3 box = box_of(whole);
  for (const Half& half : halves(whole)) {
    Soup soup = half.soup;
    simplify_half(soup, half, box);
    Mesh mesh = test::make_mesh(half.soup);
    std::set<std::array<std::size_t, 2>> boundaries;
    for (auto [v, w] : half.boundaries)
      boundaries.insert({std::min(v, w), std::max(v, w)});
    const auto is_border =
        boost::make_function_property_map<Mesh::Edge_index>([&](const Mesh::Edge_index& e) -> bool {
          const std::size_t v = source(e, mesh), w = target(e, mesh);
          return boundaries.count({std::min(v, w), std::max(v, w)}) > 0;
        });
    const auto is_shared = boost::make_function_property_map<Mesh::Vertex_index>(
        [&](const Mesh::Vertex_index& v) -> bool { return half.is_shared[v]; });
    simplify<MemorylessQuadric>(
        mesh, CostLimit{limit},
        parameters::vertex_is_shared_map(
            is_shared, parameters::edge_is_boundary_map(is_border, parameters::bounding_box(box))));
    mesh.collect_garbage();
    CHECK(is_same_surface(test::to_soup(mesh), soup, 0));
  }
}

TEST_CASE("What is constrained stays beside what is shared") {
  const Half half = halves(terrain())[0];
  Soup soup = half.soup;
  std::vector<bool> is_fixed(soup.points.size(), false);
  for (std::size_t v = 0; v < is_fixed.size(); v += 10)
    is_fixed[v] = true;
  simplify(
      soup.points, soup.triangles, FaceCount{100},
      parameters::vertex_is_shared_map(
          map_of(half.is_shared), CGAL::parameters::vertex_is_constrained_map(map_of(is_fixed))));
  std::set<std::array<double, 3>> left;
  for (const Position& p : soup.points)
    left.insert({p[0], p[1], p[2]});
  for (std::size_t v = 0; v < is_fixed.size(); ++v)
    if (const Position& p = half.soup.points[v]; is_fixed[v] || half.is_shared[v])
      CHECK(left.count({p[0], p[1], p[2]}) == 1);
}

TEST_CASE("Points of one place share what one of them does, where vertices are split") {
  // Each triangle has points of its own; the others are numbered as they are met.
  const Half half = as_met(halves(terrain())[1]);
  Soup split;
  std::vector<bool> is_shared;
  std::vector<std::array<std::size_t, 2>> boundaries;
  for (const auto& t : half.soup.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (const auto& [v, w] : half.boundaries)
        if ((t[i] == v && t[(i + 1) % 3] == w) || (t[i] == w && t[(i + 1) % 3] == v))
          boundaries.push_back({split.points.size() + i, split.points.size() + (i + 1) % 3});
    }
    const auto first = static_cast<std::uint32_t>(split.points.size());
    for (const std::uint32_t v : t) {
      split.points.push_back(half.soup.points[v]);
      is_shared.push_back(half.is_shared[v]);
    }
    split.triangles.push_back({first, first + 1, first + 2});
  }
  Soup soup = half.soup;
  const CGAL::Bbox_3 box = box_of(soup);
  simplify_half(soup, half, box);
  simplify<MemorylessQuadric>(
      split.points, split.triangles, CostLimit{limit}, SplitVertices{},
      parameters::vertex_is_shared_map(
          map_of(is_shared),
          parameters::boundary_edges(boundaries, parameters::bounding_box(box))));
  CHECK(is_same_surface(split, soup, 0));
}

TEST_CASE("Relative limits are of the diagonal of the box that is given") {
  const Soup whole = terrain();
  const CGAL::Bbox_3 box(-3, -3, -3, 5, 3, 3);
  const double diagonal = std::sqrt(64.0 + 36 + 36);
  Soup relative = whole, absolute = whole;
  simplify(relative.points, relative.triangles, DistanceLimit::relative(1e-3),
           parameters::bounding_box(box));
  simplify(absolute.points, absolute.triangles, DistanceLimit(1e-3 * diagonal));
  CHECK(is_identical(relative, absolute));
}

TEST_CASE(
    "A box that does not hold the surface, or is none, and borders of no points are refused") {
  const Soup soup = terrain();
  const auto refuses = [&](const auto& named, const std::string& why) {
    Soup copy = soup;
    CHECK_THROWS_WITH(simplify(copy.points, copy.triangles, named), Catch::Contains(why));
    CHECK(is_identical(copy, soup));
  };
  constexpr double infinity = std::numeric_limits<double>::infinity();
  refuses(parameters::bounding_box({0, 0, 0, 1, 0.1, 0.1}), "is not inside bounding_box");
  refuses(parameters::bounding_box({0, 0, 0, 1, -1, 1}), "is not a box");
  refuses(parameters::bounding_box({0, 0, 0, infinity, 1, 1}), "is not a box");
  refuses(parameters::bounding_box(CGAL::Bbox_3()), "is not a box"); // it is empty
  using Edges = std::vector<std::array<int, 2>>;
  refuses(parameters::boundary_edges(Edges{{0, 1}, {0, 9999}}),
          "edge 1 of boundary_edges refers to point 9999 of 861");
  refuses(parameters::boundary_edges(Edges{{-1, 1}}), "refers to point -1");
}
