#ifndef TEST_SUPPORT_RANDOM_SURFACES_H
#define TEST_SUPPORT_RANDOM_SURFACES_H

/// \file
/// Surfaces to hold promises on: equal seeds are equal surfaces.

#include "hard_surfaces.h"
#include "soups.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace test {

/// A surface and its name.
struct Surface {
  std::string name;
  Soup soup;
};

/// Balls and rings, beside each other and in each other.
inline Soup many_parts(std::uint64_t seed) {
  Random random(seed);
  Soup soup = torus(16, 8);
  for (int i = 0; i < 12; ++i)
    soup = joined(soup, i % 3 == 0 ? torus(12, 6) : sphere(1),
                  {{random(-3, 3), random(-3, 3), random(-3, 3)}});
  return soup;
}

/// Two boxes side by side, each with points of its own where they touch.
inline Soup touching_boxes(std::uint64_t seed) {
  const Soup box = surface_of_cubes(5, 5, 5, [](int, int, int) { return true; });
  Soup other = surface_of_cubes(5, 4, 6, [](int, int, int) { return true; });
  if (seed % 2 == 0)
    other = box;
  return mapped(joined(box, other, {{5, 0, 0}}), [](const Position& p) {
    return p + 0.1 * (std::sin(6 * p[0]) + std::sin(7 * p[1]) + std::sin(8 * p[2])) *
                   Position{{0.3, 0.4, 0.5}};
  });
}

inline Surface plain_surface(std::uint64_t seed, const std::vector<Surface>& models) {
  Random random(seed);
  switch (seed % 14) {
  case 0:
    return {"spiral", spiral_wall(random(1, 3), 40, 5)};
  case 1:
    return {"comb", comb(5, 6, 3)};
  case 2:
    return {"linked tori", tori_in_each_other(12)};
  case 3:
    return {"close sheets", close_sheets(12, std::pow(10, random(-6, -1)))};
  case 4:
    return {"spikes", spiked(3, seed)};
  case 5:
    return {"flat fan", flat_fan(40, 4)};
  case 6:
    return {"cubes", random_cubes(4, seed)};
  case 7:
    if (!models.empty())
      return models[seed / 14 % models.size()];
    return {"borders", random_with_borders(seed)};
  case 8:
    return {"plate", plate_with_holes(3, 2)};
  case 9:
    return {"jagged", with_holes(grid(24, 18), seed, 12)};
  case 10:
    return {"flat", grid(25, 20)};
  case 11:
    return {"parts", many_parts(seed)};
  case 12:
    return {"touching boxes", touching_boxes(seed / 14)};
  default:
    return {"closed", random_closed(seed)};
  }
}

/// On whole multiples of a length, so that much lies on each other, without faces that lose a
/// corner.
inline Soup on_lattice(Soup soup, double step) {
  for (Position& p : soup.points)
    for (double& x : p.coordinates)
      x = step * std::round(x / step);
  std::erase_if(soup.triangles, [&](const Triangle& t) {
    const auto& p = soup.points;
    return p[t[0]] == p[t[1]] || p[t[1]] == p[t[2]] || p[t[2]] == p[t[0]];
  });
  return soup;
}

/// With noise, turned, on a lattice, in another unit, far from the origin, by the seed.
inline Surface surface_of(std::uint64_t seed, const std::vector<Surface>& models) {
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

#endif // TEST_SUPPORT_RANDOM_SURFACES_H
