#include "hard_surfaces.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace test {

Soup spiral_wall(double turns, int steps, int height) {
  const Soup bar = surface_of_cubes(steps, 2, height, [](int, int, int) { return true; });
  return mapped(bar, [&](const Position& p) {
    const double angle = 2 * std::numbers::pi * turns * p[0] / steps;
    const double radius = 1 + angle / (2 * std::numbers::pi) + 0.375 * p[1];
    return Position{{radius * std::cos(angle), radius * std::sin(angle), p[2] * turns / height}};
  });
}

Soup comb(int teeth, int length, int height) {
  const Soup cubes = surface_of_cubes(2 * teeth - 1, length, height,
                                      [](int x, int y, int) { return x % 2 == 0 || y == 0; });
  return mapped(cubes, [&](const Position& p) {
    const double tooth = std::floor((p[0] + 0.5) / 2), side = p[0] - 2 * tooth; // 0 or 1
    return Position{{tooth + 0.8 * side, 0.5 * p[1], 0.5 * p[2]}};
  });
}

Soup tori_in_each_other(std::uint32_t n) {
  const Soup torus = test::torus(2 * n, n);
  Soup other = torus;
  double reach = 0, height = 0;
  for (Position& p : other.points) {
    reach = std::max(reach, p[0]);
    height = std::max(height, p[2]);
    std::swap(p[1], p[2]);
    p[1] = -p[1];
  }
  return joined(torus, other, {{reach - height, 0, 0}});
}

Soup close_sheets(std::uint32_t n, double gap) {
  const Soup sheet = mapped(grid(n, n), [](const Position& p) {
    return Position{{p[0], p[1], 0.05 * std::sin(9 * p[0]) * std::cos(7 * p[1])}};
  });
  return joined(sheet, sheet, {{0, 0, gap}});
}

Soup spiked(int level, std::uint64_t seed) {
  Random random(seed);
  Soup soup = sphere(level);
  for (Position& p : soup.points)
    if (random.below(12) == 0)
      p *= 1 + random(0, 2);
  return soup;
}

Soup flat_fan(std::uint32_t sectors, std::uint32_t rings) {
  Soup soup;
  soup.points.push_back({});
  for (std::uint32_t r = 1; r <= rings; ++r)
    for (std::uint32_t s = 0; s < sectors; ++s) {
      const double angle = 2 * std::numbers::pi * s / sectors;
      soup.points.push_back({{r * std::cos(angle), r * std::sin(angle), 0}});
    }
  const auto at = [&](std::uint32_t r, std::uint32_t s) {
    return 1 + (r - 1) * sectors + s % sectors;
  };
  for (std::uint32_t s = 0; s < sectors; ++s) {
    soup.triangles.push_back({0, at(1, s), at(1, s + 1)});
    for (std::uint32_t r = 1; r < rings; ++r) {
      soup.triangles.push_back({at(r, s), at(r + 1, s), at(r + 1, s + 1)});
      soup.triangles.push_back({at(r, s), at(r + 1, s + 1), at(r, s + 1)});
    }
  }
  return soup;
}

Soup random_cubes(int n, std::uint64_t seed) {
  const auto is_there = [&](int x, int y, int z) {
    return Random(seed * 1000003 + static_cast<std::uint64_t>((x * n + y) * n + z)).below(3) == 0;
  };
  return surface_of_cubes(n, n, n, is_there);
}

} // namespace test
