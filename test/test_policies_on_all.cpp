// Every cost with every placement, all pairs and both orders, on every kind of mesh and on soups.
#include "on_all.h"

#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace {

using namespace quadrille;
using namespace test;

template <class Kind, class Cost, class Placement, class Pairs, class Order>
Result check_result(const Soup& soup, const Cost& cost, const Placement& placement,
                    const Pairs& pairs, const Order& order) {
  constexpr bool is_by_edges = std::is_same_v<Pairs, EdgePairs>;
  const Topology topology = is_by_edges ? Topology::kept : Topology::free;
  const FaceRatio stop{0.3};
  const Result result = Kind::run(soup, cost, placement, pairs, order, stop, topology);
  INFO(result.report);
  const auto target = static_cast<std::size_t>(
      std::lround(stop.ratio * static_cast<double>(soup.triangles.size())));
  CHECK(result.soup.triangles.size() == result.report.faces_after);
  CHECK((result.report.stop == StopReason::target_met) == (result.report.faces_after <= target));
  CHECK(is_clean(result.soup));
  if (is_by_edges) {
    CHECK(topology_of(result.soup).is_manifold);
    CHECK(result.report.components_after == 2);
    CHECK(result.report.non_edge_contractions == 0);
  } else {
    CHECK(result.report.components_after == 1);
    CHECK(result.report.non_edge_contractions > 0);
  }
  if (std::is_same_v<Placement, EndpointPlacement>)
    for (std::size_t v = 0; v < result.soup.points.size(); ++v) {
      const Position& p = result.soup.points[v];
      REQUIRE(is_place_of(soup, p));
      if constexpr (Cost::dimension > 3) {
        const auto expected = attributes_at<Cost::dimension - 3>(p);
        REQUIRE(std::equal(expected.begin(), expected.end(), result.attributes[v].begin()));
      }
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

template <class... Policies>
void check_greedy(const Policies&... policies) {
  const Soup soup = two_parts();
  const GreedyOrder order;
  const Result expected = check_result<OnSoup>(soup, policies..., order);
  check_same<OnMesh<Mesh>>("Surface_mesh", expected, soup, policies..., order);
  check_same<OnMesh<Polyhedron>>("Polyhedron_3", expected, soup, policies..., order);
  check_same<OnMesh<CellComplex>>("Linear_cell_complex", expected, soup, policies..., order);
  check_same<OnMesh<PolyMesh>>("OpenMesh", expected, soup, policies..., order);
}

// On two kinds only, which keeps the compiler's time low. The parts are so large that passes pay:
// the result is not that of greedy order.
template <class... Policies>
void check_relaxed(const Policies&... policies) {
  const Soup soup = two_parts(with_noise(cube(6), 1, 0.1), with_noise(cube(6), 2, 0.1));
  const Result greedy = check_result<OnSoup>(soup, policies..., GreedyOrder{});
  for (const RelaxedOrder& order : {RelaxedOrder{}, RelaxedOrder{.refresh = true}}) {
    INFO("in passes" << (order.refresh ? ", refreshed" : ""));
    const Result expected = check_result<OnSoup>(soup, policies..., order);
    CHECK(expected.soup.triangles != greedy.soup.triangles);
    check_same<OnMesh<Mesh>>("Surface_mesh", expected, soup, policies..., order);
  }
}

template <class Cost>
void check_cost(const Cost& cost) {
  const auto check_placement = [&](const auto& placement) {
    check_greedy(cost, placement, EdgePairs{});
    check_greedy(cost, placement, ThresholdPairs::relative(0.1));
    check_relaxed(cost, placement, EdgePairs{});
    check_relaxed(cost, placement, ThresholdPairs::relative(0.1));
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

} // namespace

TEST_CASE("Quadric goes with all placements and pairs on all surfaces") {
  check_cost(Quadric{});
  check_cost(Quadric{.crease_degrees = 40, .weighting = Weighting::uniform});
}

TEST_CASE("MemorylessQuadric goes with all placements and pairs on all surfaces") {
  check_cost(MemorylessQuadric{});
}

TEST_CASE("EdgeLength goes with all that fits on all surfaces") {
  check_cost(EdgeLength{});
}

TEST_CASE("Attribute quadrics go with all placements and pairs on all surfaces") {
  check_cost(ColorQuadric{});
  check_cost(TextureQuadric{});
  check_cost(AttributeQuadric<1>{});
}

TEST_CASE("NormalQuadric goes with all placements and pairs on all surfaces") {
  check_cost(NormalQuadric{});
}
