// Borders and creases that hold within the surface and let it be across.
#include "meshes.h"
#include "soups.h"

#include <quadrille/memoryless_quadric.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace {

using namespace quadrille;
using test::Mesh;
using test::Position;
using test::Soup;

// A square grid of n × n, jittered sideways by up to 0.3 of its step and by 0.01 across.
Soup jagged_patch(std::uint64_t seed, std::uint32_t n) {
  test::Random random(seed);
  return test::mapped(test::grid(n, n), [&](const Position& p) {
    const double jitter = 0.3 / n;
    return Position{
        {p[0] + random(-jitter, jitter), p[1] + random(-jitter, jitter), random(-0.01, 0.01)}};
  });
}

double greatest_height(const Mesh& mesh) {
  double height = 0;
  for (Mesh::Vertex_index v : mesh.vertices())
    height = std::max(height, std::abs(mesh.point(v).z()));
  return height;
}

} // namespace

TEMPLATE_TEST_CASE("A jagged rim in noise makes no spikes", "", Quadric, MemorylessQuadric) {
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    for (std::uint32_t n : {3u, 5u, 10u, 20u}) {
      CAPTURE(seed, n);
      Mesh mesh = test::make_mesh(jagged_patch(seed, n));
      const std::size_t faces = std::max<std::size_t>(6, mesh.number_of_faces() / 10);
      simplify<TestType, OptimalPlacement>(mesh, FaceCount{faces});
      CHECK(greatest_height(mesh) < 0.03);
    }
}

TEST_CASE("A line named as a crease on a flat noisy part makes no spikes") {
  const auto on_middle = [](const Position& p) { return std::abs(p[0] - 0.5) < 0.03; };
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    Mesh mesh = test::make_mesh(jagged_patch(seed, 10));
    auto creases = mesh.add_property_map<Mesh::Edge_index, bool>("e:crease", false).first;
    for (Mesh::Edge_index e : mesh.edges())
      creases[e] = on_middle(test::to_position(mesh.point(mesh.vertex(e, 0)))) &&
                   on_middle(test::to_position(mesh.point(mesh.vertex(e, 1))));
    simplify(mesh, FaceCount{20}, parameters::edge_is_crease_map(creases));
    CHECK(greatest_height(mesh) < 0.03);
  }
}

TEST_CASE(
    "What a border leaves at its ends is a distance to its line, half as far along the normal") {
  const Vector<3> p{{1, 2, 3}}, q{{1, 4, 3}}, r{{2, 2, 3}}; // along y, in the plane z = 3
  const auto state = Quadric{.boundary_weight = 10}.boundary(p, q, r);
  const double weight = 10 * 4; // times the squared length of the edge
  CHECK(state({{0, 5, 0}}) == Approx(0).margin(1e-12));
  CHECK(state({{0.5, 5, 0}}) == Approx(weight * 0.25));
  CHECK(state({{0, 5, 0.5}}) == Approx(weight * 0.25 / 4));
  CHECK(state({{0.5, 0, 0.5}}) == Approx(weight * 0.25 * 5 / 4));
}
