// What Quadric remembers beside planes: lines along normals, noise, and squares of areas.
#include "meshes.h"
#include "soups.h"

#include <quadrille/simplify.h>

#include <CGAL/property_map.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using namespace test;

constexpr Position p{{1, 2, 3}}, q{{3, 2, 3}}, r{{1, 5, 3}}; // of area 3, with the normal z

Soup simplified(const Soup& input, const Quadric& cost, double ratio, double scale = 1) {
  PointSoup soup(input);
  for (Point& point : soup.points)
    point = Point(scale * point.x(), scale * point.y(), scale * point.z());
  simplify(soup.points, soup.triangles, cost, FaceRatio{ratio});
  Soup result = to_soup(soup);
  for (Position& point : result.points)
    point *= 1 / scale;
  return result;
}

Soup noisy(double noise = 0.01) {
  return with_noise(sphere(4), 1, noise);
}

// In the mean over all faces.
double smallest_angle(const Soup& soup) {
  double sum = 0;
  for (const Triangle& t : soup.triangles) {
    double greatest = 0; // cosine
    for (std::size_t i = 0; i < 3; ++i) {
      const Position a = soup.points[t[(i + 1) % 3]] - soup.points[t[i]];
      const Position b = soup.points[t[(i + 2) % 3]] - soup.points[t[i]];
      greatest = std::max(greatest, dot(a, b) / std::sqrt(squared_length(a) * squared_length(b)));
    }
    sum += std::acos(greatest) * 180 / std::numbers::pi;
  }
  return sum / static_cast<double>(soup.triangles.size());
}

// What the vertices of a mesh remember that nothing has been done to.
std::vector<QuadricForm<3>> remembered(const Soup& input, const Quadric& cost) {
  std::vector<QuadricForm<3>> forms(input.points.size());
  PointSoup soup(input);
  simplify(soup.points, soup.triangles, cost, FaceRatio{1},
           parameters::vertex_quadric_map(CGAL::make_property_map(forms)));
  return forms;
}

Position vertex_normal(const Soup& soup, std::size_t v) {
  Position normal{};
  for (const Triangle& t : soup.triangles)
    if (std::find(t.begin(), t.end(), v) != t.end())
      normal += area_vector(soup, t);
  return 1 / std::sqrt(squared_length(normal)) * normal;
}

} // namespace

TEST_CASE("a vertex leaves a line along its normal, and the mean over noise") {
  const Quadric cost{.line_weight = 0.25, .normal_noise = 0.5, .position_noise = 2};
  CHECK(cost.has_vertex_terms());
  CHECK(!Quadric{}.has_vertex_terms());
  const QuadricForm<3> planes = cost.face(p, q, r); // of the weight 3
  const QuadricForm<3> terms = cost.vertex(planes, {{0, 0, 7}});
  const Position x{{4, 3, 2}};
  const double line = 0.25 * (4 * 4 + 3 * 3); // from the z axis
  const double noise = 0.25 * (16 + 9 + 4) + (1 + 3 * 0.25) * 4;
  CHECK(terms(x) == Approx(3 * (line + noise)));
  // Without a normal there is no line.
  CHECK(cost.vertex(planes, {})(x) == Approx(3 * noise));
}

TEST_CASE("noise is what planes cost in the mean, if normals and places are random") {
  const double s = 0.3, t = 0.2;
  const Quadric cost{.normal_noise = s, .position_noise = t};
  const Position n{{0, 0, 1}}, x{{0.4, 0.3, -0.2}};
  Random random(1);
  const auto normal_variable = [&] { // of the variance 1, as a sum of 12
    double sum = -6;
    for (int i = 0; i < 12; ++i)
      sum += random(0, 1);
    return sum;
  };
  double sum = 0;
  constexpr int samples = 200000;
  for (int i = 0; i < samples; ++i) {
    Position normal = n, place{};
    for (std::size_t k = 0; k < 3; ++k) {
      normal[k] += s * normal_variable();
      place[k] = t * normal_variable();
    }
    const double distance = dot(normal, x - place);
    sum += distance * distance;
  }
  QuadricForm<3> plane = QuadricForm<3>::plane(n, 1);
  plane += cost.vertex(plane, n);
  CHECK(sum / samples == Approx(plane(x)).epsilon(0.02));
}

TEST_CASE("vertices of the input remember lines and noise, in the mesh's units") {
  const Soup soup = mapped(noisy(), [](Position x) { return 1000 * x; });
  const Quadric cost{.line_weight = 0.5, .normal_noise = 0.1, .position_noise = 30};
  const auto plain = remembered(soup, Quadric{}), with = remembered(soup, cost);
  for (std::size_t v = 0; v < soup.points.size(); v += 37) {
    // Both are means: divided by their traces.
    QuadricForm<3> expected = plain[v];
    expected += cost.vertex(plain[v], vertex_normal(soup, v));
    expected *= 1 / expected.trace();
    const Position x{{20, -10, 5}};
    CHECK(with[v](x) == Approx(expected(x)));
    CHECK(with[v]({}) == Approx(expected({})));
  }
}

TEST_CASE(
    "lines and noise of normals make better triangles, and noise of places changes the order") {
  const Soup soup = torus(100, 50);
  const Soup plain = simplified(soup, Quadric{}, 0.1);
  const double angle = smallest_angle(plain);
  CHECK(smallest_angle(simplified(soup, Quadric{.line_weight = 0.03}, 0.1)) > angle + 3);
  CHECK(smallest_angle(simplified(soup, Quadric{.normal_noise = 0.2}, 0.1)) > angle + 3);
  CHECK(!is_identical(simplified(soup, Quadric{.position_noise = 0.01}, 0.1), plain));
}

TEST_CASE("lines, noise and squared areas depend on no unit") {
  const Soup soup = noisy();
  for (double exponent : {-300., 300.}) {
    const double scale = std::ldexp(1, static_cast<int>(exponent));
    for (const Quadric& cost :
         {Quadric{.line_weight = 0.01}, Quadric{.normal_noise = 0.1, .position_noise = 0.02},
          Quadric{.weighting = Weighting::by_squared_area, .line_weight = 0.01}}) {
      Quadric scaled = cost;
      scaled.position_noise *= scale;
      CHECK(is_identical(simplified(soup, scaled, 0.1, scale), simplified(soup, cost, 0.1)));
    }
  }
}

TEST_CASE(
    "triangle quadrics: the square of three times the volume below a face, and borders alike") {
  const Quadric cost{.weighting = Weighting::by_squared_area};
  const Position x{{0, 0, 2}};
  CHECK(cost.face(p, q, r)(x) == Approx(3 * 3 * 2 * 2)); // (area · height)² = (3 · volume)²
  // An edge counts as a square on it: by the fourth power of its length.
  const Position double_q = p + 2 * (q - p), double_r = p + 2 * (r - p);
  CHECK(cost.boundary(p, double_q, double_r)(2 * Position{{0, 1, 0}}) ==
        Approx(64 * cost.boundary(p, q, r)({{0, 1, 0}})));
  CHECK(cost.crease(p, q, r)(x) == Approx(cost.boundary(p, q, r)(x)));
}

TEST_CASE("lines and noise that make no sense are refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Quadric& cost : {Quadric{.line_weight = -1}, Quadric{.normal_noise = nan},
                              Quadric{.position_noise = std::numeric_limits<double>::infinity()}}) {
    PointSoup soup(sphere(1));
    CHECK_THROWS_AS(simplify(soup.points, soup.triangles, cost), std::invalid_argument);
  }
}
