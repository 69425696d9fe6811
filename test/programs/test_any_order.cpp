// What threads do at a time may be done in any order. Threads that get in each other's way do so
// now and then; tasks that depend on each other differ each time that they are done backwards.
#define QUADRILLE_WITH_TBB // so that more than one thread may be asked for
#include "meshes.h"
#include "soups.h"

#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <cstdint>
#include <vector>

namespace {

using namespace quadrille;
using test::Mesh;

test::Soup simplified(const auto& cost, Mesh mesh, const RelaxedOrder& order, bool backwards) {
  internal::runs_backwards = backwards;
  simplify(mesh, cost, FaceRatio{0.1}, order);
  return test::to_soup(mesh);
}

} // namespace

TEMPLATE_TEST_CASE("Tasks of several threads may be done in any order", "", Quadric,
                   MemorylessQuadric) {
  // The last one has so many vertices that blocks are joined.
  const test::Mesh inputs[] = {test::read_model("bunny00"), test::read_model("nefertiti"),
                               test::make_mesh(test::shuffled(test::torus(300, 280), 1))};
  for (const test::Mesh& input : inputs)
    for (bool refresh : {false, true}) {
      const TestType cost;
      const RelaxedOrder order{.refresh = refresh, .threads = 3};
      const test::Soup one = simplified(cost, input, {.refresh = refresh}, false);
      for (bool backwards : {false, true}) {
        CAPTURE(input.number_of_faces(), refresh, backwards);
        const test::Soup soup = simplified(cost, input, order, backwards);
        REQUIRE(soup.points == one.points);
        REQUIRE(soup.triangles == one.triangles);
      }
    }
}

TEST_CASE("The same where faces are glued at random") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 4));
  test::Random random(seed);
  test::Soup input;
  for (int i = 0; i < 9000; ++i)
    input.points.push_back({{random(0, 1), random(0, 1), random(0, 1)}});
  for (int i = 0; i < 9000; ++i)
    input.triangles.push_back({random.below(9000), random.below(9000), random.below(9000)});
  for (bool refresh : {false, true}) {
    const RelaxedOrder order{.refresh = refresh, .threads = 3};
    std::vector<test::Point> forward = test::points_of(input), backward = forward;
    auto forward_triangles = input.triangles, backward_triangles = input.triangles;
    internal::runs_backwards = false;
    simplify(forward, forward_triangles, FaceRatio{0.1}, order, Topology::free);
    internal::runs_backwards = true;
    simplify(backward, backward_triangles, FaceRatio{0.1}, order, Topology::free);
    CAPTURE(seed, refresh);
    CHECK(forward == backward);
    CHECK(forward_triangles == backward_triangles);
  }
}
