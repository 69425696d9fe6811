// Simplifies with given policies on one kind of mesh, and checks what is promised of each policy.
#ifndef TEST_POLICIES_ON_ALL_H
#define TEST_POLICIES_ON_ALL_H

#include "on_all.h"

#include <quadrille/edge_length.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace test {

using namespace quadrille;

template <class Kind, class Cost, class Placement, class Pairs, class Order>
Result check_result(const Soup& soup, const Cost& cost, const Placement& placement,
                    const Pairs& pairs, const Order& order) {
  constexpr bool is_by_edges = std::is_same_v<Pairs, EdgePairs>;
  const Topology topology = is_by_edges ? Topology::kept : Topology::free;
  const FaceRatio stop{0.3};
  const Result result = Kind::run(soup, cost, placement, pairs, order, stop, topology);
  INFO(result.report);
  Asked asked;
  asked.soup = soup;
  asked.is_mesh = Kind::is_mesh;
  asked.topology = topology;
  asked.is_by_edges = is_by_edges;
  asked.is_at_endpoints = std::is_same_v<Placement, EndpointPlacement>;
  asked.stop = stop;
  if constexpr (Cost::dimension > 3)
    for (const Position& p : soup.points) {
      const auto values = attributes_at<Cost::dimension - 3>(p);
      asked.attributes.emplace_back(values.begin(), values.end());
    }
  CHECK(broken(asked, result) == "");
  CHECK(is_clean(result.soup));
  if (is_by_edges) {
    CHECK(topology_of(result.soup).is_manifold);
    CHECK(result.report.components_after == 2);
  } else {
    CHECK(result.report.components_after == 1);
    CHECK(result.report.non_edge_contractions > 0);
  }
  return result;
}

template <class Kind, class... Policies>
void check_same(const char* kind, const Result& expected, const Soup& soup,
                const Policies&... policies) {
  INFO("on a " << kind);
  const Result result = check_result<Kind>(soup, policies...);
  CHECK(result.report.contractions == expected.report.contractions);
  CHECK(result.report.rejections == expected.report.rejections);
  const std::vector<Position>& places = expected.soup.points;
  const bool is_same = faces_at(places, result.soup) == faces_at(places, expected.soup);
  CHECK(is_same);
}

/// Calls check(cost, placement, pairs) with all placements that fit and both kinds of pairs.
template <class Cost, class Check>
void for_all_placements_and_pairs(const Cost& cost, Check check) {
  const auto check_placement = [&](const auto& placement) {
    check(cost, placement, EdgePairs{});
    check(cost, placement, ThresholdPairs::relative(0.1));
  };
  if constexpr (!std::is_same_v<Cost, EdgeLength>) {
    INFO("optimal placement");
    check_placement(OptimalPlacement{});
  }
  {
    INFO("placement at the ends");
    check_placement(EndpointPlacement{});
  }
  {
    INFO("placement at the midpoint");
    check_placement(MidpointPlacement{});
  }
}

/// Those with which all kinds of mesh are tried: for these it makes no difference which they are.
template <class Cost, class Placement, class Pairs>
constexpr bool is_usual = std::is_same_v<Pairs, EdgePairs> &&
                          (std::is_same_v<Placement, OptimalPlacement> ||
                           std::is_same_v<Cost, EdgeLength>);

/// All kinds of mesh give what a soup gives.
template <class Cost>
void check_on_all(const Cost& cost) {
  for_all_placements_and_pairs(cost, [](const auto&... policies) {
    const Soup soup = two_parts();
    const GreedyOrder order;
    const Result expected = check_result<OnSoup>(soup, policies..., order);
    check_same<OnMesh<Mesh>>("Surface_mesh", expected, soup, policies..., order);
    if constexpr (is_usual<std::decay_t<decltype(policies)>...>) {
      check_same<OnMesh<Polyhedron>>("Polyhedron_3", expected, soup, policies..., order);
      check_same<OnMesh<CellComplex>>("Linear_cell_complex", expected, soup, policies..., order);
      check_same<OnMesh<PolyMesh>>("OpenMesh", expected, soup, policies..., order);
    }
  });
}

} // namespace test

#endif // TEST_POLICIES_ON_ALL_H
