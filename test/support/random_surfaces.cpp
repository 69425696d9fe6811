#include "random_surfaces.h"

#include "hard_surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace test {

namespace {

/// Balls and rings, beside each other and in each other.
Soup many_parts(std::uint64_t seed) {
  Random random(seed);
  Soup soup = torus(16, 8);
  for (int i = 0; i < 12; ++i)
    soup = joined(soup, i % 3 == 0 ? torus(12, 6) : sphere(1),
                  {{random(-3, 3), random(-3, 3), random(-3, 3)}});
  return soup;
}

/// Two boxes side by side, each with points of its own where they touch.
Soup touching_boxes(std::uint64_t seed) {
  const Soup box = surface_of_cubes(5, 5, 5, [](int, int, int) { return true; });
  Soup other = surface_of_cubes(5, 4, 6, [](int, int, int) { return true; });
  if (seed % 2 == 0)
    other = box;
  return mapped(joined(box, other, {{5, 0, 0}}), [](const Position& p) {
    return p + 0.1 * (std::sin(6 * p[0]) + std::sin(7 * p[1]) + std::sin(8 * p[2])) *
                   Position{{0.3, 0.4, 0.5}};
  });
}

constexpr std::array kinds{
    SurfaceKind{"spiral",
                [](std::uint64_t, Random& random) { return spiral_wall(random(1, 3), 40, 5); }},
    SurfaceKind{"comb", [](std::uint64_t, Random&) { return comb(5, 6, 3); }},
    SurfaceKind{"linked tori", [](std::uint64_t, Random&) { return tori_in_each_other(12); }},
    SurfaceKind{"close sheets",
                [](std::uint64_t, Random& random) {
                  return close_sheets(12, std::pow(10, random(-6, -1)));
                }},
    SurfaceKind{"spikes", [](std::uint64_t seed, Random&) { return spiked(3, seed); }},
    SurfaceKind{"flat fan", [](std::uint64_t, Random&) { return flat_fan(40, 4); }},
    SurfaceKind{"cubes", [](std::uint64_t seed, Random&) { return random_cubes(4, seed); }},
    SurfaceKind{"borders",
                [](std::uint64_t seed, Random&) { return random_with_boundaries(seed); }},
    SurfaceKind{"plate", [](std::uint64_t, Random&) { return plate_with_holes(3, 2); }},
    SurfaceKind{"jagged",
                [](std::uint64_t seed, Random&) { return with_holes(grid(24, 18), seed, 12); }},
    SurfaceKind{"flat", [](std::uint64_t, Random&) { return grid(25, 20); }},
    SurfaceKind{"parts", [](std::uint64_t seed, Random&) { return many_parts(seed); }},
    SurfaceKind{"touching boxes",
                [](std::uint64_t seed, Random&) { return touching_boxes(seed / 14); }},
    SurfaceKind{"closed", [](std::uint64_t seed, Random&) { return random_closed(seed); }}};
static_assert(kinds.size() == 14); // which seeds of tests are chosen by

Surface plain_surface(std::uint64_t seed, const std::vector<Surface>& models) {
  Random random(seed);
  const SurfaceKind& kind = kinds[seed % kinds.size()];
  if (kind.name == std::string("borders") && !models.empty())
    return models[seed / kinds.size() % models.size()];
  return {kind.name, kind.make(seed, random)};
}

/// On whole multiples of a length, so that much lies on each other, without faces that lose a
/// corner.
Soup on_lattice(Soup soup, double step) {
  for (Position& p : soup.points)
    for (double& x : p.coordinates)
      x = step * std::round(x / step);
  std::erase_if(soup.triangles, [&](const Triangle& t) {
    const auto& p = soup.points;
    return p[t[0]] == p[t[1]] || p[t[1]] == p[t[2]] || p[t[2]] == p[t[0]];
  });
  return soup;
}

} // namespace

std::span<const SurfaceKind> surface_kinds() {
  return kinds;
}

Surface surface_of(std::uint64_t seed, const std::vector<Surface>& models) {
  Surface surface = plain_surface(seed, models);
  Random random(seed + 77);
  Soup& soup = surface.soup;
  const double edge = diagonal(soup) / std::sqrt(double(soup.triangles.size()));
  if (random.below(2) == 0)
    soup = with_noise(soup, seed, edge * random(0, 0.2));
  if (random.below(2) == 0)
    soup = tilted(soup);
  if (random.below(6) == 0)
    soup = on_lattice(soup, diagonal(soup) / 255);
  const double unit = random.below(3) == 0 ? std::pow(10, random(-6, 6)) : 1;
  const double far = random.below(4) == 0 ? 1e5 * diagonal(soup) : 0;
  soup = mapped(soup, [&](const Position& p) { return unit * (p + Position{{far, -far, far}}); });
  return surface;
}

} // namespace test
