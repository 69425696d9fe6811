// Flat and symmetric surfaces, on which all costs are alike, keep an even triangulation.
#include "meshes.h"
#include "soups.h"

#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
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

TEST_CASE("HighestDegree keeps its word where steps would not") {
  Mesh mesh = models().back().mesh;
  simplify(mesh, FaceRatio{0.01}, HighestDegree{24});
  CHECK(highest_degree(mesh) <= 24);
}
