// A tolerance that varies keeps its word: each face of the input stays within its own of the
// result, and each point of the result within that of some face, measured apart by CGAL.
#include "farthest.h"
#include "meshes.h"
#include "point_replay.h"
#include "soups.h"

#include <quadrille/distance_limits.h>
#include <quadrille/record.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <CGAL/property_map.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace quadrille;
using test::Kernel;
using test::Point;
using test::Position;
using test::Soup;

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Outcome {
  Report report;
  Soup result;
};

template <class... Arguments>
Outcome simplified(const Soup& input, const std::vector<double>& tolerances,
                   const Arguments&... arguments) {
  test::PointSoup soup(input);
  const Report report = simplify<Quadric, OptimalPlacement>(
      soup.points, soup.triangles, arguments...,
      parameters::vertex_tolerance_map(CGAL::make_property_map(tolerances)));
  return {report, test::to_soup(soup)};
}

Kernel::Triangle_3 triangle(const Soup& soup, const test::Triangle& t) {
  return {test::to_point<Point>(soup.points[t[0]]), test::to_point<Point>(soup.points[t[1]]),
          test::to_point<Point>(soup.points[t[2]])};
}

double tolerance_of(const test::Triangle& t, const std::vector<double>& tolerances) {
  return std::min({tolerances[t[0]], tolerances[t[1]], tolerances[t[2]]});
}

double distance(const Point& p, const Kernel::Triangle_3& t) {
  return std::sqrt(CGAL::squared_distance(p, t));
}

// By how much a point of the input is beyond the tolerance of its face.
double beyond(const Soup& input, const std::vector<double>& tolerances, const Soup& result) {
  double most = -infinity;
  for (const auto& t : input.triangles)
    test::for_each_point(input, t, 2, [&](const Position& position) {
      const Point p = test::to_point<Point>(position);
      double nearest = infinity;
      for (const auto& now : result.triangles)
        nearest = std::min(nearest, distance(p, triangle(result, now)));
      most = std::max(most, nearest - tolerance_of(t, tolerances));
    });
  return most;
}

// By how much a point of the result is beyond the tolerance of each input face.
double beyond_back(const Soup& input, const std::vector<double>& tolerances, const Soup& result) {
  double most = -infinity;
  for (const auto& now : result.triangles)
    test::for_each_point(result, now, 2, [&](const Position& position) {
      const Point p = test::to_point<Point>(position);
      double least = infinity;
      for (const auto& t : input.triangles)
        least = std::min(least, distance(p, triangle(input, t)) - tolerance_of(t, tolerances));
      most = std::max(most, least);
    });
  return most;
}

void check_within(const Soup& input, const std::vector<double>& tolerances,
                  const Outcome& outcome) {
  INFO(outcome.report);
  const double own = 0x1p-39 * test::greatest_coordinate(input);
  CHECK(beyond(input, tolerances, outcome.result) <= own);
  CHECK(beyond_back(input, tolerances, outcome.result) <= own);
  REQUIRE(outcome.report.used_tolerance);
  CHECK(outcome.report.used_tolerance->fraction <= 1);
  const double greatest = *std::max_element(tolerances.begin(), tolerances.end());
  CHECK(outcome.report.hausdorff_bound <= 1.000001 * greatest);
  CHECK(test::farthest(input, outcome.result, 2) <= outcome.report.hausdorff_bound + own);
}

// A tolerance that grows a hundredfold along x, over a surface of side 1.
std::vector<double> growing(const Soup& soup, double least) {
  std::vector<double> tolerances;
  for (const Position& p : soup.points)
    tolerances.push_back(least * std::pow(100, std::clamp(0.5 * p[0] + 0.5, 0.0, 1.0)));
  return tolerances;
}

std::size_t faces_on_side(const Soup& soup, double side) {
  return static_cast<std::size_t>(
      std::count_if(soup.triangles.begin(), soup.triangles.end(), [&](const auto& t) {
        return side * (soup.points[t[0]][0] + soup.points[t[1]][0] + soup.points[t[2]][0]) > 0;
      }));
}

Soup waves(std::uint32_t n, double height) {
  return test::mapped(test::grid(n, n), [&](const Position& p) {
    return Position{{2 * p[0] - 1, 2 * p[1] - 1, height * std::sin(9 * p[0]) * std::sin(7 * p[1])}};
  });
}

} // namespace

TEST_CASE("Each face stays within its tolerance, both ways") {
  for (const Soup& input : {test::with_noise(test::sphere(3), 1, 0.01), waves(14, 0.1)}) {
    const std::vector<double> tolerances = growing(input, 0.003);
    for (const Outcome& outcome :
         {simplified(input, tolerances, ToleranceLimit{}),
          simplified(input, tolerances, ToleranceLimit{}, RelaxedOrder{}),
          simplified(input, tolerances, ToleranceLimit{}, Topology::free)}) {
      check_within(input, tolerances, outcome);
      CHECK(10 * outcome.result.triangles.size() < 8 * input.triangles.size());
      CHECK(4 * faces_on_side(outcome.result, 1) < 3 * faces_on_side(outcome.result, -1));
    }
  }
}

TEST_CASE("What a contraction uses of a tolerance adds up") {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const Soup input =
        test::with_noise(seed % 2 ? test::octahedron() : test::grid(4, 4), seed, 0.2);
    const std::vector<double> tolerances = growing(input, 0.02);
    for (std::size_t faces = input.triangles.size(); faces-- > 2;) {
      INFO("seed " << seed << ", " << faces << " faces");
      const Outcome outcome =
          simplified(input, tolerances, AnyOf{ToleranceLimit{}, FaceCount{faces}});
      check_within(input, tolerances, outcome);
      if (outcome.result.triangles.size() > faces)
        break; // no more can go
    }
  }
}

TEST_CASE("A tolerance of 0 leaves what is not flat, and flattens nothing") {
  const Soup input = waves(16, 0.1);
  std::vector<double> tolerances;
  for (const Position& p : input.points)
    tolerances.push_back(p[0] < 0 ? 0 : infinity);
  const Outcome outcome = simplified(input, tolerances, ToleranceLimit{});
  for (std::size_t v = 0; v < input.points.size(); ++v)
    if (input.points[v][0] < 0)
      CHECK(std::count(outcome.result.points.begin(), outcome.result.points.end(),
                       input.points[v]) == 1);
  CHECK(faces_on_side(outcome.result, 1) < 60);

  const Soup flat = test::tilted(test::grid(16, 16));
  CHECK(simplified(flat, std::vector<double>(flat.points.size(), 0.0), ToleranceLimit{})
            .result.triangles.size() == 2);
}

TEST_CASE("Tolerances stay with their vertices where these are numbered anew") {
  const Soup input = test::shuffled(test::with_noise(test::sphere(5), 3, 0.001), 1);
  std::vector<double> tolerances;
  for (const Position& p : input.points)
    tolerances.push_back(p[0] < -0.5 ? 0 : infinity);
  for (const Outcome& outcome : {simplified(input, tolerances, ToleranceLimit{}),
                                 simplified(input, tolerances, ToleranceLimit{}, RelaxedOrder{})}) {
    const std::set<std::array<double, 3>> left = [&] {
      std::set<std::array<double, 3>> points;
      for (const Position& p : outcome.result.points)
        points.insert(p.coordinates);
      return points;
    }();
    CHECK(std::all_of(input.points.begin(), input.points.end(), [&](const Position& p) {
      return p[0] >= -0.5 || left.contains(p.coordinates);
    }));
    CHECK(faces_on_side(outcome.result, 1) < 1000);
  }
}

TEST_CASE("A small tolerance is handed on to the faces that come to lie there") {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    test::Random random(seed);
    const Soup input = test::mapped(test::grid(12, 12), [&](const Position& p) {
      return Position{{p[0], p[1], p[0] > 0.7 ? random(-0.1, 0.1) : 0.0}}; // else flat
    });
    std::vector<double> tolerances;
    for (const Position& p : input.points)
      tolerances.push_back(p[0] < 0.4 ? 0.001 : 1);
    for (const std::size_t faces : {60u, 20u, 2u})
      check_within(input, tolerances,
                   simplified(input, tolerances, AnyOf{ToleranceLimit{}, FaceCount{faces}}));
  }
}

TEST_CASE("Points that a record carries along stay within their tolerances") {
  const Soup input = test::with_noise(test::sphere(3), 7, 0.005);
  std::vector<double> tolerances;
  for (const Position& p : input.points)
    tolerances.push_back(0.1 * std::pow(10, p[0]));
  const auto check = [&](const auto& limit, const auto& order, const auto& topology) {
    test::Log log;
    const auto [report, result] =
        simplified(input, tolerances, limit, order, topology, record_into(log));
    REQUIRE(report.faces_after < report.faces_before);
    test::PointReplay replay(log, 5000, 1);
    replay.run();
    const test::Nearest of_result(result);
    double used = 0;
    for (const test::CarriedPoint& p : replay.points()) {
      CHECK(of_result.distance(p.now) < 1e-12);
      used = std::max(used, std::sqrt(squared_distance(p.begin, p.now)) /
                                tolerance_of(input.triangles[p.begin_face], tolerances));
    }
    CHECK(used < 1);
    CHECK(used > 0.1);
  };
  check(ToleranceLimit{}, GreedyOrder{}, Topology::kept);
  check(ToleranceLimit{}, RelaxedOrder{}, Topology::free);
}

TEST_CASE("One tolerance for all is a Hausdorff limit") {
  const Soup input = test::with_noise(test::sphere(3), 1, 0.02);
  const Outcome outcome =
      simplified(input, std::vector<double>(input.points.size(), 0.0625), ToleranceLimit{});
  test::PointSoup soup(input);
  const Report of_limit =
      simplify<Quadric, OptimalPlacement>(soup.points, soup.triangles, HausdorffLimit{0.0625});
  CHECK(outcome.report.faces_after == of_limit.faces_after);
  CHECK(outcome.report.hausdorff_bound == Approx(of_limit.hausdorff_bound));
  CHECK(outcome.report.used_tolerance->fraction == Approx(of_limit.hausdorff_bound / 0.0625));
}

TEST_CASE("The report tells where most of a tolerance is used") {
  Soup input = waves(12, 0);
  for (Position& p : input.points)
    if (std::abs(p[0] - 0.5) < 0.1 && std::abs(p[1] + 0.5) < 0.1)
      p[2] = 0.01; // one bump, which goes
  const Outcome outcome =
      simplified(input, std::vector<double>(input.points.size(), 0.02), ToleranceLimit{});
  REQUIRE(outcome.report.used_tolerance);
  CHECK(outcome.report.used_tolerance->fraction >= 0.5);
  CHECK(outcome.report.used_tolerance->fraction <= 1);
  const Position place{outcome.report.used_tolerance->place};
  CHECK(std::any_of(outcome.result.triangles.begin(), outcome.result.triangles.end(),
                    [&](const auto& t) {
                      const auto& at = outcome.result.points;
                      const Position middle = 1. / 3 * (at[t[0]] + at[t[1]] + at[t[2]]);
                      return dot(middle - place, middle - place) < 1e-20;
                    }));
}

TEST_CASE("Tolerances have the mesh's unit, wherever it lies") {
  const Soup input = test::with_noise(test::sphere(2), 4, 0.05);
  const std::vector<double> tolerances = growing(input, 0.002);
  const Outcome here = simplified(input, tolerances, ToleranceLimit{});
  for (const double factor : {0x1p-30, 0x1p20}) {
    const Soup scaled = test::mapped(input, [&](const Position& p) { return factor * p; });
    std::vector<double> of_scaled;
    for (const double tolerance : tolerances)
      of_scaled.push_back(factor * tolerance);
    const Outcome there = simplified(scaled, of_scaled, ToleranceLimit{});
    CHECK(there.result.triangles == here.result.triangles);
    CHECK(there.report.used_tolerance->fraction == here.report.used_tolerance->fraction);
  }
  const Soup far = test::mapped(input, [](const Position& p) {
    return p + Position{{1e5, 2e5, 0}};
  });
  check_within(far, tolerances, simplified(far, tolerances, ToleranceLimit{}));
}

TEST_CASE("On a mesh tolerances are those of its vertices") {
  const Soup input = test::with_noise(test::sphere(2), 5, 0.05);
  test::Mesh mesh = test::make_mesh(input);
  const std::vector<double> tolerances = growing(input, 0.002);
  auto map = mesh.add_property_map<test::Mesh::Vertex_index, double>("v:tolerance").first;
  for (const auto v : mesh.vertices())
    map[v] = tolerances[v];
  const Report report = simplify<Quadric, OptimalPlacement>(mesh, ToleranceLimit{},
                                                            parameters::vertex_tolerance_map(map));
  mesh.collect_garbage();
  check_within(input, tolerances, {report, test::to_soup(mesh)});
}

TEST_CASE("Tolerances that make no sense are refused") {
  const Soup input = test::sphere(1);
  std::vector<double> tolerances(input.points.size(), 1);
  const auto message = [&](const auto&... arguments) -> std::string {
    test::PointSoup soup(input);
    try {
      simplify<Quadric, OptimalPlacement>(soup.points, soup.triangles, arguments...);
    } catch (const std::invalid_argument& e) {
      CHECK(test::to_soup(soup).points == input.points);
      return e.what();
    }
    return "";
  };
  const auto map = parameters::vertex_tolerance_map(CGAL::make_property_map(tolerances));
  CHECK_THAT(message(ToleranceLimit{}), Catch::Contains("vertex_tolerance_map"));
  CHECK_THAT(message(HausdorffLimit{0.1}, map), Catch::Contains("ToleranceLimit"));
  for (const double bad : {-0.5, std::numeric_limits<double>::quiet_NaN()}) {
    tolerances[7] = bad;
    CHECK_THAT(message(ToleranceLimit{}, map), Catch::Contains("vertex 7"));
  }
}
