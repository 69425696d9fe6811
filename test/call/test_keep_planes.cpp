// KeepPlanes: the measure is made of points and triangles alone, with the planes from which the
// surfaces were made. Each vertex that a vertex of a region has become is in its plane, and the
// faces that lie in the plane have the area of the region.
#include "soups.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <quadrille/compiled.h>
#include <quadrille/keep_planes.h>
#include <quadrille/placement.h>
#include <quadrille/quadric.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using test::Position;
using test::Soup;

struct Flat {
  Position normal;
  double offset;
};

struct Shape {
  std::string name;
  Soup soup;
  std::vector<Flat> flats;
  double rounding = 0; // of heights above the planes: none where these are coordinates
  double curved = 0;   // how much of the area of a region may differ, for its rough outline
  std::size_t fewest = 40;
  double least_area = 0.05;
};

double height(const Flat& flat, const std::array<double, 3>& p) {
  return flat.normal[0] * p[0] + flat.normal[1] * p[1] + flat.normal[2] * p[2] - flat.offset;
}

SoupPoints arrays_of(const Soup& soup) {
  SoupPoints points;
  for (const Position& p : soup.points)
    points.push_back(p.coordinates);
  return points;
}

bool lies_in(const Flat& flat, const SoupPoints& points, const std::array<std::uint32_t, 3>& t,
             double rounding) {
  return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) {
    return std::abs(height(flat, points[v])) <= rounding;
  });
}

double area_in(const Flat& flat, const SoupPoints& points, const SoupTriangles& triangles,
               double rounding) {
  double area = 0;
  for (const auto& t : triangles)
    if (lies_in(flat, points, t, rounding))
      area += std::sqrt(squared_length(double_area_vector(
                  Position{points[t[0]]}, Position{points[t[1]]}, Position{points[t[2]]}))) /
              2;
  return area;
}

Position scaled(const Position& p, double factor) {
  return Position{{p[0] * factor, p[1] * factor, p[2] * factor}};
}

// A rough ball that is cut off, as a scan of a part on a print bed.
Shape cut_ball() {
  test::Random random(1);
  const Soup ball = test::mapped(test::sphere(4), [&](const Position& p) {
    Position q = scaled(p, 1 + 0.01 * random(-1, 1));
    q[2] = (std::max)(q[2], -0.6);
    return q;
  });
  return {"ball", ball, {{{{0, 0, 1}}, -0.6}}, 0, 0.06};
}

// Rough ground with water at one height, in several lakes; one of them has an island.
Shape lakes() {
  test::Random random(2);
  const Soup ground = test::mapped(test::grid(50, 50), [&](const Position& p) {
    const double x = p[0] - 0.5, y = p[1] - 0.5, r = std::sqrt(x * x + y * y);
    const double z = 0.1 * std::cos(14 * r) + 0.004 * random(-1, 1);
    return Position{{p[0], p[1], (std::max)(z, -0.03)}};
  });
  return {"lakes", ground, {{{{0, 0, 1}}, -0.03}}, 0, 0.06, 200, 0.01};
}

// A box with a rough roof: its walls meet each other at edges and corners, and the floor.
Shape house() {
  test::Random random(3);
  const Soup box = test::mapped(test::cube(14), [&](const Position& p) {
    Position q = p;
    if (p[2] == 1)
      q[2] += 0.02 * random(0, 1) * (p[0] * (1 - p[0]) * p[1] * (1 - p[1]) > 0 ? 1 : 0);
    return q;
  });
  std::vector<Flat> flats;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (double offset : {0., 1.})
      if (axis < 2 || offset == 0) {
        flats.push_back({{}, offset});
        flats.back().normal[axis] = 1;
      }
  return {"house", box, flats, 0, 0.01};
}

// A shape turned so that no plane is perpendicular to an axis.
Shape turned(Shape shape) {
  const Soup axes =
      test::tilted({{Position{{1, 0, 0}}, Position{{0, 1, 0}}, Position{{0, 0, 1}}}, {}});
  shape.name += ", turned";
  shape.soup = test::tilted(shape.soup);
  shape.rounding = 1e-13;
  for (Flat& flat : shape.flats) {
    const Position n = flat.normal;
    flat.normal = n[0] * axes.points[0] + n[1] * axes.points[1] + n[2] * axes.points[2];
  }
  return shape;
}

std::vector<Shape> shapes() {
  return {cut_ball(), lakes(), house(), turned(cut_ball()), turned(lakes()), turned(house())};
}

// Do all vertices of a region stay in the plane, and keep its faces their area?
void check_flats(const Shape& shape, const SoupResult& result) {
  const SoupPoints before = arrays_of(shape.soup);
  for (const Flat& flat : shape.flats) {
    double farthest = 0;
    for (const auto& t : shape.soup.triangles)
      if (lies_in(flat, before, t, shape.rounding))
        for (std::uint32_t v : t)
          farthest =
              (std::max)(farthest, std::abs(height(flat, result.points[result.vertex_map[v]])));
    CHECK(farthest <= shape.rounding);
    const double area = area_in(flat, before, shape.soup.triangles, shape.rounding);
    REQUIRE(area > 0.05);
    CHECK(area_in(flat, result.points, result.triangles, shape.rounding) ==
          Approx(area).epsilon(shape.curved + 1e-9));
  }
}

// The segments around the faces that lie in a plane.
using Segment = std::array<Position, 2>;
std::vector<Segment> outline(const Flat& flat, const SoupPoints& points,
                             const SoupTriangles& triangles, double rounding) {
  std::map<std::array<std::uint32_t, 2>, int> sides;
  for (const auto& t : triangles)
    if (lies_in(flat, points, t, rounding))
      for (std::size_t i = 0; i < 3; ++i)
        ++sides[{(std::min)(t[i], t[(i + 1) % 3]), (std::max)(t[i], t[(i + 1) % 3])}];
  std::vector<Segment> segments;
  for (const auto& [ends, count] : sides)
    if (count == 1)
      segments.push_back({Position{points[ends[0]]}, Position{points[ends[1]]}});
  return segments;
}

double distance(const Position& p, const Segment& s) {
  const Position along = s[1] - s[0];
  const double length = squared_length(along);
  const double t = length > 0 ? std::clamp(dot(p - s[0], along) / length, 0., 1.) : 0;
  return std::sqrt(squared_distance(p, s[0] + t * along));
}

struct Distances {
  double greatest = 0, mean_square = 0;
};
// From points of some segments to the nearest of the others.
Distances distances(const std::vector<Segment>& from, const std::vector<Segment>& to) {
  Distances result;
  double weight = 0;
  for (const Segment& s : from) {
    const double length = std::sqrt(squared_distance(s[0], s[1]));
    const int steps = 1 + static_cast<int>(length / 0.01);
    for (int i = 0; i <= steps; ++i) {
      double least = INFINITY;
      for (const Segment& other : to)
        least = (std::min)(least, distance(s[0] + double(i) / steps * (s[1] - s[0]), other));
      result.greatest = (std::max)(result.greatest, least);
      result.mean_square += length / steps * least * least;
      weight += length / steps;
    }
  }
  result.mean_square /= weight;
  return result;
}
// Both ways, between the outlines of an input and of a result.
Distances outline_distances(const Shape& shape, const SoupResult& result) {
  Distances both;
  for (const Flat& flat : shape.flats) {
    const auto before = outline(flat, arrays_of(shape.soup), shape.soup.triangles, shape.rounding);
    const auto after = outline(flat, result.points, result.triangles, shape.rounding);
    REQUIRE(!before.empty());
    REQUIRE(!after.empty());
    for (const Distances& d : {distances(before, after), distances(after, before)}) {
      both.greatest = (std::max)(both.greatest, d.greatest);
      both.mean_square = (std::max)(both.mean_square, d.mean_square);
    }
  }
  return both;
}

SoupOptions options_to(std::size_t faces, double least_area = 0.05) {
  SoupOptions options;
  options.faces = faces;
  options.keep_planes = least_area;
  return options;
}

SoupResult simplified(const Soup& soup, const SoupOptions& options) {
  const SoupPoints points = arrays_of(soup);
  return simplified_soup({points, soup.triangles}, options);
}

} // namespace

TEST_CASE("plane regions stay in their planes, and keep their areas", "[planes]") {
  for (const Shape& shape : shapes())
    for (const std::size_t faces : {shape.soup.triangles.size() / 5, shape.fewest}) {
      CAPTURE(shape.name, faces);
      const SoupResult result = simplified(shape.soup, options_to(faces, shape.least_area));
      CHECK(result.report.kept_planes >= shape.flats.size());
      CHECK(result.triangles.size() <= faces + 1);
      check_flats(shape, result);
    }
}

TEST_CASE("plane regions stay flat with any cost, order and placement", "[planes]") {
  using Cost = SoupOptions::Cost;
  for (const Cost cost :
       {Cost::memoryless_quadric, Cost::thin_feature_quadric, Cost::edge_length}) {
    Shape shape = turned(house());
    if (cost == Cost::edge_length)
      shape.curved = 0.08; // lengths of edges do not look at outlines
    SoupOptions options = options_to(200);
    options.cost = cost;
    CAPTURE(static_cast<int>(cost));
    check_flats(shape, simplified(shape.soup, options));
    options.order = SoupOptions::Order::relaxed;
    check_flats(shape, simplified(shape.soup, options));
  }
  const Shape shape = turned(house());
  for (const auto placement :
       {SoupOptions::Placement::endpoint, SoupOptions::Placement::midpoint}) {
    SoupOptions options = options_to(200);
    options.placement = placement;
    check_flats(shape, simplified(shape.soup, options));
  }
  SoupOptions options = options_to(500, 0.01);
  options.order = SoupOptions::Order::relaxed;
  options.topology = Topology::free;
  check_flats(lakes(), simplified(lakes().soup, options));
}

TEST_CASE("outlines of plane regions stay near with any cost and placement", "[planes]") {
  for (const Shape& shape : {lakes(), turned(house())})
    for (const auto cost : {SoupOptions::Cost::quadric, SoupOptions::Cost::memoryless_quadric,
                            SoupOptions::Cost::edge_length})
      for (const auto placement :
           {SoupOptions::Placement::optimal, SoupOptions::Placement::midpoint}) {
        SoupOptions options = options_to(shape.soup.triangles.size() / 8, shape.least_area);
        options.cost = cost;
        if (cost != SoupOptions::Cost::edge_length)
          options.placement = placement;
        const SoupResult result = simplified(shape.soup, options);
        CAPTURE(shape.name, static_cast<int>(cost), static_cast<int>(placement));
        CHECK(std::sqrt(outline_distances(shape, result).mean_square) <= 0.005);
      }
}

TEST_CASE("no outline of a plane region goes further than its limit", "[planes]") {
  for (const Shape& shape : {lakes(), turned(cut_ball())})
    for (const double limit : {0.01, 0.03})
      for (const auto cost : {SoupOptions::Cost::quadric, SoupOptions::Cost::memoryless_quadric,
                              SoupOptions::Cost::edge_length})
        for (const auto order : {SoupOptions::Order::greedy, SoupOptions::Order::relaxed}) {
          SoupOptions options = options_to(10, shape.least_area);
          options.cost = cost;
          options.order = order;
          options.plane_outline = limit;
          const SoupResult result = simplified(shape.soup, options);
          CAPTURE(shape.name, limit, static_cast<int>(cost), static_cast<int>(order));
          const double greatest = outline_distances(shape, result).greatest;
          CHECK(greatest <= limit + 1e-12);
          CHECK(greatest > limit / 4);
        }
  SoupOptions options = options_to(10, 0.01);
  options.error = 0.05; // limits outlines, too
  CHECK(outline_distances(lakes(), simplified(lakes().soup, options)).greatest <= 0.05 + 1e-12);
  options.plane_outline = 0;
  const Shape straight = turned(house());
  CHECK(simplified(straight.soup, options).triangles.size() <
        straight.soup.triangles.size() / 2);
}

TEST_CASE("plane regions stay flat with guards and limits of distances", "[planes]") {
  const Shape shape = lakes();
  SoupOptions options;
  options.keep_planes = 0.01;
  options.error = 0.02;
  options.both_ways = true;
  options.coordinates_are_floats = true;
  Shape floats = shape;
  floats.soup = test::as_floats(shape.soup);
  floats.flats[0].offset = static_cast<double>(-0.03f);
  check_flats(floats, simplified(floats.soup, options));
  options = options_to(300, 0.01);
  options.no_self_intersection = true;
  check_flats(shape, simplified(shape.soup, options));
}

TEST_CASE("plane regions stay flat with colours and labels", "[planes]") {
  const Shape shape = turned(house());
  test::Random random(5);
  std::vector<double> colors;
  for (std::size_t i = 0; i < 3 * shape.soup.points.size(); ++i)
    colors.push_back(random(0, 1));
  std::vector<std::uint32_t> labels;
  for (const auto& t : shape.soup.triangles)
    labels.push_back(shape.soup.points[t[0]][0] > 0.3 ? 7 : 4);
  const SoupPoints points = arrays_of(shape.soup);
  const SoupView view{
      points, shape.soup.triangles, labels, {{SoupChannelView::Kind::colors, 3, colors, {}, {}}}};
  const SoupResult result = simplified_soup(view, options_to(500));
  check_flats(shape, result);
  REQUIRE(result.labels.size() == result.triangles.size());
  for (std::size_t i = 0; i < result.labels.size(); ++i)
    CHECK(result.labels[i] == labels[result.input_faces[i]]);
}

TEST_CASE("a region that is nearly flat becomes flat", "[planes]") {
  test::Random random(6);
  Shape shape = cut_ball();
  for (Position& p : shape.soup.points)
    if (p[2] == -0.6)
      p[2] += 1e-4 * random(-1, 1);
  SoupOptions options = options_to(200);
  CHECK(simplified(shape.soup, options).report.kept_planes == 0);
  options.plane_flatness = 2e-4;
  const SoupResult result = simplified(shape.soup, options);
  CHECK(result.report.kept_planes == 1);
  double low = 1;
  for (const auto& p : result.points)
    low = (std::min)(low, p[2]);
  const Flat flat{{{0, 0, 1}}, low};
  CHECK(low == Approx(-0.6).margin(1e-4));
  CHECK(area_in(flat, result.points, result.triangles, 0) ==
        Approx(area_in({{{0, 0, 1}}, -0.6}, arrays_of(shape.soup), shape.soup.triangles, 1.1e-4))
            .epsilon(0.08));
}

TEST_CASE("a fixed vertex stays where it is, and the rest of its region in the plane", "[planes]") {
  Shape shape = lakes();
  std::size_t lowest = 0;
  for (std::size_t v = 0; v < shape.soup.points.size(); ++v)
    if (shape.soup.points[v][2] == -0.03)
      lowest = v;
  shape.soup.points[lowest][2] = -0.03 - 1e-7;
  SoupOptions options = options_to(300, 0.01);
  options.fixed.resize(shape.soup.points.size(), false);
  options.fixed[lowest] = true;
  const SoupResult result = simplified(shape.soup, options);
  CHECK(result.points[result.vertex_map[lowest]][2] == -0.03 - 1e-7);
  check_flats(shape, result);
}

TEST_CASE("without a plane region nothing is different", "[planes]") {
  const Soup ball = test::sphere(3);
  SoupOptions options;
  const SoupResult plain = simplified(ball, options);
  options.keep_planes = 1;
  const SoupResult other = simplified(ball, options);
  CHECK(plain.points == other.points);
  CHECK(plain.triangles == other.triangles);
}

TEST_CASE("a mesh keeps its planes", "[planes]") {
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  const Shape shape = house();
  CGAL::Surface_mesh<Point> mesh;
  for (const Position& p : shape.soup.points)
    mesh.add_vertex(Point(p[0], p[1], p[2]));
  using Vertex = CGAL::Surface_mesh<Point>::Vertex_index;
  for (const auto& t : shape.soup.triangles)
    mesh.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
  const std::optional<KeepPlanes> planes = KeepPlanes{0.5};
  CHECK(simplify(mesh, FaceCount{100}, planes).kept_planes == 5);
  mesh.collect_garbage();
  std::size_t at_floor = 0;
  for (const auto v : mesh.vertices())
    at_floor += mesh.point(v).z() == 0;
  CHECK(at_floor >= 4);
}

TEST_CASE("planes need an area, and placements that do not look around", "[planes]") {
  const Soup box = test::cube(3);
  SoupPoints points = arrays_of(box);
  SoupTriangles triangles = box.triangles;
  CHECK_THROWS_WITH(simplify(points, triangles, KeepPlanes{-1}),
                    Catch::Contains("area -1 is negative"));
  CHECK_THROWS_WITH(simplify(points, triangles, KeepPlanes{1, INFINITY}),
                    Catch::Contains("flatness inf is negative or not finite"));
  CHECK_THROWS_WITH(simplify(points, triangles, KeepPlanes{1, {}, -1}),
                    Catch::Contains("outline -1 is negative or not finite"));
  CHECK_THROWS_WITH(simplify(points, triangles, KeepPlanes{0.5}, VolumeKeeping<OptimalPlacement>{}),
                    Catch::Contains("KeepPlanes does not go with a placement that looks"));
  CHECK(points == arrays_of(box));
  SoupOptions options;
  options.plane_flatness = 1;
  CHECK_THROWS_WITH(simplified(box, options), Catch::Contains("plane_flatness needs keep_planes"));
  options.plane_flatness.reset();
  options.plane_outline = 1;
  CHECK_THROWS_WITH(simplified(box, options), Catch::Contains("plane_outline needs keep_planes"));
}

TEST_CASE("a height field is one in the library without templates, or is rejected", "[planes]") {
  SoupOptions options = options_to(300);
  options.height_field = SoupOptions::Axis::z;
  const SoupResult result = simplified(lakes().soup, options);
  for (const auto& t : result.triangles) {
    const auto &p = result.points[t[0]], &q = result.points[t[1]], &r = result.points[t[2]];
    CHECK((q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1]) > 0);
  }
  options.height_field = SoupOptions::Axis::x;
  CHECK_THROWS_WITH(simplified(lakes().soup, options),
                    Catch::Contains("the input is no height field along x: triangle"));
}
