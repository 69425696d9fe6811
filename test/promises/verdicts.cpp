// Damages right results of random solids at random: is each damage found by the claim that it
// breaks, and by no other, and is what is right held? For each seed one kind of damage.
#include "damage.h"
#include "soups.h"

#include <quadrille/verify.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using test::Soup;

// Balls of 32 faces stand for balls of 128, which are 0.3 of their radius larger at most.
constexpr double distance = 0.5;

quadrille::Verdict verdict_on(const Soup& input, const Soup& result,
                              const quadrille::Claims& claims) {
  return quadrille::verify(input.points, input.triangles, result.points, result.triangles, claims);
}

std::string text_of(const quadrille::Verdict& verdict) {
  std::ostringstream text;
  text << verdict;
  return text.str();
}

/// With the points and faces in another order, so that parts have other numbers.
bool is_found(std::uint64_t seed, const test::Damage& damage) {
  test::RandomSolid solid(seed);
  const Soup input = test::shuffled(solid.soup(1), seed), right = solid.soup(0);
  const quadrille::Verdict held = verdict_on(input, test::shuffled(right, seed + 1), damage.claims);
  Soup damaged = right;
  damage.apply(solid, damaged);
  const quadrille::Verdict verdict =
      verdict_on(input, test::shuffled(damaged, seed + 2), damage.claims);
  if (held && test::broken_findings(verdict) == std::vector{damage.finding})
    return true;
  std::printf("seed %llu, %s:\n  right: %s\n  damaged: %s\n", static_cast<unsigned long long>(seed),
              damage.name.c_str(), text_of(held).c_str(), text_of(verdict).c_str());
  return false;
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: verdicts FIRST_SEED COUNT\n");
    return 2;
  }
  std::vector<test::Damage> damages = test::damages_of_faces(distance);
  for (test::Damage& damage : test::damages_of_parts())
    damages.push_back(std::move(damage));
  std::map<std::string, std::pair<int, int>> counts;
  bool is_right = true;
  const std::uint64_t first = std::strtoull(argv[1], nullptr, 10);
  for (std::uint64_t seed = first; seed < first + std::strtoull(argv[2], nullptr, 10); ++seed) {
    const test::Damage& damage = damages[seed % damages.size()];
    auto& [found, all] = counts[damage.name];
    found += is_found(seed, damage);
    is_right &= found == ++all;
  }
  for (const auto& [name, count] : counts)
    std::printf("%s: %d of %d found\n", name.c_str(), count.first, count.second);
  return is_right ? 0 : 1;
}
