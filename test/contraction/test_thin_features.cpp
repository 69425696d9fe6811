// ThinFeatureQuadric: what a loss costs, and thin parts that stay.
#include "contractions.h"
#include "meshes.h"
#include "soups.h"

#include <quadrille/distance.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

namespace {

using namespace quadrille;
using internal::Index;
using test::is_identical;
using test::Mesh;
using test::read_model;
using test::Soup;

ThinFeatureQuadric with_loss(double weight, double tolerance) {
  ThinFeatureQuadric cost;
  cost.loss_weight = weight;
  cost.loss_tolerance = tolerance;
  return cost;
}

// Ends passes, of which each asks once, so that no pair waits in a queue.
struct ThreePasses : Visitor {
  mutable int passes = 0;
  bool proceed(const Status& status) const { return status.contractions == 0 || ++passes < 3; }
};

template <class Cost, class... Arguments>
Soup simplified(const Mesh& input, const Cost& cost, const Arguments&... arguments) {
  Mesh mesh = input;
  simplify(mesh, cost, arguments...);
  return test::to_soup(mesh);
}

// A plane of a face.
struct Plane {
  Vector<3> point, normal; // of unit length
  double area;
};

// The planes of the faces that have gone into each vertex.
class Remembered {
public:
  explicit Remembered(const Soup& soup) : planes_(soup.points.size()) {
    for (const test::Triangle& t : soup.triangles) {
      const Vector<3>& p = soup.points[t[0]];
      const Vector<3> normal = double_area_vector(p, soup.points[t[1]], soup.points[t[2]]);
      const double length = std::sqrt(squared_length(normal));
      for (Index v : t)
        planes_[v].push_back({p, (1 / length) * normal, length / 2});
    }
  }

  // The area-weighted sum of squared distances of x to what v remembers.
  double value(Index v, const Vector<3>& x) const {
    double sum = 0;
    for (const Plane& plane : planes_[v])
      sum += plane.area * std::pow(dot(plane.normal, x - plane.point), 2);
    return sum;
  }

  // A third of it: each face has three corners.
  double area(Index v) const {
    double sum = 0;
    for (const Plane& plane : planes_[v])
      sum += plane.area / 3;
    return sum;
  }

  void merge(Index v, Index w) {
    planes_[v].insert(planes_[v].end(), planes_[w].begin(), planes_[w].end());
    planes_[w] = planes_[v];
  }

private:
  std::vector<std::vector<Plane>> planes_;
};

template <class Policies>
auto surface_of(const Soup& soup, const Policies& policies) {
  const auto input = test::input_of(soup);
  return std::make_unique<internal::WorkingSurface<Policies>>(input, input.box(), policies);
}

// Beyond the tolerance; not above 0 where there is none.
template <class Surface>
double excess(Surface& surface, const Remembered& remembered, Index v, Index w, double tolerance) {
  const auto target = surface.evaluator().evaluate(v, w).target;
  const double growth = remembered.value(v, target) + remembered.value(w, target) -
                        remembered.value(v, test::position(surface, v)) -
                        remembered.value(w, test::position(surface, w));
  return growth - 3 * std::pow(tolerance * (remembered.area(v) + remembered.area(w)), 2);
}

} // namespace

TEST_CASE("Only what is lost beyond the tolerance costs more") {
  const Mesh mesh = test::make_mesh(test::with_noise(test::torus(60, 30), 1, 0.02));
  const auto without = with_loss(0, 0);
  for (std::size_t count : {2000u, 200u}) {
    CAPTURE(count);
    const FaceCount stop{count};
    CHECK(is_identical(simplified(mesh, with_loss(3, 1e3), stop), simplified(mesh, without, stop)));
    CHECK_FALSE(
        is_identical(simplified(mesh, with_loss(3, 0), stop), simplified(mesh, without, stop)));
    const auto in_passes = [&](const auto& cost) {
      const ThreePasses visitor;
      return simplified(mesh, cost, stop, RelaxedOrder{}, CGAL::parameters::visitor(visitor));
    };
    CHECK(is_identical(in_passes(with_loss(3, 1e3)), in_passes(without)));
    CHECK_FALSE(is_identical(in_passes(with_loss(3, 0)), in_passes(without)));
  }
}

TEST_CASE("Nothing is lost of a sphere") {
  const Mesh mesh = test::make_mesh(test::with_noise(test::sphere(5), 1, 0.001));
  CHECK(is_identical(simplified(mesh, ThinFeatureQuadric{}, FaceRatio{0.2}),
                     simplified(mesh, with_loss(0, 0), FaceRatio{0.2})));
}

TEST_CASE("A loss is what the squared distances to remembered planes grow by, beyond a tolerance") {
  const double weight = 5, tolerance = GENERATE(0.0, 0.1, 0.2);
  CAPTURE(tolerance);
  const auto policies =
      internal::pick_policies<internal::NotGiven, internal::NotGiven>(with_loss(weight, tolerance));
  const auto no_losses =
      internal::pick_policies<internal::NotGiven, internal::NotGiven>(with_loss(0, 0));
  std::size_t losses = 0, others = 0;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const Soup soup = test::large(test::with_noise(test::uv_sphere(10, 9), seed, 0.03));
    Remembered remembered(soup);
    const auto surface = surface_of(soup, policies);
    const auto without = surface_of(soup, no_losses);
    test::Random random(seed);
    for (int step = 0; step < 30; ++step) {
      std::vector<std::array<Index, 2>> pairs;
      const auto compare = [&](Index v, Index w, float listed_cost) {
        CAPTURE(seed, step, v, w);
        const auto candidate = surface->evaluator().evaluate(v, w);
        REQUIRE(listed_cost == Approx(candidate.key).epsilon(1e-5));
        const double cost = candidate.cost;
        const double loss = excess(*surface, remembered, v, w, tolerance);
        ++(loss > 0 ? losses : others);
        const double expected =
            without->evaluator().evaluate(v, w).cost + weight * std::max(0.0, loss);
        REQUIRE(cost == Approx(expected).epsilon(1e-5));
        pairs.push_back({v, w});
      };
      for (Index v = 0; v < surface->complex().vertex_capacity(); ++v)
        surface->pairs().for_each(surface->scratch(), v, [&](Index w, float listed_cost) {
          if (v < w)
            compare(v, w, listed_cost);
        });
      for (int attempt = 0; attempt < 20; ++attempt) {
        const auto [a, b] = pairs[random.below(pairs.size())];
        if (!test::contract(*surface, a, b))
          continue;
        REQUIRE(test::contract(*without, a, b));
        remembered.merge(a, b);
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
    simplify(mesh, cost, FaceCount{faces});
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
