// Vertices around which the surface has become flatter: which they are, and what it helps to cost
// their pairs anew.
#include "meshes.h"
#include "soups.h"

#include <quadrille/distance.h>
#include <quadrille/internal/core/order/cost_refresh.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace {

using namespace quadrille;
using internal::FlattenedVertices;
using internal::Index;

std::vector<Index> taken(FlattenedVertices& vertices) {
  std::vector<Index> all;
  vertices.take([&](Index v) { all.push_back(v); });
  return all;
}

// Leaves cheaper pairs where they are.
struct Waiting : MemorylessQuadric {
  static constexpr double tolerated_fall = 0;
};

// Each goes the general way; the second sends back all pairs that have become dearer.
struct Tolerant : MemorylessQuadric {};
struct Strict : MemorylessQuadric {
  static constexpr double tolerated_rise = 1;
};

template <class Cost, class... Arguments>
test::Soup simplified(test::Mesh mesh, const Arguments&... arguments) {
  simplify<Cost>(mesh, arguments...);
  return test::to_soup(mesh);
}

template <class Cost>
double rms_after(const test::Mesh& input, double ratio) {
  test::Mesh mesh = input;
  simplify<Cost, OptimalPlacement>(mesh, FaceRatio{ratio});
  return surface_distance(input, mesh).rms;
}

} // namespace

TEST_CASE("A vertex is flattened when its unevenness has fallen far enough") {
  FlattenedVertices vertices(3, 0.5);
  for (Index v : {0U, 1U, 2U})
    vertices.note(v, 8);
  vertices.look_at(0, 4);
  vertices.look_at(1, 3.9);
  vertices.look_at(2, 9);
  CHECK(taken(vertices) == std::vector<Index>{1});
  CHECK(taken(vertices).empty());
}

TEST_CASE("A flattened vertex is found once, and not when it has been noted since") {
  FlattenedVertices vertices(2, 0.5);
  vertices.note(0, 8);
  vertices.note(1, 8);
  for (double unevenness : {3.0, 1.0, -1.0, 0.0})
    for (Index v : {0U, 1U})
      vertices.look_at(v, unevenness);
  vertices.note(0, 3);
  CHECK(taken(vertices) == std::vector<Index>{1});
  vertices.note(1, 1);
  vertices.look_at(1, 0.4);
  vertices.look_at(0, 1.6);
  CHECK(taken(vertices) == std::vector<Index>{1});
}

TEST_CASE("Flattened vertices are many when they fill a batch") {
  FlattenedVertices vertices(FlattenedVertices::many, 0.5);
  for (Index v = 0; v < FlattenedVertices::many; ++v) {
    CHECK_FALSE(vertices.are_many());
    vertices.note(v, 1);
    vertices.look_at(v, 0);
  }
  CHECK(vertices.are_many());
  taken(vertices);
  CHECK_FALSE(vertices.are_many());
}

TEST_CASE("Unevenness is none in a plane, and grows with height and area") {
  const MemorylessQuadric cost;
  const auto of_pyramid = [&](double height, double size) {
    const Vector<3> top{{0, 0, height * size}};
    const std::vector<Vector<3>> base = {
        {{size, 0, 0}}, {{0, size, 0}}, {{-size, 0, 0}}, {{0, -size, 0}}};
    MemorylessQuadric::Current sum{};
    for (std::size_t i = 0; i < 4; ++i)
      sum += cost.current_face(top, base[i], base[(i + 1) % 4]);
    return cost.unevenness(sum);
  };
  CHECK(cost.unevenness({}) == 0);
  CHECK(of_pyramid(0, 1) == 0);
  CHECK(of_pyramid(0.2, 1) > 3 * of_pyramid(0.1, 1));
  CHECK(of_pyramid(0.1, 2) == Approx(std::pow(2, 2.5) * of_pyramid(0.1, 1)));
  // Planes (1, ±1, 1) and so on over √3, each of weight w = (√3 / 2)^(5/4): all eigenvalues 4 w
  // / 3.
  CHECK(of_pyramid(1, 1) == Approx(4 * std::pow(std::sqrt(3.0) / 2, 1.25) / 27));
}

TEST_CASE("Pairs that have become cheaper do not wait for too long") {
  double ratio = 1;
  for (std::uint64_t seed = 0; seed < 2; ++seed) {
    const test::Mesh mesh = test::make_mesh(test::with_noise(test::sphere(6), seed, 0.003));
    ratio *= rms_after<MemorylessQuadric>(mesh, 0.3) / rms_after<Waiting>(mesh, 0.3);
  }
  CAPTURE(ratio);
  CHECK(ratio < 0.99);
}

TEST_CASE("Pairs that have become a little dearer are not sent back") {
  const test::Mesh mesh = test::make_mesh(test::with_noise(test::sphere(4), 1, 0.01));
  const FaceRatio stop{0.3};
  CHECK_FALSE(test::is_identical(simplified<Tolerant>(mesh, stop), simplified<Strict>(mesh, stop)));
}
