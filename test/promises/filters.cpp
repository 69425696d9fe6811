// Simplifies random and hard surfaces with each filter, and with limits of the distance, and looks
// at levels of the record, by nothing but the points of both. Prints what is broken, and fails if
// anything is.
//   filters FIRST_SEED COUNT [MODEL.off...]    models are simplified beside the others, in their
//   turn
#include "filter_attack.h"
#include "seeds.h"

#include <quadrille/memoryless_quadric.h>
#include <quadrille/placement.h>
#include <quadrille/quadric.h>
#include <quadrille/relaxed_order.h>

#include <cstdint>

namespace {

using namespace quadrille;
using test::Way;
using Attack = test::FilterAttack<Way<Quadric, OptimalPlacement, GreedyOrder>,
                                  Way<MemorylessQuadric, EndpointPlacement, GreedyOrder>,
                                  Way<MemorylessQuadric, OptimalPlacement, RelaxedOrder>,
                                  Way<MemorylessQuadric, OptimalPlacement, GreedyOrder>>;

} // namespace

int main(int argc, char** argv) {
  return test::check_seeds(argc, argv, [](std::uint64_t seed, const test::Surface& surface) {
    return test::is_none_broken(Attack(seed, surface).broken());
  });
}
