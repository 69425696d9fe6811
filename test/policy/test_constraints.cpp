// What the faces that vanish must not take with them, and limits that hold in every order.
#include "meshes.h"
#include "soups.h"

#include <boost/property_map/function_property_map.hpp>
#include <quadrille/distance_limits.h>
#include <quadrille/edge_length.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace {

using namespace quadrille;
using test::Point;
using test::PointSoup;
using test::Soup;

bool has(const PointSoup& soup, const Point& p) {
  return std::count(soup.points.begin(), soup.points.end(), p) == 1;
}

auto only(std::size_t v) {
  return CGAL::parameters::vertex_is_constrained_map(
      boost::make_function_property_map<std::size_t>([v](std::size_t w) { return v == w; }));
}

} // namespace

TEST_CASE("The last face of a fixed vertex stays where topology is free") {
  for (std::size_t v = 0; v < 3; ++v) {
    PointSoup soup(test::triangle());
    const Point fixed = soup.points[v];
    const Report report = simplify<Quadric, OptimalPlacement>(
        soup.points, soup.triangles, FaceCount{0}, only(v), Topology::free);
    CHECK(report.faces_after == 1);
    CHECK(report.rejected(Rejection::constraint) > 0);
    CHECK(has(soup, fixed));
  }
}

TEST_CASE("A fixed vertex is the last that is left of a surface where topology is free") {
  for (std::size_t v = 0; v < 20; ++v) {
    PointSoup soup(test::with_noise(test::grid(4, 3), 1, 0.05));
    const Point fixed = soup.points[v];
    simplify<EdgeLength, MidpointPlacement>(soup.points, soup.triangles, FaceCount{0},
                                            NormalFlip{180}, Topology::free, only(v));
    CHECK(soup.triangles.size() == 1);
    CHECK(has(soup, fixed));
  }
}

TEST_CASE("A fixed vertex that keeps a face is in nobody's way where topology is free") {
  // 3---2
  // | \ |   of the two faces at 3, that of the short edge vanishes
  // 0-1-+
  PointSoup soup(
      {{{{0, 0, 0}}, {{0.5, 0, 0.1}}, {{1, 1, 0}}, {{0, 1, 0}}}, {{0, 1, 3}, {1, 2, 3}}});
  const auto all_but_one =
      boost::make_function_property_map<std::size_t>([](std::size_t v) { return v != 1; });
  const Report report = simplify<EdgeLength, EndpointPlacement>(
      soup.points, soup.triangles, FaceCount{1},
      CGAL::parameters::vertex_is_constrained_map(all_but_one));
  CHECK(report.faces_after == 1);
  CHECK(report.rejected(Rejection::constraint) == 3); // the pairs that are left
}

TEST_CASE("A vertex goes with its last face, and is counted") {
  for (std::size_t faces = 0; faces < 60; ++faces) {
    PointSoup soup(test::random_with_boundaries(4));
    const Report report = simplify<EdgeLength, MidpointPlacement>(
        soup.points, soup.triangles, FaceCount{faces}, NormalFlip{180});
    CHECK(report.vertices_after == soup.points.size());
    CHECK(report.faces_after == soup.triangles.size());
  }
}

TEST_CASE("An error limit holds in every order, and is used") {
  const Soup input = test::with_noise(test::grid(30, 30), 3, 0.002);
  const auto check = [&](const auto& order, double limit) {
    test::Mesh mesh = test::make_mesh(input);
    const Report report = simplify<Quadric, OptimalPlacement>(mesh, DistanceLimit(limit), order);
    CHECK(report.distance_bound <= limit);
    CHECK(report.distance_bound > limit / 2);
    CHECK(report.stop == StopReason::target_met);
  };
  for (double limit : {0.0005, 0.002}) {
    check(GreedyOrder{}, limit);
    check(RelaxedOrder{}, limit);
    check(RelaxedOrder{.share = 1}, limit);
  }
}

TEST_CASE("Passes meet a number of faces, and leave a mesh") {
  const Soup input = test::with_noise(test::torus(40, 30), 3, 0.02);
  for (std::size_t faces : {2300u, 2000u, 1402u, 800u, 300u}) {
    test::Mesh mesh = test::make_mesh(input);
    const Report report =
        simplify<Quadric, OptimalPlacement>(mesh, FaceCount{faces}, RelaxedOrder{.share = 1});
    CHECK(report.faces_after == faces);
    CHECK(test::is_valid_triangle_mesh(mesh));
    CHECK(is_same_topology(test::topology_of(test::to_soup(mesh)), test::topology_of(input)));
  }
}
