// cut_handles: tunnels and handles up to a size are cut, wider ones stay, and the surface stays a
// closed manifold.

#include "soups.h"

#include <quadrille/cut_handles.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using test::Position;
using test::Soup;

// --- Shapes with tunnels and handles of known widths ---------------------------------------------

struct Square {
  int x, y, width;
  bool has(int at_x, int at_y) const {
    return at_x >= x && at_x < x + width && at_y >= y && at_y < y + width;
  }
  bool is_apart_from(const Square& other) const {
    return x > other.x + other.width + 1 || other.x > x + width + 1 ||
           y > other.y + other.width + 1 || other.y > y + width + 1;
  }
};

constexpr int columns = 26, rows = 20;

/// Squares of these widths, somewhere on a plate, apart from each other.
std::vector<Square> squares(std::uint64_t seed, const std::vector<int>& widths) {
  test::Random random(seed);
  std::vector<Square> result;
  for (const int width : widths)
    for (bool is_placed = false; !is_placed;) {
      const auto most = [width](int cells) { return static_cast<std::size_t>(cells - width - 4); };
      const Square square{2 + static_cast<int>(random.below(most(columns))),
                          2 + static_cast<int>(random.below(most(rows))), width};
      is_placed = true;
      for (const Square& other : result)
        is_placed &= square.is_apart_from(other);
      if (is_placed)
        result.push_back(square);
    }
  return result;
}

bool is_in(const std::vector<Square>& squares, int x, int y) {
  for (const Square& square : squares)
    if (square.has(x, y))
      return true;
  return false;
}

Soup plate(const std::vector<Square>& holes) {
  return test::surface_of_cubes(columns, rows, 4,
                                [&](int x, int y, int) { return !is_in(holes, x, y); });
}

/// Walls of two cubes around a hollow room, with holes in one of them.
Soup shell(const std::vector<Square>& holes) {
  return test::surface_of_cubes(columns, rows, 10, [&](int x, int y, int z) {
    const bool is_wall = x < 2 || y < 2 || z < 2 || x >= columns - 2 || y >= rows - 2 || z >= 8;
    return is_wall && (z >= 2 || !is_in(holes, x, y));
  });
}

/// Two plates with posts between them.
Soup posts(const std::vector<Square>& posts) {
  return test::surface_of_cubes(columns, rows, 10, [&](int x, int y, int z) {
    return z < 3 || z >= 7 || is_in(posts, x, y);
  });
}

/// Each point goes half of the way to the mean of its neighbours, several times.
Soup smoothed(Soup soup, int times) {
  for (int i = 0; i < times; ++i) {
    std::vector<Position> sum(soup.points.size());
    std::vector<double> count(soup.points.size());
    for (const auto& t : soup.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        sum[t[k]] += soup.points[t[(k + 1) % 3]];
        ++count[t[k]];
      }
    for (std::size_t v = 0; v < soup.points.size(); ++v)
      soup.points[v] = 0.5 * soup.points[v] + 0.5 / count[v] * sum[v];
  }
  return soup;
}
Soup smooth_plate(const std::vector<Square>& holes) {
  return smoothed(plate(holes), 3);
}

struct Shape {
  const char* name;
  Soup (*make)(const std::vector<Square>&);
};
constexpr std::array<Shape, 4> shapes{
    {{"plate", plate}, {"shell", shell}, {"posts", posts}, {"smooth plate", smooth_plate}}};

const std::vector<int> widths{1, 4, 2, 1, 2, 1};

/// What is left of a shape once all that is narrower than a size has been filled or taken away.
Soup filled(const Shape& shape, std::vector<Square> squares, double size) {
  std::erase_if(squares, [size](const Square& square) { return square.width < size; });
  return shape.make(squares);
}

using Points = std::vector<std::array<double, 3>>;

Soup soup_of(const Points& points, const std::vector<test::Triangle>& triangles) {
  Soup soup{{}, triangles};
  for (const auto& p : points)
    soup.points.push_back({p});
  return soup;
}

Points arrays_of(const Soup& soup) {
  Points points;
  for (const Position& p : soup.points)
    points.push_back(p.coordinates);
  return points;
}

void require_manifold(const Soup& soup) {
  const auto topology = test::topology_of(soup);
  CAPTURE(topology);
  CHECK(topology.is_closed());
  CHECK(topology.is_manifold);
  CHECK(topology.is_oriented);
  CHECK(!topology.has_duplicate_faces);
}

/// The parts that a shape has, and how many handles they have together.
std::pair<std::size_t, long> parts_and_genus(const Soup& soup) {
  const auto topology = test::topology_of(soup);
  return {topology.components, topology.genus()};
}

/// The number of edges where points at one place are one: less where both sides of a cut touch.
std::size_t edges_by_place(const Points& points, const std::vector<test::Triangle>& triangles) {
  std::set<std::array<std::array<double, 3>, 2>> edges;
  for (const test::Triangle& triangle : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto &a = points[triangle[i]], &b = points[triangle[(i + 1) % 3]];
      edges.insert({(std::min)(a, b), (std::max)(a, b)});
    }
  return edges.size();
}

/// A soup without tunnels and handles below a size. What must hold of any is checked.
std::pair<Soup, HandleChanges> cut(const Soup& input, double size) {
  Points points = arrays_of(input);
  std::vector<test::Triangle> triangles = input.triangles;
  const HandleChanges changes = cut_handles(points, triangles, size);
  const Soup result = soup_of(points, triangles);
  require_manifold(result);
  CHECK(test::volume(result) == Approx(test::volume(input)).epsilon(0.02));
  CHECK(edges_by_place(points, triangles) == 3 * triangles.size() / 2);
  const auto before = parts_and_genus(input), after = parts_and_genus(result);
  CHECK(before.second == after.second + static_cast<long>(changes.cut_handles));
  CHECK(after.first == before.first + changes.split_components);
  CHECK(points.size() == input.points.size() + changes.origins.size());
  CHECK(changes.triangles.size() == triangles.size());
  CHECK(std::equal(input.points.begin(), input.points.end(), result.points.begin()));
  for (std::size_t i = 0; i < changes.origins.size(); ++i) {
    const auto& [a, b] = changes.origins[i];
    REQUIRE((std::max)(a, b) < input.points.size() + i);
    if (a != b)
      CHECK(result.points[input.points.size() + i] ==
            0.5 * result.points[a] + 0.5 * result.points[b]);
  }
  return {result, changes};
}

/// A shape without tunnels and handles below a size.
void check(const Shape& shape, std::uint64_t seed, double size) {
  INFO(shape.name << ", seed " << seed << ", size " << size);
  const auto holes = squares(seed, widths);
  const auto [result, changes] = cut(shape.make(holes), size);
  CHECK(parts_and_genus(result).second == parts_and_genus(filled(shape, holes, size)).second);
}

/// A plate with a narrow tunnel and a wide one.
Soup two_tunnels() {
  return plate({{4, 4, 1}, {12, 8, 5}});
}

} // namespace

TEST_CASE("What is narrower than the size goes, all else stays") {
  for (const Shape& shape : shapes)
    for (std::uint64_t seed = 1; seed <= 3; seed += 2)
      for (double size : {0., 0.4, 1.5, 2.4})
        check(shape, seed, size);
}

TEST_CASE("A ring is cut across, where it is thinner than its hole is wide") {
  const Soup ring = test::torus(40, 24); // of the diameter 0.8, with a hole of 1.2
  for (const double size : {0.5, 0.75})
    CHECK(cut(ring, size).second.cut_handles == 0);
  for (const double size : {0.9, 1.2})
    CHECK(cut(ring, size).second.cut_handles == 1);
  CHECK(cut(test::with_noise(ring, 1, 0.02), 1.2).second.cut_handles == 1);
}

TEST_CASE("A tunnel that alone joins two walls parts them, and a limb stays however thin") {
  // A hollow box with one hole in its wall: the room gets a surface of its own.
  const Soup box = shell({{8, 8, 1}});
  const auto [room, of_room] = cut(box, 1.5);
  CHECK(of_room.cut_handles == 0);
  CHECK(of_room.split_components == 1);
  // Two blocks joined by a bar.
  const Soup bar = test::surface_of_cubes(
      30, 8, 8, [](int x, int y, int z) { return x < 8 || x >= 22 || (y == 4 && z == 4); });
  CHECK(cut(bar, 1.5).second.origins.empty());
  // Nor where one of them has a wide tunnel.
  const Soup bar_and_tunnel = test::surface_of_cubes(30, 14, 8, [](int x, int y, int z) {
    return (x < 14 && !(x >= 4 && x < 10 && y >= 4 && y < 10)) || x >= 22 || (y == 4 && z == 4);
  });
  CHECK(cut(bar_and_tunnel, 1.5).second.origins.empty());
  // A dent is no tunnel, however deep.
  const Soup dent = test::surface_of_cubes(
      9, 9, 12, [](int x, int y, int z) { return x != 4 || y != 4 || z < 2; });
  CHECK(cut(dent, 1.5).second.origins.empty());
}

TEST_CASE("A surface that is oriented inwards is cut where one that is oriented outwards is") {
  const auto inwards = [](Soup soup) {
    for (test::Triangle& triangle : soup.triangles)
      std::swap(triangle[0], triangle[1]);
    return soup;
  };
  CHECK(cut(inwards(two_tunnels()), 1.5).second.cut_handles == 1);
  CHECK(cut(inwards(shell({{8, 8, 1}})), 1.5).second.split_components == 1);
  const Soup bar = test::surface_of_cubes(
      30, 8, 8, [](int x, int y, int z) { return x < 8 || x >= 22 || (y == 4 && z == 4); });
  CHECK(cut(inwards(bar), 1.5).second.origins.empty());
}

TEST_CASE("A tunnel is as wide as its side or its diameter") {
  const auto slit = [](int u, int v) {
    return test::surface_of_cubes(20, 20, 8, [=](int x, int y, int) {
      return !(x >= 8 && x < 8 + u && y >= 8 && y < 8 + v);
    });
  };
  CHECK(cut(slit(3, 3), 3.01).second.cut_handles == 1);
  CHECK(cut(slit(3, 3), 2.99).second.cut_handles == 0);
  CHECK(cut(slit(1, 4), 2.51).second.cut_handles == 1);
  CHECK(cut(slit(1, 4), 2.49).second.cut_handles == 0);
}

TEST_CASE("The last of several tunnels through a wall parts it") {
  const auto [result, changes] = cut(shell({{5, 5, 1}, {9, 9, 1}, {15, 5, 1}, {15, 12, 1}}), 1.5);
  CHECK(changes.cut_handles == 3);
  CHECK(changes.split_components == 1);
}

TEST_CASE("Nothing is cut at points that are kept") {
  const Soup input = two_tunnels();
  Points points = arrays_of(input);
  std::vector<test::Triangle> triangles = input.triangles;
  std::vector<bool> is_kept;
  for (const auto& p : points)
    is_kept.push_back(p[0] >= 4 && p[0] <= 5 && p[1] >= 4 && p[1] <= 5);
  CHECK(cut_handles(points, triangles, 1.5, is_kept).origins.empty());
  CHECK(test::is_identical(soup_of(points, triangles), input));
}

TEST_CASE("Cuts go round what is not manifold, and boundaries stay") {
  // Two blocks that touch along an edge, each with a tunnel.
  Soup input = test::surface_of_cubes(10, 10, 3, [](int x, int y, int) {
    return (x < 5) == (y < 5) && !(x == 2 && y == 2) && !(x == 7 && y == 7);
  });
  Points points = arrays_of(input);
  std::vector<test::Triangle> triangles = input.triangles;
  CHECK(cut_handles(points, triangles, 1.5).cut_handles == 2);
  Soup open = two_tunnels();
  open.triangles.erase(open.triangles.begin(), open.triangles.begin() + 2);
  points = arrays_of(open);
  triangles = open.triangles;
  CHECK(cut_handles(points, triangles, 1.5).cut_handles == 1);
  CHECK(test::topology_of(soup_of(points, triangles)).boundary_edges ==
        test::topology_of(open).boundary_edges);
}

TEST_CASE("Nothing is cut between faces that are wound against each other") {
  Soup input = two_tunnels();
  for (std::size_t face = 0; face < input.triangles.size(); face += 2)
    std::swap(input.triangles[face][0], input.triangles[face][1]);
  Points points = arrays_of(input);
  std::vector<test::Triangle> triangles = input.triangles;
  CHECK(cut_handles(points, triangles, 1.5).origins.empty());
}

TEST_CASE("A size that is no length is refused, and the soup unchanged") {
  const Soup input = two_tunnels();
  Points points = arrays_of(input);
  std::vector<test::Triangle> triangles = input.triangles;
  for (const double size : {-1., std::numeric_limits<double>::infinity()})
    CHECK_THROWS_WITH(cut_handles(points, triangles, size), Catch::Contains("is no length"));
  CHECK(test::is_identical(soup_of(points, triangles), input));
}
