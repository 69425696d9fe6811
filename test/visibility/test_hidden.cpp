// Hidden faces, on shapes of which is known what is seen, and how much of it.

#include "meshes.h"
#include "soups.h"

#include <CGAL/boost/graph/helpers.h>
#include <catch2/catch.hpp>
#include <quadrille/hidden.h>
#include <quadrille/manifold.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using Catch::Contains;
using test::joined;
using test::Position;
using test::Soup;

Soup scaled(Soup soup, double factor, const Position& shift = {}) {
  for (Position& p : soup.points)
    p = factor * p + shift;
  return soup;
}

Soup reversed(Soup soup) {
  for (auto& [a, b, c] : soup.triangles)
    std::swap(b, c);
  return soup;
}

/// A cube of the side 2 around the origin, 12 n² faces, oriented outward.
Soup cube(int n) {
  return scaled(test::cube(n), 2, {{-1, -1, -1}});
}

/// The surface that a line in the plane of x and z describes when it turns around the z axis. Ends
/// with x = 0 are poles.
Soup turned(const std::vector<std::array<double, 2>>& line, std::uint32_t around) {
  Soup soup;
  std::vector<std::uint32_t> begin;
  for (const auto& [x, z] : line) {
    begin.push_back(static_cast<std::uint32_t>(soup.points.size()));
    for (std::uint32_t k = 0; k < (x == 0 ? 1 : around); ++k) {
      const double angle = 2 * std::numbers::pi * k / around;
      soup.points.push_back({{x * std::cos(angle), x * std::sin(angle), z}});
    }
  }
  const auto point = [&](std::size_t i, std::uint32_t k) {
    return begin[i] + (line[i][0] == 0 ? 0 : k % around);
  };
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    for (std::uint32_t k = 0; k < around; ++k) {
      if (line[i][0] != 0)
        soup.triangles.push_back({point(i, k), point(i, k + 1), point(i + 1, k)});
      if (line[i + 1][0] != 0)
        soup.triangles.push_back({point(i, k + 1), point(i + 1, k + 1), point(i + 1, k)});
    }
  return soup;
}

std::vector<std::array<double, 2>> arc(double radius, double from, double to, int steps) {
  std::vector<std::array<double, 2>> line;
  for (int i = 0; i <= steps; ++i) {
    const double angle = from + (to - from) * i / steps;
    line.push_back({radius * std::sin(angle), -radius * std::cos(angle)});
  }
  return line;
}

/// A bottle: a sphere of radius 1 with a wall of 0.02, and an opening at its top of a radius.
Soup bottle(double opening, std::uint32_t around = 24) {
  constexpr double pi = std::numbers::pi;
  auto line = arc(1, 0, pi - std::asin(opening), 12);
  const auto inside = arc(0.98, pi - std::asin(opening / 0.98), 0, 12);
  line.insert(line.end(), inside.begin(), inside.end());
  line.front()[0] = line.back()[0] = 0;
  return turned(line, around);
}

HiddenFaces hidden(const Soup& soup, const HiddenOptions& options = {}) {
  return hidden_faces(soup.points, soup.triangles, options);
}

/// The numbers of hidden faces below and from `first` on.
std::array<std::size_t, 2> hidden_parts(const HiddenFaces& found, std::size_t first) {
  std::array<std::size_t, 2> counts{};
  for (std::size_t face = 0; face < found.is_hidden.size(); ++face)
    counts[face >= first] += found.is_hidden[face];
  return counts;
}

using Parts = std::array<std::size_t, 2>;

/// A cube of 16³ cells with an empty space of 8³ in its middle, and tunnels to that from cells of
/// the outside.
Soup shell_of_cubes(const std::vector<std::array<int, 3>>& tunnels) {
  const auto is_tunnel = [&](const std::array<int, 3>& cell) {
    return std::any_of(tunnels.begin(), tunnels.end(), [&](const std::array<int, 3>& mouth) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        if (mouth[axis] % 15 == 0 && cell[u] == mouth[u] && cell[v] == mouth[v] &&
            (mouth[axis] == 0) == (cell[axis] < 8))
          return true;
      }
      return false;
    });
  };
  const auto is_inside = [](int x) { return x >= 4 && x < 12; };
  return test::surface_of_cubes(16, 16, 16, [&](int x, int y, int z) {
    return !(is_inside(x) && is_inside(y) && is_inside(z)) && !is_tunnel({x, y, z});
  });
}

/// The mouths of tunnels that may cross each other.
std::vector<std::array<int, 3>> random_tunnels(std::uint32_t seed, int count) {
  std::minstd_rand random(seed);
  const auto below = [&](std::uint32_t n) { return static_cast<int>(random() % n); };
  std::vector<std::array<int, 3>> mouths;
  for (int i = 0; i < count; ++i) {
    std::array<int, 3> mouth{4 + below(8), 4 + below(8), 4 + below(8)};
    mouth[random() % 3] = 15 * below(2);
    mouths.push_back(mouth);
  }
  return mouths;
}

/// Does a face lie on the cube from 0 to `size`?
bool is_in_hull(const Soup& soup, std::size_t face, double size) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const double at : {0.0, size})
      if (std::all_of(soup.triangles[face].begin(), soup.triangles[face].end(),
                      [&](std::uint32_t v) { return soup.points[v][axis] == at; }))
        return true;
  return false;
}

/// The edges, by places, along which faces run more often one way than the other.
std::size_t edges_out_of_balance(const Soup& soup) {
  std::map<std::array<std::array<double, 3>, 2>, int> balance;
  for (const auto& triangle : soup.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto &a = soup.points[triangle[i]].coordinates,
                 &b = soup.points[triangle[(i + 1) % 3]].coordinates;
      balance[{(std::min)(a, b), (std::max)(a, b)}] += a < b ? 1 : -1;
    }
  return static_cast<std::size_t>(
      std::count_if(balance.begin(), balance.end(), [](const auto& b) { return b.second != 0; }));
}

} // namespace

TEST_CASE("A cube in a cube is hidden, and named with its size") {
  const Soup outside = cube(6), inside = scaled(cube(4), 0.5);
  const HiddenFaces found = hidden(joined(outside, inside));
  CHECK(hidden_parts(found, outside.triangles.size()) == Parts{0, inside.triangles.size()});
  CHECK(found.count == inside.triangles.size());
  CHECK(found.area == Approx(6));
  CHECK(found.whole_area == Approx(30));
  CHECK(found.cut_edges == 0);
  REQUIRE(found.groups.size() == 1);
  const HiddenGroup& group = found.groups.front();
  CHECK(group.kind == HiddenKind::inner_component);
  CHECK(group.faces.front() == outside.triangles.size());
  CHECK(group.faces.size() == inside.triangles.size());
  CHECK(group.area == Approx(6));
  CHECK(group.volume == Approx(1));
  CHECK(group.diagonal == Approx(std::sqrt(3.0)));
}

TEST_CASE("The wall of an empty space is a cavity") {
  const Soup outside = test::sphere(4), wall = reversed(scaled(test::sphere(3), 0.9));
  const HiddenFaces found = hidden(joined(outside, wall));
  CHECK(hidden_parts(found, outside.triangles.size()) == Parts{0, wall.triangles.size()});
  REQUIRE(found.groups.size() == 1);
  CHECK(found.groups.front().kind == HiddenKind::cavity);
  CHECK(found.groups.front().volume == Approx(4.0 / 3 * std::numbers::pi * 0.729).epsilon(0.05));
  CHECK(to_string(found.groups.front().kind) == "cavity");
}

TEST_CASE("All of a convex surface, a torus, a grid and a double-sided sheet is seen") {
  const Soup sheet = test::grid(8, 8);
  CHECK(hidden(test::sphere(4)).count == 0);
  CHECK(hidden(cube(1)).count == 0);
  CHECK(hidden(test::torus(48, 24)).count == 0);
  CHECK(hidden(sheet).count == 0);
  CHECK(hidden(joined(sheet, reversed(sheet))).count == 0);
  CHECK(hidden(test::triangle()).count == 0);
  CHECK(hidden(Soup{}).count == 0);
}

TEST_CASE(
    "The inside of a cup is seen through its opening, and that of a bottle through its neck") {
  CHECK(hidden(bottle(0.9)).count == 0);
  CHECK(hidden(bottle(0.2)).count == 0);
  // A single free ray of 32 is above the threshold; more rays show that it was a rare one.
  const Soup narrow = bottle(0.1);
  const auto is_hidden = hidden(narrow, {.threshold = 0.02}).is_hidden;
  for (std::size_t face = narrow.triangles.size() / 2; face < narrow.triangles.size(); ++face)
    if (narrow.points[narrow.triangles[face][0]][2] < 0)
      CHECK(is_hidden[face]);
  // Through this neck, a fraction of 0.0003 of the directions leads to the bottom.
  const HiddenFaces found = hidden(bottle(0.05));
  CHECK(found.count > 100);
  CHECK(found.cut_edges > 0);
  CHECK(found.groups.size() < 10);
  CHECK(found.groups.front().kind == HiddenKind::inner_surface);
  CHECK(found.groups.front().volume == 0);
}

TEST_CASE("Two plates with a thin gap hide only what is deep in it, if a threshold allows that") {
  const Soup plates = joined(test::grid(40, 40), scaled(test::grid(40, 40), 1, {{0, 0, 0.01}}));
  CHECK(hidden(plates).count == 0);
  // The front of the lower plate and the back of the upper one are in the gap.
  const HiddenFaces found = hidden(reversed(plates), {.front_only = true});
  CHECK(hidden_parts(found, 3200)[0] == 0);
}

TEST_CASE("Boxes that touch hide the faces between them") {
  const Soup left = cube(4), right = scaled(cube(4), 1, {{2, 0, 0}});
  const HiddenFaces found = hidden(joined(left, right));
  CHECK(found.count == 2 * 32);
  CHECK(found.area == Approx(8));
}

TEST_CASE("The inner one of two coincident walls is hidden, and nothing is left open") {
  const Soup outside = cube(3);
  const HiddenFaces found = hidden(joined(outside, reversed(outside)));
  CHECK(hidden_parts(found, outside.triangles.size()) == Parts{0, outside.triangles.size()});
  CHECK(found.cut_edges == 0);
  REQUIRE(found.groups.size() == 1);
  CHECK(found.groups.front().kind == HiddenKind::cavity);
}

TEST_CASE("Only the fronts of faces count if that is asked for") {
  const Soup inside_out = reversed(test::sphere(3));
  CHECK(hidden(inside_out).count == 0);
  CHECK(hidden(inside_out, {.front_only = true}).count == inside_out.triangles.size());
  CHECK(hidden(test::sphere(3), {.front_only = true}).count == 0);
  CHECK(hidden(test::grid(4, 4), {.front_only = true}).count == 0);
}

TEST_CASE("Hidden faces do not depend on the unit, the place, seams and extreme coordinates") {
  const Soup shell = joined(test::sphere(3), reversed(scaled(test::sphere(3), 0.9)));
  const auto expected = hidden(shell).is_hidden;
  for (const double unit : {1e-150, 0x1p-40, 0x1p90, 1e150})
    CHECK(hidden(scaled(shell, unit)).is_hidden == expected);
  CHECK(hidden(scaled(shell, 1, {{1024, -512, 64}})).is_hidden == expected);
  Soup split;
  for (const auto& triangle : shell.triangles) {
    const auto first = static_cast<std::uint32_t>(split.points.size());
    for (const std::uint32_t v : triangle)
      split.points.push_back(shell.points[v]);
    split.triangles.push_back({first, first + 1, first + 2});
  }
  const HiddenFaces found = hidden(split);
  CHECK(found.is_hidden == expected);
  CHECK(found.groups.size() == 1);
}

TEST_CASE("A non-manifold edge connects hidden groups, and a degenerate face does no harm") {
  Soup inside = scaled(test::surface_of_cubes(2, 2, 1, [](int x, int y, int) { return x == y; }),
                       0.2, {{-0.2, -0.2, -0.1}});
  inside.triangles.push_back({0, 0, 1});
  inside.triangles.push_back({0, 1, 1});
  const Soup outside = cube(3);
  const HiddenFaces found = hidden(joined(outside, inside));
  CHECK(hidden_parts(found, outside.triangles.size()) == Parts{0, inside.triangles.size()});
  CHECK(found.groups.front().faces.size() == 24 + 2);
  CHECK(found.groups.front().volume == Approx(2 * 0.008));
}

TEST_CASE("Hidden triangles are removed from a soup, the others keep their order") {
  const Soup outside = cube(3), inside = scaled(cube(2), 0.3);
  const Soup both = joined(inside, outside);
  Soup soup = both;
  const HiddenRemoval changes = remove_hidden(soup.points, soup.triangles);
  CHECK(changes.found.count == inside.triangles.size());
  CHECK(changes.removed == inside.triangles.size());
  CHECK(changes.caps == 0);
  CHECK(soup.points.size() == inside.points.size() + outside.points.size());
  CHECK(std::equal(soup.triangles.begin(), soup.triangles.end(),
                   both.triangles.begin() + std::ptrdiff_t(inside.triangles.size()),
                   both.triangles.end()));
}

TEST_CASE("What is left of a shell with tunnels is its closed outer wall") {
  const Soup shell = shell_of_cubes({{6, 9, 0}, {9, 6, 0}, {0, 6, 6}, {15, 9, 9}, {9, 0, 10}});
  REQUIRE(test::topology_of(shell).is_manifold);
  REQUIRE(test::topology_of(shell).genus() == 4);
  Soup rest = shell;
  const HiddenRemoval changes = remove_hidden(rest.points, rest.triangles);
  const test::SoupTopology after = test::topology_of(rest);
  CHECK(changes.caps == 5);
  CHECK(after.is_manifold);
  CHECK(after.is_oriented);
  CHECK(after.is_closed());
  CHECK(after.components == 1);
  CHECK(after.genus() == 0);
  CHECK_FALSE(after.has_duplicate_faces);
  CHECK(test::count_degenerate_faces(rest) == 0);
  CHECK(test::volume(rest) == Approx(16 * 16 * 16).epsilon(0.02)); // but for dents
  // All faces of the outer wall stay, and caps are all that is added.
  REQUIRE(changes.triangles.size() == rest.triangles.size());
  const std::size_t kept = shell.triangles.size() - changes.removed;
  std::vector<bool> stays(shell.triangles.size(), false);
  for (std::size_t i = 0; i < kept; ++i) {
    stays[changes.triangles[i]] = true;
    CHECK(rest.triangles[i] == shell.triangles[changes.triangles[i]]);
  }
  for (std::size_t face = 0; face < shell.triangles.size(); ++face)
    CHECK((stays[face] || !is_in_hull(shell, face, 16)));
  REQUIRE(changes.origins.size() == rest.points.size() - shell.points.size());
  for (const auto& [a, b] : changes.origins)
    CHECK((a < shell.points.size() && b < shell.points.size() && a != b));
}

TEST_CASE("Random shells stay closed manifolds, and seams stay where they were") {
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    Soup shell = shell_of_cubes(random_tunnels(seed, 6));
    shell = test::with_noise(shell, seed, 0.2);
    make_manifold(shell.points, shell.triangles);
    REQUIRE(test::topology_of(shell).is_closed());
    Soup rest = shell;
    const HiddenRemoval changes = remove_hidden(rest.points, rest.triangles);
    CHECK(changes.removed > 100);
    const test::SoupTopology after = test::topology_of(rest);
    INFO(seed << ": " << after);
    CHECK(after.is_manifold);
    CHECK(after.is_oriented);
    CHECK(after.is_closed());
    CHECK_FALSE(after.has_collapsed_faces);
    CHECK(test::count_degenerate_faces(rest) == 0);
    // Each triangle has points of its own: only places connect them.
    Soup split;
    for (const auto& triangle : shell.triangles) {
      const auto first = static_cast<std::uint32_t>(split.points.size());
      for (const std::uint32_t v : triangle)
        split.points.push_back(shell.points[v]);
      split.triangles.push_back({first, first + 1, first + 2});
    }
    remove_hidden(split.points, split.triangles);
    CHECK(edges_out_of_balance(split) == 0);
  }
}

TEST_CASE("A non-manifold shell gets no open edge, and an open one stays open where it was") {
  for (std::uint32_t seed = 1; seed <= 2; ++seed) {
    const Soup shell = shell_of_cubes(random_tunnels(seed, 8));
    Soup rest = shell;
    CHECK(remove_hidden(rest.points, rest.triangles).caps > 0);
    CHECK(edges_out_of_balance(rest) == 0);
    Soup open = shell; // without a square of the outer wall
    std::erase_if(open.triangles, [&](const auto& triangle) {
      return std::all_of(triangle.begin(), triangle.end(), [&](std::uint32_t v) {
        const Position& p = open.points[v];
        return p[2] == 0 && p[0] >= 1 && p[0] <= 2 && p[1] >= 1 && p[1] <= 2;
      });
    });
    REQUIRE(edges_out_of_balance(open) == 4);
    remove_hidden(open.points, open.triangles);
    CHECK(edges_out_of_balance(open) == 4);
  }
}

TEST_CASE("No cap hides what is seen: a ring on a table keeps what lies on it") {
  const Soup table = test::surface_of_cubes(11, 11, 1, [](int, int, int) { return true; });
  const Soup ring = test::surface_of_cubes(
      7, 7, 2, [](int x, int y, int) { return x < 2 || y < 2 || x > 4 || y > 4; });
  const Soup both = joined(table, ring, {{2, 2, 1}});
  REQUIRE(hidden(both).count == 2 * 2 * 40); // where they touch
  Soup rest = both;
  const HiddenRemoval changes = remove_hidden(rest.points, rest.triangles);
  CHECK(changes.caps == 0);
  CHECK((rest.triangles == both.triangles));
  // A bar instead leaves a hole that is closed flush with the table.
  Soup bar = joined(table, test::surface_of_cubes(3, 7, 2, [](int, int, int) { return true; }),
                    {{4, 2, 1}});
  CHECK(remove_hidden(bar.points, bar.triangles).caps == 2);
  CHECK(edges_out_of_balance(bar) == 0);
  CHECK(test::volume(bar) == Approx(11 * 11 + 3 * 7 * 2));
}

TEST_CASE("Hidden faces are removed from a mesh, which stays closed") {
  const Soup shape = bottle(0.05);
  test::Mesh mesh = test::make_mesh(shape);
  const HiddenRemoval changes = remove_hidden(mesh);
  CHECK(changes.found.is_hidden == hidden(shape).is_hidden);
  CHECK(changes.removed > 100);
  CHECK(changes.caps == 1);
  CHECK(mesh.is_valid());
  CHECK(CGAL::is_closed(mesh));
  CHECK(mesh.number_of_faces() == changes.triangles.size());
  Soup soup = shape;
  remove_hidden(soup.points, soup.triangles);
  CHECK(mesh.number_of_faces() == soup.triangles.size());
}

TEST_CASE("Whoever follows the search can end it, and nothing is removed") {
  const Soup shell = joined(test::sphere(3), scaled(test::sphere(3), 0.5));
  std::vector<double> fractions;
  HiddenOptions options;
  options.progress = [&](double fraction) {
    fractions.push_back(fraction);
    return true;
  };
  CHECK(hidden(shell, options).count > 0);
  CHECK(std::is_sorted(fractions.begin(), fractions.end()));
  CHECK(fractions.back() == 1);
  options.progress = [](double fraction) { return fraction == 0; };
  Soup soup = shell;
  CHECK(remove_hidden(soup.points, soup.triangles, options).found.is_cancelled);
  CHECK(soup.triangles == shell.triangles);
}

TEST_CASE("Options that make no sense are rejected, and so are broken surfaces") {
  const Soup sphere = test::sphere(1);
  const auto rejects = [&](const HiddenOptions& options, const char* message) {
    CHECK_THROWS_WITH(hidden(sphere, options), Contains(message));
  };
  rejects({.directions = 8}, "8 directions are not between 16 and 1048576");
  rejects({.threshold = 1}, "the threshold 1 is not at least 0 and less than 1");
  rejects({.threshold = std::nan("")}, "the threshold");
  rejects({.threads = 0}, "there has to be a thread");
#ifndef QUADRILLE_WITH_TBB
  rejects({.threads = 2}, "2 threads need oneTBB");
#endif
  CHECK_THROWS_WITH(hidden({sphere.points, {{0, 1, 99}}}), Contains("face 0 names point 99"));
  CHECK_THROWS_WITH(hidden({{{{0, 0, std::nan("")}}}, {}}), Contains("vertex 0 is not finite"));
  CHECK_THROWS_WITH(visibility_importance({}, -1), Contains("the least importance -1"));
}

TEST_CASE("Visible fractions are those of formulas") {
  const Soup ball = test::sphere(3);
  for (const double fraction : visibility(ball.points, ball.triangles).faces)
    CHECK(fraction == 1);
  // From the bottom of a cylinder as deep as wide, a cone of atan(1/2) around the axis is free.
  const Soup cup =
      joined(reversed(turned({{0, -1}, {0.01, -1}}, 8)), turned({{1, -1.001}, {1, 1}}, 256));
  const Visibility middle =
      visibility(cup.points, cup.triangles, {.directions = 1024, .front_only = true});
  CHECK(middle.faces.front() == Approx(1 - 2 / std::sqrt(5.0)).margin(0.02));
}

TEST_CASE(
    "A vertex has the mean of its faces' fractions, and importances are not below the least") {
  const Soup outside = cube(2), inside = scaled(cube(2), 0.3);
  const Soup soup = joined(outside, inside);
  const Visibility found = visibility(soup.points, soup.triangles);
  const std::vector<double> importances = visibility_importance(found, 0.125);
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    CHECK(found.vertices[v] == (v < outside.points.size() ? 1 : 0));
    CHECK(importances[v] == (v < outside.points.size() ? 1 : 0.125));
  }
  const test::Mesh mesh = test::make_mesh(soup);
  CHECK(visibility(mesh).faces == found.faces);
}
