#ifndef TEST_PROMISES_SEEDS_H
#define TEST_PROMISES_SEEDS_H

#include "models.h"
#include "random_surfaces.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

namespace test {

/// Prints each line. Are there none?
inline bool is_none_broken(const std::vector<std::string>& lines) {
  for (const std::string& line : lines)
    std::printf("BROKEN: %s\n", line.c_str());
  std::fflush(stdout);
  return lines.empty();
}

/// Calls check(seed, surface), which tells whether all promises are held, for the surface of each
/// seed. Arguments of the program: FIRST_SEED COUNT [MODEL.off...], models beside the others, in
/// their turn. The exit status of the program.
template <class Check>
int check_seeds(int argc, char** argv, Check check) {
  const std::uint64_t first = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 0;
  const std::uint64_t count = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 100;
  std::vector<Surface> models;
  for (int i = 3; i < argc; ++i)
    models.push_back({name_of(argv[i]), read_soup(argv[i], 100'000)});
  std::uint64_t broken = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed)
    try {
      broken += !check(seed, surface_of(seed, models));
    } catch (const std::exception& error) {
      std::printf("seed %llu: BROKEN: %s\n", static_cast<unsigned long long>(seed), error.what());
      ++broken;
    }
  std::printf("%llu of %llu seeds broken\n", static_cast<unsigned long long>(broken),
              static_cast<unsigned long long>(count));
  return broken == 0 ? 0 : 1;
}

} // namespace test

#endif // TEST_PROMISES_SEEDS_H
