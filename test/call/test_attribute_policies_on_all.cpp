// Every cost of attributes with every placement and all pairs, on every kind of mesh and on soups.
#include "policies_on_all.h"

#include <quadrille/attribute_quadric.h>

using namespace test;

TEST_CASE("Attribute quadrics go with all placements and pairs on all surfaces") {
  check_on_all(ColorQuadric{});
  check_on_all(TextureQuadric{});
  check_on_all(AttributeQuadric<1>{});
}

TEST_CASE("NormalQuadric goes with all placements and pairs on all surfaces") {
  check_on_all(NormalQuadric{});
}
