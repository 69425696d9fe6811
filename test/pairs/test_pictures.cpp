// Quadrics as ellipsoids and pairs as segments.
#include "../examples/products/figures/pictures.h"
#include "meshes.h"
#include "soups.h"

#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>
#include <vector>

namespace {

using namespace quadrille;
using namespace figures;
using test::Mesh;
using test::Position;
using Form = QuadricForm<3>;
using Pair = std::array<std::uint32_t, 2>;

// Two unit squares, one above the other, each of two triangles, and a point of its own in between.
struct Sheets {
  static constexpr double gap = 0.25;
  std::vector<std::array<double, 3>> points = {{0, 0, 0},   {1, 0, 0},   {1, 1, 0},
                                               {0, 1, 0},   {0, 0, gap}, {1, 0, gap},
                                               {1, 1, gap}, {0, 1, gap}, {0, 0, gap / 2}};
  std::vector<std::array<int, 3>> triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};

  const std::set<Pair> edges = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {2, 3},
                                {4, 5}, {4, 6}, {4, 7}, {5, 6}, {6, 7}};
  const std::set<Pair> across = {{0, 4}, {1, 5}, {2, 6}, {3, 7}};
};

std::set<Pair> pairs_of(const auto& segments, bool are_edges) {
  std::set<Pair> pairs;
  for (const auto& segment : segments)
    if (segment.is_edge == are_edges)
      CHECK(pairs.insert(segment.vertices).second);
  return pairs;
}

// Selects an edge, twice, a pair that is none, one of a point without faces, and a point with
// itself, and does not include the edges.
struct TwoPairs {
  void operator()(const SurfaceView&, const EmitPair& emit) const {
    emit(2, 0);
    emit(6, 1);
    emit(0, 2);
    emit(8, 0);
    emit(3, 3);
  }
};

} // namespace

TEST_CASE("Segments are the edges and the pairs closer than the threshold") {
  const Sheets s;
  const auto segments = pair_segments(s.points, s.triangles, ThresholdPairs{1.01 * Sheets::gap});
  CHECK(pairs_of(segments, true) == s.edges);
  CHECK(pairs_of(segments, false) == s.across);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    CHECK((i == 0 || segments[i - 1].vertices < segments[i].vertices));
    for (std::size_t end = 0; end < 2; ++end)
      CHECK(segments[i].ends[end] == s.points[segments[i].vertices[end]]);
  }
}

TEST_CASE("Segments are those of the policy: edges only, or no edges but its own") {
  const Sheets s;
  const auto edges = pair_segments(s.points, s.triangles, EdgePairs{});
  CHECK(pairs_of(edges, true) == s.edges);
  CHECK(pairs_of(edges, false).empty());
  const auto two = pair_segments(s.points, s.triangles, TwoPairs{});
  CHECK(pairs_of(two, true) == std::set<Pair>{{0, 2}});
  CHECK(pairs_of(two, false) == std::set<Pair>{{1, 6}});
}

TEST_CASE("Segments of a mesh are those of its soup, counted off where vertices were removed") {
  const test::Soup soup = test::random_with_boundaries(4);
  Mesh mesh = test::make_mesh(soup);
  const ThresholdPairs pairs = ThresholdPairs::relative(0.1);
  simplify(mesh, FaceRatio{0.6});
  std::vector<test::Point> points;
  std::map<Mesh::Vertex_index, std::uint32_t> number;
  for (const auto v : mesh.vertices()) {
    number.emplace(v, static_cast<std::uint32_t>(points.size()));
    points.push_back(mesh.point(v));
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    triangles.push_back({number.at(mesh.source(h)), number.at(mesh.target(h)),
                         number.at(mesh.target(mesh.next(h)))});
  }
  const auto of_mesh = pair_segments(mesh, pairs),
             of_soup = pair_segments(points, triangles, pairs);
  REQUIRE(of_mesh.size() == of_soup.size());
  CHECK(pairs_of(of_mesh, true).size() == mesh.number_of_edges());
  CHECK_FALSE(pairs_of(of_mesh, false).empty());
  for (std::size_t i = 0; i < of_mesh.size(); ++i) {
    CHECK(of_mesh[i].vertices == of_soup[i].vertices);
    CHECK(of_mesh[i].ends == of_soup[i].ends);
    CHECK(of_mesh[i].is_edge == of_soup[i].is_edge);
  }
}

TEST_CASE("Segments of what is no surface are refused") {
  Sheets s;
  s.triangles[2][1] = 9;
  CHECK_THROWS_WITH(pair_segments(s.points, s.triangles, EdgePairs{}),
                    "quadrille::pair_segments: face 2 names point 9 of 9");
  s.triangles[2][1] = 5;
  CHECK_THROWS_AS(pair_segments(s.points, s.triangles, ThresholdPairs{-1}), std::invalid_argument);
  s.points[3][1] = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(pair_segments(s.points, s.triangles, EdgePairs{}),
                    "quadrille::pair_segments: vertex 3 is not finite");
}

TEST_CASE("On an ellipsoid its quadric has the level, and no half axis is too long") {
  Form form = Form::plane({{0.6, 0, 0.8}}, 0.7);
  form += Form::plane({{0.1, 0.9, -0.2}}, 0.3);
  const std::vector<std::array<double, 3>> points = {{{1, 2, 3}}};
  const double level = 0.5, longest = 20;
  const auto ellipsoid =
      quadric_ellipsoids(points, std::vector<Form>{form}, {.level = level, .longest = longest});
  double farthest = 0;
  for (const auto& p : ellipsoid.points) {
    const Position x{{p[0] - points[0][0], p[1] - points[0][1], p[2] - points[0][2]}};
    CHECK(form(x) / (level * level) + squared_length(x) / (longest * longest) == Approx(1));
    farthest = std::max(farthest, std::sqrt(squared_length(x)));
  }
  CHECK(farthest <= longest * (1 + 1e-12));
  CHECK(farthest > 0.9 * longest);
}

TEST_CASE(
    "Ellipsoids are closed, look outwards, and are one for each vertex, whatever its quadric") {
  const std::size_t meridians = GENERATE(3u, 16u), parallels = GENERATE(1u, 2u, 8u);
  const std::vector<test::Point> points = {{0, 0, 0}, {5, 0, 0}, {0, 5, 0}};
  const std::vector<Form> forms = {Form::point(1), Form::plane({{0, 0, 1}}, 1e20), Form{}};
  const auto soup = quadric_ellipsoids(points, forms, {1, 1, meridians, parallels});
  CHECK(soup.triangles.size() == points.size() * 2 * meridians * parallels);
  CHECK(soup.points.size() == points.size() * (2 + meridians * parallels));
  std::map<Pair, int> sides; // each edge once in either direction
  for (const auto& [a, b, c] : soup.triangles)
    for (const auto& [v, w] : {std::tuple(a, b), {b, c}, {c, a}})
      CHECK(++sides[{v, w}] == 1);
  for (const auto& [side, count] : sides)
    CHECK(sides.contains({side[1], side[0]}));
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    const auto& [a, b, c] = soup.triangles[i];
    const test::Point centre = points[i / (2 * meridians * parallels)];
    CHECK(CGAL::orientation(soup.points[a], soup.points[b], soup.points[c], centre) !=
          CGAL::POSITIVE);
    if (i < 2 * meridians * parallels) // a sphere
      CHECK(CGAL::squared_distance(soup.points[a], centre) == Approx(0.5));
  }
}

TEST_CASE("Ellipsoids of a mesh are those of its vertices that are left") {
  Mesh mesh = test::make_mesh(test::random_closed(2));
  const auto quadrics = mesh.add_property_map<Mesh::Vertex_index, Form>("v:quadric").first;
  simplify(mesh, FaceRatio{0.5}, parameters::vertex_quadric_map(quadrics));
  std::vector<test::Point> points;
  std::vector<Form> forms;
  for (const auto v : mesh.vertices()) {
    points.push_back(mesh.point(v));
    forms.push_back(quadrics[v]);
  }
  const EllipsoidShape shape{.level = 0.1, .longest = 0.5};
  const auto of_mesh = quadric_ellipsoids(mesh, quadrics, shape);
  const auto of_soup = quadric_ellipsoids(points, forms, shape);
  CHECK(of_mesh.points == of_soup.points);
  CHECK(of_mesh.triangles == of_soup.triangles);
  CHECK(of_mesh.triangles.size() == 256 * mesh.number_of_vertices());
}

TEST_CASE("Ellipsoids of no shape and of no quadric are refused") {
  const std::vector<test::Point> points(2, CGAL::ORIGIN);
  std::vector<Form> forms(2);
  const auto made = [&](const EllipsoidShape& shape) { quadric_ellipsoids(points, forms, shape); };
  CHECK_NOTHROW(made({.level = 1, .longest = 2}));
  CHECK_THROWS_AS(made({.level = 0, .longest = 2}), std::invalid_argument);
  CHECK_THROWS_AS(made({.level = 1, .longest = std::numeric_limits<double>::infinity()}),
                  std::invalid_argument);
  CHECK_THROWS_AS(made({1, 1, 2, 1}), std::invalid_argument);
  CHECK_THROWS_AS(made({1, 1, 3, 0}), std::invalid_argument);
  forms[1] *= std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(made({.level = 1, .longest = 2}),
                    "quadrille::quadric_ellipsoids: vertex 1 or its quadric is not finite");
  forms.pop_back();
  CHECK_THROWS_WITH(made({.level = 1, .longest = 2}),
                    "quadrille::quadric_ellipsoids: there are 1 quadrics for 2 points");
}
