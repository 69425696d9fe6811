// Every cost without attributes with every placement and all pairs, on every kind of mesh and on
// soups.
#include "policies_on_all.h"

#include <quadrille/edge_length.h>
#include <quadrille/memoryless_quadric.h>

using namespace test;

TEST_CASE("Quadric goes with all placements and pairs on all surfaces") {
  check_on_all(Quadric{});
  check_on_all(Quadric{.crease_degrees = 40, .weighting = Weighting::uniform});
}

TEST_CASE("MemorylessQuadric goes with all placements and pairs on all surfaces") {
  check_on_all(MemorylessQuadric{});
}

TEST_CASE("EdgeLength goes with all that fits on all surfaces") {
  check_on_all(EdgeLength{});
}
