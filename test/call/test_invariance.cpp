// The result does not depend on the unit, the place, the direction or the numbering of the input.
#include "meshes.h"
#include "soups.h"

#include <quadrille/attribute_quadric.h>
#include <quadrille/distance_limits.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using test::Position;
using test::Soup;

struct Surface {
  std::string name;
  Soup soup;
};

std::vector<Surface> surfaces() {
  return {{"sphere", test::random_closed(0)},
          {"torus", test::random_closed(1)},
          {"genus 2", test::random_closed(2)},
          {"sheet", test::random_with_boundaries(3)},
          {"with holes", test::random_with_boundaries(4)}};
}

template <class Cost>
Soup simplified(const Soup& soup, Report* report = nullptr) {
  test::Mesh mesh = test::make_mesh(soup);
  // At fewer faces a sheet with holes ends before it is spoilt, which is told by parts of the
  // diagonal of its box; that depends on the direction.
  const Report told = simplify<Cost, OptimalPlacement>(mesh, FaceRatio{0.4});
  if (report)
    *report = told;
  return test::to_soup(mesh);
}

// The greatest distance of corresponding points, or infinity if the triangles are others.
double difference(const Soup& a, const Soup& b) {
  if (a.triangles != b.triangles || a.points.size() != b.points.size())
    return std::numeric_limits<double>::infinity();
  double squared = 0;
  for (std::size_t v = 0; v < a.points.size(); ++v)
    squared = std::max(squared, squared_distance(a.points[v], b.points[v]));
  return std::sqrt(squared);
}

// Simplifying and then mapping gives what mapping and then simplifying does, up to `tolerance` of
// the diagonal.
template <class Cost, class Map>
void check(const Soup& soup, Map map, double tolerance) {
  const Soup mapped_first = simplified<Cost>(test::mapped(soup, map));
  const Soup mapped_last = test::mapped(simplified<Cost>(soup), map);
  const double limit = tolerance > 0 ? tolerance * test::diagonal(mapped_last) : 0;
  CHECK(difference(mapped_first, mapped_last) <= limit);
}

} // namespace

TEMPLATE_TEST_CASE("The unit does not matter, and not at all if it is a power of two", "", Quadric,
                   MemorylessQuadric, ThinFeatureQuadric) {
  for (const auto& [name, soup] : surfaces()) {
    CAPTURE(name);
    for (double scale : {1e-8, 1e-5, 1e-3, 0.1, 3.0, 1e3, 1e5, 1e8}) {
      CAPTURE(scale);
      check<TestType>(
          soup, [&](const Position& p) { return scale * p; }, 1e-9);
    }
    for (int exponent : {-900, -300, -26, -1, 1, 26, 300, 900}) {
      CAPTURE(exponent);
      const double scale = std::ldexp(1.0, exponent);
      check<TestType>(
          soup, [&](const Position& p) { return scale * p; }, 0);
    }
  }
}

TEST_CASE("Nor does the unit matter to passes, thresholds, limits of error, and attributes") {
  const Soup soup =
      test::joined(test::with_noise(test::torus(40, 30), 1, 0.01), test::sphere(3), {{2.41, 0, 0}});
  for (int exponent : {-900, -560, -26, 1, 300, 900}) {
    CAPTURE(exponent);
    const double scale = std::ldexp(1.0, exponent);
    const auto scaled = [&](const Position& p) { return scale * p; };
    const auto check_with = [&](const auto& policies_at) {
      const auto simplified_at = [&](const Soup& input, double unit) {
        test::Mesh mesh = test::make_mesh(input);
        const Report report =
            std::apply([&](const auto&... policies) { return simplify(mesh, policies...); },
                       policies_at(unit));
        return std::pair(test::to_soup(mesh), report);
      };
      const auto [result, report] = simplified_at(soup, 1);
      const auto [at_scale, report_at_scale] = simplified_at(test::mapped(soup, scaled), scale);
      CHECK(result.triangles.size() < soup.triangles.size() / 2);
      CHECK(difference(test::mapped(result, scaled), at_scale) == 0);
      CHECK(report.non_edge_contractions == report_at_scale.non_edge_contractions);
      return report;
    };
    check_with([](double) { return std::tuple(FaceRatio{0.25}, RelaxedOrder{}); });
    check_with([](double) {
      return std::tuple(FaceRatio{0.25}, RelaxedOrder{.share = 0.2, .refresh = true});
    });
    check_with([](double unit) { return std::tuple(DistanceLimit(0.1 * unit)); });
    CHECK(check_with([](double unit) {
            return std::tuple(FaceRatio{0.25}, ThresholdPairs(0.3 * unit));
          }).non_edge_contractions > 0);
    CHECK(check_with([](double) {
            return std::tuple(FaceRatio{0.25}, ThresholdPairs::relative(0.05));
          }).non_edge_contractions > 0);

    const auto colored = [&](const Soup& input) {
      std::vector<test::Point> points = test::points_of(input);
      std::vector<std::array<double, 3>> colors;
      for (const Position& p : soup.points)
        colors.push_back({0.5 + 0.3 * p[0], std::sin(5 * p[1]), p[2]});
      auto triangles = input.triangles;
      simplify<ColorQuadric, OptimalPlacement>(
          points, triangles, FaceRatio{0.25},
          CGAL::parameters::vertex_color_map(CGAL::make_property_map(colors)));
      Soup result{{}, triangles};
      for (const test::Point& p : points)
        result.points.push_back({{p.x(), p.y(), p.z()}});
      return result;
    };
    CHECK(difference(test::mapped(colored(soup), scaled), colored(test::mapped(soup, scaled))) ==
          0);
  }
}

TEMPLATE_TEST_CASE("The error follows the unit", "", Quadric, MemorylessQuadric) {
  for (const auto& [name, soup] : surfaces()) {
    CAPTURE(name);
    Report report, large_report;
    simplified<TestType>(soup, &report);
    simplified<TestType>(test::mapped(soup, [](const Position& p) { return 0x1p30 * p; }),
                         &large_report);
    CHECK(report.error > 0);
    CHECK(large_report.error == 0x1p30 * report.error);
  }
}

TEMPLATE_TEST_CASE("The place does not matter, as far as doubles hold the input", "", Quadric,
                   MemorylessQuadric) {
  for (const auto& [name, soup] : surfaces()) {
    CAPTURE(name);
    for (double factor : {1.0, 1e3, 1e6}) {
      CAPTURE(factor);
      const double d = factor * test::diagonal(soup);
      const Position offset{{d, -0.7 * d, 0.4 * d}};
      // The same surface near zero: what is left of it there, moved back without rounding.
      const Soup held =
          test::mapped(soup, [&](const Position& p) { return (p + offset) - offset; });
      check<TestType>(
          held, [&](const Position& p) { return p + offset; }, 1e-15 * factor + 1e-9);
    }
  }
}

TEMPLATE_TEST_CASE("The direction does not matter", "", Quadric, MemorylessQuadric) {
  for (const auto& [name, soup] : surfaces()) {
    CAPTURE(name);
    const auto turn = [](const Position& p) { return test::tilted(Soup{{p}, {}}).points.front(); };
    check<TestType>(soup, turn, 1e-9);
    check<TestType>(
        soup,
        [](const Position& p) {
          return Position{{-p[0], p[1], p[2]}};
        },
        1e-9);
    check<TestType>(
        soup,
        [](const Position& p) {
          return Position{{p[0], p[1], -p[2]}};
        },
        1e-9);
    check<TestType>(
        soup,
        [](const Position& p) {
          return Position{{p[1], p[2], p[0]}};
        },
        1e-9);
    check<TestType>(
        soup,
        [](const Position& p) {
          return Position{{p[1], p[0], p[2]}};
        },
        1e-9);
  }
}

TEMPLATE_TEST_CASE("The numbers of vertices and faces do not matter", "", Quadric,
                   MemorylessQuadric) {
  for (const auto& [name, soup] : surfaces()) {
    CAPTURE(name);
    const Soup expected = simplified<TestType>(soup);
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      CAPTURE(seed);
      test::Random random(seed);
      Soup other = test::shuffled(soup, seed);
      for (test::Triangle& t : other.triangles)
        std::rotate(t.begin(), t.begin() + random.below(3), t.end());
      CHECK(test::is_same_surface(simplified<TestType>(other), expected,
                                  1e-10 * test::diagonal(soup)));
    }
  }
}

TEST_CASE("Points that no face uses change nothing, wherever they lie and whatever they say") {
  const auto check = [](const Soup& soup, const auto&... arguments) {
    const auto simplified_with = [&](double far, double color) {
      test::PointSoup surface(soup);
      std::vector<std::array<double, 3>> colors;
      for (const Position& p : soup.points)
        colors.push_back({std::sin(5 * p[0]), std::cos(7 * p[1]), 0.5});
      if (far > 0) {
        surface.points.push_back({far, -far, far / 3});
        colors.push_back({color, -color, color});
      }
      if constexpr ((std::is_same_v<decltype(arguments), const ColorQuadric&> || ...))
        simplify(surface.points, surface.triangles, arguments...,
                 CGAL::parameters::vertex_color_map(CGAL::make_property_map(colors)));
      else
        simplify(surface.points, surface.triangles, arguments...);
      colors.resize(std::min(colors.size(), surface.points.size()));
      return std::tuple(surface.points, surface.triangles, colors);
    };
    const auto alone = simplified_with(0, 0);
    CHECK(std::get<1>(alone).size() < soup.triangles.size());
    for (double far : {1e4, 1e20, 3.4e38, 1e150, 1e300})
      CHECK((simplified_with(far, far) == alone));
  };
  const Soup soup = test::random_closed(2);
  check(soup, Quadric{}, FaceRatio{0.2});
  check(soup, ColorQuadric{}, FaceRatio{0.2});
  check(soup, Quadric{}, DistanceLimit::relative(0.05));
  const Soup disordered = test::shuffled(test::with_noise(test::torus(120, 60), 1, 0.01), 1);
  check(disordered, Quadric{}, FaceRatio{0.2}); // is renumbered
  check(disordered, Quadric{}, FaceRatio{0.2}, RelaxedOrder{});
}
