// vertex_importance_map: what a contraction costs where it is large; and the maps of importance.h.
#include "meshes.h"
#include "soups.h"

#include <quadrille/channels.h>
#include <quadrille/importance.h>
#include <quadrille/internal/core/cost/vertex_importance.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <CGAL/property_map.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace quadrille;
using namespace test;

auto important(std::vector<double>& importance) {
  return parameters::vertex_importance_map(CGAL::make_property_map(importance));
}

template <class... Arguments>
Soup simplified(const Soup& input, const Arguments&... arguments) {
  PointSoup soup(input);
  simplify(soup.points, soup.triangles, arguments...);
  return to_soup(soup);
}

// A factor beyond x, and 1 before it.
std::vector<double> beyond(const Soup& soup, double x, double factor) {
  std::vector<double> importance;
  for (const Position& p : soup.points)
    importance.push_back(p[0] > x ? factor : 1);
  return importance;
}

Soup noisy(int levels = 4) {
  return with_noise(sphere(levels), 1, 0.002);
}

// Of the faces on the right, for each on the left.
double ratio_of_faces(const Soup& soup) {
  double left = 0, right = 0;
  for (const Triangle& t : soup.triangles) {
    const double x = soup.points[t[0]][0] + soup.points[t[1]][0] + soup.points[t[2]][0];
    (x > 0 ? right : left) += 1;
  }
  return right / left;
}

Soup scaled(Soup soup, double factor) {
  for (Position& p : soup.points)
    p *= factor;
  return soup;
}

std::string complaint(const Soup& input, std::vector<double> importance) {
  PointSoup soup(input);
  try {
    simplify(soup.points, soup.triangles, FaceRatio{0.5}, important(importance));
  } catch (const std::invalid_argument& error) {
    CHECK(is_identical(to_soup(soup), input));
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("an importance that is the same everywhere changes no bit") {
  const Soup soup = noisy();
  for (const AnyOrder& order : {AnyOrder(GreedyOrder{}), AnyOrder(RelaxedOrder{})}) {
    const Soup expected = simplified(soup, FaceRatio{0.1}, order);
    for (double factor : {0., 1., 0.3, 1e300, 1e-300}) {
      std::vector<double> importance(soup.points.size(), factor);
      CHECK(is_identical(simplified(soup, FaceRatio{0.1}, order, important(importance)), expected));
    }
  }
}

TEST_CASE("an importance of 8 leaves about twice as many faces, of 64 four times") {
  const Soup soup = with_noise(sphere(5), 1, 1e-5); // it is renumbered if it is shuffled
  for (const AnyOrder& order : {AnyOrder(GreedyOrder{}), AnyOrder(RelaxedOrder{})})
    for (const Soup& input : {soup, shuffled(soup, 1)})
      for (double factor : {8., 64.}) {
        std::vector<double> importance = beyond(input, 0, factor);
        const double ratio =
            ratio_of_faces(simplified(input, FaceRatio{0.05}, order, important(importance)));
        CAPTURE(factor, ratio);
        CHECK(ratio > 0.75 * std::cbrt(factor));
        CHECK(ratio < 1.25 * std::cbrt(factor));
      }
}

TEST_CASE("importance depends on no unit, of lengths or of its own") {
  const Soup soup = noisy();
  std::vector<double> importance = beyond(soup, 0, 50);
  const Soup expected = simplified(soup, FaceRatio{0.1}, important(importance));
  for (int exponent : {-40, 40}) {
    const double factor = std::ldexp(1, exponent);
    std::vector<double> others = importance;
    for (double& x : others)
      x *= factor;
    CHECK(is_identical(simplified(soup, FaceRatio{0.1}, important(others)), expected));
    const Soup result = simplified(scaled(soup, factor), FaceRatio{0.1}, important(importance));
    CHECK(is_identical(scaled(result, 1 / factor), expected));
  }
}

TEST_CASE("what is of no importance goes first, the cheapest before the others") {
  const Soup soup = noisy();
  std::vector<double> importance = beyond(soup, 0, 1);
  for (std::size_t v = 0; v < importance.size(); ++v)
    importance[v] = soup.points[v][0] > 0 ? 1 : 0;
  const Soup result = simplified(soup, FaceRatio{0.6}, important(importance));
  // The right half is as it was, but for its rim.
  const auto far = [](const Position& p) { return p[0] > 0.1; };
  std::vector<Position> before, after;
  std::copy_if(soup.points.begin(), soup.points.end(), std::back_inserter(before), far);
  std::copy_if(result.points.begin(), result.points.end(), std::back_inserter(after), far);
  CHECK(before == after);
  // The left half is as good as if it had been simplified alone: a sphere.
  CHECK(volume(result) > 0.97 * volume(soup));
}

TEST_CASE("what has become part of a vertex counts on") {
  internal::VertexImportance importance({0.5F, 1, 0.25F, 0.125F});
  importance.merge(3, 2);
  CHECK(importance.of_pair(3, 3) == 0.25F);
  importance.merge(1, 3);
  CHECK(importance.of_pair(1, 1) == 1);
  importance.merge(0, 1);
  CHECK(importance.of_pair(0, 0) == 1);
}

TEST_CASE("a few important vertices among others count for all that they become part of") {
  const Soup soup = with_noise(sphere(5), 1, 1e-5);
  std::vector<double> importance = beyond(soup, 0, 64);
  for (std::size_t v = 0; v < importance.size(); ++v)
    if (v % 7 != 0)
      importance[v] = 1;
  for (const AnyOrder& order : {AnyOrder(GreedyOrder{}), AnyOrder(RelaxedOrder{})}) {
    const double ratio =
        ratio_of_faces(simplified(soup, FaceRatio{0.05}, order, important(importance)));
    CAPTURE(ratio);
    CHECK(ratio > 2.5);
    CHECK(ratio < 5);
  }
}

TEST_CASE("a part vanishes later that has an important vertex") {
  const Soup one = sphere(1), two = joined(one, one, {{100, 0, 0}}); // far apart: they are small
  for (const bool is_second : {false, true}) {
    std::vector<double> importance(two.points.size(), 1);
    importance[is_second ? one.points.size() + 3 : 3] = 100;
    const Soup result =
        simplified(two, FaceCount{4}, Topology::components_may_vanish, important(importance));
    REQUIRE(!result.points.empty());
    CHECK((result.points.front()[0] > 2) == is_second);
  }
}

TEST_CASE("of points at one place the greatest importance counts") {
  Soup soup = noisy();
  std::vector<double> importance = beyond(soup, 0, 50);
  const std::size_t faces = 500;
  const Soup expected = simplified(soup, FaceCount{faces}, important(importance));
  for (Triangle& t : soup.triangles)
    for (auto& v : t) { // a point for each corner, of which the first has the importance
      soup.points.push_back(soup.points[v]);
      importance.push_back(0);
      v = static_cast<std::uint32_t>(soup.points.size() - 1);
    }
  std::vector<double> values(soup.points.size(), 1);
  const Soup result = simplified(soup, FaceCount{faces}, SplitVertices{}, important(importance));
  CHECK(result.triangles.size() == expected.triangles.size());
  CHECK(ratio_of_faces(result) == Approx(ratio_of_faces(expected)));
}

TEST_CASE("importance on a mesh is that on its soup, and of every cost") {
  const Soup soup = noisy();
  std::vector<double> importance = beyond(soup, 0, 27);
  const Soup expected =
      simplified(soup, MemorylessQuadric{}, FaceRatio{0.1}, important(importance));
  CHECK(ratio_of_faces(expected) > 2);
  Mesh mesh = make_mesh(soup);
  auto map = mesh.add_property_map<Mesh::Vertex_index, double>("v:importance", 1).first;
  for (const auto v : mesh.vertices())
    map[v] = importance[v];
  simplify(mesh, MemorylessQuadric{}, FaceRatio{0.1}, parameters::vertex_importance_map(map));
  mesh.collect_garbage();
  CHECK(is_same_surface(to_soup(mesh), expected, 0));
}

TEST_CASE("an importance that is negative or not finite is refused, and its vertex named") {
  const Soup soup = sphere(1);
  for (double wrong :
       {-1., std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    std::vector<double> importance(soup.points.size(), 1);
    importance[17] = wrong;
    const std::string what = complaint(soup, importance);
    CAPTURE(what);
    CHECK(what.find("vertex 17, ") != std::string::npos);
    CHECK(what.find("is negative or not finite") != std::string::npos);
  }
}

// --- Maps ----------------------------------------------------------------------------------------

TEST_CASE("curvature_importance: a sphere and a plane are alike all over") {
  for (const double x : curvature_importance(sphere(3).points, sphere(3).triangles))
    CHECK(x == Approx(8).epsilon(0.25));
  for (const Soup& flat : {grid(4, 4), tilted(grid(37, 23))}) // of which normals are rounded
    for (const double x : curvature_importance(flat.points, flat.triangles))
      CHECK(x == 1);
}

TEST_CASE("curvature_importance tells the curvatures of a torus") {
  const Soup soup = torus(120, 60); // of radii 1 and 0.4
  const std::vector<double> x = curvature_importance(soup.points, soup.triangles, {1});
  const auto curvature = [](const Position& p) {
    const double around = std::hypot(p[0], p[1]); // from the axis
    return std::hypot(1 / 0.4, (around - 1) / 0.4 / around);
  };
  const double scale = (x[0] - 1) / curvature(soup.points[0]);
  for (std::size_t v = 0; v < x.size(); ++v)
    CHECK((x[v] - 1) / curvature(soup.points[v]) == Approx(scale).epsilon(0.02));
}

TEST_CASE("maps of importance depend on no unit, and are those of the mesh") {
  const Soup soup = noisy(3), large = scaled(soup, 0x1p400);
  CHECK(curvature_importance(large.points, large.triangles) ==
        curvature_importance(soup.points, soup.triangles));
  const Position eye{{3, 1, 0}};
  const std::vector<double> seen = view_importance(soup.points, soup.triangles, {eye});
  CHECK(view_importance(large.points, large.triangles, {0x1p400 * eye}) == seen);
  Mesh mesh = make_mesh(soup);
  auto map = mesh.add_property_map<Mesh::Vertex_index, double>("v:importance", 0).first;
  view_importance(mesh, map, {eye});
  for (const auto v : mesh.vertices())
    CHECK(map[v] == seen[v]);
}

TEST_CASE("view_importance: by the cube of the distance, and by how faces are turned") {
  const Soup soup = sphere(4);
  const ViewImportance how{{{4, 0, 0}}, 0.5, 16};
  const std::vector<double> x = view_importance(soup.points, soup.triangles, how);
  const auto of_distance = [&](std::size_t v) {
    return std::pow(5 / std::sqrt(squared_distance(soup.points[v], how.eye)), 3);
  };
  for (std::size_t v = 0; v < x.size(); ++v) {
    const double facing = x[v] / of_distance(v);
    const double outline = 1. / 4; // of the sphere, seen from 4 radii
    const double expected = soup.points[v][0] > outline + 0.1   ? 1
                            : soup.points[v][0] < outline - 0.1 ? 0.5
                                                                : facing;
    CHECK(facing == Approx(expected).epsilon(1e-3));
  }
  CHECK(std::any_of(x.begin(), x.end(), [&](const double& value) {
    return value / of_distance(static_cast<std::size_t>(&value - x.data())) > 15;
  }));
}

TEST_CASE("maps of importance refuse what makes no sense") {
  const Soup soup = sphere(1);
  CHECK_THROWS_AS(curvature_importance(soup.points, soup.triangles, {-1}), std::invalid_argument);
  CHECK_THROWS_AS(view_importance(soup.points, soup.triangles, {{{NAN, 0, 0}}}),
                  std::invalid_argument);
  CHECK_THROWS_AS(view_importance(soup.points, soup.triangles, {{}, -1}), std::invalid_argument);
  Soup bad = soup;
  bad.points[3][1] = NAN;
  CHECK_THROWS_WITH(curvature_importance(bad.points, bad.triangles),
                    Catch::Contains("vertex 3 is not finite"));
  bad = soup;
  bad.triangles[2][0] = 1000;
  CHECK_THROWS_AS(curvature_importance(bad.points, bad.triangles), std::invalid_argument);
}
