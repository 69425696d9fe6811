// The indices by which costs and placements are told what a pair is about: those of the input.
#include "meshes.h"

#include <quadrille/record.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>
#include <quadrille/weighted.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <type_traits>
#include <vector>

using namespace quadrille;
using namespace test;

namespace {

// What the calls of a policy have seen.
struct Seen {
  std::size_t calls = 0, untouched = 0, greatest = 0;
  bool is_wrong = false;
};

// How far the ends have to go, times the importance of the most important vertex of the input that
// they stand for. It looks whether what it is told is right.
struct ByImportance {
  static constexpr std::size_t dimension = 3;
  static constexpr bool asks_for_indices = true;
  struct State {
    std::vector<std::size_t> indices; // of all that a vertex stands for
    void operator+=(const State& other) {
      indices.insert(indices.end(), other.indices.begin(), other.indices.end());
    }
    bool has(std::size_t index) const { return std::ranges::count(indices, index) == 1; }
  };

  const std::vector<Position>* points; // of the input
  const std::vector<double>* importance;
  Seen* seen;

  State face(const Position&, const Position&, const Position&) const { return {}; }
  State input_vertex(std::size_t index) const { return {{index}}; }
  double operator()(const auto& pair, const Position& x) const {
    const std::vector<std::size_t>& all = pair.state.indices;
    ++seen->calls;
    seen->greatest = std::max(seen->greatest, all.size());
    seen->is_wrong |= !pair.state.has(pair.first_index) || !pair.state.has(pair.second_index);
    if (all.size() == 2) { // both are where they were
      ++seen->untouched;
      seen->is_wrong |=
          pair.first != (*points)[pair.first_index] || pair.second != (*points)[pair.second_index];
    }
    double greatest = 0;
    for (std::size_t v : all)
      greatest = std::max(greatest, (*importance)[v]);
    return greatest * (squared_distance(pair.first, x) + squared_distance(pair.second, x));
  }
};

struct Two {
  double operator()(const Position&) const { return 2; }
};
static_assert(CostPolicy<ByImportance> && CostPolicy<Weighted<ByImportance, Two>>);
static_assert(
    std::derived_from<internal::PairOf<Weighted<ByImportance, Two>>, internal::PairIndices>);
static_assert(std::is_empty_v<internal::IndicesFor<Quadric>>); // who does not ask pays nothing
static_assert(sizeof(internal::PairOf<Quadric>) ==
              2 * sizeof(Position) + sizeof(Quadric::State) + sizeof(double));
static_assert(std::is_empty_v<internal::PairNames<internal::UsualPolicies<Quadric, false>>>);

// A surface whose vertices lie in any order, three of them without a face, and how important they
// are: a hundred times as much where x > 0.
struct Example {
  Soup soup = shuffled(with_noise(torus(110, 50), 1, 0.005), 1);
  std::vector<double> importance;
  Seen seen;

  Example() {
    soup.points.insert(soup.points.begin(), 3, Position{});
    for (Triangle& t : soup.triangles)
      for (auto& v : t)
        v += 3;
    for (const Position& p : soup.points)
      importance.push_back(p[0] > 0 ? 100 : 1);
  }
  ByImportance cost() { return {&soup.points, &importance, &seen}; }

  void check(const Soup& after) const {
    CHECK(!seen.is_wrong);
    CHECK(seen.untouched > 3 * soup.points.size());
    const auto important =
        std::ranges::count_if(after.points, [](const Position& p) { return p[0] > 0; });
    CHECK(important > 3 * (std::ssize(after.points) - important));
  }
};

// The middle, as it is told by a placement of either unit: are the ends those that a recorder has
// been told of last?
struct Places {
  std::vector<Position> at;
  std::size_t calls = 0;
  bool is_wrong = false;

  void begin(const RecordedSurface& surface) {
    for (std::size_t v = 0; 3 * v < surface.values.size(); ++v)
      at.push_back({{surface.values[3 * v], surface.values[3 * v + 1], surface.values[3 * v + 2]}});
  }
  void record(const RecordedContraction& contraction) {
    if (contraction.kept != not_recorded)
      std::copy_n(contraction.values.begin(), 3, at[contraction.kept].coordinates.begin());
  }
  void end() {}
};

template <bool is_scale_free>
struct Middle {
  static constexpr bool asks_for_indices = true;
  using ScaleFree = std::conditional_t<is_scale_free, Middle, void>;
  Places* places;

  Position operator()(const auto& cost, const auto& pair) const {
    ++places->calls;
    const Position way = pair.second - pair.first;
    const Position told = places->at[pair.second_index] - places->at[pair.first_index];
    // The engine's unit is a power of two times that of the mesh.
    const double scale = is_scale_free ? std::sqrt(squared_length(told) / squared_length(way)) : 1;
    places->is_wrong |= !(squared_distance(scale * way, told) <= 1e-24);
    const Position middle = 0.5 * (pair.first + pair.second);
    return cost(pair, middle) < cost(pair, pair.first) ? middle : pair.first;
  }
};

template <bool is_scale_free>
void check_placement() {
  Soup soup = shuffled(with_noise(torus(40, 20), 1, 0.01), 2);
  soup.points.insert(soup.points.begin(), 3, Position{});
  for (Triangle& t : soup.triangles)
    for (auto& v : t)
      v += 3;
  Places places;
  const Report report =
      simplify(soup.points, soup.triangles, Quadric{}, Middle<is_scale_free>{&places},
               FaceRatio{0.2}, record_into(places));
  CHECK(report.contractions > 500);
  CHECK(places.calls > 2000);
  CHECK(!places.is_wrong);
}

} // namespace

TEST_CASE("A cost is told the vertices of a soup, and remembers all that they stand for") {
  Example example;
  Soup soup = example.soup;
  SECTION("one by one") {
    simplify(soup.points, soup.triangles, example.cost(), MidpointPlacement{}, FaceRatio{0.2});
    example.check(soup);
  }
  SECTION("in passes") {
    simplify(soup.points, soup.triangles, example.cost(), MidpointPlacement{}, FaceRatio{0.2},
             RelaxedOrder{});
    example.check(soup);
  }
  SECTION("in passes that remember anew, to the end") {
    simplify(soup.points, soup.triangles, example.cost(), MidpointPlacement{}, FaceCount{40},
             RelaxedOrder{.refresh = true});
    CHECK(!example.seen.is_wrong);
    CHECK(example.seen.greatest > 5500 / 20);
  }
}

TEST_CASE("A cost is told the vertices of a mesh, in its order") {
  Example example;
  Mesh mesh = make_mesh<Mesh>(example.soup);
  mesh.remove_vertex(Mesh::Vertex_index(1)); // of no face: there is a gap
  REQUIRE(mesh.has_garbage());
  example.soup.points.erase(example.soup.points.begin() + 1);
  example.importance.erase(example.importance.begin() + 1);
  simplify(mesh, example.cost(), MidpointPlacement{}, FaceRatio{0.2});
  example.check(to_soup(mesh));
}

TEST_CASE("A placement is told the vertices of its pair, in either unit") {
  check_placement<true>();
  check_placement<false>();
}
