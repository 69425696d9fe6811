// VoxelSize: surfaces of formulas are made of voxels and simplified, and the distance of the result
// to the formula is measured, which shares nothing with the engine.
#include "soups.h"

#include <quadrille/compiled.h>
#include <quadrille/quadric.h>
#include <quadrille/simplify.h>
#include <quadrille/voxel_size.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using test::Position;
using test::Soup;
using Cell = std::array<int, 3>;
using Formula = std::function<double(const Position&)>; // below 0 inside
using LabelOfCell = std::function<int(const Cell&)>;    // of the voxels, 0 outside

constexpr int side = 40; // voxels, whose centres are at integers

// The squares between voxels of different labels, each once, with the labels on both sides.
struct Blocks {
  Soup soup;
  std::vector<std::array<int, 2>> labels; // in front of each triangle, and behind it
};

Blocks blocks(const LabelOfCell& label) {
  Blocks result;
  std::map<Cell, std::uint32_t> numbers;
  const auto corner = [&](const Cell& c) {
    const auto [at, is_new] =
        numbers.try_emplace(c, static_cast<std::uint32_t>(result.soup.points.size()));
    if (is_new)
      result.soup.points.push_back({{c[0] - 0.5, c[1] - 0.5, c[2] - 0.5}});
    return at->second;
  };
  for (int x = 0; x <= side; ++x)
    for (int y = 0; y <= side; ++y)
      for (int z = 0; z <= side; ++z)
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const Cell high{x, y, z};
          Cell low = high;
          --low[axis];
          const int inside = label(low), outside = label(high);
          if (inside == outside)
            continue;
          std::array<std::uint32_t, 4> square;
          constexpr std::array<Cell, 4> around{{{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}}};
          for (std::size_t i = 0; i < 4; ++i) {
            Cell at = high;
            at[(axis + 1) % 3] += around[i][1];
            at[(axis + 2) % 3] += around[i][2];
            square[i] = corner(at);
          }
          if (inside == 0)
            std::swap(square[1], square[3]);
          result.soup.triangles.push_back({square[0], square[1], square[2]});
          result.soup.triangles.push_back({square[0], square[2], square[3]});
          const std::array<int, 2> sides{inside == 0 ? 0 : outside, inside == 0 ? outside : inside};
          result.labels.insert(result.labels.end(), 2, sides);
        }
  return result;
}

// Marching cubes of a binary image: in each cube of eight voxels the crossings of its edges are
// joined along its sides, and their loops are cut into triangles.
class MarchingCubes {
public:
  explicit MarchingCubes(std::function<bool(const Cell&)> is_inside)
      : is_inside_(std::move(is_inside)) {
    for (int x = -1; x < side; ++x)
      for (int y = -1; y < side; ++y)
        for (int z = -1; z < side; ++z)
          march({x, y, z});
  }
  const Soup& soup() const { return soup_; }

private:
  void march(const Cell& cube) {
    next_.clear();
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (int at = 0; at < 2; ++at)
        join_on_side(cube, axis, at);
    while (!next_.empty()) {
      std::vector<std::uint32_t> loop;
      for (auto at = next_.begin(); at != next_.end();) {
        const Cell to = at->second;
        loop.push_back(number(at->first));
        next_.erase(at);
        at = next_.find(to);
      }
      for (std::size_t i = 2; i < loop.size(); ++i)
        soup_.triangles.push_back({loop[0], loop[i - 1], loop[i]});
    }
  }

  // Joins each crossing into a run of corners inside to the crossing out of it.
  void join_on_side(const Cell& cube, std::size_t axis, int at) {
    std::array<Cell, 4> corners;
    std::array<bool, 4> is_inside;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t turn = at == 1 ? i : 3 - i;
      corners[i] = cube;
      corners[i][axis] += at;
      corners[i][(axis + 1) % 3] += turn == 1 || turn == 2;
      corners[i][(axis + 2) % 3] += turn >= 2;
      is_inside[i] = is_inside_(corners[i]);
    }
    const auto middle = [&](std::size_t i) {
      Cell sum;
      for (std::size_t k = 0; k < 3; ++k)
        sum[k] = corners[i][k] + corners[(i + 1) % 4][k];
      return sum;
    };
    for (std::size_t last = 0; last < 4; ++last)
      if (is_inside[last] && !is_inside[(last + 1) % 4]) {
        std::size_t first = last;
        while (is_inside[(first + 3) % 4])
          first = (first + 3) % 4;
        next_[middle((first + 3) % 4)] = middle(last);
      }
  }

  std::uint32_t number(const Cell& twice) {
    const auto [at, is_new] =
        numbers_.try_emplace(twice, static_cast<std::uint32_t>(soup_.points.size()));
    if (is_new)
      soup_.points.push_back({{twice[0] / 2.0, twice[1] / 2.0, twice[2] / 2.0}});
    return at->second;
  }

  std::function<bool(const Cell&)> is_inside_;
  Soup soup_;
  std::map<Cell, std::uint32_t> numbers_; // of points, by twice their coordinates
  std::map<Cell, Cell> next_;             // the crossing after each one of a cube
};

Position centred(const Position& p) {
  return {{p[0] - 19.7, p[1] - 19.4, p[2] - 19.9}};
}

double length(const Position& p) {
  return std::sqrt(squared_length(p));
}

double ball(const Position& p) {
  return length(centred(p)) - 15.3;
}
double ring(const Position& p) {
  const Position q = centred(p);
  return std::hypot(std::hypot(q[0], q[1]) - 11.2, q[2]) - 5.7;
}
// The distance from a ball with ridges, to first order.
double ridges(const Position& p) {
  const auto level = [](const Position& x) {
    const Position q = centred(x);
    const double r = length(q) + 1e-12;
    return r - 14 - 1.5 * std::sin(4 * q[0] / r + 1) * std::sin(3 * q[1] / r) -
           std::sin(7 * q[2] / r);
  };
  Position slope;
  for (std::size_t i = 0; i < 3; ++i) {
    Position low = p, high = p;
    low[i] -= 1e-4;
    high[i] += 1e-4;
    slope[i] = (level(high) - level(low)) / 2e-4;
  }
  return level(p) / length(slope);
}

// The root mean square of the distances of points of all triangles.
double rms(const SoupPoints& points, const SoupTriangles& triangles, const Formula& formula) {
  double sum = 0, area = 0;
  constexpr int steps = 6;
  for (const auto& t : triangles) {
    const Position a{points[t[0]]}, b{points[t[1]]}, c{points[t[2]]};
    double squares = 0;
    int count = 0;
    for (int i = 0; i < steps; ++i)
      for (int j = 0; i + j < steps; ++j, ++count) {
        const double u = (i + 1.0 / 3) / steps, v = (j + 1.0 / 3) / steps;
        const double d = formula((1 - u - v) * a + u * b + v * c);
        squares += d * d;
      }
    const double weight = length(double_area_vector(a, b, c));
    sum += weight * squares / count;
    area += weight;
  }
  return std::sqrt(sum / area);
}

SoupPoints arrays_of(const Soup& soup) {
  SoupPoints points;
  for (const Position& p : soup.points)
    points.push_back(p.coordinates);
  return points;
}

SoupResult simplified(const Soup& soup, std::size_t faces, bool are_voxels) {
  SoupOptions options;
  options.faces = faces;
  if (are_voxels)
    options.voxel_size = 1;
  const SoupPoints points = arrays_of(soup);
  return simplified_soup({points, soup.triangles}, options);
}

Soup blocky(const Formula& formula) {
  return blocks([&](const Cell& c) {
           return formula({{double(c[0]), double(c[1]), double(c[2])}}) < 0 ? 1 : 0;
         })
      .soup;
}
Soup marched(const Formula& formula) {
  return MarchingCubes([&](const Cell& c) {
           return formula({{double(c[0]), double(c[1]), double(c[2])}}) < 0;
         })
      .soup();
}

// Six times the volume in front of or behind the triangles of a label.
double volume_of(int label, const SoupPoints& points, const SoupTriangles& triangles,
                 const auto& labels_of) {
  double volume = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& t = triangles[i];
    const Position a{points[t[0]]}, b{points[t[1]]}, c{points[t[2]]};
    const std::array<int, 2>& labels = labels_of(i);
    const double sign = (labels[1] == label ? 1 : 0) - (labels[0] == label ? 1 : 0);
    volume += sign * dot(a, cross(b, c));
  }
  return volume;
}

} // namespace

TEST_CASE("smoothed staircases are half as far from the formula", "[voxels]") {
  const std::pair<const char*, Formula> formulas[] = {
      {"ball", ball}, {"ring", ring}, {"ridges", ridges}};
  for (const auto& [name, formula] : formulas)
    for (const bool is_blocky : {true, false}) {
      const Soup soup = is_blocky ? blocky(formula) : marched(formula);
      REQUIRE(soup.triangles.size() > 3000);
      const SoupResult plain = simplified(soup, 900, false), smooth = simplified(soup, 900, true);
      const double before = rms(plain.points, plain.triangles, formula);
      const double after = rms(smooth.points, smooth.triangles, formula);
      CAPTURE(name, is_blocky, before, after, after / before);
      CHECK(after <= (is_blocky ? 0.4 : 0.55) * before);
    }
}

TEST_CASE("no vertex of a staircase moves by more than half a voxel along an axis", "[voxels]") {
  const Soup soup = blocky(ridges);
  const SoupResult result = simplified(soup, soup.triangles.size(), true);
  REQUIRE(result.points.size() == soup.points.size());
  double farthest = 0;
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    for (std::size_t i = 0; i < 3; ++i)
      farthest = (std::max)(farthest, std::abs(result.points[v][i] - soup.points[v][i]));
  CHECK(farthest <= 0.5 + 1e-12);
  CHECK(farthest > 0.3);
}

TEST_CASE("walls of labels stay shared, and volumes stay the same", "[voxels]") {
  const LabelOfCell label = [](const Cell& c) {
    const Position p{{double(c[0]), double(c[1]), double(c[2])}};
    return ball(p) >= 0 ? 0 : p[0] + 0.3 * p[1] < 25 ? 1 : p[2] < 19 ? 2 : 3;
  };
  const Blocks input = blocks(label);
  const SoupPoints points = arrays_of(input.soup);
  std::vector<std::uint32_t> labels;
  for (const auto& [front, back] : input.labels)
    labels.push_back(static_cast<std::uint32_t>(4 * front + back));
  SoupOptions options;
  options.faces = 900;
  options.voxel_size = 1;
  const SoupResult result = simplified_soup({points, input.soup.triangles, labels, {}}, options);
  CHECK(result.triangles.size() <= 901);
  std::map<std::array<std::uint32_t, 2>, int> sides;
  for (const auto& t : result.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      ++sides[{(std::min)(t[i], t[(i + 1) % 3]), (std::max)(t[i], t[(i + 1) % 3])}];
  std::size_t open = 0, of_three = 0;
  for (const auto& [edge, count] : sides) {
    open += count == 1;
    of_three += count == 3;
  }
  CHECK(open == 0);
  CHECK(of_three > 20);
  for (int i = 1; i <= 3; ++i) {
    const double before =
        volume_of(i, points, input.soup.triangles, [&](std::size_t t) { return input.labels[t]; });
    const double after = volume_of(i, result.points, result.triangles, [&](std::size_t t) {
      return input.labels[result.input_faces[t]];
    });
    CHECK(after == Approx(before).epsilon(0.02));
  }
}

TEST_CASE("flat walls of many voxels stay flat, and fixed vertices in their places", "[voxels]") {
  const Soup box = blocky([](const Position& p) {
    return (std::max)({std::abs(p[0] - 20), std::abs(p[1] - 20), std::abs(p[2] - 20)}) - 12.2;
  });
  SoupOptions options;
  options.faces = box.triangles.size();
  options.voxel_size = 1;
  options.fixed.resize(box.points.size(), false);
  options.fixed[0] = true;
  const SoupPoints points = arrays_of(box);
  const SoupResult result = simplified_soup({points, box.triangles}, options);
  CHECK(result.points[0] == points[0]);
  for (std::size_t v = 0; v < points.size(); ++v)
    if (std::hypot(points[v][0] - 20, points[v][1] - 20) < 5)
      CHECK(result.points[v][2] == Approx(points[v][2]).margin(0.2));
}

TEST_CASE("the preset of voxels finds the size of those of marching cubes", "[voxels]") {
  for (const bool is_blocky : {true, false}) {
    Soup soup = is_blocky ? blocky(ring) : marched(ring);
    for (Position& p : soup.points)
      p = 0.37 * p;
    const SoupPoints points = arrays_of(soup);
    SoupOptions options;
    options.faces = 900;
    options.preset = SoupOptions::Preset::voxels;
    const SoupResult found = simplified_soup({points, soup.triangles}, options);
    options.preset.reset();
    options.manifold = true;
    options.topology = Topology::components_may_vanish;
    options.simplified_topology = 1.7 * 0.37;
    options.voxel_size = 0.37;
    const SoupResult own = simplified_soup({points, soup.triangles}, options);
    REQUIRE(found.points.size() == own.points.size());
    double farthest = 0;
    for (std::size_t v = 0; v < own.points.size(); ++v)
      for (std::size_t i = 0; i < 3; ++i)
        farthest = (std::max)(farthest, std::abs(found.points[v][i] - own.points[v][i]));
    CHECK(farthest < 1e-6);
  }
}

TEST_CASE("a voxel has a size", "[voxels]") {
  SoupPoints points = arrays_of(test::cube(3));
  SoupTriangles triangles = test::cube(3).triangles;
  CHECK_THROWS_WITH(simplify(points, triangles, VoxelSize{0}),
                    Catch::Contains("the size 0 is not above 0"));
  CHECK(points == arrays_of(test::cube(3)));
}
