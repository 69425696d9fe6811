// join_gaps: parts that are closer than a size are joined where they face each other, others stay
// apart, and closed manifolds stay closed manifolds of the same genus.

#include "soups.h"

#include <quadrille/join_gaps.h>
#include <quadrille/manifold.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using test::joined;
using test::Position;
using test::Soup;

Soup scaled(const Soup& soup, const Position& factors, const Position& shift = {}) {
  return test::mapped(soup, [&](const Position& p) {
    return Position{{factors[0] * p[0], factors[1] * p[1], factors[2] * p[2]}} + shift;
  });
}
Soup scaled(const Soup& soup, double factor, const Position& shift = {}) {
  return scaled(soup, {{factor, factor, factor}}, shift);
}
Soup reversed(Soup soup) {
  for (auto& [a, b, c] : soup.triangles)
    std::swap(b, c);
  return soup;
}

/// Two cubes of n² and m² squares a side, beside each other.
Soup two_cubes(int n, int m, const Position& shift) {
  return joined(test::cube(n), test::cube(m), shift);
}

/// A noisy ball of radius 1 with ten small ones around it, at these distances from it.
Soup floaters(const std::vector<double>& gaps) {
  Soup soup = test::with_noise(test::sphere(4), 3, 0.004);
  double angle = 0;
  for (const double gap : gaps) {
    const double z = std::sin(3 * angle) / 2, x = std::sqrt(1 - z * z);
    const Position direction{{x * std::cos(angle), x * std::sin(angle), z}};
    soup = joined(soup, scaled(test::sphere(2), 0.1), (1.1 + gap) * direction);
    angle += 2 * std::numbers::pi / 10;
  }
  return soup;
}

/// The pairs of faces that meet, as CGAL's exact kernel sees them.
std::size_t crossings(const Soup& soup) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  CGAL::Surface_mesh<Point> mesh;
  for (const Position& p : soup.points)
    mesh.add_vertex({p[0], p[1], p[2]});
  using Vertex = CGAL::Surface_mesh<Point>::Vertex_index;
  for (const auto& [a, b, c] : soup.triangles)
    REQUIRE(mesh.add_face(Vertex(a), Vertex(b), Vertex(c)) != mesh.null_face());
  std::vector<std::pair<CGAL::SM_Face_index, CGAL::SM_Face_index>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
  return pairs.size();
}

/// A soup after the joins. What must hold of any is checked.
std::pair<Soup, GapChanges> join(const Soup& input, double size) {
  Soup result = input;
  const GapChanges changes = join_gaps(result.points, result.triangles, size);
  const auto before = test::topology_of(input), after = test::topology_of(result);
  CAPTURE(before, after, size);
  CHECK(after.is_manifold);
  CHECK(after.is_oriented);
  CHECK(!after.has_duplicate_faces);
  CHECK(after.boundary_edges == before.boundary_edges);
  CHECK(after.components == before.components - changes.joined_gaps);
  if (before.is_closed())
    CHECK(after.genus() == before.genus());
  CHECK(crossings(result) == crossings(input));
  REQUIRE(result.points.size() == input.points.size() + changes.origins.size());
  CHECK(std::equal(input.points.begin(), input.points.end(), result.points.begin()));
  for (std::size_t i = 0; i < changes.origins.size(); ++i) {
    const auto& [a, b] = changes.origins[i];
    REQUIRE((std::max)(a, b) < input.points.size() + i);
    CHECK(result.points[input.points.size() + i] ==
          0.5 * result.points[a] + 0.5 * result.points[b]);
  }
  CHECK(changes.triangles.size() == result.triangles.size());
  if (changes.joined_gaps == 0)
    CHECK(test::is_identical(result, input));
  return {result, changes};
}

/// How many gaps are joined. No one stays open.
std::size_t count_joined(const Soup& input, double size) {
  const GapChanges changes = join(input, size).second;
  CHECK(changes.open_gaps == 0);
  return changes.joined_gaps;
}

double added_volume(const Soup& input, double size) {
  return test::volume(join(input, size).first) - test::volume(input);
}

} // namespace

TEST_CASE("Two cubes become one block, whatever their resolution, if the gap is not too wide") {
  for (const auto& [n, m] : {std::pair{1, 1}, {8, 8}, {1, 8}, {5, 8}}) {
    const Soup cubes = two_cubes(n, m, {{1.05, 0, 0}});
    CHECK(count_joined(cubes, 0.049) == 0);
    CHECK(count_joined(cubes, 0.051) == 1);
    CHECK(added_volume(cubes, 0.1) == Approx(0.05)); // all of the gap
  }
  CHECK(test::topology_of(join(two_cubes(1, 1, {{1.05, 0, 0}}), 0.1).first).faces == 28);
}

TEST_CASE("Where cubes overlap in part, the gap is filled there, up to the size beyond") {
  for (const auto& [n, m] : {std::pair{1, 1}, {8, 8}, {1, 9}}) {
    const Soup cubes = two_cubes(n, m, {{1.05, 0.3, 0.41}});
    const double overlap = 0.7 * 0.59 * 0.05;
    CHECK(added_volume(cubes, 0.1) > 0.9 * overlap);
    CHECK(added_volume(cubes, 0.1) < 1.4 * overlap);
  }
}

TEST_CASE("Edges and corners are joined, too") {
  for (const int n : {1, 8}) {
    CHECK(count_joined(two_cubes(n, n, {{1.03, 1.03, 0}}), 0.1) == 1);
    CHECK(count_joined(two_cubes(n, n, {{1.03, 1.03, 0}}), 0.04) == 0);
    CHECK(count_joined(two_cubes(n, n, {{1.03, 1.03, 1.03}}), 0.1) == 1);
  }
  // Two beams that cross each other, with a gap between edges in the middle of long faces.
  const Soup beams = joined(scaled(test::cube(), {{10, 1, 1}}), scaled(test::cube(), {{1, 10, 1}}),
                            {{4.5, -4.5, 1.1}});
  CHECK(count_joined(beams, 0.09) == 0);
  CHECK(added_volume(beams, 0.2) > 0.9 * 0.1);
  CHECK(added_volume(beams, 0.2) < 1.3 * 0.1);
}

TEST_CASE("Round walls grow together as far as they are near") {
  const Soup balls = joined(test::tilted(test::sphere(4)), test::sphere(4), {{1.6, 1.3, 0}});
  const double gap = std::hypot(1.6, 1.3) - 2;
  CHECK(count_joined(balls, 0.9 * gap) == 0);
  const double narrow = added_volume(balls, 1.5 * gap), wide = added_volume(balls, 3 * gap);
  CHECK(narrow > 0);
  CHECK(wide > 3 * narrow);
  CHECK(wide < 0.2);
  CHECK(count_joined(joined(test::sphere(5), test::sphere(2), {{2.05, 0.3, 0}}), 0.3) == 1);
  CHECK(count_joined(joined(scaled(test::cube(), 10), test::sphere(4), {{5, 5, 11.1}}), 0.3) == 1);
}

TEST_CASE("A ring above a plate is joined without another handle") {
  const Soup ring = test::torus(40, 16);
  const Soup plate = scaled(test::cube(), {{4, 4, 1}}, {{-2, -2, -1.45}});
  CHECK(count_joined(joined(plate, ring), 0.2) == 1);
  // An open plate keeps its boundary.
  const Soup sheet = scaled(test::grid(20, 20), {{4, 4, 1}}, {{-2, -2, -0.45}});
  CHECK(count_joined(joined(sheet, ring), 0.2) == 1);
}

TEST_CASE("Floating parts are joined if they are near enough, the others stay as they are") {
  const Soup soup = floaters({0.02, 0.05, 0.08, 0.11, 0.14, 0.17, 0.2, 0.23, 0.26, 0.29});
  CHECK(count_joined(soup, 0.01) == 0);
  CHECK(count_joined(soup, 0.065) == 2);
  const auto [result, changes] = join(soup, 0.155);
  CHECK(changes.joined_gaps == 5);
  CHECK(changes.open_gaps == 0);
  // Those that are farther away have all of their triangles, in their order.
  const std::size_t from = soup.triangles.size() - 5 * test::sphere(2).triangles.size();
  const auto found =
      std::search(result.triangles.begin(), result.triangles.end(),
                  soup.triangles.begin() + static_cast<std::ptrdiff_t>(from), soup.triangles.end());
  CHECK(found != result.triangles.end());
}

TEST_CASE("Rough walls are joined") {
  const Soup walls = test::with_noise(two_cubes(20, 16, {{1.05, 0.2, 0.1}}), 1, 0.008);
  CHECK(added_volume(walls, 0.09) > 0.8 * 0.8 * 0.9 * 0.05);
}

TEST_CASE("The two sides of a wall are not joined however thin it is, nor what faces away") {
  const Soup cube = test::cube(6);
  const Soup shell = joined(cube, reversed(scaled(cube, 0.96, {{0.02, 0.02, 0.02}})));
  CHECK(count_joined(shell, 0.2) == 0);
  // A part in the room of the shell is joined to the wall of the room only.
  const Soup filled = joined(shell, scaled(cube, 0.9, {{0.05, 0.05, 0.05}}));
  CHECK(count_joined(filled, 0.02) == 0);
  CHECK(count_joined(filled, 0.1) == 1);
  CHECK(count_joined(reversed(two_cubes(4, 4, {{1.05, 0, 0}})), 0.1) == 0);
  const Soup sheet = test::grid(6, 6);
  CHECK(count_joined(joined(sheet, sheet, {{0, 0, 0.05}}), 0.1) == 0);
  CHECK(count_joined(joined(sheet, sheet, {{1.05, 0, 0}}), 0.1) == 0); // boundaries
}

TEST_CASE("Parts in a row are joined one by one, the closest first") {
  const Soup cube = test::cube(4);
  Soup row = cube;
  for (const double x : {1.02, 2.06, 3.16})
    row = joined(row, cube, {{x, 0, 0}});
  CHECK(count_joined(row, 0.03) == 1);
  CHECK(count_joined(row, 0.05) == 2);
  CHECK(count_joined(row, 0.11) == 3);
  // Four in a square: three joins, no handle.
  const Soup square = joined(joined(cube, cube, {{1.05, 0, 0}}), joined(cube, cube, {{1.05, 0, 0}}),
                             {{0, 1.05, 0}});
  CHECK(count_joined(square, 0.06) == 3);
}

TEST_CASE("Voxels with an empty layer between them") {
  const auto halves = [](int x, int y, int z) { return x < 7 || (x > 7 && y > 2 && z < 9); };
  const Soup soup = test::surface_of_cubes(15, 10, 10, halves);
  CHECK(count_joined(soup, 0.9) == 0);
  CHECK(count_joined(soup, 1) == 1);
  CHECK(added_volume(soup, 1) >= 7 * 9);
}

TEST_CASE("A gap stays open where every bridge would cross something, and that is told") {
  const Soup wall = scaled(test::cube(4), {{0.01, 3, 3}}, {{1.02, -1, -1}});
  const Soup input = joined(two_cubes(4, 4, {{1.05, 0, 0}}), wall);
  const GapChanges through = join(input, 0.1).second;
  CHECK(through.joined_gaps == 2); // both cubes with the wall
  CHECK(through.open_gaps == 0);
  // Cubes that touch each other shifted: their edges cross in the plane of both.
  const GapChanges touching = join(two_cubes(8, 8, {{1, 0.3, 0.1}}), 0.1).second;
  CHECK(touching.joined_gaps == 0);
  CHECK(touching.open_gaps == 1);
}

TEST_CASE("Triangles of kept points stay") {
  const Soup input = two_cubes(4, 4, {{1.05, 0, 0}});
  Soup result = input;
  std::vector<bool> is_kept(input.points.size(), false);
  for (std::size_t v = 0; v < input.points.size(); ++v)
    is_kept[v] = input.points[v][0] == 1 && input.points[v][1] < 0.6;
  CHECK(join_gaps(result.points, result.triangles, 0.1, is_kept).joined_gaps == 1);
  for (const auto& t : input.triangles)
    if (is_kept[t[0]] || is_kept[t[1]] || is_kept[t[2]])
      CHECK(std::count(result.triangles.begin(), result.triangles.end(), t) == 1);
  is_kept.assign(input.points.size(), true);
  result = input;
  CHECK(join_gaps(result.points, result.triangles, 0.1, is_kept).joined_gaps == 0);
  CHECK(test::is_identical(result, input));
}

TEST_CASE("Floats and other indices go in and out, and small or distant surfaces are joined") {
  const Soup input = two_cubes(4, 4, {{1.05, 0, 0}});
  for (const auto& [factor, shift] : {std::pair{1., 1e5}, {1e-12, 0.}, {1e12, 0.}})
    CHECK(count_joined(scaled(input, factor, {{shift, shift, 0}}), 0.1 * factor) == 1);
  std::vector<std::array<float, 3>> points;
  for (const Position& p : input.points)
    points.push_back(
        {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
  std::vector<std::vector<int>> triangles;
  for (const auto& [a, b, c] : input.triangles)
    triangles.push_back({static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)});
  CHECK(join_gaps(points, triangles, 0.1).joined_gaps == 1);
  const auto expected = join(input, 0.1).first.triangles;
  REQUIRE(triangles.size() == expected.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
    CHECK(std::equal(expected[i].begin(), expected[i].end(), triangles[i].begin()));
}

TEST_CASE("Wrong arguments leave the soup as it was") {
  const Soup input = two_cubes(1, 1, {{1.05, 0, 0}});
  Soup soup = input;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double size : {-1., infinity, std::nan("")})
    CHECK_THROWS_WITH(join_gaps(soup.points, soup.triangles, size),
                      Catch::Contains("quadrille::join_gaps") && Catch::Contains("is no length"));
  CHECK(test::is_identical(soup, input));
  soup.triangles.back()[0] = 99;
  CHECK_THROWS_AS(join_gaps(soup.points, soup.triangles, 0.1), std::invalid_argument);
  Soup empty;
  CHECK(join_gaps(empty.points, empty.triangles, 1).triangles.empty());
}
