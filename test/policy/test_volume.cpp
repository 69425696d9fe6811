// VolumeKeeping keeps the volume beside any cost and placement, to the rounding of coordinates.
#include "soups.h"

#include <quadrille/edge_length.h>
#include <quadrille/guards.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/parameters.h>
#include <quadrille/placement.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using test::Position;
using test::Soup;

struct Result {
  Soup soup;
  Report report;
  double change; // of the volume, in itself
};

template <class Cost, class Placement>
Result simplified(const Soup& soup, double ratio, const auto&... arguments) {
  std::vector<std::array<double, 3>> points;
  for (const Position& p : soup.points)
    points.push_back(p.coordinates);
  Result result{{{}, soup.triangles}, {}, 0};
  result.report =
      simplify<Cost, Placement>(points, result.soup.triangles, FaceRatio{ratio}, arguments...);
  for (const auto& p : points)
    result.soup.points.push_back({p});
  const long double before = test::exact_volume(soup);
  result.change = static_cast<double>((test::exact_volume(result.soup) - before) / before);
  return result;
}

Soup noisy_torus(std::uint32_t around) {
  return test::with_noise(test::torus(2 * around, around), 4, 0.2 / around);
}

template <class Cost, class Placement>
void check(const Soup& soup, double tolerance, const auto&... arguments) {
  const Result plain = simplified<Cost, Placement>(soup, 0.05, arguments...);
  const Result kept = simplified<Cost, VolumeKeeping<Placement>>(soup, 0.05, arguments...);
  INFO(kept.report);
  CHECK(std::abs(kept.change) < tolerance);
  CHECK(std::abs(kept.change) <= std::abs(plain.change));
  CHECK(50 * kept.report.faces_after <= 51 * plain.report.faces_after);
  CHECK(test::topology_of(kept.soup).is_closed());
}

} // namespace

TEST_CASE("The volume stays the same, whatever the cost and the placement") {
  const Soup soup = noisy_torus(50);
  check<Quadric, OptimalPlacement>(soup, 1e-12);
  check<Quadric, EndpointPlacement>(soup, 1e-12);
  check<Quadric, MidpointPlacement>(soup, 1e-12);
  check<EdgeLength, MidpointPlacement>(soup, 1e-12);
  check<MemorylessQuadric, OptimalPlacement>(soup, 1e-12);
  check<MemorylessQuadric, EndpointPlacement>(soup, 1e-12);
  check<ThinFeatureQuadric, OptimalPlacement>(soup, 1e-12);
  check<Quadric, OptimalPlacement>(soup, 1e-12, RelaxedOrder{});
}

TEST_CASE("Doubles that happen to be floats keep the volume as others do, beside other promises") {
  const Soup soup = test::as_floats(noisy_torus(30));
  using Kept = VolumeKeeping<OptimalPlacement>;
  const Result apart = simplified<MemorylessQuadric, Kept>(soup, 0.2, NoSelfIntersection{});
  CHECK(std::abs(apart.change) < 1e-12);
  const Result floats = simplified<MemorylessQuadric, Kept>(
      soup, 0.2, NoSelfIntersection{}, parameters::coordinates_are_floats(true));
  CHECK(test::is_identical(floats.soup, test::as_floats(floats.soup)));
  CHECK(std::abs(floats.change) < 1e-6);
}

TEST_CASE("Tens of thousands of contractions do not add up to more") {
  const Soup soup = noisy_torus(150);
  const Result result = simplified<Quadric, VolumeKeeping<OptimalPlacement>>(soup, 0.02);
  CHECK(result.report.contractions > 40000);
  CHECK(std::abs(result.change) < 1e-12);
  CHECK(std::abs(*result.report.volume_after / *result.report.volume_before - 1) < 1e-12);
}

TEST_CASE("Far from the origin it stays the same up to the rounding of coordinates") {
  const Soup far = test::mapped(noisy_torus(50), [](const Position& p) {
    return p + Position{{1e5, -3e5, 2e5}};
  });
  check<Quadric, OptimalPlacement>(far, 1e-9);
}

TEST_CASE("A fixed vertex takes part only where the volume stays the same") {
  const Soup soup = test::cube(6);
  std::vector<int> is_fixed(soup.points.size(), 0);
  is_fixed[0] = 1;
  const auto fixed = CGAL::parameters::vertex_is_constrained_map(CGAL::make_property_map(is_fixed));
  const Result flat = simplified<Quadric, VolumeKeeping<OptimalPlacement>>(soup, 0.03, fixed);
  CHECK(flat.report.faces_after <= 14);
  CHECK(std::abs(flat.change) < 1e-14);

  const Soup torus = noisy_torus(30);
  is_fixed.assign(torus.points.size(), 1);
  for (std::size_t v = 0; v < is_fixed.size(); v += 3)
    is_fixed[v] = 0;
  const auto many = CGAL::parameters::vertex_is_constrained_map(CGAL::make_property_map(is_fixed));
  const Result curved = simplified<Quadric, VolumeKeeping<OptimalPlacement>>(torus, 0.03, many);
  CHECK(curved.report.rejected(Rejection::volume) > 0);
  CHECK(std::abs(curved.change) < 1e-12);
}

TEST_CASE("The place of least cost that keeps the volume is near the plain one") {
  const Result plain = simplified<Quadric, OptimalPlacement>(noisy_torus(50), 0.1);
  const Result kept = simplified<Quadric, VolumeKeeping<OptimalPlacement>>(noisy_torus(50), 0.1);
  CHECK(kept.report.error < 1.5 * plain.report.error);
}

TEST_CASE("The report tells the volume where there is one") {
  const auto report_of = [](const Soup& soup, const auto&... arguments) {
    const Result result =
        simplified<Quadric, VolumeKeeping<OptimalPlacement>>(soup, 0.5, arguments...);
    if (result.report.volume_after)
      CHECK(std::abs(*result.report.volume_after - double(test::exact_volume(result.soup))) <=
            1e-12 * std::abs(double(test::exact_volume(result.soup))));
    return result.report;
  };
  for (const double unit : {1e-80, 1.0, 1e30}) {
    const Soup soup = test::mapped(test::cube(4), [&](const Position& p) {
      return unit * (p + Position{{1000, 0, -3000}});
    });
    CHECK(*report_of(soup).volume_before == Approx(unit * unit * unit).epsilon(1e-11));
  }
  Soup bubble = test::mapped(test::sphere(2), [](const Position& p) { return 0.6 * p; });
  for (test::Triangle& t : bubble.triangles)
    std::swap(t[0], t[1]);
  const Soup ball = test::joined(test::sphere(3), bubble);
  CHECK(*report_of(ball).volume_before == Approx(double(test::exact_volume(ball))).epsilon(1e-13));
  CHECK_FALSE(report_of(test::grid(4, 4)).volume_before.has_value());
  CHECK_FALSE(report_of(test::sphere(2), Topology::free).volume_after.has_value());
  Soup turned = test::sphere(2);
  std::swap(turned.triangles[5][0], turned.triangles[5][1]);
  CHECK_FALSE(report_of(turned).volume_before.has_value());
  CHECK_FALSE(simplified<Quadric, OptimalPlacement>(test::sphere(2), 0.5) // nobody asks
                  .report.volume_before.has_value());
}
