// With KeepSolid{} a solid stays one, as CGAL sees it.
#include "hard_surfaces.h"
#include "meshes.h"
#include "soups.h"
#include "winding_number.h"

#include <quadrille/distance_limits.h>
#include <quadrille/guards.h>
#include <quadrille/hull.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/quadric.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>
#include <quadrille/verify.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using test::Position;
using test::Soup;
using test::Triangle;
namespace PMP = CGAL::Polygon_mesh_processing;
using Exact = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

Soup turned(Soup soup) {
  for (Triangle& t : soup.triangles)
    std::swap(t[0], t[1]);
  return soup;
}
Soup scaled(Soup soup, const Position& scale) {
  for (Position& p : soup.points)
    for (std::size_t i = 0; i < 3; ++i)
      p[i] *= scale[i];
  return soup;
}

/// Bumps that both sides of a wall have alike.
Soup with_bumps(Soup soup, double height) {
  for (Position& p : soup.points) {
    const Position q = p;
    for (std::size_t i = 0; i < 3; ++i)
      p[i] += height * std::sin(7 * q[(i + 1) % 3] + double(i)) * std::cos(5 * q[(i + 2) % 3]);
  }
  return soup;
}

Soup shell(double gap) {
  const Soup sphere = test::sphere(4);
  return with_bumps(test::joined(sphere, turned(scaled(sphere, {{1 - gap, 1 - gap, 1 - gap}}))),
                    0.06);
}

/// A closed box of thin walls.
Soup thin_walls(int n, double thickness) {
  const Soup cube = test::cube(n);
  const double inner = 1 - 2 * thickness;
  Soup cavity = turned(scaled(cube, {{inner, inner, inner}}));
  return with_bumps(test::joined(cube, cavity, {{thickness, thickness, thickness}}), 0.05);
}

/// The surface as CGAL's exact kernel sees it.
Exact exact(const Soup& soup) {
  return test::make_mesh<Exact>(soup);
}
std::size_t pairs(const Exact& mesh) {
  std::vector<std::pair<Exact::Face_index, Exact::Face_index>> found;
  PMP::self_intersections(mesh, std::back_inserter(found));
  return found.size();
}

/// A manifold solid stays one.
template <class Cost = Quadric>
Report check_solid(const Soup& input, const auto& stop) {
  Exact mesh = exact(input);
  REQUIRE((CGAL::is_closed(mesh) && pairs(mesh) == 0 && PMP::does_bound_a_volume(mesh)));
  const Exact before = mesh;
  const Report report = simplify<Cost>(mesh, stop, KeepSolid{});
  mesh.collect_garbage();
  INFO(report);
  CHECK(report.faces_after < report.faces_before);
  CHECK(CGAL::is_closed(mesh));
  CHECK(pairs(mesh) == 0);
  CHECK(PMP::does_bound_a_volume(mesh));
  CHECK(report.self_intersections->before == 0);
  CHECK(report.self_intersections->after == 0);
  CHECK(*report.volume_before == Approx(PMP::volume(before)).epsilon(1e-12));
  CHECK(*report.volume_after == Approx(PMP::volume(mesh)).epsilon(1e-12));
  const test::SoupTopology is = test::topology_of(test::to_soup(mesh)),
                           was = test::topology_of(input);
  CHECK(is.euler() == was.euler());
  CHECK(is.components == was.components);
  const Verdict verdict = verify(before, mesh, {.no_self_intersection = true, .solid = true});
  INFO(verdict);
  CHECK(verdict);
  return report;
}

/// The distance between the two components of a mesh.
double wall(const Exact& mesh) {
  std::map<Exact::Face_index, std::size_t> component;
  REQUIRE(PMP::connected_components(mesh, boost::make_assoc_property_map(component)) == 2);
  std::array<std::vector<CGAL::Epick::Triangle_3>, 2> sides;
  for (const auto& [face, side] : component) {
    const auto h = halfedge(face, mesh);
    sides[side].emplace_back(mesh.point(source(h, mesh)), mesh.point(target(h, mesh)),
                             mesh.point(target(next(h, mesh), mesh)));
  }
  double least = std::numeric_limits<double>::infinity();
  for (const auto& a : sides[0])
    for (const auto& b : sides[1])
      least = std::min(least, CGAL::squared_distance(a, b));
  return std::sqrt(least);
}

std::string complaint(Soup soup, const auto&... arguments) {
  test::PointSoup points(soup);
  const auto old = points.points;
  try {
    simplify(points.points, points.triangles, arguments...);
  } catch (const std::invalid_argument& error) {
    CHECK(points.points == old);
    CHECK(points.triangles == soup.triangles);
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("KeepSolid: what would pass through itself stays a solid") {
  for (const Soup& soup : {shell(0.03), thin_walls(14, 0.02)}) {
    Exact without = exact(soup);
    simplify(without, FaceRatio{0.06});
    without.collect_garbage();
    CHECK(pairs(without) > 0);
    check_solid(soup, FaceRatio{0.06});
    CHECK(check_solid(soup, FaceRatio{0.02}).rejected(Rejection::self_intersection) > 0);
    check_solid<MemorylessQuadric>(soup, FaceRatio{0.06});
  }
}

TEST_CASE("KeepSolid: nested parts, links, handles, and cubes that nearly touch") {
  check_solid(test::tori_in_each_other(24), FaceCount{100});
  check_solid(test::plate_with_holes(3, 4), FaceRatio{0.2});
  const Soup cube = test::cube(6);
  check_solid(test::joined(cube, cube, {{1.000001, 0, 0}}), FaceCount{30});
  Soup matryoshka = test::sphere(3);
  for (const double size : {0.9, 0.8, 0.7}) {
    const Soup inner = scaled(test::sphere(3), {{size, size, size}});
    matryoshka = test::joined(matryoshka, size == 0.8 ? inner : turned(inner));
  }
  check_solid(with_bumps(matryoshka, 0.02), FaceRatio{0.1});
}

TEST_CASE("KeepSolid: walls lose no more than twice a limit of both ways") {
  Exact mesh = exact(thin_walls(8, 0.06));
  const double before = wall(mesh), limit = before / 3;
  const Report report = simplify(mesh, HausdorffLimit{limit}, KeepSolid{});
  mesh.collect_garbage();
  CHECK(report.faces_after < report.faces_before);
  CHECK(report.hausdorff_bound <= limit);
  CHECK(wall(mesh) >= before - 2 * limit);
}

TEST_CASE("KeepSolid: a limit of the distance goes with hulls") {
  const Soup ball = test::sphere(3);
  const Soup soup = with_bumps(test::joined(ball, turned(scaled(ball, {{0.9, 0.9, 0.9}}))), 0.06);
  const double limit = 0.1;
  const auto check = [&]<class Hull>(Hull) {
    test::PointSoup hull(soup);
    const Report report = simplify<MemorylessQuadric, Hull>(hull.points, hull.triangles,
                                                            HausdorffLimit{limit}, KeepSolid{});
    INFO(report);
    CHECK(report.faces_after < report.faces_before / 2);
    CHECK(report.hausdorff_bound <= limit);
    const Soup result = test::to_soup(hull);
    const Verdict verdict = verify(test::points_of(soup), soup.triangles, test::points_of(result),
                                   result.triangles, {.distance_both_ways = limit, .solid = true});
    INFO(verdict);
    CHECK(verdict);
    // No point that is inside of the smaller one is outside of the larger one.
    const bool is_outer = std::is_same_v<Hull, OuterHull>;
    const Soup &inner = is_outer ? soup : result, &outer = is_outer ? result : soup;
    const test::WindingNumber of_inner(inner), of_outer(outer);
    test::Random random(5);
    std::size_t seen = 0, outside = 0;
    for (int i = 0; i < 1000; ++i) {
      const Position p = random(0.8, 1.1) * soup.points[random.below(soup.points.size())];
      const auto in_inner = of_inner(p), in_outer = of_outer(p);
      seen += in_inner == 1;
      outside += in_inner && in_outer && *in_inner > *in_outer;
    }
    CHECK(seen > 100);
    CHECK(outside == 0);
    CHECK((*report.volume_after > *report.volume_before) == is_outer);
  };
  check(OuterHull{});
  check(InnerHull{});
}

TEST_CASE("KeepSolid: closed models") {
  for (const char* name : {"elephant", "pinion_small", "triceratops"}) {
    INFO(name);
    Exact mesh;
    const Soup soup = test::to_soup(test::read_model(name));
    if (pairs(exact(soup)) > 0 || !CGAL::is_closed(exact(soup)))
      CHECK_FALSE(complaint(soup, KeepSolid{}).empty());
    else
      check_solid<MemorylessQuadric>(soup, FaceRatio{0.1});
  }
}

TEST_CASE("KeepSolid: solids that touch along an edge or at a point stay closed") {
  const auto check = [](const Soup& soup) {
    test::PointSoup result(soup);
    const Report report = simplify(result.points, result.triangles, FaceCount{8}, KeepSolid{});
    INFO(report);
    CHECK(report.faces_after < report.faces_before);
    const Verdict verdict = verify(test::points_of(soup), soup.triangles, result.points,
                                   result.triangles, {.no_self_intersection = true, .solid = true});
    INFO(verdict);
    CHECK(verdict);
  };
  check(test::surface_of_cubes(4, 4, 2, [](int x, int y, int) { return x / 2 == y / 2; }));
  check(test::surface_of_cubes(
      4, 4, 4, [](int x, int y, int z) { return x / 2 == y / 2 && y / 2 == z / 2; }));
}

TEST_CASE("KeepSolid: what is no solid is refused, and told where") {
  Soup open = test::sphere(2);
  const Triangle gone = open.triangles.back();
  open.triangles.pop_back();
  const std::string is_open = complaint(open, KeepSolid{});
  CAPTURE(is_open);
  CHECK(is_open.find("KeepSolid: the surface is not closed: 3 edges") != std::string::npos);
  bool is_of_face = false; // the place that it tells is a corner of the face that is gone
  for (const std::uint32_t v : gone) {
    const Position& p = open.points[v];
    is_of_face |= is_open.find("from (" + internal::text_of(p[0]) + ", " + internal::text_of(p[1]) +
                               ", " + internal::text_of(p[2]) + ")") != std::string::npos;
  }
  CHECK(is_of_face);
  const std::string is_turned =
      complaint(test::joined(test::tetrahedron(), test::triangle(), {{4, 0, 0}}), KeepSolid{});
  CHECK(is_turned.find(": 3 edges") != std::string::npos);

  const Soup crossing = test::joined(test::sphere(2), test::sphere(2), {{0.7, 0.1, 0.2}});
  const std::string crosses = complaint(crossing, KeepSolid{});
  CHECK(crosses.find("intersects itself: " + std::to_string(pairs(exact(crossing))) +
                     " pairs of faces do, the first one near (") != std::string::npos);

  const Soup sphere = test::sphere(2);
  CHECK(complaint(sphere, KeepSolid{}, Topology::free).find("keeps the topology") !=
        std::string::npos);
  CHECK_FALSE(complaint(sphere, KeepSolid{}, Topology::components_may_vanish).empty());
  CHECK(complaint(sphere, KeepSolid{}, Topology::kept).empty());
  test::PointSoup cubes(test::joined(test::cube(4), test::cube(4), {{1.001, 0, 0}}));
  const Report report = simplify(cubes.points, cubes.triangles, FaceCount{40}, KeepSolid{},
                                 ThresholdPairs(0.01)); // topology is kept still
  CHECK(report.components_after == 2);
  CHECK(report.non_edge_contractions == 0);
}

TEST_CASE("KeepSolid: chosen at run time, it is as if it were not there") {
  Soup open = test::grid(8, 8);
  std::optional<KeepSolid> choice;
  CHECK(complaint(open, choice, Topology::free).empty());
  test::Mesh mesh = test::make_mesh(test::sphere(2));
  CHECK_FALSE(simplify(mesh, choice).self_intersections.has_value());
  CHECK_FALSE(simplify(mesh, choice).volume_before.has_value());
  choice = KeepSolid{};
  CHECK(simplify(mesh, choice).self_intersections.has_value());
  CHECK(simplify(mesh, choice).volume_before.has_value());
}
