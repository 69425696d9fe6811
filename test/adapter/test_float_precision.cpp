// A mesh of floats comes out as good as floats can hold it: as with doubles, and rounded once.
#include "meshes.h"
#include "soups.h"

#include <quadrille/distance.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using test::Mesh;
using test::Position;
using test::Soup;
using Floats = CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>;

std::vector<std::pair<std::string, Soup>> surfaces() {
  return {{"sphere", test::with_noise(test::sphere(4), 1, 0.02)},
          {"genus 2", test::with_noise(test::plate_with_holes(2, 5), 2, 0.05)},
          {"sheet", test::with_noise(test::grid(30, 30), 3, 0.01)},
          {"cow", test::to_soup(test::read_model("cow"))}};
}

Position offset(const Soup& soup, double diagonals) {
  const double d = diagonals * test::diagonal(soup);
  return {{d, -0.7 * d, 0.4 * d}};
}

Soup moved(const Soup& soup, const Position& d) {
  return test::mapped(soup, [&](const Position& p) { return p + d; });
}

// From one float to the next where the coordinates are largest.
double step(const Soup& soup) {
  double largest = 0;
  for (const Position& p : soup.points)
    for (double x : p.coordinates)
      largest = std::max(largest, std::abs(x));
  const auto x = static_cast<float>(largest);
  return std::nextafter(x, std::numeric_limits<float>::infinity()) - x;
}

template <class M, class Cost, class Order>
M simplified(const Soup& soup, const Order& order) {
  M mesh = test::make_mesh<M>(soup);
  simplify<Cost, OptimalPlacement>(mesh, FaceRatio{0.25}, order);
  return mesh;
}

// From the same points of the input to surfaces of which each point is half a step away at most,
// along each axis.
void check_distance(const Soup& soup, const Floats& of_floats, const Mesh& of_doubles) {
  const Mesh input = test::make_mesh(soup);
  const SurfaceDistance distance = surface_distance(input, of_floats, {.samples = 5000});
  const SurfaceDistance expected = surface_distance(input, of_doubles, {.samples = 5000});
  CHECK(distance.rms_a_to_b <= expected.rms_a_to_b + step(soup));
  CHECK(distance.hausdorff_a_to_b <= expected.hausdorff_a_to_b + step(soup));
}

} // namespace

TEMPLATE_TEST_CASE("With points of floats the result is the nearest floats of that with doubles",
                   "", Quadric, MemorylessQuadric) {
  const auto check = [](const Soup& soup, const auto& order) {
    const Mesh of_doubles = simplified<Mesh, TestType>(soup, order);
    const Floats of_floats = simplified<Floats, TestType>(soup, order);
    const Soup expected = test::as_floats(test::to_soup(of_doubles));
    const Soup result = test::to_soup(of_floats);
    CHECK(result.points == expected.points);
    CHECK(result.triangles == expected.triangles);
    check_distance(soup, of_floats, of_doubles);
  };
  for (const auto& [name, soup] : surfaces())
    for (double diagonals : {0.0, 1e3, 1e4, 1e5}) {
      CAPTURE(name, diagonals);
      const Soup held = test::as_floats(moved(soup, offset(soup, diagonals)));
      check(held, GreedyOrder{});
      check(held, RelaxedOrder{});
    }
}

TEMPLATE_TEST_CASE("Far away, floats cost no more than what they cannot hold of the input", "",
                   Quadric, MemorylessQuadric) {
  const auto check = [](const Soup& soup, double diagonals, const auto& order) {
    const Position d = offset(soup, diagonals);
    const Soup held = test::as_floats(moved(soup, d));
    const Mesh input = test::make_mesh(soup);
    const Soup far = test::to_soup(simplified<Floats, TestType>(held, order));
    const Mesh back = test::make_mesh(moved(far, -1 * d));
    const Mesh expected = simplified<Mesh, TestType>(soup, order);
    CHECK(surface_distance(input, back, {.samples = 5000}).rms <=
          1.05 * surface_distance(input, expected, {.samples = 5000}).rms + 0.5 * step(held));
  };
  for (const auto& [name, soup] : surfaces())
    for (double diagonals : {1e3, 1e4, 1e5}) {
      CAPTURE(name, diagonals);
      check(soup, diagonals, GreedyOrder{});
      check(soup, diagonals, RelaxedOrder{});
    }
}

TEMPLATE_TEST_CASE("At the end of the range of numbers, what is left is in it", "", Mesh, Floats) {
  using FT = std::remove_cvref_t<decltype(typename TestType::Point().x())>;
  const double greatest = std::numeric_limits<FT>::max();
  const Soup ball = test::mapped(test::sphere(3), [&](const Position& p) { return greatest * p; });
  TestType mesh = test::make_mesh<TestType>(ball);
  const Report report = simplify(mesh, FaceCount{60});
  CHECK(report.stop == StopReason::target_met);
  std::size_t at_the_end = 0;
  for (const auto v : mesh.vertices())
    for (int i = 0; i < 3; ++i) {
      REQUIRE(std::isfinite(mesh.point(v)[i]));
      at_the_end += std::abs(mesh.point(v)[i]) == std::numeric_limits<FT>::max();
    }
  CHECK(at_the_end > 0);
}
