// Every cost with every placement and all pairs, in relaxed order.
#include "policies_on_all.h"

#include <quadrille/attribute_quadric.h>
#include <quadrille/edge_length.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>

namespace {

using namespace test;

// The parts are so large that passes pay: it matters how many pairs they look at.
template <class Cost>
void check_relaxed(const Cost& cost) {
  for_all_placements_and_pairs(cost, [](const auto&... policies) {
    const Soup soup = two_parts(with_noise(cube(6), 1, 0.1), with_noise(cube(6), 2, 0.1));
    for (const bool refresh : {false, true}) {
      INFO("in passes" << (refresh ? ", refreshed" : ""));
      const auto run = [&](double share) {
        return check_result<OnSoup>(soup, policies...,
                                    RelaxedOrder{.share = share, .refresh = refresh});
      };
      CHECK(run(0.5).soup.triangles != run(0.1).soup.triangles);
    }
  });
}

} // namespace

TEST_CASE("Costs of shape go with all that fits in relaxed order") {
  check_relaxed(Quadric{});
  check_relaxed(Quadric{.crease_degrees = 40, .weighting = Weighting::uniform});
  check_relaxed(MemorylessQuadric{});
  check_relaxed(EdgeLength{});
}

TEST_CASE("Costs of attributes go with all placements and pairs in relaxed order") {
  check_relaxed(ColorQuadric{});
  check_relaxed(TextureQuadric{});
  check_relaxed(AttributeQuadric<1>{});
  check_relaxed(NormalQuadric{});
}
