// Filters and stops by lengths, angles and time: what the result has, told without the engine.
#include "hard_surfaces.h"
#include "meshes.h"

#include <quadrille/edge_length.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_ratio_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/property_map.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

using namespace quadrille;
using namespace test;

namespace {

using Edge = std::array<std::uint32_t, 2>;

std::set<Edge> edges_of(const Soup& soup) {
  std::set<Edge> edges;
  for (const Triangle& t : soup.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      edges.insert({std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])});
  return edges;
}

double length(const Soup& soup, const Edge& edge) {
  return std::sqrt(squared_distance(soup.points[edge[0]], soup.points[edge[1]]));
}

double longest_edge(const Soup& soup) {
  double longest = 0;
  for (const Edge& edge : edges_of(soup))
    longest = std::max(longest, length(soup, edge));
  return longest;
}

// In degrees, by the law of cosines.
double smallest_angle(const Soup& soup) {
  double smallest = 180;
  for (const Triangle& t : soup.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const double a = length(soup, {t[(i + 1) % 3], t[(i + 2) % 3]});
      const double b = length(soup, {t[i], t[(i + 1) % 3]}),
                   c = length(soup, {t[i], t[(i + 2) % 3]});
      const double cosine = (b * b + c * c - a * a) / (2 * b * c);
      smallest = std::min(smallest, std::acos(std::min(cosine, 1.0)) * 180 / std::numbers::pi);
    }
  return smallest;
}

// May a short edge be contracted, in a surface without borders that keeps its topology?
bool has_two_common_neighbours(const std::map<std::uint32_t, std::set<std::uint32_t>>& neighbours,
                               const Edge& edge) {
  std::vector<std::uint32_t> common;
  std::ranges::set_intersection(neighbours.at(edge[0]), neighbours.at(edge[1]),
                                std::back_inserter(common));
  return common.size() == 2;
}

template <class... Policies>
std::pair<Soup, Report> simplified_soup(Soup soup, const Policies&... policies) {
  const Report report = simplify(soup.points, soup.triangles, policies...);
  return {soup, report};
}

const Soup& input() {
  static const Soup soup = with_noise(torus(60, 30), 1, 0.01);
  return soup;
}

} // namespace

TEST_CASE("No edge becomes longer than LongestEdge says") {
  const double limit = 2 * longest_edge(input());
  CHECK(longest_edge(simplified_soup(input(), FaceCount{100}).first) > limit);
  for (const auto& [soup, report] :
       {simplified_soup(input(), FaceCount{100}, NormalFlip{}, LongestEdge{limit}),
        simplified_soup(input(), FaceCount{100}, NormalFlip{}, LongestEdge{limit},
                        RelaxedOrder{})}) {
    CHECK(report.faces_after < report.faces_before / 2);
    CHECK(report.rejected(Rejection::filter) > 0);
    CHECK(longest_edge(soup) <= limit);
  }
}

TEST_CASE("Edges that are longer than the limit become no longer") {
  const double limit = longest_edge(input());
  const Soup coarse = simplified_soup(input(), FaceCount{400}).first;
  REQUIRE(longest_edge(coarse) > limit);
  const Soup soup = simplified_soup(coarse, FaceCount{100}, NormalFlip{}, LongestEdge{limit}).first;
  CHECK(longest_edge(soup) <= longest_edge(coarse));
}

TEST_CASE("No face gets a smaller angle than SmallestAngle says") {
  const double limit = 15;
  REQUIRE(smallest_angle(input()) > limit);
  CHECK(smallest_angle(simplified_soup(input(), FaceCount{300}).first) < limit);
  const auto [soup, report] =
      simplified_soup(input(), FaceCount{300}, NormalFlip{}, SmallestAngle{limit});
  CHECK(report.rejected(Rejection::shape) > 0);
  CHECK(report.faces_after < 400);
  CHECK(smallest_angle(soup) >= limit * (1 - 1e-9));
}

TEST_CASE("The shortest edge is longer than ShortestEdge says, where edges may be contracted") {
  const Soup uneven = with_noise(torus(60, 30), 2, 0.05);
  const double limit = 2 * longest_edge(torus(60, 30));
  const auto check = [&](const auto&... policies) {
    const auto [soup, report] =
        simplified_soup(uneven, EdgeLength{}, ShortestEdge{limit}, NormalFlip{180}, policies...);
    CHECK(report.faces_after < report.faces_before / 2);
    CHECK(report.error <= limit * (1 + 1e-6));
    std::map<std::uint32_t, std::set<std::uint32_t>> neighbours;
    for (const Edge& edge : edges_of(soup)) {
      neighbours[edge[0]].insert(edge[1]);
      neighbours[edge[1]].insert(edge[0]);
    }
    for (const Edge& edge : edges_of(soup))
      if (length(soup, edge) <= limit)
        CHECK_FALSE(has_two_common_neighbours(neighbours, edge));
  };
  check(MidpointPlacement{});
  check(EndpointPlacement{});
  check(MidpointPlacement{}, RelaxedOrder{});
  const Soup free = simplified_soup(uneven, EdgeLength{}, MidpointPlacement{}, ShortestEdge{limit},
                                    NormalFlip{180}, Topology::free)
                        .first;
  for (const Edge& edge : edges_of(free))
    CHECK(length(free, edge) > limit);
}

TEST_CASE("Edges that are equal as floats are told apart by ShortestEdge") {
  Soup soup;
  for (int i = -20; i <= 20; ++i) {
    Soup part = mapped(octahedron(), [](const Position& p) { return 3.0 * p; });
    part.points[0] = {{2.5, 2.5, 0}};
    part.points[2] = {{1.5 - 1e-9 * i, 2.5, 0}};
    soup = joined(soup, part, {{0, 0, 10.0 * i}});
  }
  simplify(soup.points, soup.triangles, EdgeLength{}, MidpointPlacement{}, ShortestEdge{1},
           NormalFlip{180});
  for (const Edge& edge : edges_of(soup))
    CHECK(length(soup, edge) > 1);
  CHECK_FALSE(ShortestEdge{1}(Status{.next_error = 1 + 1e-8}));
  CHECK(ShortestEdge{1}(Status{.next_error = 1 + 1e-6}));
}

TEST_CASE("Nothing is contracted when the time is up, and a long time changes nothing") {
  for (const TimeBudget& budget : {TimeBudget(0), [] {
                                     TimeBudget budget(0.001);
                                     std::this_thread::sleep_for(std::chrono::milliseconds(2));
                                     return budget;
                                   }()}) {
    const auto [soup, report] = simplified_soup(input(), budget);
    CHECK(report.contractions == 0);
    CHECK(report.stop == StopReason::target_met);
    CHECK(soup.triangles.size() == input().triangles.size());
  }
  const Soup expected = simplified_soup(input(), FaceCount{200}).first;
  for (double seconds : {1e6, std::numeric_limits<double>::infinity()})
    CHECK(is_identical(simplified_soup(input(), AnyOf{FaceCount{200}, TimeBudget{seconds}}).first,
                       expected));
}

namespace {

struct LastStatus : Visitor {
  Status* last;

  explicit LastStatus(Status& status) : last(&status) {}
  bool proceed(const Status& status) const {
    *last = status;
    return true;
  }
};

void check_counted_edges(const Soup& surface, const auto&... policies) {
  const std::size_t before = topology_of(surface).edges;
  for (const std::size_t target : {before / 2, before / 6}) {
    Status last;
    const auto [soup, report] = simplified_soup(surface, EdgeCount{target}, policies...,
                                                CGAL::parameters::visitor(LastStatus(last)));
    const std::size_t after = topology_of(soup).edges;
    CAPTURE(target, after, report);
    CHECK(last.stage == Stage::write);
    CHECK(last.initial_edges == before);
    CHECK(last.edges == after);
    if (!is_target_reached(report.stop) && target < before / 2)
      continue; // topology holds more
    CHECK(after <= target);
    CHECK(after + 12 > target);
  }
}

} // namespace

TEST_CASE("EdgeCount stops at so many edges, whatever contractions take") {
  check_counted_edges(input());
  check_counted_edges(input(), RelaxedOrder{});
  const Soup sheet = with_noise(grid(60, 40), 3, 0.2);
  check_counted_edges(sheet);
  check_counted_edges(sheet, RelaxedOrder{});
  Soup parts = input();
  const Soup speck = mapped(octahedron(), [](const Position& p) { return 0.01 * p; });
  for (int i = 0; i < 20; ++i)
    parts = joined(parts, speck, {{9, 0, 1.0 * i}});
  CHECK(simplified_soup(parts, EdgeCount{300}, Topology::components_may_vanish)
            .second.vanished_components > 0);
  check_counted_edges(parts, Topology::components_may_vanish);
  const Soup cubes = random_cubes(9, 4); // edges of four faces, and tunnels that close
  REQUIRE_FALSE(topology_of(cubes).is_manifold);
  check_counted_edges(cubes);
  check_counted_edges(cubes, Topology::free);
  check_counted_edges(cubes, Topology::free, RelaxedOrder{});
  check_counted_edges(uv_sphere(400, 6)); // hubs at the poles
  check_counted_edges(uv_sphere(400, 6), Topology::free);
}

TEST_CASE("EdgeRatio is a part of the edges, of those that are selected") {
  Soup soup = input();
  const std::size_t edges = topology_of(soup).edges;
  const auto whole = simplified_soup(soup, EdgeRatio{0.25}).first;
  CHECK(topology_of(whole).edges <= edges / 4);
  CHECK(topology_of(whole).edges + 3 > edges / 4);
  std::vector<char> is_selected(soup.triangles.size());
  Soup half;
  half.points = soup.points;
  for (std::size_t i = 0; i < soup.triangles.size(); ++i)
    if (soup.points[soup.triangles[i][0]][0] > 0) {
      is_selected[i] = true;
      half.triangles.push_back(soup.triangles[i]);
    }
  const std::size_t selected = topology_of(half).edges;
  simplify(soup.points, soup.triangles, AnyOf{EdgeRatio{0.5}, FaceCount{0}},
           parameters::face_is_selected_map(CGAL::make_property_map(is_selected)));
  const std::size_t gone = edges - topology_of(soup).edges;
  CHECK(gone >= selected - selected / 2);
  CHECK(gone < selected - selected / 2 + 3);
  CHECK_THROWS_AS(simplify(soup.points, soup.triangles, EdgeRatio{1.5}), std::invalid_argument);
  CHECK_FALSE(EdgeCount{1'000'000}(Status{})); // who does not ask never stops by edges
}

namespace {

// A predicate written for CGAL's edge_collapse, by its own rules: generic in the edge profile.
struct CostPredicate {
  double limit;
  template <class Profile>
  bool operator()(double cost, const Profile&, std::size_t, std::size_t) const {
    return cost > limit;
  }
};

} // namespace

TEST_CASE("CgalStop asks predicates of CGAL as CGAL does") {
  namespace SMS = CGAL::Surface_mesh_simplification;
  const Soup soup = input();
  const std::size_t edges = topology_of(soup).edges;
  // CGAL asks before each contraction, and stops below the number.
  const auto counted =
      simplified_soup(soup, CgalStop(SMS::Count_stop_predicate<Mesh>(edges / 3))).first;
  CHECK(topology_of(counted).edges < edges / 3);
  CHECK(topology_of(counted).edges + 4 > edges / 3);
  const auto ratio =
      simplified_soup(soup, CgalStop(SMS::Count_ratio_stop_predicate<Mesh>(0.25))).first;
  CHECK(topology_of(ratio).edges * 4 < edges);
  CHECK(topology_of(ratio).edges * 4 + 16 > edges);
  const double limit = 1e-7;
  const auto by_cost = simplified_soup(soup, CgalStop(CostPredicate{limit})).first;
  CHECK(is_identical(by_cost, simplified_soup(soup, CostLimit{limit}).first));
  CHECK(by_cost.triangles.size() < soup.triangles.size());
  CHECK(by_cost.triangles.size() > 100);
}
