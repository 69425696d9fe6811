// What a run by parts promises holds of random surfaces, told by nothing but the points: over many
// seeds sh test/promises/run.sh parts looks at it.
#include "chunk_attack.h"

#include <catch2/catch.hpp>

#include <cstdint>
#include <string>
#include <vector>

TEST_CASE("By parts, distances, topology and regions hold of random surfaces") {
  for (const std::uint64_t seed : {9U, 11U}) // a jagged sheet, many parts
    CHECK(test::ChunkAttack(seed, test::surface_of(seed, {})).broken() ==
          std::vector<std::string>{});
}
