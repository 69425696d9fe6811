// CostLimit: greedy order ends where the next pair costs more; passes leave out what does.
#include "soups.h"

#include <quadrille/distance_limits.h>
#include <quadrille/edge_length.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>
#include <quadrille/weighted.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using test::Position;
using test::Soup;

// What contractions cost of which the policy has let the order go on; it stops at none.
struct Listen {
  static constexpr Needs needs = {.cost = true};
  std::vector<double>* costs;

  bool operator()(const Status& status) const {
    if (status.next_cost < std::numeric_limits<double>::infinity() && status.next_cost > 0) {
      costs->resize(std::max(costs->size(), status.contractions + 1));
      costs->back() = status.next_cost;
    }
    return false;
  }
};

// Stops at a limit, and tells how much was below.
struct Highest {
  static constexpr Needs needs = {.cost = true};
  double limit;
  double* highest;
  bool operator()(const Status& status) const {
    if (status.next_cost > limit)
      return true;
    *highest = std::max(*highest, status.next_cost);
    return false;
  }
};

template <class... Policies>
Report reduce(Soup& soup, const Policies&... policies) {
  return simplify(soup.points, soup.triangles, policies...);
}

// The costs of a run to the end.
template <class... Policies>
std::vector<double> costs_of(Soup soup, const Policies&... policies) {
  std::vector<double> costs;
  const Report report = reduce(soup, Listen{&costs}, policies...);
  costs.resize(std::min(costs.size(), report.contractions));
  return costs;
}

Soup model() {
  return test::with_noise(test::sphere(4), 8, 0.01);
}
Soup open_model() {
  return test::with_noise(test::grid(30, 20), 8, 0.01);
}

Soup times(Soup soup, double factor) {
  for (Position& p : soup.points)
    p = factor * p;
  return soup;
}

} // namespace

TEMPLATE_TEST_CASE("Greedy order ends where the next pair costs more than the limit", "", Quadric,
                   MemorylessQuadric, ThinFeatureQuadric) {
  for (const Soup& soup : {model(), open_model()}) {
    const std::vector<double> costs = costs_of(soup, TestType{});
    for (const std::size_t contractions : {costs.size() / 4, costs.size() / 2}) {
      const double limit = costs[contractions];
      Soup left = soup;
      std::vector<double> seen;
      const Report report =
          reduce(left, TestType{}, AllOf{CostLimit{limit}, CostLimit{0.9 * limit}});
      const auto first_beyond =
          std::find_if(costs.begin(), costs.end(), [&](double cost) { return cost > limit; });
      // Costs that look at the surface as it is take a pair that has become a little more costly;
      // beyond the limit they do not, and go on with what costs less.
      CHECK(report.contractions >= static_cast<std::size_t>(first_beyond - costs.begin()));
      CHECK(report.stop == StopReason::target_met);
      if constexpr (std::is_same_v<TestType, Quadric>)
        CHECK(report.contractions == static_cast<std::size_t>(first_beyond - costs.begin()));
      else
        CHECK(static_cast<double>(report.contractions) < 1.1 * double(contractions));
    }
  }
}

TEST_CASE("Of edge lengths, none is left below the limit") {
  for (const bool in_passes : {false, true}) {
    Soup soup = model();
    AnyOrder order = GreedyOrder{};
    if (in_passes)
      order = RelaxedOrder{};
    reduce(soup, EdgeLength{}, MidpointPlacement{}, CostLimit{0.25 * 0.25}, Topology::free,
           NormalFlip{180}, order);
    double shortest = 1;
    for (const auto& t : soup.triangles)
      for (std::size_t i = 0; i < 3; ++i)
        shortest =
            std::min(shortest, squared_distance(soup.points[t[i]], soup.points[t[(i + 1) % 3]]));
    CHECK(shortest > 0.25 * 0.25 * (1 - 1e-6));
    CHECK(soup.triangles.size() > 50);
  }
}

TEMPLATE_TEST_CASE("Passes contract what costs less than the limit, and nothing else", "", Quadric,
                   MemorylessQuadric) {
  for (const Soup& soup : {model(), open_model()}) {
    const std::vector<double> costs = costs_of(soup, TestType{});
    const double limit = costs[costs.size() / 2];
    Soup greedy = soup;
    reduce(greedy, TestType{}, CostLimit{limit});
    for (const RelaxedOrder& order : {RelaxedOrder{}, RelaxedOrder{.share = 1}}) {
      Soup left = soup;
      const Report report = reduce(left, TestType{}, CostLimit{limit}, order);
      CHECK(static_cast<double>(left.triangles.size()) ==
            Approx(double(greedy.triangles.size())).epsilon(0.05));
      CHECK(report.stop == StopReason::target_met);
    }
    Soup left = soup; // whatever passes and the order behind them do
    double highest = 0;
    reduce(left, TestType{}, Highest{limit, &highest}, RelaxedOrder{.share = 1});
    CHECK(highest <= limit);
    CHECK(highest > 0.9 * limit);
  }
}

TEST_CASE("Limits of cost are in the units of the mesh") {
  const Soup soup = model();
  const auto count = [&](double factor, const auto& cost, double limit) {
    Soup scaled = times(soup, factor);
    reduce(scaled, cost, MidpointPlacement{}, CostLimit{limit});
    return scaled.triangles.size();
  };
  const auto check = [&](const auto& cost, double power) {
    const std::vector<double> costs = costs_of(soup, cost, MidpointPlacement{});
    const double limit = costs[costs.size() / 2];
    const std::size_t faces = count(1, cost, limit);
    CHECK(static_cast<double>(faces) == Approx(0.5 * double(soup.triangles.size())).epsilon(0.2));
    for (const double factor : {2.0, 0.125, 1024.0}) { // powers of 2 change no bits
      CHECK(count(factor, cost, limit * std::pow(factor, power)) == faces);
      CHECK(count(factor, cost, 1.5 * limit * std::pow(factor, power)) < faces);
    }
  };
  check(Quadric{}, 4);
  check(Quadric{.weighting = Weighting::uniform}, 2);
  check(MemorylessQuadric{}, 4.5);
  check(ThinFeatureQuadric{}, 4);
  check(EdgeLength{}, 2);
  check(Weighted(EdgeLength{}, [](const Position&) { return 1.0; }), 2); // which is not scale-free

  const std::vector<double> lengths = costs_of(soup, EdgeLength{}, MidpointPlacement{});
  double shortest = 9;
  for (const auto& t : soup.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      shortest =
          std::min(shortest, squared_distance(soup.points[t[i]], soup.points[t[(i + 1) % 3]]));
  CHECK(lengths.front() == Approx(shortest));
}

TEST_CASE("A limit of cost beside other stop policies") {
  const Soup soup = model();
  const std::vector<double> costs = costs_of(soup, Quadric{});
  const CostLimit half{costs[costs.size() / 2]}, tenth{costs[costs.size() / 10]};
  const auto faces = [&](const auto& stop, const auto&... rest) {
    Soup left = soup;
    reduce(left, Quadric{}, stop, rest...);
    return left.triangles.size();
  };
  CHECK(faces(AnyOf{half, FaceCount{1800}}) == 1800);
  CHECK(faces(AnyOf{tenth, FaceCount{500}}) == faces(tenth));
  CHECK(faces(AllOf{tenth, FaceCount{500}}) == 500);
  CHECK(faces(AllOf{half, FaceCount{1800}}) == faces(half));
  CHECK(faces(AnyOf{half, DistanceLimit{0.003}}) >= faces(DistanceLimit{0.003}));
  CHECK(faces(AnyOf{half, DistanceLimit{10.0}}) == faces(half));
  CHECK(100 * faces(AnyOf{AnyOf{half}, FaceCount{0}}, RelaxedOrder{}) < 105 * faces(half));
  CHECK(faces(CostLimit{0}) == soup.triangles.size());
  CHECK(faces(CostLimit{std::numeric_limits<double>::infinity()}) == faces(FaceCount{0}));
}

TEST_CASE("A limit that all contractions are below is met when none is left") {
  Soup soup = model();
  const Report report = reduce(soup, Quadric{}, CostLimit{1e9});
  CHECK(soup.triangles.size() == 4);
  CHECK(report.stop == StopReason::target_met);
}

TEST_CASE("A part vanishes only if it costs less than the limit") {
  Soup soup = joined(model(), times(model(), 1e-3), {{3, 0, 0}});
  const std::vector<double> costs = costs_of(soup, Quadric{}, Topology::components_may_vanish);
  for (const bool in_passes : {false, true}) {
    AnyOrder order = GreedyOrder{};
    if (in_passes)
      order = RelaxedOrder{};
    Soup left = soup;
    CHECK(reduce(left, Quadric{}, CostLimit{0}, Topology::components_may_vanish, order)
              .vanished_components == 0);
    left = soup;
    CHECK(reduce(left, Quadric{}, CostLimit{1e-4}, Topology::components_may_vanish, order)
              .vanished_components == 1);
  }
}

TEST_CASE("What costs is known only to a stop policy that asks") {
  struct NeverKnown {
    bool* is_known;
    bool operator()(const Status& status) const {
      *is_known |= status.next_cost < std::numeric_limits<double>::infinity() &&
                   status.contractions > 0 && status.next_cost > 0;
      return false;
    }
  };
  Soup soup = model();
  bool is_known = false;
  reduce(soup, Quadric{}, NeverKnown{&is_known});
  CHECK_FALSE(is_known);
  CHECK_THROWS_AS(reduce(soup, CostLimit{-1}), std::invalid_argument);
  CHECK_THROWS_AS(reduce(soup, CostLimit{std::nan("")}), std::invalid_argument);
  CHECK(CostLimit{3}.cost() == 3);
}
