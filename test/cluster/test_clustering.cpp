// Vertex clustering against brute force with maps, and what is promised of it.

#include "meshes.h"
#include "soups.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <quadrille/cluster.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using Catch::Contains;
using test::Position;
using test::Soup;
using test::Triangle;

constexpr auto mean = ClusterPlacement::mean;
constexpr auto quadric = ClusterPlacement::quadric;

// --- Brute force ---------------------------------------------------------------------------------

using Cell = std::array<std::int64_t, 3>;

/// Cells by floor() about the lower corner of the used points.
struct Cells {
  Position low, high, width;
  std::array<std::int64_t, 3> count;

  Cells(const Soup& soup, const Grid& grid)
      : count{std::int64_t(grid.x), std::int64_t(grid.y), std::int64_t(grid.z)} {
    find_box(soup);
    for (std::size_t i = 0; i < 3; ++i)
      width[i] = (high[i] - low[i]) / static_cast<double>(count[i]);
  }
  Cells(const Soup& soup, const CellSize& size) {
    find_box(soup);
    width = {{size.edge, size.edge, size.edge}};
    for (std::size_t i = 0; i < 3; ++i)
      count[i] = std::max<std::int64_t>(1, std::llround(std::ceil((high[i] - low[i]) / size.edge)));
  }

  Cell of(const Position& p) const {
    Cell cell{};
    for (std::size_t i = 0; i < 3; ++i)
      if (width[i] > 0)
        cell[i] = std::min(count[i] - 1, std::int64_t(std::floor((p[i] - low[i]) / width[i])));
    return cell;
  }
  bool contains(const Cell& cell, const Position& p, double tolerance) const {
    bool inside = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const double begin = low[i] + static_cast<double>(cell[i]) * width[i];
      inside &= begin - tolerance <= p[i] && p[i] <= begin + width[i] + tolerance;
    }
    return inside;
  }

private:
  void find_box(const Soup& soup) {
    bool is_first = true;
    for (const auto& [a, b, c] : soup.triangles)
      if (a != b && b != c && c != a)
        for (std::uint32_t v : {a, b, c}) {
          for (std::size_t i = 0; i < 3; ++i) {
            low[i] = is_first ? soup.points[v][i] : std::min(low[i], soup.points[v][i]);
            high[i] = is_first ? soup.points[v][i] : std::max(high[i], soup.points[v][i]);
          }
          is_first = false;
        }
  }
};

struct Reference {
  std::vector<Cell> cells; // of each vertex
  Soup soup;
  std::size_t doubled = 0;
};

/// In long double.
Position mean_of(const std::set<std::uint32_t>& members, const Soup& soup) {
  std::array<long double, 3> sum{};
  for (std::uint32_t v : members)
    for (std::size_t i = 0; i < 3; ++i)
      sum[i] += static_cast<long double>(soup.points[v][i]);
  Position p;
  for (std::size_t i = 0; i < 3; ++i)
    p[i] = static_cast<double>(sum[i] / static_cast<long double>(members.size()));
  return p;
}

/// Means in long double, triangles in sets of cells.
template <class Choice>
Reference brute_force(const Soup& soup, const Choice& choice) {
  const Cells cells(soup, choice);
  std::map<Cell, std::set<std::uint32_t>> members;
  std::set<std::set<Cell>> seen;
  std::vector<std::array<Cell, 3>> left;
  Reference result;
  for (const auto& [a, b, c] : soup.triangles) {
    if (a == b || b == c || c == a)
      continue;
    const std::array corners{cells.of(soup.points[a]), cells.of(soup.points[b]),
                             cells.of(soup.points[c])};
    members[corners[0]].insert(a);
    members[corners[1]].insert(b);
    members[corners[2]].insert(c);
    const std::set<Cell> distinct(corners.begin(), corners.end());
    if (distinct.size() < 3)
      continue;
    if (seen.insert(distinct).second)
      left.push_back(corners);
    else
      ++result.doubled;
  }
  std::map<std::uint32_t, Cell> in_order; // by the first point
  for (const auto& corners : left)
    for (const Cell& cell : corners)
      in_order[*members[cell].begin()] = cell;
  std::map<Cell, std::uint32_t> number;
  for (const auto& [first, cell] : in_order) {
    number[cell] = static_cast<std::uint32_t>(result.cells.size());
    result.cells.push_back(cell);
    result.soup.points.push_back(mean_of(members[cell], soup));
  }
  for (const auto& [a, b, c] : left)
    result.soup.triangles.push_back({number[a], number[b], number[c]});
  return result;
}

double extent(const Soup& soup) {
  double greatest = 0;
  for (const Position& p : soup.points)
    for (double x : p.coordinates)
      greatest = std::max(greatest, std::abs(x));
  return greatest;
}

void check_points(const std::vector<Position>& points, const std::vector<Position>& expected,
                  double tolerance) {
  REQUIRE(points.size() == expected.size());
  double farthest = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    farthest = std::max(farthest, std::sqrt(squared_distance(points[i], expected[i])));
  CHECK(farthest <= tolerance);
}

ClusterReport cluster(Soup& soup, const ClusterCells& cells, ClusterPlacement placement = mean) {
  std::vector<test::Point> points = test::points_of(soup);
  const ClusterReport report = cluster_vertices(points, soup.triangles, cells, placement);
  soup.points.clear();
  for (const test::Point& p : points)
    soup.points.push_back(test::to_position(p));
  return report;
}

// --- Surfaces ------------------------------------------------------------------------------------

/// Any triangles between any points, some of them degenerate, some points without a triangle.
Soup random_soup(std::uint64_t seed, std::uint32_t points, std::uint32_t triangles) {
  test::Random random(seed);
  Soup soup;
  for (std::uint32_t i = 0; i < points; ++i)
    soup.points.push_back({{random(-3, 5), random(-1, 1), random(7, 8)}});
  for (std::uint32_t i = 0; i < triangles; ++i)
    soup.triangles.push_back({random.below(points), random.below(points), random.below(points)});
  return soup;
}

Soup moved(const Soup& soup, const Position& by) {
  return test::mapped(soup, [&](const Position& p) { return p + by; });
}

Soup scaled(const Soup& soup, double factor) {
  return test::mapped(soup, [&](const Position& p) { return factor * p; });
}

} // namespace

TEST_CASE("Clusters are those of brute force") {
  const std::vector<Soup> soups{test::sphere(4),
                                test::open_cylinder(40, 20),
                                test::cube(7),
                                random_soup(1, 300, 2000),
                                random_soup(2, 50, 3000),
                                random_soup(8, 400, 120),
                                test::tilted(test::grid(30, 20))};
  for (std::size_t s = 0; s < soups.size(); ++s)
    for (const Grid& grid :
         {Grid{2, 2, 2}, Grid{11, 4, 4}, Grid{1, 7, 30}, Grid{1000, 1000, 1000}}) {
      CAPTURE(s, grid.x, grid.y, grid.z);
      const Reference expected = brute_force(soups[s], grid);
      Soup soup = soups[s];
      const ClusterReport report = cluster(soup, grid);
      CHECK(soup.triangles == expected.soup.triangles);
      check_points(soup.points, expected.soup.points, 1e-15 * extent(soups[s]));
      CHECK(report.faces_before == soups[s].triangles.size());
      CHECK(report.vertices_before == soups[s].points.size());
      CHECK(report.faces_after == soup.triangles.size());
      CHECK(report.vertices_after == soup.points.size());
      CHECK(report.doubled_faces == expected.doubled);
      CHECK(report.cells == grid);
    }
}

TEST_CASE("Cubes of a given size begin at the lower corner") {
  for (const Soup& input : {test::sphere(3), random_soup(3, 200, 900)})
    for (double edge : {0.11, 0.5, 1.3, 100.0}) {
      CAPTURE(edge);
      const Reference expected = brute_force(input, CellSize{edge});
      Soup soup = input;
      const ClusterReport report = cluster(soup, CellSize{edge});
      CHECK(soup.triangles == expected.soup.triangles);
      check_points(soup.points, expected.soup.points, 1e-15 * extent(input));
      CHECK(report.cell == Position{{edge, edge, edge}});
    }
}

TEST_CASE("A point between two cells is in the upper one, and on the last side in the last") {
  // Points at 0, 1/4, …, 1 along x; two rows of triangles.
  const Soup strip = test::grid(4, 1);
  Soup soup = strip;
  const ClusterReport report = cluster(soup, Grid{2, 2, 1});
  CHECK(report.cells == Grid{2, 2, 1});
  CHECK(soup.points ==
        std::vector<Position>{{{0.125, 0, 0}}, {{0.75, 0, 0}}, {{0.125, 1, 0}}, {{0.75, 1, 0}}});
  CHECK(soup.triangles.size() == 2);

  soup = strip;
  CHECK(cluster(soup, CellSize{0.5}).cells == Grid{2, 2, 1});
  CHECK(soup.points.size() == 4);
}

TEST_CASE("A point alone in its cell stays to the bit, and all keep their order") {
  const Soup input = test::tilted(test::sphere(3));
  for (ClusterPlacement placement : {mean, quadric}) {
    Soup soup = input;
    cluster(soup, Grid{100'000, 100'000, 100'000}, placement);
    CHECK(test::is_identical(soup, input));
  }
  std::vector<std::array<float, 3>> points{{0.1F, 0.2F, 0.3F}, {1.1F, 0, 0}, {0, 1.7F, 0.9F}};
  const auto expected = points;
  std::vector<Triangle> triangles{{2, 0, 1}};
  cluster_vertices(points, triangles, Grid{9, 9, 9}, quadric);
  CHECK(points == expected);
  CHECK(triangles == std::vector<Triangle>{{2, 0, 1}});

  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  const Exact::FT third = Exact::FT(1) / 3; // no double is that
  std::vector<Exact::Point_3> exact{{third, 0, 0}, {2, third, 0}, {0, 2, third}};
  const auto exact_before = exact;
  cluster_vertices(exact, triangles, Grid{9, 9, 9});
  CHECK(exact == exact_before);
}

TEST_CASE("Of triangles between the same cells the first is left, as it was") {
  // Two sheets, a tenth of a cell apart, that look away from each other.
  Soup soup{{{{0, 0, 0}},
             {{2, 0, 0}},
             {{0, 2, 0}},
             {{0, 0, 0.1}},
             {{2, 0, 0.1}},
             {{0, 2, 0.1}},
             {{2, 2, 2}}},
            {{1, 0, 2}, {3, 4, 5}, {4, 5, 3}, {6, 0, 1}}};
  const ClusterReport report = cluster(soup, CellSize{1});
  CHECK(report.doubled_faces == 2);
  CHECK(soup.triangles == std::vector<Triangle>{{1, 0, 2}, {3, 0, 1}});
  check_points(soup.points, {{{0, 0, 0.05}}, {{2, 0, 0.05}}, {{0, 2, 0.05}}, {{2, 2, 2}}}, 1e-15);
}

TEST_CASE("One cell, no triangle, and points without triangles leave nothing behind") {
  Soup sphere = test::sphere(2);
  const ClusterReport report = cluster(sphere, Grid{1, 1, 1}, quadric);
  CHECK(report.faces_after == 0);
  CHECK(report.vertices_after == 0);
  CHECK(sphere.points.empty());
  CHECK(sphere.triangles.empty());

  for (const ClusterCells& cells :
       {ClusterCells(Grid{3, 3, 3}), ClusterCells(CellSize{1}), ClusterCells(FaceCount{5})})
    for (ClusterPlacement placement : {mean, quadric})
      for (Soup soup : {Soup{}, Soup{{{{1, 2, 3}}, {{4, 5, 6}}}, {}},
                        Soup{{{{1, 2, 3}}, {{4, 5, 6}}}, {{0, 1, 0}, {1, 1, 1}}}}) {
        cluster(soup, cells, placement);
        CHECK(soup.points.empty());
        CHECK(soup.triangles.empty());
      }

  // A point of no triangle, or of degenerate ones only, is no part of the box.
  Soup expected = test::sphere(3), soup = expected;
  soup.points.push_back({{1e9, -1e9, 1e9}});
  const auto far = static_cast<std::uint32_t>(soup.points.size() - 1);
  soup.triangles.insert(soup.triangles.end(), {{0, 0, far}, {0, far, far}, {far, 0, far}});
  cluster(expected, Grid{5, 5, 5});
  cluster(soup, Grid{5, 5, 5});
  CHECK(test::is_identical(soup, expected));
}

TEST_CASE("Where the surface lies makes no difference, nor does its unit") {
  for (ClusterPlacement placement : {mean, quadric}) {
    const Soup input = test::tilted(test::sphere(4));
    Soup expected = input;
    cluster(expected, Grid{9, 8, 7}, placement);
    REQUIRE(expected.triangles.size() > 200);
    for (const Position& by : {Position{{-5, -7, -9}}, Position{{1e8, -1e9, 3e7}}}) {
      Soup soup = moved(input, by);
      cluster(soup, Grid{9, 8, 7}, placement);
      CHECK(soup.triangles == expected.triangles);
      // Planes of faces whose coordinates are rounded to 2⁻²³ are as inexact as that by their size.
      check_points(soup.points, moved(expected, by).points, extent(soup) > 1e6 ? 1e-5 : 1e-12);
    }
    for (double factor : {0x1p-900, 0x1p-40, 0x1p900}) {
      Soup soup = scaled(input, factor);
      const ClusterReport report = cluster(soup, Grid{9, 8, 7}, placement);
      CHECK(test::is_identical(soup, scaled(expected, factor)));
      CHECK(report.cell[0] > 0.2 * factor);
    }
    Soup soup = scaled(input, 0x1p-900);
    cluster(soup, CellSize{0x1p-902}, placement);
    Soup same = input;
    cluster(same, CellSize{0.25}, placement);
    CHECK(test::is_identical(soup, scaled(same, 0x1p-900)));
  }
}

namespace {

/// Triangles by their positions, up to rounding, whichever way they look.
auto unoriented(const Soup& soup) {
  using Rounded = std::array<long long, 3>;
  std::multiset<std::multiset<Rounded>> faces;
  for (const Triangle& t : soup.triangles) {
    std::multiset<Rounded> corners;
    for (std::uint32_t v : t) {
      const Position p = 1e9 * soup.points[v];
      corners.insert({std::llround(p[0]), std::llround(p[1]), std::llround(p[2])});
    }
    faces.insert(corners);
  }
  return faces;
}

} // namespace

TEST_CASE("The order of points and triangles makes no difference") {
  const Soup input = test::tilted(test::sphere(4));
  const Soup shuffled = test::shuffled(input, 7);
  for (ClusterPlacement placement : {mean, quadric}) {
    Soup a = input, b = shuffled;
    cluster(a, Grid{6, 6, 6}, placement);
    cluster(b, Grid{6, 6, 6}, placement);
    CHECK(unoriented(a) == unoriented(b));
  }
}

TEST_CASE("By quadrics a box keeps its sides, edges and corners") {
  const Soup input = test::cube(16);
  REQUIRE(test::volume(input) == Approx(1));
  for (const Grid& grid : {Grid{3, 3, 3}, Grid{5, 4, 3}, Grid{2, 2, 2}}) {
    Soup by_mean = input, soup = input;
    cluster(by_mean, grid, mean);
    cluster(soup, grid, quadric);
    CHECK(test::volume(by_mean) < 0.95);
    CHECK(test::volume(soup) == Approx(1).epsilon(1e-12));
    for (const Position& p : soup.points) {
      const auto on_side = [](double x) { return std::min(std::abs(x), std::abs(x - 1)) < 1e-13; };
      CHECK((on_side(p[0]) || on_side(p[1]) || on_side(p[2])));
    }
    for (std::size_t corner = 0; corner < 8; ++corner) {
      const Position at{{double(corner & 1), double(corner >> 1 & 1), double(corner >> 2)}};
      CHECK(std::ranges::any_of(
          soup.points, [&](const Position& p) { return squared_distance(p, at) < 1e-26; }));
    }
    // Edges: in each cell along one of them, the vertex is on it.
    const auto on_edge = std::ranges::count_if(soup.points, [](const Position& p) {
      return std::ranges::count_if(p.coordinates,
                                   [](double x) { return std::min(x, 1 - x) < 1e-13; }) == 2;
    });
    CHECK(std::size_t(on_edge) == 4 * (grid.x + grid.y + grid.z - 6));
  }
}

TEST_CASE("A flat part stays flat and within its border") {
  const Soup input = test::tilted(test::grid(40, 40));
  const Position normal = test::tilted(Soup{{{{0, 0, 1}}}, {}}).points[0];
  const Position u = test::tilted(Soup{{{{1, 0, 0}}}, {}}).points[0];
  const Position v = test::tilted(Soup{{{{0, 1, 0}}}, {}}).points[0];
  for (ClusterPlacement placement : {mean, quadric}) {
    Soup soup = input;
    cluster(soup, Grid{6, 6, 6}, placement);
    REQUIRE(soup.triangles.size() > 20);
    for (const Position& p : soup.points) {
      CHECK(std::abs(dot(normal, p)) < 1e-14);
      CHECK(std::abs(dot(u, p) - 0.5) < 0.5 + 1e-12);
      CHECK(std::abs(dot(v, p) - 0.5) < 0.5 + 1e-12);
    }
  }
  Soup level = test::grid(10, 10); // a box without height
  const ClusterReport report = cluster(level, Grid{3, 3, 5}, quadric);
  CHECK(report.vertices_after == 9);
  CHECK(report.faces_after == 8);
  for (const Position& p : level.points)
    CHECK(p[2] == 0);
}

TEST_CASE("A vertex never leaves its cell") {
  for (const auto& [input, grid] : {std::pair(random_soup(4, 400, 4000), Grid{4, 4, 4}),
                                    std::pair(random_soup(5, 90, 400), Grid{3, 5, 2}),
                                    std::pair(test::tilted(test::cube(9)), Grid{4, 4, 4}),
                                    std::pair(test::open_cylinder(60, 9), Grid{7, 7, 7})}) {
    const Reference expected = brute_force(input, grid);
    const Cells cells(input, grid);
    for (ClusterPlacement placement : {mean, quadric}) {
      Soup soup = input;
      cluster(soup, grid, placement);
      REQUIRE(soup.triangles == expected.soup.triangles);
      std::size_t inside = 0;
      for (std::size_t i = 0; i < soup.points.size(); ++i)
        inside += cells.contains(expected.cells[i], soup.points[i], 1e-13);
      CHECK(inside == soup.points.size());
    }
  }
}

TEST_CASE("By quadrics a smooth surface is closer than by means") {
  Soup by_mean = test::tilted(test::sphere(5)), by_quadric = by_mean;
  cluster(by_mean, Grid{8, 8, 8}, mean);
  cluster(by_quadric, Grid{8, 8, 8}, quadric);
  const double exact = test::volume(test::sphere(5));
  CHECK(test::volume(by_mean) < 0.97 * exact);
  CHECK(std::abs(test::volume(by_quadric) - exact) < 0.5 * std::abs(test::volume(by_mean) - exact));
}

TEST_CASE("A count of faces is kept, and a finer grid has more") {
  for (const Soup& input : {test::tilted(test::sphere(5)), test::cube(20),
                            random_soup(6, 500, 3000), test::tilted(test::grid(60, 60))})
    for (std::size_t most : {std::size_t{0}, std::size_t{1}, std::size_t{12}, std::size_t{100},
                             std::size_t{500}, std::size_t{2000}}) {
      CAPTURE(input.triangles.size(), most);
      Soup soup = input;
      const ClusterReport report = cluster(soup, FaceCount{most});
      CHECK(report.faces_after == soup.triangles.size());
      CHECK(soup.triangles.size() <= most);
      const std::size_t along = std::max({report.cells.x, report.cells.y, report.cells.z});
      REQUIRE(along < (1U << 20));
      Soup finer = input;
      cluster(finer, CellSize{report.cell[0] * double(along) / double(along + 1)});
      CHECK(finer.triangles.size() > most);
    }
}

TEST_CASE("A count of faces that the soup has changes nothing") {
  const Soup input = test::tilted(test::sphere(4));
  for (std::size_t most : {input.triangles.size(), std::numeric_limits<std::size_t>::max()})
    for (ClusterPlacement placement : {mean, quadric}) {
      Soup soup = input;
      const ClusterReport report = cluster(soup, FaceCount{most}, placement);
      CHECK(report.faces_after == input.triangles.size());
      CHECK(test::is_identical(soup, input));
    }
}

namespace {

template <class Points, class Triangles>
void check_containers(double tolerance) {
  using P = typename Points::value_type;
  using T = typename Triangles::value_type;
  Soup expected = scaled(test::sphere(2), 0.75); // of coordinates that floats need not round much
  Points points;
  for (const Position& p : expected.points)
    points.push_back(internal::point_at<P>(p));
  Triangles triangles;
  for (const auto& [a, b, c] : expected.triangles) {
    using I = typename T::value_type;
    triangles.push_back(T{static_cast<I>(a), static_cast<I>(b), static_cast<I>(c)});
  }
  const ClusterReport report = cluster_vertices(points, triangles, CellSize{0.4}, quadric);
  cluster(expected, CellSize{0.4}, quadric);
  CHECK(report.faces_after == expected.triangles.size());
  Soup result;
  for (const P& p : points)
    result.points.push_back(internal::position_of(p));
  for (const T& t : triangles)
    result.triangles.push_back({std::uint32_t(t[0]), std::uint32_t(t[1]), std::uint32_t(t[2])});
  CHECK(result.triangles == expected.triangles);
  check_points(result.points, expected.points, tolerance);
}

} // namespace

TEST_CASE("All kinds of points and triangles") {
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel::Point_3;
  using Single = CGAL::Simple_cartesian<float>::Point_3;
  check_containers<std::vector<std::array<double, 3>>, std::vector<std::array<std::size_t, 3>>>(0);
  check_containers<std::deque<std::array<double, 3>>, std::deque<std::array<int, 3>>>(0);
  check_containers<std::vector<test::Point>, std::vector<std::vector<std::uint16_t>>>(0);
  check_containers<std::vector<Exact>, std::vector<std::array<std::int64_t, 3>>>(0);
  check_containers<std::vector<std::array<float, 3>>, std::vector<std::array<short, 3>>>(1e-6);
  check_containers<std::vector<Single>, std::vector<std::vector<unsigned>>>(1e-6);
}

namespace {

void check_rejection(const Soup& input, const ClusterCells& cells, const std::string& message) {
  CAPTURE(message);
  for (ClusterPlacement placement : {mean, quadric}) {
    std::vector<Position> points = input.points;
    std::vector<std::array<double, 3>> arrays;
    for (const Position& p : points)
      arrays.push_back(p.coordinates);
    std::vector<std::vector<std::int64_t>> triangles;
    for (const auto& t : input.triangles)
      triangles.emplace_back(t.begin(), t.end());
    const auto arrays_before = arrays;
    const auto triangles_before = triangles;
    CHECK_THROWS_WITH(cluster_vertices(arrays, triangles, cells, placement),
                      "quadrille::cluster_vertices: " + message);
    CHECK_THROWS_AS(cluster_vertices(arrays, triangles, cells, placement), std::invalid_argument);
    bool is_as_it_was = triangles == triangles_before && arrays.size() == arrays_before.size();
    for (std::size_t v = 0; is_as_it_was && v < arrays.size(); ++v)
      for (std::size_t i = 0; i < 3; ++i)
        is_as_it_was &= arrays[v][i] == arrays_before[v][i] || std::isnan(arrays[v][i]);
    CHECK(is_as_it_was);
  }
}

} // namespace

TEST_CASE("Bad input is refused, and the soup is as it was") {
  const Soup sphere = test::sphere(2);
  const Grid grid{3, 3, 3};

  Soup soup = sphere;
  soup.triangles[5] = {1, 2, 66};
  check_rejection(soup, grid, "face 5 names point 66 of 66");
  soup = sphere;
  soup.points[9][1] = std::numeric_limits<double>::quiet_NaN();
  check_rejection(soup, grid, "point 9 is not finite");
  soup.points[9][1] = -std::numeric_limits<double>::infinity();
  check_rejection(soup, grid, "point 9 is not finite");

  check_rejection(sphere, Grid{3, 0, 2}, "a grid of 3 x 0 x 2 cells is empty");
  check_rejection(sphere, Grid{std::size_t{1} << 53, 1, 1},
                  "9007199254740992 x 1 x 1 cells are too many");
  check_rejection(sphere, Grid{std::size_t{1} << 32, std::size_t{1} << 30, 4},
                  "4294967296 x 1073741824 x 4 cells are too many");
  check_rejection(sphere, CellSize{0}, "CellSize 0 is not positive and finite");
  check_rejection(sphere, CellSize{-1}, "CellSize -1 is not positive and finite");
  check_rejection(sphere, CellSize{std::numeric_limits<double>::infinity()},
                  "CellSize inf is not positive and finite");
  check_rejection(sphere, CellSize{std::numeric_limits<double>::quiet_NaN()},
                  "CellSize nan is not positive and finite");
  check_rejection(
      test::cube(2), CellSize{0x1p-60},
      "1152921504606846976 x 1152921504606846976 x 1152921504606846976 cells are too many");

  std::vector<std::array<double, 3>> points(4);
  std::vector<std::vector<int>> triangles{{0, 1, 2}, {0, 1, 2, 3}};
  CHECK_THROWS_WITH(cluster_vertices(points, triangles, grid),
                    "quadrille::cluster_vertices: face 1 is not a triangle; "
                    "CGAL::Polygon_mesh_processing::triangulate_polygons triangulates it");
  triangles = {{0, 1, 2}, {0, -1, 2}};
  CHECK_THROWS_WITH(cluster_vertices(points, triangles, grid),
                    "quadrille::cluster_vertices: face 1 names point -1 of 4");
}

TEST_CASE("As many cells as can be numbered, and cells larger than any box") {
  const Soup input = test::sphere(3);
  Soup soup = input;
  cluster(soup, Grid{std::size_t{1} << 21, std::size_t{1} << 21, std::size_t{1} << 21});
  CHECK(test::is_identical(soup, input));
  cluster(soup, Grid{std::size_t{1} << 52, 2, 2});
  CHECK(soup.triangles.size() > 100);
  for (double edge : {3.0, 1e300}) {
    soup = scaled(input, edge == 3 ? 1 : 0x1p-900);
    const ClusterReport report = cluster(soup, CellSize{edge}, quadric);
    CHECK(report.cells == Grid{1, 1, 1});
    CHECK(report.faces_after == 0);
  }
}

TEST_CASE("A report of clustering prints itself") {
  Soup soup = test::cube(4);
  std::ostringstream out;
  out << cluster(soup, Grid{2, 2, 2});
  CHECK(out.str() == "192 -> 12 faces, 98 -> 8 vertices, 2 x 2 x 2 cells, 0 duplicate faces");
}

TEST_CASE("Eigenvectors of a symmetric matrix") {
  test::Random random(11);
  for (int i = 0; i < 200; ++i) {
    SymmetricMatrix<3> a;
    for (int planes = i % 4; planes >= 0; --planes) // of rank 1 to 4, of very different weights
      a += SymmetricMatrix<3>::outer_product({{random(-1, 1), random(-1, 1), random(-1, 1)}},
                                             std::ldexp(1.0, planes * (i % 9)));
    const internal::Eigenvectors eigen(a);
    for (std::size_t k = 0; k < 3; ++k) {
      const Position v = eigen.vector(k);
      CHECK(squared_distance(a * v, eigen.value(k) * v) < 1e-28 * a.trace() * a.trace());
      CHECK(std::abs(squared_length(v) - 1) < 1e-14);
      CHECK(std::abs(dot(v, eigen.vector((k + 1) % 3))) < 1e-14);
    }
  }
}
