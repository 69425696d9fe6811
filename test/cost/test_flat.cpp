// Flat and symmetric surfaces, on which all costs are alike, keep an even triangulation.
#include "meshes.h"
#include "soups.h"

#include <quadrille/distance_limits.h>
#include <quadrille/internal/core/surface/flat_polygons.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using test::Mesh;
using test::Position;

struct Model {
  std::string name;
  Mesh mesh;
};

std::vector<Model> models() {
  const auto of_steps = test::mapped(test::grid(150, 150), [](const Position& p) {
    return Position{
        {150 * p[0], 150 * p[1], std::floor(4 * std::sin(5 * p[0]) * std::cos(4 * p[1]))}};
  });
  return {{"tilted plane", test::make_mesh(test::tilted(test::grid(150, 150)))},
          {"cube", test::make_mesh(test::cube(61))},
          {"cylinder", test::make_mesh(test::open_cylinder(150, 150))},
          {"sphere", test::make_mesh(test::sphere(6))},
          {"steps", test::make_mesh(of_steps)}};
}

std::size_t highest_degree(const Mesh& mesh) {
  std::size_t highest = 0;
  for (Mesh::Vertex_index v : mesh.vertices())
    highest = std::max<std::size_t>(highest, mesh.degree(v));
  return highest;
}

template <class Cost, class Order>
void require_even(const Order& order) {
  for (const auto& [name, input] : models()) {
    Mesh mesh = input;
    const Report report = simplify<Cost, OptimalPlacement>(mesh, FaceRatio{0.01}, order);
    INFO(name << ": " << report);
    CHECK(report.stop == StopReason::target_met);
    CHECK(test::is_valid_triangle_mesh(mesh));
    CHECK(highest_degree(mesh) <= (name == "steps" ? 32 : 12));
  }
}

} // namespace

TEMPLATE_TEST_CASE("No vertex gathers the edges of a flat part", "", Quadric, MemorylessQuadric) {
  require_even<TestType>(GreedyOrder{});
  require_even<TestType>(RelaxedOrder{});
}

namespace {

// The lowest height of a face, in its longest edge.
double lowest_face(const Mesh& mesh) {
  double lowest = 1;
  for (const auto& t : test::to_soup(mesh).triangles) {
    const test::Soup soup = test::to_soup(mesh);
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i)
      longest = std::max(longest, squared_distance(soup.points[t[i]], soup.points[t[(i + 1) % 3]]));
    lowest = std::min(lowest, std::sqrt(squared_length(test::area_vector(soup, t))) * 2 / longest);
  }
  return lowest;
}

// An L of three cubes, stairs, and a block with a pit.
std::vector<std::pair<test::Soup, std::size_t>> solids() {
  return {
      {test::cube(8), 12},
      {test::surface_of_cubes(6, 6, 6, [](int x, int y, int) { return x < 3 || y < 3; }), 20},
      {test::surface_of_cubes(6, 6, 6, [](int x, int, int z) { return x / 2 + z / 2 < 3; }), 28},
      {test::surface_of_cubes(
           6, 6, 6, [](int x, int y, int z) { return z < 3 || x < 2 || x > 3 || y < 2 || y > 3; }),
       28}};
}

// A sheet of which each diagonal has a vertex on one side only, and a face of no height between.
test::Soup with_needles(test::Soup soup) {
  const std::vector<test::Triangle> triangles = std::exchange(soup.triangles, {});
  for (std::size_t i = 0; i < triangles.size(); i += 2) {
    const auto [a, d, c] = triangles[i + 1];
    const auto m = static_cast<std::uint32_t>(soup.points.size());
    soup.points.push_back(0.5 * (soup.points[a] + soup.points[d]));
    for (const test::Triangle& t :
         {triangles[i], test::Triangle{a, m, c}, test::Triangle{m, d, c}, test::Triangle{a, d, m}})
      soup.triangles.push_back(t);
  }
  return soup;
}

} // namespace

TEMPLATE_TEST_CASE("Needles that the input has are contracted away", "",
                   (std::pair<Quadric, GreedyOrder>), (std::pair<MemorylessQuadric, GreedyOrder>),
                   (std::pair<Quadric, RelaxedOrder>)) {
  const auto& [cost, order] = TestType();
  for (const double noise : {0.0, 0.02}) {
    Mesh mesh = test::make_mesh(with_needles(test::with_noise(test::grid(12, 12), 1, noise)));
    REQUIRE(lowest_face(mesh) < 1e-12);
    const Report report = simplify(mesh, cost, order, FaceRatio{0.1});
    INFO(report);
    CHECK(report.stop == StopReason::target_met);
    CHECK(lowest_face(mesh) > 1e-4);
  }
}

TEMPLATE_TEST_CASE("Block solids lose nothing down to their corners, and make no needles", "",
                   Quadric, MemorylessQuadric) {
  for (const auto& [solid, lossless] : solids()) {
    const Mesh input = test::make_mesh(solid);
    for (std::size_t faces = lossless; faces < input.number_of_faces(); faces = faces * 5 / 4 + 2) {
      Mesh mesh = input;
      const Report report = simplify<TestType, OptimalPlacement>(mesh, FaceCount{faces / 2 * 2});
      INFO(report);
      CHECK(report.stop == StopReason::target_met);
      CHECK(report.error < 1e-7);
      CHECK(test::volume(test::to_soup(mesh)) == Approx(test::volume(solid)));
      CHECK(lowest_face(mesh) > 1e-4);
    }
  }
}

namespace {

// A foil of these sides, each cut into 20 × 20 squares, and one without a quarter.
test::Soup foil(double x, double y, double z) {
  return test::mapped(test::cube(20), [=](const Position& p) {
    return Position{{x * p[0], y * p[1], z * p[2]}};
  });
}
test::Soup thin_l() {
  return test::mapped(
      test::surface_of_cubes(16, 16, 2, [](int x, int y, int) { return x < 8 || y < 8; }),
      [](const Position& p) {
        return Position{{6.25 * p[0], 6.25 * p[1], 0.005 * p[2]}};
      });
}

// How far the furthest point of one surface is from the other, measured at vertices.
double greatest_loss(const test::Soup& from, const test::Soup& to) {
  double greatest = 0;
  for (const Position& p : from.points) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& t : to.triangles)
      nearest = std::min(nearest, internal::squared_distance_to_triangle(
                                      p, to.points[t[0]], to.points[t[1]], to.points[t[2]]));
    greatest = std::max(greatest, nearest);
  }
  return std::sqrt(greatest);
}

} // namespace

// The faces of a wall of 100 × 0.01 are as low as needles: what is narrow in the input is none.
TEMPLATE_TEST_CASE("Foils lose nothing down to their corners", "",
                   (std::pair<Quadric, GreedyOrder>), (std::pair<MemorylessQuadric, GreedyOrder>),
                   (std::pair<Quadric, RelaxedOrder>)) {
  const auto& [cost, order] = TestType();
  for (const auto& [solid, lossless] :
       {std::pair{foil(100, 100, 0.01), 12}, std::pair{test::tilted(foil(100, 50, 0.01)), 12},
        std::pair{foil(100, 0.01, 0.01), 12}, std::pair{thin_l(), 20}}) {
    const Mesh input = test::make_mesh(solid);
    for (int faces : {lossless, 2 * lossless}) {
      Mesh mesh = input;
      const Report report = simplify(mesh, cost, order, FaceCount{static_cast<std::size_t>(faces)});
      INFO(report);
      CHECK(report.stop == StopReason::target_met);
      CHECK(report.error < 1e-4);
      CHECK(greatest_loss(solid, test::to_soup(mesh)) < 1e-4);
    }
  }
}

TEST_CASE("A limit of error leaves nothing of a foil but its corners") {
  Mesh mesh = test::make_mesh(test::tilted(foil(100, 100, 0.01)));
  const Report report = simplify(mesh, DistanceLimit{0.001});
  CHECK(report.faces_after == 12);
}

// The planes of the rim weigh a thousandth of the others, and tell next to nothing in the mean.
TEMPLATE_TEST_CASE("The error tells how far thin parts have receded", "", GreedyOrder,
                   RelaxedOrder) {
  for (const double height : {1.0, 0.01}) {
    const test::Soup disc =
        test::mapped(test::sphere(4), [=](const Position& p) { // its equator becomes the rim
          return Position{{50 * p[0], 50 * p[1], (p[2] > 0 ? 0.5 : -0.5) * height}};
        });
    for (const std::size_t faces : {200u, 60u, 24u, 10u}) {
      Mesh mesh = test::make_mesh(disc);
      const Report report = simplify(mesh, FaceCount{faces}, TestType{});
      const double lost = greatest_loss(disc, test::to_soup(mesh));
      INFO(report << ": lost " << lost);
      CHECK(report.error > 0.7 * lost);
      CHECK(report.error < 3 * lost + height);
    }
  }
  Mesh l = test::make_mesh(thin_l()); // flat it has 8
  const Report report = simplify(l, FaceCount{6}, TestType{});
  const double lost = greatest_loss(thin_l(), test::to_soup(l));
  INFO(report << ": lost " << lost);
  CHECK(lost > 5);
  CHECK(report.error > 0.7 * lost);
}

TEST_CASE("Corners of a block keep their bits") {
  Mesh mesh = test::make_mesh(test::cube(10));
  simplify(mesh, FaceCount{12});
  for (Mesh::Vertex_index v : mesh.vertices())
    for (double x : test::to_position(mesh.point(v)).coordinates)
      CHECK((x == std::floor(x)));
}

TEST_CASE("A sheet is simplified without an error") {
  Mesh mesh = test::make_mesh(test::tilted(test::grid(40, 40)));
  const Report report = simplify(mesh, FaceCount{2});
  CHECK(report.faces_after == 2);
  CHECK(report.error < 1e-8);
}

TEST_CASE("HighestDegree keeps its word where steps would not") {
  Mesh mesh = models().back().mesh;
  simplify(mesh, FaceRatio{0.01}, HighestDegree{24});
  CHECK(highest_degree(mesh) <= 24);
}
