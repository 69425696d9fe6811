// The quadrics of attributes and creases, by their definitions.
#include "meshes.h"
#include "soups.h"

#include <quadrille/attribute_quadric.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace {

using namespace quadrille;
using test::Point;
using test::Soup;

template <std::size_t N>
Vector<N> random_position(test::Random& random) {
  Vector<N> p;
  for (double& x : p.coordinates)
    x = random(-1, 1);
  return p;
}

// Of x to the plane through p, q and r, by the normal equations.
template <std::size_t N>
double squared_distance_to_plane(const Vector<N>& x, const Vector<N>& p, const Vector<N>& q,
                                 const Vector<N>& r) {
  const Vector<N> u = q - p, v = r - p, d = x - p;
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v);
  const double determinant = uu * vv - uv * uv;
  const double s = (vv * dot(d, u) - uv * dot(d, v)) / determinant;
  const double t = (uu * dot(d, v) - uv * dot(d, u)) / determinant;
  return squared_length(d - s * u - t * v);
}

// A sheet in the unit square, folded along x = 1/2 by a right angle.
Soup roof(std::uint32_t n) {
  return test::mapped(test::grid(2 * n, n), [](const test::Position& p) {
    return test::Position{{p[0], p[1], std::abs(p[0] - 0.5)}};
  });
}

struct CountCreases : Quadric {
  std::size_t* count;
  State crease(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) const {
    ++*count;
    return Quadric::crease(p, q, r);
  }
};

} // namespace

TEMPLATE_TEST_CASE_SIG("A face leaves its area times the squared distance to its plane", "",
                       ((std::size_t N), N), 1, 2, 3, 5) {
  test::Random random(N);
  for (int i = 0; i < 20; ++i) {
    const auto p = random_position<3 + N>(random), q = random_position<3 + N>(random),
               r = random_position<3 + N>(random), x = random_position<3 + N>(random);
    const double area =
        std::sqrt(squared_length(double_area_vector(space(p), space(q), space(r)))) / 2;
    CHECK(AttributeQuadric<N>{}.face(p, q, r)(x - p) ==
          Approx(area * squared_distance_to_plane(x, p, q, r)).epsilon(1e-6));
  }
}

TEST_CASE("By default a step across the range of the attributes is a part of the diagonal") {
  const Vector<3> weights =
      ColorQuadric{.importance = 0.5}.attribute_weights({{0, 10, -1}}, {{100, 20, 1}}, 20.0);
  CHECK(weights == Vector<3>{{0.1, 0.1, 0.1}});
  CHECK(TextureQuadric{}.attribute_weights({{3, 3}}, {{3, 3}}, 20.0) == Vector<2>{{1, 1}});
}

TEST_CASE("Attributes that are linear on the surface stay so") {
  Soup soup = test::with_noise(test::grid(12, 12), 2, 0.02);
  std::vector<Point> points;
  std::vector<std::array<double, 2>> texture;
  for (test::Position& p : soup.points) {
    p[2] = 0;
    points.push_back(test::to_point<Point>(p));
    texture.push_back({10 * p[0] + p[1], 7 - 3 * p[1]});
  }
  simplify<TextureQuadric, OptimalPlacement>(
      points, soup.triangles, FaceRatio{0.2},
      CGAL::parameters::vertex_texture_map(CGAL::make_property_map(texture)));
  REQUIRE(points.size() < 60);
  for (std::size_t v = 0; v < points.size(); ++v) {
    CHECK(texture[v][0] == Approx(10 * points[v].x() + points[v].y()).margin(1e-5));
    CHECK(texture[v][1] == Approx(7 - 3 * points[v].y()).margin(1e-5));
  }
}

TEST_CASE("A crease is an edge at which the normals differ by more than its angle") {
  for (double degrees : {30.0, 89.0, 91.0, 180.0}) {
    CAPTURE(degrees);
    std::size_t count = 0;
    CountCreases cost{{.crease_degrees = degrees}, &count};
    test::Mesh mesh = test::make_mesh(roof(6));
    simplify(mesh, cost, FaceRatio{1});
    CHECK(count == (degrees < 90 ? 6 * 2 * 2 : 0)); // edges, faces, ends
  }
}
