// Borders that are thinned out as functions of themselves: neighbouring tiles fit bit by bit.
#include "meshes.h"

#include <quadrille/boundaries.h>
#include <quadrille/distance_limits.h>
#include <quadrille/filters.h>

#include <CGAL/property_map.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace quadrille;
using namespace test;

namespace {

using Segment = std::array<std::array<double, 3>, 2>;

// A tile of terrain: its columns from `begin` to `end`, its rows from 0 to 128, in 128ths.
Soup tile(std::uint32_t begin, std::uint32_t end) {
  Soup soup = grid(end - begin, 128);
  for (Position& p : soup.points) {
    const double x = (begin + p[0] * (end - begin)) / 128, y = p[1];
    p[0] = x;
    p[2] = 0.08 * std::sin(9 * x + 4 * y * y) * std::cos(7 * y) + 0.01 * std::sin(40 * y + x);
  }
  return soup;
}

std::vector<Segment> boundary_segments(const Soup& soup) {
  std::map<Segment, int> faces;
  for (const Triangle& t : soup.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& a = soup.points[t[i]].coordinates;
      const auto& b = soup.points[t[(i + 1) % 3]].coordinates;
      ++faces[{std::min(a, b), std::max(a, b)}];
    }
  std::vector<Segment> segments;
  for (const auto& [segment, count] : faces)
    if (count == 1)
      segments.push_back(segment);
  return segments;
}

// Those along x.
std::vector<Segment> boundary_at(const Soup& soup, double x) {
  std::vector<Segment> segments = boundary_segments(soup);
  std::erase_if(segments, [x](const Segment& s) { return s[0][0] != x || s[1][0] != x; });
  return segments;
}

double distance(const Position& p, const Segment& s) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 1000; ++i) {
    const double t = i / 1000.;
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k)
      sum += std::pow(p[k] - ((1 - t) * s[0][k] + t * s[1][k]), 2);
    least = std::min(least, std::sqrt(sum));
  }
  return least;
}

std::vector<char> on_boundary(const Soup& soup) {
  std::set<std::array<double, 3>> ends;
  for (const Segment& s : boundary_segments(soup))
    ends.insert(s.begin(), s.end());
  std::vector<char> is_on;
  for (const Position& p : soup.points)
    is_on.push_back(ends.contains(p.coordinates));
  return is_on;
}

// Of a tile, in whose plane corners have both coordinates at an end.
std::vector<char> corners(const Soup& soup, double begin, double end) {
  std::vector<char> is_corner;
  for (const Position& p : soup.points)
    is_corner.push_back((p[0] == begin || p[0] == end) && (p[1] == 0 || p[1] == 1));
  return is_corner;
}

auto constrained(std::vector<char>& is_constrained) {
  return CGAL::parameters::vertex_is_constrained_map(CGAL::make_property_map(is_constrained));
}

constexpr double tolerance = 0.002;

struct ThinnedTile {
  Soup boundaries_only, soup;
  Report report;
};

ThinnedTile thinned_tile(Soup soup, double begin, double end) {
  std::vector<char> fixed = corners(soup, begin, end);
  const HeightField field;
  ThinnedTile result;
  result.report = simplify_boundaries(soup.points, soup.triangles, DistanceLimit{tolerance}, field,
                                      NormalFlip{180}, constrained(fixed));
  result.boundaries_only = soup;
  fixed = on_boundary(soup);
  simplify(soup.points, soup.triangles, FaceRatio{0.05}, field, constrained(fixed));
  result.soup = soup;
  return result;
}

} // namespace

TEST_CASE("Tiles of different sizes get the same border from both sides") {
  const Soup left = tile(0, 96), right = shuffled(tile(96, 128), 7);
  const ThinnedTile a = thinned_tile(left, 0, 0.75), b = thinned_tile(right, 0.75, 1);
  CHECK(a.report.stop == StopReason::target_met);
  CHECK(b.report.stop == StopReason::target_met);

  const std::vector<Segment> common = boundary_at(a.soup, 0.75);
  CHECK(common == boundary_at(b.soup, 0.75));
  CHECK(common.size() > 8);
  CHECK(common.size() < 64);
  CHECK(a.soup.triangles.size() < left.triangles.size() / 19);
  CHECK(boundary_segments(joined(a.soup, b.soup)).size() == // no gap: only the outer border is left
        boundary_segments(a.soup).size() + boundary_segments(b.soup).size() - 2 * common.size());
  double farthest = 0;
  for (const Position& p : left.points)
    if (p[0] == 0.75) {
      double least = 1;
      for (const Segment& s : common)
        least = std::min(least, distance(p, s));
      farthest = std::max(farthest, least);
    }
  CHECK(farthest <= tolerance * 1.01);
  CHECK(farthest > tolerance / 2);
}

TEST_CASE("Inner vertices stay as they are, and so do constrained ones and ends of the border") {
  Soup soup = tile(0, 96);
  const std::vector<char> was_on_boundary = on_boundary(soup);
  std::vector<char> fixed = corners(soup, 0, 0.75);
  fixed[97 * 50] = true; // of the border at x = 0
  const Soup before = soup;
  const Report report = simplify_boundaries(soup.points, soup.triangles, DistanceLimit{0.05},
                                            HeightField{}, NormalFlip{180}, constrained(fixed));
  CHECK(report.stop == StopReason::target_met);
  std::set<std::array<double, 3>> left;
  for (const Position& p : soup.points)
    left.insert(p.coordinates);
  std::size_t gone = 0;
  for (std::size_t v = 0; v < before.points.size(); ++v)
    if (!left.contains(before.points[v].coordinates)) {
      CHECK(was_on_boundary[v]);
      CHECK(v % 97 * (v % 97 - 96) * (v / 97) * (v / 97 - 128) == 0);
      ++gone;
    }
  CHECK(gone == before.points.size() - soup.points.size());
  CHECK(gone > 200);
  for (const std::size_t v :
       std::initializer_list<std::size_t>{0, 96, 97 * 50, 97 * 128, 97 * 129 - 1})
    CHECK(left.contains(before.points[v].coordinates));
  CHECK(is_same_topology(topology_of(soup), topology_of(before)));
}

TEST_CASE("A loop keeps three vertices, a straight line its ends") {
  for (const double far : {0.0, 10.0}) {
    Soup tube = open_cylinder(24, 40);
    const Report report =
        simplify_boundaries(tube.points, tube.triangles, DistanceLimit{far}, NormalFlip{180});
    CHECK(report.stop == StopReason::target_met);
    CHECK(topology_of(tube).boundary_edges == (far > 0 ? 6 : 48));
    CHECK(topology_of(tube).boundary_loops == 2);
  }
  Soup square = grid(16, 16);
  std::vector<char> fixed = corners(square, 0, 1);
  fixed[6] = true; // of a side
  const Report report =
      simplify_boundaries(square.points, square.triangles, DistanceLimit{0}, constrained(fixed));
  CHECK(report.stop == StopReason::target_met);
  CHECK(topology_of(square).boundary_edges == 5);
}

TEST_CASE("Where several points are as far, the border does not depend on where it begins") {
  Soup zigzag = grid(32, 2), tube = open_cylinder(24, 2);
  for (Position& p : zigzag.points)
    p[2] = static_cast<int>(p[0] * 32) % 4 == 2 ? 0.1 : 0;
  std::vector<Segment> expected;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    Soup soup = shuffled(joined(zigzag, tube, {{9, 0, 0}}), seed);
    std::vector<char> fixed = corners(soup, 0, 1);
    simplify_boundaries(soup.points, soup.triangles, DistanceLimit{0.08}, NormalFlip{180},
                        constrained(fixed));
    if (seed == 0)
      expected = boundary_segments(soup);
    CHECK(boundary_segments(soup) == expected);
  }
  CHECK(expected.size() < 60);
}

TEST_CASE("A mesh gets the same borders as a soup, and keeps what is inside") {
  const Soup soup = tile(0, 32);
  Mesh mesh = make_mesh<Mesh>(soup);
  auto fixed = mesh.add_property_map<Mesh::Vertex_index, bool>("v:fixed", false).first;
  for (const auto v : mesh.vertices())
    fixed[v] = (mesh.point(v).x() == 0 || mesh.point(v).x() == 0.25) &&
               (mesh.point(v).y() == 0 || mesh.point(v).y() == 1);
  const Report report =
      simplify_boundaries(mesh, DistanceLimit{tolerance}, HeightField{}, NormalFlip{180},
                          CGAL::parameters::vertex_is_constrained_map(fixed));
  CHECK(report.stop == StopReason::target_met);
  CHECK(boundary_segments(to_soup(mesh)) ==
        boundary_segments(thinned_tile(soup, 0, 0.25).boundaries_only));
}

TEST_CASE("A relative limit of a boundary is a fraction of the diagonal") {
  Soup relative = tile(0, 96), absolute = relative;
  std::vector<char> fixed = corners(relative, 0, 0.75);
  const auto simplified = [&](Soup& soup, const DistanceLimit& limit) {
    simplify_boundaries(soup.points, soup.triangles, limit, HeightField{}, NormalFlip{180},
                        constrained(fixed));
  };
  const double diagonal = ::test::diagonal(relative);
  simplified(relative, DistanceLimit::relative(tolerance / diagonal));
  simplified(absolute, DistanceLimit{tolerance});
  CHECK(relative.points.size() < 96 * 128);
  CHECK(is_identical(relative, absolute));
}

TEST_CASE("What holds a border is told, and a tolerance that is none is refused") {
  Soup soup = tile(0, 96);
  const Report report = simplify_boundaries(soup.points, soup.triangles, DistanceLimit{1},
                                            NormalFlip{}, LongestEdge{0.05});
  CHECK_FALSE(is_target_reached(report.stop));
  CHECK(report.rejected(Rejection::filter) > 0);
  CHECK(report.contractions > 0);
  const Soup before = soup;
  for (const double none : {-1.0, std::numeric_limits<double>::quiet_NaN()})
    CHECK_THROWS_AS(simplify_boundaries(soup.points, soup.triangles, DistanceLimit{none}),
                    std::invalid_argument);
  CHECK(is_identical(soup, before));
  soup.triangles[2][1] = 9999999;
  CHECK_THROWS_WITH(
      simplify_boundaries(soup.points, soup.triangles, DistanceLimit{1}),
      Catch::StartsWith("quadrille::simplify_boundaries: face 2 names point 9999999"));
}
