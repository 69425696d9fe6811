// ThinFeatureQuadric: MemorylessQuadric where nothing is lost, and thin parts that stay.
#include "meshes.h"
#include "soups.h"

#include <quadrille/distance.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace {

using namespace quadrille;
using internal::Index;
using test::Mesh;
using test::read_model;
using test::Soup;

ThinFeatureQuadric with_loss(double weight, double tolerance) {
  ThinFeatureQuadric cost;
  cost.loss_weight = weight;
  cost.loss_tolerance = tolerance;
  return cost;
}

template <class Cost, class... Arguments>
Soup simplified(const Mesh& input, const Cost& cost, const Arguments&... arguments) {
  Mesh mesh = input;
  simplify<Cost, OptimalPlacement>(mesh, cost, arguments...);
  return test::to_soup(mesh);
}

bool is_identical(const Soup& a, const Soup& b) {
  return a.points == b.points && a.triangles == b.triangles;
}

// A plane of a face, as each of its corners remembers it.
struct Plane {
  Vector<3> point, normal; // of unit length
  double area;

  double squared_distance_to(const Vector<3>& x) const {
    return std::pow(dot(normal, x - point), 2);
  }
};

// What two vertices remember costs at one position.
double value(const std::vector<Plane>& planes, const Vector<3>& x) {
  double sum = 0;
  for (const Plane& plane : planes)
    sum += plane.area * plane.squared_distance_to(x);
  return sum;
}

double area(const std::vector<Plane>& planes) {
  double sum = 0;
  for (const Plane& plane : planes)
    sum += plane.area / 3;
  return sum;
}

} // namespace

TEST_CASE("Without a weight of losses, costs are memoryless ones") {
  const Mesh mesh = test::make_mesh(test::with_noise(test::torus(60, 30), 1, 0.02));
  for (std::size_t count : {2000u, 200u}) {
    CAPTURE(count);
    const FaceCount stop{count};
    CHECK(is_identical(simplified(mesh, with_loss(0, 0.15), stop),
                       simplified(mesh, MemorylessQuadric{}, stop)));
    CHECK(is_identical(simplified(mesh, with_loss(0, 0), stop, RelaxedOrder{}),
                       simplified(mesh, MemorylessQuadric{}, stop, RelaxedOrder{})));
    CHECK_FALSE(is_identical(simplified(mesh, with_loss(3, 0), stop),
                             simplified(mesh, MemorylessQuadric{}, stop)));
  }
}

TEST_CASE("Where nothing is lost, costs are memoryless ones") {
  const Mesh mesh = test::make_mesh(test::with_noise(test::sphere(5), 1, 0.001));
  CHECK(is_identical(simplified(mesh, ThinFeatureQuadric{}, FaceRatio{0.2}),
                     simplified(mesh, MemorylessQuadric{}, FaceRatio{0.2})));
}

TEST_CASE("A loss is what the squared distances to remembered planes grow by, beyond a tolerance") {
  const double weight = 5, tolerance = GENERATE(0.0, 0.1, 0.2);
  CAPTURE(tolerance);
  const auto policies =
      internal::pick_policies<ThinFeatureQuadric, OptimalPlacement>(with_loss(weight, tolerance));
  const auto memoryless = internal::pick_policies<MemorylessQuadric, OptimalPlacement>();
  std::size_t losses = 0, others = 0;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    Soup soup = test::with_noise(test::uv_sphere(10, 9), seed, 0.03);
    // Half of the extent is 2^20 and more: the engine's unit is the mesh's then.
    soup = test::mapped(soup, [&, unit = 0x1p22 / test::diagonal(soup)](const test::Position& p) {
      return unit * p;
    });
    internal::SurfaceInput<3> input;
    input.positions = soup.points;
    input.triangles = soup.triangles;
    std::vector<std::vector<Plane>> remembered(soup.points.size());
    for (const test::Triangle& t : soup.triangles) {
      const Vector<3> normal =
          double_area_vector(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]);
      const double length = std::sqrt(squared_length(normal));
      for (Index v : t)
        remembered[v].push_back({soup.points[t[0]], (1 / length) * normal, length / 2});
    }
    internal::PairContraction<std::remove_const_t<decltype(policies)>> surface(input, policies);
    internal::PairContraction<std::remove_const_t<decltype(memoryless)>> without(input, memoryless);
    internal::Scratch& scratch = surface.scratch();
    test::Random random(seed);
    for (int step = 0; step < 30; ++step) {
      struct Pair {
        Index first, second;
      };
      std::vector<Pair> allowed;
      for (Index v = 0; v < surface.vertex_capacity(); ++v) {
        if (!surface.complex().has_faces(v))
          continue;
        surface.for_each_pair(scratch, v, [&](Index w, float listed_cost) {
          if (w < v)
            return;
          const auto candidate = surface.evaluate(v, w);
          CAPTURE(seed, step, v, w);
          REQUIRE(listed_cost == Approx(candidate.cost).epsilon(1e-6));
          std::vector<Plane> planes = remembered[v];
          planes.insert(planes.end(), remembered[w].begin(), remembered[w].end());
          const double growth = value(planes, candidate.target) -
                                value(remembered[v], surface.position(v)) -
                                value(remembered[w], surface.position(w));
          const double excess = growth - 3 * std::pow(tolerance * area(planes), 2);
          ++(excess > 0 ? losses : others);
          const double expected = without.evaluate(v, w).cost + weight * std::max(0.0, excess);
          REQUIRE(candidate.cost == Approx(expected).epsilon(1e-5));
          allowed.push_back({v, w});
        });
      }
      for (int attempt = 0; attempt < 20; ++attempt) {
        const auto [a, b] = allowed[random.below(allowed.size())];
        const auto candidate = surface.evaluate(a, b);
        surface.gather(scratch, a, b);
        if (surface.rejection(scratch, a, b, candidate))
          continue;
        surface.contract(scratch, a, b, candidate);
        surface.count(scratch.tally);
        without.gather(without.scratch(), a, b);
        without.contract(without.scratch(), a, b, without.evaluate(a, b));
        remembered[a].insert(remembered[a].end(), remembered[b].begin(), remembered[b].end());
        remembered[b] = remembered[a];
        break;
      }
    }
  }
  CHECK(losses > 500);
  CHECK((tolerance == 0 || others > 1000));
}

TEST_CASE("Thin parts stay at low counts, and nothing is worse at others") {
  const auto error = [](const Mesh& input, const auto& cost, std::size_t faces) {
    Mesh mesh = input;
    simplify<std::remove_cvref_t<decltype(cost)>, OptimalPlacement>(mesh, cost, FaceCount{faces});
    mesh.collect_garbage();
    return surface_distance(mesh, input, {.samples = 10'000}).rms;
  };
  for (const char* name : {"cow", "dino", "camel"}) {
    const Mesh input = read_model(name);
    for (std::size_t faces : {64u, 500u}) {
      CAPTURE(name, faces);
      const double accumulated = error(input, Quadric{}, faces);
      const double memoryless = error(input, MemorylessQuadric{}, faces);
      const double ours = error(input, ThinFeatureQuadric{}, faces);
      CHECK(ours < 1.1 * std::min(accumulated, memoryless));
      if (faces == 64)
        CHECK(memoryless > 1.2 * ours); // lost a leg
    }
  }
}
