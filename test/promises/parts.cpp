// Simplifies random and hard surfaces by small parts, from a file to a file, and looks at
// distances, topology and regions of labels, by nothing but the points of both. Prints what is
// broken, and fails if anything is.
//   parts FIRST_SEED COUNT [MODEL.off...]    models are simplified beside the others, in their
//   turn
#include "chunk_attack.h"
#include "seeds.h"

#include <cstdint>

int main(int argc, char** argv) {
  return test::check_seeds(argc, argv, [](std::uint64_t seed, const test::Surface& surface) {
    return test::is_none_broken(test::ChunkAttack(seed, surface).broken());
  });
}
