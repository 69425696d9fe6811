// What a memoryless cost says of a pair, through any number of contractions, is what its faces say.
#include "contractions.h"
#include "soups.h"

#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using internal::Index;
using test::Soup;

template <class Surface>
Soup soup_of(const Surface& surface) {
  Soup soup;
  for (Index v = 0; v < surface.complex().vertex_capacity(); ++v)
    soup.points.push_back(test::position(surface, v));
  for (Index face = 0; face < surface.complex().face_capacity(); ++face)
    if (!surface.complex().is_removed(face))
      soup.triangles.push_back(surface.complex().vertices(face));
  return soup;
}

bool has(const test::Triangle& t, Index v) {
  return std::find(t.begin(), t.end(), v) != t.end();
}

// The sum of squared distances of x to the planes of the faces at a or b, each once, weighted by a
// power of their areas, with the constraint planes beside them.
double cost_of(const Soup& soup, Index a, Index b, const Vector<3>& x, double boundary_weight,
               double power) {
  double sum = 0;
  const auto shares_edge = [&](const test::Triangle& t, Index v, Index w) {
    return std::count_if(soup.triangles.begin(), soup.triangles.end(),
                         [&](const auto& other) { return has(other, v) && has(other, w); }) == 1 &&
           has(t, v) && has(t, w);
  };
  for (const test::Triangle& t : soup.triangles) {
    if (!has(t, a) && !has(t, b))
      continue;
    const Vector<3>& p = soup.points[t[0]];
    const Vector<3> normal = double_area_vector(p, soup.points[t[1]], soup.points[t[2]]);
    const double twice_area = std::sqrt(squared_length(normal));
    const double distance = dot(normal, x - p) / twice_area;
    sum += std::pow(twice_area / 2, power) * distance * distance;
    for (std::size_t i = 0; i < 3; ++i) {
      const Index v = t[i], w = t[(i + 1) % 3];
      if (!shares_edge(t, v, w) || (v != a && v != b && w != a && w != b))
        continue;
      const Vector<3> along = soup.points[w] - soup.points[v];
      const Vector<3> across = cross(along, normal);
      const double offset = dot(across, x - soup.points[v]);
      sum += boundary_weight * std::pow(squared_length(along), power) * offset * offset /
             squared_length(across);
    }
  }
  return sum;
}

template <class Surface>
std::vector<std::pair<Index, float>> pairs_of(Surface& surface, Index v) {
  std::vector<std::pair<Index, float>> pairs;
  surface.pairs().for_each(surface.scratch(), v,
                           [&](Index w, float cost) { pairs.emplace_back(w, cost); });
  return pairs;
}

// Checks the cost of every pair, contracts one, and so on. Returns how many contractions it did.
template <class Surface>
std::size_t contract_and_compare(Surface& surface, std::uint64_t seed, int steps, double power) {
  test::Random random(seed);
  std::size_t contractions = 0;
  for (int step = 0; step < steps; ++step) {
    const Soup soup = soup_of(surface);
    for (Index v = 0; v < surface.complex().vertex_capacity(); ++v) {
      if (!surface.complex().has_faces(v))
        continue;
      for (const auto& [w, listed_cost] : pairs_of(surface, v)) {
        if (w < v)
          continue;
        const auto candidate = surface.evaluator().evaluate(v, w);
        CAPTURE(seed, step, v, w);
        REQUIRE(listed_cost == Approx(candidate.key).epsilon(1e-6).margin(1e-30));
        REQUIRE(candidate.cost ==
                Approx(cost_of(soup, v, w, candidate.target, 100, power)).epsilon(1e-6));
      }
    }
    for (int attempt = 0; attempt < 100; ++attempt) {
      const test::Triangle t = soup.triangles[random.below(soup.triangles.size())];
      const auto [a, b] = std::minmax(t[0], t[1]);
      if (test::contract(surface, a, b)) {
        ++contractions;
        break;
      }
    }
  }
  return contractions;
}

template <class Cost, class... Arguments>
void check_costs(const Cost& cost, double power, const Soup& soup, std::uint64_t seed,
                 const Arguments&... arguments) {
  const auto policies =
      internal::pick_policies<internal::NotGiven, internal::NotGiven>(cost, arguments...);
  const auto input = test::input_of(test::large(soup));
  internal::WorkingSurface<std::remove_const_t<decltype(policies)>> surface(input, input.box(),
                                                                            policies);
  CHECK(contract_and_compare(surface, seed, 12, power) > 8);
}

template <class... Arguments>
void check(const Soup& soup, std::uint64_t seed, const Arguments&... arguments) {
  check_costs(MemorylessQuadric{}, 1.25, soup, seed, arguments...);
}

} // namespace

TEST_CASE("The local terms of a closed surface are those of its faces") {
  for (std::uint64_t seed = 0; seed < 3; ++seed)
    check(test::random_closed(seed), seed);
}

TEST_CASE("The local terms of a surface with borders are those of its faces and borders") {
  for (std::uint64_t seed = 0; seed < 3; ++seed)
    check(test::random_with_boundaries(seed), seed);
}

TEST_CASE("A vertex of many faces shares with its neighbours what one of few does") {
  Soup soup = test::with_noise(test::uv_sphere(24, 6), 5, 0.02); // 24 faces at each pole
  check(soup, 5);
  soup.triangles.erase(soup.triangles.begin()); // now one pole lies on a border
  check(soup, 6);
}

TEST_CASE("A vertex forgets what few faces have said when it gets many") {
  const Soup soup = test::large(test::with_noise(test::uv_sphere(14, 8), 5, 0.01));
  const auto policies = internal::pick_policies<MemorylessQuadric, OptimalPlacement>();
  const auto input = test::input_of(soup);
  internal::WorkingSurface<std::remove_const_t<decltype(policies)>> surface(input, input.box(),
                                                                            policies);
  Index pole = 0;
  const auto faces_at = [&](Index v) { return surface.complex().degree_bound(v); };
  for (Index v = 0; v < surface.complex().vertex_capacity(); ++v)
    if (faces_at(v) > faces_at(pole))
      pole = v;
  REQUIRE(faces_at(pole) == 14);
  const auto widen = [&] {
    for (const auto& [w, cost] : pairs_of(surface, pole))
      if (w > pole && test::contract(surface, pole, w))
        return true;
    return false;
  };
  while (faces_at(pole) < 20) {
    REQUIRE(widen());
    for (const auto& [w, cost] : pairs_of(surface, pole))
      CHECK(cost == Approx(surface.evaluator().evaluate(pole, w).key).epsilon(1e-6).margin(1e-30));
  }
}

TEST_CASE("Local terms follow in passes, but for vertices that these have contracted") {
  const Soup input = test::random_closed(5);
  const auto policies =
      internal::pick_policies<MemorylessQuadric, OptimalPlacement>(RelaxedOrder{});
  const auto arrays = test::input_of(test::large(input));
  internal::WorkingSurface<std::remove_const_t<decltype(policies)>> surface(arrays, arrays.box(),
                                                                            policies);
  std::vector<bool> is_touched(surface.complex().vertex_capacity());
  std::size_t contractions = 0, compared = 0;
  for (Index face = 0; face < surface.complex().face_capacity(); face += 7) {
    const auto [a, b, c] = surface.complex().vertices(face);
    if (surface.complex().is_removed(face) || is_touched[a] || is_touched[b])
      continue;
    auto candidate = surface.evaluator().evaluate(a, b);
    const internal::GatheredStar star(surface.complex(), a, b, surface.scratch());
    internal::Contraction contraction(candidate, star);
    if (surface.checks().rejection(contraction))
      continue;
    surface.apply(contraction, internal::InPass{[&](Index v) { return !is_touched[v]; }});
    is_touched[a] = is_touched[b] = true;
    ++contractions;
    const Soup soup = soup_of(surface);
    for (const test::Triangle& t : soup.triangles) {
      if (is_touched[t[0]] || is_touched[t[1]])
        continue;
      const auto other = surface.evaluator().evaluate(t[0], t[1]);
      CAPTURE(face, t);
      REQUIRE(other.cost ==
              Approx(cost_of(soup, t[0], t[1], other.target, 100, 1.25)).epsilon(1e-6));
      ++compared;
    }
  }
  CHECK(contractions > 5);
  CHECK(compared > 100);
}

TEST_CASE("Local terms follow where topology is free") {
  check(test::random_with_boundaries(4), 4, Topology::free);
  // Parts without a border become sheets, which have one.
  const Soup part = test::with_noise(test::torus(4, 3), 1, 0.1);
  for (std::uint64_t seed = 0; seed < 4; ++seed)
    check(test::joined(part, part, {{4, 0, 0}}), seed, Topology::free);
}

TEST_CASE("A memoryless position of least cost keeps the volume") {
  const Soup soup = test::large(test::with_noise(test::sphere(2), 1, 0.02));
  const auto policies = internal::pick_policies<MemorylessQuadric, OptimalPlacement>();
  const auto input = test::input_of(soup);
  internal::WorkingSurface<std::remove_const_t<decltype(policies)>> surface(input, input.box(),
                                                                            policies);
  const double before = test::volume(soup);
  for (Index v = 0; v < 40; v += 3) {
    if (!surface.complex().has_faces(v))
      continue;
    const Index w = pairs_of(surface, v).front().first;
    if (test::contract(surface, std::min(v, w), std::max(v, w)))
      CHECK(test::volume(soup_of(surface)) == Approx(before).epsilon(1e-9));
  }
}

TEST_CASE("What is no loss of a thin feature costs by plain areas") {
  ThinFeatureQuadric cost;
  cost.loss_weight = 0;
  check_costs(cost, 1, test::random_closed(7), 7);
  check_costs(cost, 1, test::random_with_boundaries(8), 8);
}
