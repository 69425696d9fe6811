#include "meshes.h"
#include "soups.h"

#include <quadrille/bounded_hausdorff.h>
#include <quadrille/distance.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Triangle = Kernel::Triangle_3;
using Points = std::vector<Point>;
using Triangles = std::vector<std::array<int, 3>>;

// The unit square in the plane z = height, as two triangles.
Points square(double height) {
  return {{0, 0, height}, {1, 0, height}, {1, 1, height}, {0, 1, height}};
}
const Triangles two_triangles{{0, 1, 2}, {0, 2, 3}};

// A floor, and on one of its edges a wall of the same shape:
//
//        3
//        |\        the wall 0 1 3 is perpendicular to the floor 0 1 2
//        | \       .
//        0--1
//       /  .
//      2
const Points corner{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const Triangles floor_only{{0, 1, 2}};
const Triangles floor_and_wall{{0, 1, 2}, {0, 1, 3}};

template <class Mesh>
Mesh tetrahedron(double size) {
  using P = typename boost::property_traits<
      typename boost::property_map<Mesh, CGAL::vertex_point_t>::type>::value_type;
  using FT = typename CGAL::Kernel_traits<P>::Kernel::FT;
  const FT s = static_cast<FT>(size), o = 0;
  Mesh mesh;
  CGAL::make_tetrahedron(P(o, o, o), P(s, o, o), P(o, s, o), P(o, o, s), mesh);
  return mesh;
}

Points moved(Points points, double scale, double offset) {
  for (Point& p : points)
    p = Point(scale * p.x() + offset, scale * p.y() + offset, scale * p.z() + offset);
  return points;
}

} // namespace

TEST_CASE("Parallel squares are as far apart everywhere as their planes") {
  const auto d = quadrille::surface_distance(square(0), two_triangles, square(0.25), two_triangles);
  for (double figure :
       {d.rms, d.rms_a_to_b, d.rms_b_to_a, d.hausdorff, d.hausdorff_a_to_b, d.hausdorff_b_to_a})
    CHECK(figure == Approx(0.25));
}

TEST_CASE("What only one surface has counts in its own direction only") {
  const auto d = quadrille::surface_distance(corner, floor_only, corner, floor_and_wall);
  CHECK(d.rms_a_to_b == 0);
  CHECK(d.hausdorff_a_to_b == 0);
  CHECK(d.hausdorff_b_to_a == 1); // vertex 3, which no sample needs to hit
  // z² has a mean of 1/6 over the wall, and the wall is half of the surface.
  CHECK(d.rms_b_to_a == Approx(std::sqrt(1.0 / 12)).epsilon(0.005));
  CHECK(d.rms == Approx(d.rms_b_to_a / std::sqrt(2.0)));
  CHECK(d.hausdorff == 1);
}

TEST_CASE("A surface is at no distance from itself") {
  const auto d = quadrille::surface_distance(corner, floor_and_wall, corner, floor_and_wall);
  CHECK(d.hausdorff == Approx(0).margin(1e-15));
}

TEST_CASE("A wall on a wall may be non-manifold") {
  const Triangles three_at_an_edge{{0, 1, 2}, {0, 1, 3}, {1, 0, 4}};
  Points points = corner;
  points.push_back({0, 0, -2});
  const auto d = quadrille::surface_distance(corner, floor_and_wall, points, three_at_an_edge);
  CHECK(d.hausdorff_a_to_b == Approx(0).margin(1e-15));
  CHECK(d.hausdorff_b_to_a == 2);
}

TEST_CASE("Points that no triangle uses do not count") {
  Points with_stray = corner;
  with_stray.push_back({100, 100, 100});
  const auto d = quadrille::surface_distance(with_stray, floor_only, corner, floor_only);
  CHECK(d.hausdorff == Approx(0).margin(1e-15));
}

TEST_CASE("Equal seeds give equal figures, others nearly so") {
  using Sampling = quadrille::DistanceSampling;
  const auto rms = [](const Sampling& sampling) {
    return quadrille::surface_distance(corner, floor_only, corner, floor_and_wall, sampling).rms;
  };
  CHECK(rms({.samples = 1000, .seed = 1}) == rms({.samples = 1000, .seed = 1}));
  CHECK(rms({.samples = 1000, .seed = 1}) != rms({.samples = 1000, .seed = 2}));
  CHECK(rms({.samples = 1000, .seed = 1}) ==
        Approx(rms({.samples = 1000, .seed = 2})).epsilon(0.1));
}

TEST_CASE("Distances follow the unit and do not depend on the place") {
  const auto at = [](double scale, double offset) {
    return quadrille::surface_distance(moved(square(0), scale, offset), two_triangles,
                                       moved(square(0.25), scale, offset), two_triangles);
  };
  CHECK(at(1e-9, 0).rms == Approx(0.25e-9));
  CHECK(at(1e9, 0).rms == Approx(0.25e9));
  CHECK(at(1, 1e7).rms == Approx(0.25));
  const Points slope{{0, 0, 0}, {1, 0, 0.375}, {0, 1, -0.625}};
  const Points far_away = moved(slope, 1, 1e7); // where the step between doubles is 2e-9
  const auto d = quadrille::surface_distance(far_away, floor_only, far_away, floor_only);
  CHECK(d.hausdorff == Approx(0).margin(1e-15));
}

TEST_CASE("The figures follow the unit as far as doubles hold the surfaces") {
  const auto scaled = [](const test::Soup& soup, double scale) {
    return test::mapped(test::tilted(soup), [&](const test::Position& p) { return scale * p; });
  };
  const test::Soup fine = test::uv_sphere(24, 12), coarse = test::uv_sphere(8, 5);
  const double error = 1e-4;
  struct Figures {
    quadrille::SurfaceDistance of_soups, of_meshes;
    double bounded, bounded_reverse;
  };
  const auto at = [&](double scale) {
    const test::PointSoup a(scaled(fine, scale)), b(scaled(coarse, scale));
    const auto mesh_a = test::make_mesh(scaled(fine, scale));
    const auto mesh_b = test::make_mesh(scaled(coarse, scale));
    const quadrille::DistanceSampling sampling{.samples = 10'000};
    return Figures{
        quadrille::surface_distance(a.points, a.triangles, b.points, b.triangles, sampling),
        quadrille::surface_distance(mesh_a, mesh_b, sampling),
        quadrille::bounded_hausdorff(mesh_a, mesh_b, scale * error),
        quadrille::bounded_hausdorff(mesh_b, mesh_a, scale * error)};
  };
  const auto figures = [](const quadrille::SurfaceDistance& d) {
    return std::array{d.rms,        d.hausdorff,        d.rms_a_to_b,
                      d.rms_b_to_a, d.hausdorff_a_to_b, d.hausdorff_b_to_a};
  };
  const auto check = [&](const quadrille::SurfaceDistance& d, const quadrille::SurfaceDistance& d1,
                         double scale) {
    for (std::size_t i = 0; i < 6; ++i)
      CHECK(figures(d)[i] / scale == Approx(figures(d1)[i]).epsilon(1e-9));
  };
  const Figures one = at(1);
  CHECK(one.of_meshes.hausdorff > 0.05);
  CHECK(one.bounded == Approx(one.of_meshes.hausdorff).margin(0.01));
  for (double scale : {1e-300, 1e-170, 1e-100, 1e-80, 1e-20, 1e20, 1e60, 1e80, 1e160, 1e300}) {
    CAPTURE(std::log10(scale));
    const Figures d = at(scale);
    check(d.of_soups, one.of_soups, scale);
    check(d.of_meshes, one.of_meshes, scale);
    CHECK(d.bounded / scale == Approx(one.bounded).margin(error));
    CHECK(d.bounded_reverse / scale == Approx(one.bounded_reverse).margin(error));
  }
  // A power of two changes no digit.
  const Figures d = at(0x1p-900);
  for (std::size_t i = 0; i < 6; ++i)
    CHECK(figures(d.of_meshes)[i] == 0x1p-900 * figures(one.of_meshes)[i]);
  CHECK(d.bounded == 0x1p-900 * one.bounded);
}

TEST_CASE("The unit of the smaller surface does not matter beside a larger one") {
  for (double scale : {1e-300, 1e-80, 1e80, 1e300}) {
    CAPTURE(std::log10(scale));
    const auto tiny = tetrahedron<test::Mesh>(1e-6 * scale);
    const auto larger = tetrahedron<test::Mesh>(scale);
    const double d = quadrille::surface_distance(tiny, larger).hausdorff;
    CHECK(d / scale == Approx(1 - 1e-6));
    CHECK(quadrille::bounded_hausdorff(tiny, larger, 1e-3 * scale) / scale ==
          Approx(1).margin(1e-3));
    CHECK(quadrille::bounded_hausdorff(larger, tiny, 1e-3 * scale) / scale ==
          Approx(1).margin(1e-3));
  }
}

TEST_CASE("An error far above the size of the surfaces is one too") {
  const auto small = tetrahedron<test::Mesh>(1e-300), smaller = tetrahedron<test::Mesh>(5e-301);
  for (double error : {1e-298, 1e-150, 1.0, 1e300, std::numeric_limits<double>::infinity()}) {
    CAPTURE(std::log10(error));
    const double d = quadrille::bounded_hausdorff(small, smaller, error);
    CHECK(d >= 5e-301);
    CHECK(d <= std::min(error, 2e-300)); // the size of the box
  }
}

TEST_CASE("An error far below rounding is one too") {
  for (double place : {0.0, 1.0, 1e6, 1e9}) {
    CAPTURE(place);
    const test::Soup soup =
        test::mapped(test::tilted(test::tetrahedron()), [&](const test::Position& p) {
          return p + test::Position{{place, 0, 0}};
        });
    const auto a = test::make_mesh(soup), b = test::make_mesh(test::with_noise(soup, 7, 1e-4));
    for (double error : {1e-18, 1e-300})
      CHECK(quadrille::bounded_hausdorff(a, b, error) ==
            Approx(quadrille::surface_distance(a, b).hausdorff).margin(1e-9));
  }
}

TEST_CASE("Surfaces in a point are measured") {
  const auto in_one = [](test::Soup soup, double x) {
    soup.points.assign(soup.points.size(), {{x, 2, 3}});
    return test::make_mesh(soup);
  };
  const auto at = [&](double x) { return in_one(test::tetrahedron(), x); };
  CHECK(quadrille::bounded_hausdorff(at(1), at(1), 1e-3) == 0);
  CHECK(quadrille::bounded_hausdorff(at(1), in_one(test::triangle(), 1), 1e-3) == 0);
  CHECK(quadrille::bounded_hausdorff(at(1), at(4), 1e-3) == Approx(3).margin(1e-3));
}

TEST_CASE("A flat surface far along its normal keeps its distances") {
  // Where x is so much greater than the surface, a power of two for the surface is too much for x.
  const auto flat = [](double size) {
    test::Soup soup = test::triangle();
    for (test::Position& p : soup.points)
      p = {{1e300, size * p[0], size * p[1]}};
    return soup;
  };
  const auto small = test::make_mesh(flat(1e-10)), larger = test::make_mesh(flat(2e-10));
  CHECK(quadrille::surface_distance(small, larger).hausdorff == Approx(1e-10));
  CHECK(quadrille::bounded_hausdorff(small, larger, 1e-13) == Approx(1e-10).epsilon(1e-3));
}

TEMPLATE_TEST_CASE("Any mesh type and kernel will do", "",
                   CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>,
                   CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>,
                   CGAL::Polyhedron_3<CGAL::Simple_cartesian<float>>,
                   CGAL::Polyhedron_3<CGAL::Exact_predicates_inexact_constructions_kernel>) {
  const auto mesh = tetrahedron<TestType>(1);
  const auto larger = tetrahedron<CGAL::Surface_mesh<Point>>(2);
  CHECK(quadrille::bounding_box_diagonal(mesh) == Approx(std::sqrt(3.0)));
  CHECK(quadrille::surface_distance(mesh, mesh).hausdorff == Approx(0).margin(1e-15));
  // The farthest are the new corners, 1 away from the old ones.
  CHECK(quadrille::surface_distance(mesh, larger).hausdorff_b_to_a == Approx(1));
  CHECK(quadrille::bounded_hausdorff(mesh, larger, 1e-3) == Approx(1).margin(1e-3));
}

TEST_CASE("The bounded distance finds what lies between vertices") {
  // The floor of a tent lies half of the tent's height below its middle: between the vertices of
  // either surface. Nearest to the centre of the square are the slopes, which fall by 1 on 1/2.
  //
  //      /\   1      distance from the centre c of the floor to a slope:
  //     /  \         1/2 · sin(atan(2)) = 1/sqrt(5)
  //    /_c__\ 0
  const Points tent_points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
  using Mesh = CGAL::Surface_mesh<Point>;
  Mesh tent, floor;
  std::vector<Mesh::Vertex_index> t, f;
  for (const Point& p : tent_points)
    t.push_back(tent.add_vertex(p));
  for (std::size_t i = 0; i < 4; ++i) {
    tent.add_face(t[i], t[(i + 1) % 4], t[4]);
    f.push_back(floor.add_vertex(tent_points[i]));
  }
  floor.add_face(f[0], f[1], f[2]);
  floor.add_face(f[0], f[2], f[3]);
  const auto sampled = quadrille::surface_distance(floor, tent);
  CHECK(sampled.hausdorff_a_to_b == Approx(1 / std::sqrt(5.0)).epsilon(0.01));
  CHECK(sampled.hausdorff_a_to_b <= 1 / std::sqrt(5.0));
  CHECK(sampled.hausdorff_b_to_a == 1);
  CHECK(quadrille::bounded_hausdorff(floor, tent, 1e-4) == Approx(1).margin(1e-4));
}

TEST_CASE("Needles, points and the empty have a nearest point or say so") {
  SECTION("a triangle that is a segment") {
    const Triangles needle{{0, 1, 2}};
    const Points on_a_line{{0, 0, 0}, {1, 0, 0}, {0.25, 0, 0}};
    const auto d = quadrille::surface_distance(square(0), two_triangles, on_a_line, needle);
    CHECK(d.hausdorff_a_to_b == 1);
    CHECK(d.rms_a_to_b == Approx(std::sqrt(1.0 / 3)).epsilon(0.005)); // the mean of y²
    CHECK(d.rms_b_to_a == Approx(0).margin(1e-15));
  }
  SECTION("a triangle that is a point") {
    const Triangles point{{0, 0, 0}};
    const auto d = quadrille::surface_distance(square(0), two_triangles, corner, point);
    CHECK(d.hausdorff_a_to_b == Approx(std::sqrt(2.0)));
  }
  SECTION("no triangle") {
    CHECK_THROWS_AS(quadrille::surface_distance(corner, Triangles{}, corner, floor_only),
                    std::invalid_argument);
    const CGAL::Surface_mesh<Point> empty;
    CHECK_THROWS_AS(quadrille::surface_distance(empty, empty), std::invalid_argument);
    CHECK_THROWS_AS(quadrille::bounded_hausdorff(empty, empty, 1), std::invalid_argument);
    CHECK(quadrille::bounding_box_diagonal(empty) == 0);
  }
}

TEST_CASE("What cannot be measured is refused") {
  const auto measure = [](const Points& points, const auto& triangles) {
    return quadrille::surface_distance(points, triangles, corner, floor_only);
  };
  CHECK_THROWS_AS(measure(corner, Triangles{{0, 1, 4}}), std::invalid_argument);
  CHECK_THROWS_AS(measure(corner, Triangles{{0, 1, -1}}), std::invalid_argument);
  const std::vector<std::vector<int>> quad{{0, 1, 2, 3}};
  CHECK_THROWS_AS(measure(corner, quad), std::invalid_argument);
  Points not_a_number = corner;
  not_a_number[1] = Point(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  CHECK_THROWS_AS(measure(not_a_number, floor_only), std::invalid_argument);
  const auto mesh = tetrahedron<CGAL::Surface_mesh<Point>>(1);
  CHECK_THROWS_AS(quadrille::bounded_hausdorff(mesh, mesh, 0), std::invalid_argument);
}

TEST_CASE("The nearest point of a triangle is in it and as near as any") {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto random_point = [&](double flatness) {
    return Point(coordinate(generator), flatness * coordinate(generator),
                 flatness * coordinate(generator));
  };
  for (double flatness : {1.0, 1e-3, 1e-9, 1e-17, 0.0}) // down to needles and segments
    for (int i = 0; i < 200; ++i) {
      const Triangle t(random_point(flatness), random_point(flatness), random_point(flatness));
      const Point query = random_point(1);
      const Point nearest = quadrille::internal::nearest_on_triangle(t, query);
      const double distance = std::sqrt(CGAL::squared_distance(query, nearest));
      const int n = 20;
      double in_triangle = std::numeric_limits<double>::infinity();
      for (int j = 0; j <= n; ++j)
        for (int k = 0; j + k <= n; ++k) {
          const Point p = CGAL::barycenter(t[0], double(j) / n, t[1], double(k) / n, t[2],
                                           double(n - j - k) / n);
          in_triangle = std::min(in_triangle, std::sqrt(CGAL::squared_distance(query, p)));
        }
      CAPTURE(flatness, i);
      CHECK(distance <= in_triangle + 1e-15);
      CHECK(distance >= in_triangle - 0.15); // the spacing of the grid
      CHECK(quadrille::internal::nearest_on_triangle(t, nearest).x() ==
            Approx(nearest.x()).margin(1e-12));
    }
}
