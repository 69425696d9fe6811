// Simplifies random and hard surfaces by small parts, from a file to a file, and looks at
// distances, topology and regions of labels, by nothing but the points of both. Prints what is
// broken, and fails if anything is.
//   parts FIRST_SEED COUNT [MODEL.off...]    models are simplified beside the others, in their
//   turn
#include "models.h"
#include "part_attack.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

namespace {

std::vector<std::string> broken_of(std::uint64_t seed, const std::vector<test::Surface>& models) {
  try {
    return test::PartAttack(seed, test::surface_of(seed, models)).broken();
  } catch (const std::exception& error) {
    return {"seed " + std::to_string(seed) + ": " + error.what()};
  }
}

} // namespace

int main(int argc, char** argv) {
  const std::uint64_t first = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 0;
  const std::uint64_t count = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 100;
  std::vector<test::Surface> models;
  for (int i = 3; i < argc; ++i)
    models.push_back({test::name_of(argv[i]), test::read_soup(argv[i], 100'000)});
  std::uint64_t broken = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const std::vector<std::string> lines = broken_of(seed, models);
    for (const std::string& line : lines)
      std::printf("BROKEN: %s\n", line.c_str());
    std::fflush(stdout);
    broken += !lines.empty();
  }
  std::printf("%llu of %llu seeds broken\n", static_cast<unsigned long long>(broken),
              static_cast<unsigned long long>(count));
  return broken == 0 ? 0 : 1;
}
