// The number of threads does not show in the result.
#include "meshes.h"
#include "soups.h"

#include <quadrille/hidden.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <cstddef>
#include <initializer_list>
#include <stdexcept>

namespace {

using namespace quadrille;
using test::Mesh;
using test::read_model;
using test::Soup;

struct Throwing {
  bool allows(const auto&) const { throw std::runtime_error("no"); }
};

// Simplifies copies of a mesh by simplify_by(mesh, threads), with each number of threads.
template <class SimplifyBy>
void require_same(const Mesh& input, std::initializer_list<unsigned> numbers_of_threads,
                  SimplifyBy simplify_by) {
  Soup of_one;
  std::size_t rejections = 0;
  for (unsigned threads : numbers_of_threads) {
    CAPTURE(threads);
    Mesh mesh = input;
    const Report report = simplify_by(mesh, threads);
    const Soup soup = test::to_soup(mesh);
    if (threads == 1) {
      of_one = soup;
      rejections = report.rejected(Rejection::normal_flip);
    }
    REQUIRE(soup.points == of_one.points);
    REQUIRE(soup.triangles == of_one.triangles);
    REQUIRE(report.rejected(Rejection::normal_flip) == rejections);
  }
}

} // namespace

TEMPLATE_TEST_CASE("Any number of threads gives the same mesh, bit for bit", "", Quadric,
                   MemorylessQuadric) {
  for (const char* name : {"bunny00", "refined_elephant", "nefertiti"})
    for (bool refresh : {false, true}) {
      CAPTURE(name, refresh);
      require_same(read_model(name), {1, 2, 3, 8}, [&](Mesh& mesh, unsigned threads) {
        return simplify<TestType, OptimalPlacement>(
            mesh, FaceRatio{0.1}, RelaxedOrder{.refresh = refresh, .threads = threads});
      });
    }
}

TEMPLATE_TEST_CASE("The same parts vanish with any number of threads", "", Quadric,
                   MemorylessQuadric) {
  Soup input = test::with_noise(test::torus(300, 120), 1, 1e-3);
  test::Random random(5);
  for (int i = 0; i < 200; ++i) {
    Soup part = i % 3 == 0 ? test::grid(3, 2) : test::sphere(1);
    const double size = random(0.001, 0.05);
    for (test::Position& p : part.points)
      p = size * p;
    input = test::joined(input, part, {{random(-2, 2), random(-2, 2), random(1, 2)}});
  }
  for (bool refresh : {false, true})
    require_same(test::make_mesh(input), {1, 2, 5}, [&](Mesh& mesh, unsigned threads) {
      const Report report = simplify<TestType, OptimalPlacement>(
          mesh, FaceRatio{0.01}, RelaxedOrder{.refresh = refresh, .threads = threads},
          Topology::components_may_vanish);
      REQUIRE(report.vanished_components > 50);
      REQUIRE(test::is_valid_triangle_mesh(mesh));
      return report;
    });
}

TEST_CASE("So does it where blocks are so many that they are joined") {
  const Mesh input = test::make_mesh(test::with_noise(test::torus(400, 200), 1, 1e-3));
  REQUIRE(input.number_of_vertices() == 80000);
  const std::size_t target = GENERATE(as<std::size_t>{}, 30000, 150000); // the second in one pass
  CAPTURE(target);
  require_same(input, {1, 2, 3}, [&](Mesh& mesh, unsigned threads) {
    const Report report = simplify<Quadric, OptimalPlacement>(mesh, FaceCount{target},
                                                              RelaxedOrder{.threads = threads});
    CHECK(report.faces_after == target);
    return report;
  });
}

TEST_CASE("And where topology is free, with borders, out of order") {
  const Mesh input =
      test::make_mesh(test::shuffled(test::with_noise(test::grid(290, 290), 1, 1e-3), 1));
  const double ratio = GENERATE(0.93, 0.3);
  const auto target =
      static_cast<std::size_t>(ratio * static_cast<double>(input.number_of_faces()));
  CAPTURE(ratio);
  require_same(input, {1, 2, 3}, [&](Mesh& mesh, unsigned threads) {
    const Report report = simplify<Quadric, OptimalPlacement>(
        mesh, FaceRatio{ratio}, Topology::free, RelaxedOrder{.threads = threads});
    CHECK(report.faces_after <= target + 1);
    CHECK(report.faces_after >= target - 1);
    return report;
  });
}

TEST_CASE("What a policy throws in a thread comes out, and the mesh is as it was") {
  Mesh mesh = read_model("bunny00");
  const Soup before = test::to_soup(mesh);
  CHECK_THROWS_WITH(
      (simplify<Quadric, OptimalPlacement>(mesh, RelaxedOrder{.threads = 2}, Throwing{})), "no");
  const Soup after = test::to_soup(mesh);
  CHECK(after.points == before.points);
  CHECK(after.triangles == before.triangles);
}

TEST_CASE("Any number of threads finds the same hidden faces, and the same fractions") {
  const Soup soup = test::joined(
      test::sphere(5), test::mapped(test::torus(96, 48), [](const auto& p) { return 0.6 * p; }));
  const HiddenFaces expected = hidden_faces(soup.points, soup.triangles);
  const Visibility seen = visibility(soup.points, soup.triangles, {.directions = 32});
  REQUIRE(expected.count > 0);
  for (unsigned threads : {2U, 3U}) {
    CHECK(hidden_faces(soup.points, soup.triangles, {.threads = threads}).is_hidden ==
          expected.is_hidden);
    CHECK(visibility(soup.points, soup.triangles, {.directions = 32, .threads = threads}).faces ==
          seen.faces);
  }
}
