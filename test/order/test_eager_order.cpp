// GreedyOrder::eager: each contraction is the cheapest that there is, for costs that change
// beside it.
#include "contractions.h"
#include "meshes.h"
#include "soups.h"

#include <quadrille/memoryless_quadric.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <vector>

namespace {

using namespace quadrille;
using internal::Index;
using test::Soup;

// Contracts the cheapest pair that is not refused, of all that there are. False if there is none.
template <class Surface>
bool contract_cheapest(Surface& surface) {
  std::vector<std::tuple<float, Index, Index>> pairs;
  surface.pairs().for_each_above(
      surface.scratch(), 0, static_cast<Index>(surface.complex().vertex_capacity()), 1,
      [&](Index v, Index w, float cost) { pairs.emplace_back(cost, v, w); });
  std::sort(pairs.begin(), pairs.end());
  return std::any_of(pairs.begin(), pairs.end(), [&](const auto& pair) {
    const auto [cost, v, w] = pair;
    return surface.complex().has_faces(v) && surface.complex().has_faces(w) &&
           test::contract(surface, v, w);
  });
}

template <class Surface>
std::vector<test::Position> points_left(const Surface& surface) {
  std::vector<test::Position> points;
  for (Index v = 0; v < surface.complex().vertex_capacity(); ++v)
    if (surface.complex().has_faces(v))
      points.push_back(test::position(surface, v));
  return points;
}

// The points of the vertices that are left, in the order of the vertices.
template <class Cost, class... Policies>
std::vector<test::Position> points_after(const Soup& soup, std::size_t contractions,
                                         const Cost& cost, const Policies&... policies) {
  test::Mesh mesh = test::make_mesh(soup);
  simplify(
      mesh, cost, [=](const Status& status) { return status.contractions == contractions; },
      policies...);
  std::vector<test::Position> points;
  for (const auto v : mesh.vertices())
    points.push_back(test::to_position(mesh.point(v)));
  return points;
}

bool are_near(const std::vector<test::Position>& p, const std::vector<test::Position>& q) {
  return std::equal(p.begin(), p.end(), q.begin(), q.end(), [](const auto& a, const auto& b) {
    return squared_distance(a, b) < 1; // on a surface of four million
  });
}

// Compares every tenth step. Returns how often the order that is not eager was elsewhere.
template <class Cost, class... Pairs>
int compare_with_brute_force(const Soup& input, const Cost& cost, const Pairs&... pairs) {
  const Soup soup = test::large(input);
  const auto policies = internal::pick_policies<Cost, OptimalPlacement>(Topology::kept, pairs...);
  const auto surface_input = test::input_of(soup);
  internal::WorkingSurface<std::remove_const_t<decltype(policies)>> surface(
      surface_input, surface_input.box(), policies);
  int others = 0;
  for (std::size_t contractions = 1; contract_cheapest(surface); ++contractions) {
    if (contractions % 10 != 0)
      continue;
    CAPTURE(contractions);
    const auto expected = points_left(surface);
    const auto points = [&](const GreedyOrder& order) {
      return points_after(soup, contractions, cost, Topology::kept, order, pairs...);
    };
    REQUIRE(are_near(points(GreedyOrder{.eager = true}), expected));
    others += !are_near(points(GreedyOrder{}), expected);
  }
  return others;
}

} // namespace

TEMPLATE_TEST_CASE("Eager order contracts the cheapest pair there is", "", MemorylessQuadric,
                   ThinFeatureQuadric) {
  int others = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    CAPTURE(seed);
    others += compare_with_brute_force(test::random_closed(seed), TestType{});
    others += compare_with_brute_force(test::random_with_borders(seed), TestType{});
  }
  CHECK(others > 20);
}

TEST_CASE("Eager order knows pairs that are not edges") {
  const Soup soup = test::random_closed(7);
  const ThresholdPairs pairs(0x1p22 / 8);
  CHECK(compare_with_brute_force(soup, MemorylessQuadric{}, pairs) > 0);
}

TEST_CASE("Costs that only their own vertices change need no eager order") {
  const Soup soup = test::random_with_borders(3);
  for (std::size_t contractions : {10U, 40U})
    CHECK(points_after(soup, contractions, Quadric{}, GreedyOrder{.eager = true}) ==
          points_after(soup, contractions, Quadric{}));
}
