// What must hold of every result does, for surfaces and policies made at random. A failure prints
// its seed and writes the surface, shrunk, to property_SEED.off.
//   QUADRILLE_SEEDS=1000-250000 test_properties   tries these seeds
#include "cases/cases.h"

#include <catch2/catch.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

std::vector<std::uint8_t> random_bytes(std::uint64_t seed) {
  test::Random random(seed);
  std::vector<std::uint8_t> bytes(64 + random.below(1024));
  for (std::uint8_t& byte : bytes)
    byte = static_cast<std::uint8_t>(random.below(256));
  return bytes;
}

// The seeds to try: from the first up to the second. 15 is slow: each two of its 1,295 points are a
// pair.
std::pair<std::uint64_t, std::uint64_t> seeds() {
  std::pair<std::uint64_t, std::uint64_t> range{16, 500};
  char dash = 0;
  if (const char* wanted = std::getenv("QUADRILLE_SEEDS"))
    std::istringstream(wanted) >> range.first >> dash >> range.second;
  return range;
}

} // namespace

TEST_CASE("What must hold of every result does") {
  const auto [first, last] = seeds();
  REQUIRE(first < last);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const test::Case input = test::make_case(test::Bytes(random_bytes(seed)));
    const std::string violation = test::violation(input);
    if (violation.empty())
      continue;
    const std::string file = "property_" + std::to_string(seed) + ".off";
    const test::Case small = test::shrunk(input);
    std::ofstream(file) << small;
    FAIL_CHECK("seed " << seed << ": " << violation << "; shrunk to " << file << ": "
                       << test::violation(small));
  }
}

TEST_CASE("Regions of labels stay where edges become seams of a texture later") {
  for (const std::uint64_t seed : {1561U, 1680U, 2183U, 5664U, 7297U, 8592U}) {
    test::Case input = test::make_case(test::Bytes(random_bytes(seed)));
    REQUIRE_FALSE(input.is_mesh);
    input.call.cost = test::CostName::channels;
    input.numbers.assign(input.soup.points.size(), {});
    input.seed = seed;
    CAPTURE(seed);
    CHECK(test::violation(input) == "");
  }
}

TEST_CASE("The same surface and policies give the same result, bit for bit") {
  for (std::uint64_t seed = 16; seed < 76; ++seed) {
    CAPTURE(seed);
    const test::Case input = test::make_case(test::Bytes(random_bytes(seed)));
    test::Outcome first, second;
    try {
      test::simplify(input, first);
      test::simplify(input, second);
    } catch (const std::logic_error&) { // bad input, or too many pairs
      continue;
    }
    CHECK(first.points == second.points);
    CHECK(first.triangles == second.triangles);
    CHECK(first.report.error == second.report.error);
    CHECK(first.report.rejections == second.report.rejections);
  }
}
