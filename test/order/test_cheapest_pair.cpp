// Greedy order beside a loop that costs all pairs anew at every step: the same contractions where
// only a vertex changes what its pairs cost, and as good a surface where costs change beside it.
#include "contractions.h"
#include "meshes.h"
#include "soups.h"

#include <quadrille/distance.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
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

template <class Surface>
Soup soup_left(const Surface& surface) {
  Soup soup;
  for (Index v = 0; v < surface.complex().vertex_capacity(); ++v)
    soup.points.push_back(test::position(surface, v));
  for (Index face = 0; face < surface.complex().face_capacity(); ++face)
    if (!surface.complex().is_removed(face))
      soup.triangles.push_back(surface.complex().vertices(face));
  return soup;
}

// What simplify() makes of a soup with as many contractions.
template <class Cost, class... Policies>
test::Mesh mesh_after(const Soup& soup, std::size_t contractions, const Policies&... policies) {
  test::Mesh mesh = test::make_mesh(soup);
  simplify(
      mesh, Cost{}, [=](const Status& status) { return status.contractions == contractions; },
      Topology::kept, policies...);
  return mesh;
}

// The points of the vertices that are left, in the order of the vertices.
std::vector<test::Position> points_of(const test::Mesh& mesh) {
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

// Calls visit(surface, contractions) with what the loop makes of a soup, at every step.
template <class Cost, class Visit, class... Pairs>
void contract_all(const Soup& soup, Visit visit, const Pairs&... pairs) {
  const auto policies = internal::pick_policies<Cost, OptimalPlacement>(Topology::kept, pairs...);
  const auto surface_input = test::input_of(soup);
  internal::WorkingSurface<std::remove_const_t<decltype(policies)>> surface(
      surface_input, surface_input.box(), policies);
  for (std::size_t contractions = 1; contract_cheapest(surface); ++contractions)
    if (!visit(surface, contractions))
      break;
}

template <class Cost, class... Pairs>
void require_same(const Soup& input, const Pairs&... pairs) {
  const Soup soup = test::large(input);
  const auto is_same = [&](const auto& surface, std::size_t contractions) {
    CAPTURE(contractions);
    if (contractions % 10 == 0)
      REQUIRE(are_near(points_of(mesh_after<Cost>(soup, contractions, pairs...)),
                       points_left(surface)));
    return true;
  };
  contract_all<Cost>(soup, is_same, pairs...);
}

// The RMS distance to the input after greedy order, divided by that after the loop.
template <class Cost>
double ratio_of_distances(const Soup& input, std::size_t steps) {
  const Soup soup = test::large(input);
  double ratio = 0;
  contract_all<Cost>(soup, [&](const auto& surface, std::size_t contractions) {
    if (contractions < steps)
      return true;
    const auto rms = [&](const Soup& result) {
      return surface_distance(test::points_of(soup), soup.triangles, test::points_of(result),
                              result.triangles, DistanceSampling{.samples = 2000})
          .rms;
    };
    ratio = rms(test::to_soup(mesh_after<Cost>(soup, steps))) / rms(soup_left(surface));
    return false;
  });
  return ratio;
}

} // namespace

TEST_CASE("Each contraction is the cheapest that there is") {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    CAPTURE(seed);
    require_same<Quadric>(test::random_closed(seed));
    require_same<Quadric>(test::random_with_boundaries(seed));
  }
  require_same<Quadric>(test::random_closed(7), ThresholdPairs(0x1p22 / 8));
}

TEMPLATE_TEST_CASE("Where costs change beside contractions the result is as close", "",
                   MemorylessQuadric, ThinFeatureQuadric) {
  double ratio = 1;
  for (std::uint64_t seed = 0; seed < 4; ++seed)
    ratio *= ratio_of_distances<TestType>(test::with_noise(test::sphere(3), seed, 0.02), 180);
  CAPTURE(ratio);
  CHECK(std::pow(ratio, 0.25) < 1.05);
  CHECK(std::pow(ratio, 0.25) > 0.9);
}
