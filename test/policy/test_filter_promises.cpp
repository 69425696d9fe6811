// What filters and levels promise of whole runs holds, told by nothing but the points: over many
// seeds sh test/promises/run.sh filters looks at it.
#include "filter_attack.h"

#include <quadrille/memoryless_quadric.h>
#include <quadrille/order.h>
#include <quadrille/placement.h>

#include <catch2/catch.hpp>

#include <cstdint>
#include <string>
#include <vector>

TEST_CASE("Filters and bounds of levels hold of whole runs, whatever the surface") {
  using namespace quadrille;
  using Attack = test::FilterAttack<test::Way<MemorylessQuadric, OptimalPlacement, GreedyOrder>>;
  for (std::uint64_t seed = 0; seed < 14; ++seed)
    CHECK(Attack(seed, test::surface_of(seed, {})).broken() == std::vector<std::string>{});
}
