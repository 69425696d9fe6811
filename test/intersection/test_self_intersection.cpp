// With NoSelfIntersection no faces come to intersect, as CGAL's Polygon_mesh_processing sees it.
#include "meshes.h"
#include "soups.h"

#include <quadrille/guards.h>
#include <quadrille/internal/core/surface/box_tree.h>
#include <quadrille/internal/guards/intersection/face_sides.h>
#include <quadrille/internal/guards/intersection/flat_fan.h>
#include <quadrille/internal/guards/intersection/triangle_pair.h>
#include <quadrille/internal/verify/checked_surface.h>
#include <quadrille/internal/verify/intersecting_pairs.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/parameters.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>
#include <quadrille/verify.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/intersections.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using internal::Index;
using test::Position;
using test::Soup;
namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
template <class Point>
using Mesh = CGAL::Surface_mesh<Point>;

template <class Point>
Mesh<Point> mesh_of(const Soup& soup) {
  std::vector<Point> points;
  for (const Position& p : soup.points) {
    using Number = typename CGAL::Kernel_traits<Point>::Kernel::FT;
    points.push_back({Number(p[0]), Number(p[1]), Number(p[2])});
  }
  Mesh<Point> mesh;
  PMP::polygon_soup_to_polygon_mesh(points, soup.triangles, mesh);
  return mesh;
}

/// How many pairs of faces of a mesh intersect, whatever its kernel.
template <class Point>
std::size_t intersections(const Mesh<Point>& mesh) {
  Mesh<Kernel::Point_3> copy;
  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 3>> faces;
  std::vector<std::size_t> numbers(mesh.num_vertices());
  for (const auto v : mesh.vertices()) {
    numbers[v] = points.size();
    const auto& p = mesh.point(v);
    points.push_back({double(p.x()), double(p.y()), double(p.z())});
  }
  for (const auto f : mesh.faces()) {
    std::array<std::size_t, 3> face;
    std::size_t i = 0;
    for (const auto v : vertices_around_face(mesh.halfedge(f), mesh))
      face[i++] = numbers[v];
    faces.push_back(face);
  }
  PMP::polygon_soup_to_polygon_mesh(points, faces, copy);
  std::vector<std::pair<Mesh<Kernel::Point_3>::Face_index, Mesh<Kernel::Point_3>::Face_index>>
      pairs;
  PMP::self_intersections(copy, std::back_inserter(pairs));
  return pairs.size();
}
std::size_t intersections(const Soup& soup) {
  return intersections(mesh_of<Kernel::Point_3>(soup));
}

/// A sheet that is folded upon itself as a hairpin, with waves that go through both sides alike.
Soup hairpin(std::uint32_t n, double gap) {
  Soup soup = test::grid(2 * n, n);
  for (Position& p : soup.points) {
    const double along = 2 * n * p[0], across = n * p[1];
    const double turn = std::clamp(along - (n - 2.0), 0.0, 4.0) / 4 * 3.14159265358979;
    const double x = along < n - 2 ? along : along > n + 2 ? 2 * n - along : n - 2 + std::sin(turn);
    const double wave = std::clamp((n - 4.0 - x) / 8, 0.0, 1.0);
    const double height = 0.5 * gap * std::cos(turn);
    p = {{x, across, height + wave * std::sin(0.25 * x) * std::cos(0.2 * across)}};
  }
  return soup;
}

/// A shell of two spheres, with bumps that both have.
Soup shell(double gap) {
  const auto bumpy = [](double radius) {
    Soup soup = test::sphere(4);
    for (Position& p : soup.points) {
      const double length = std::sqrt(dot(p, p));
      const double bump = 0.1 * std::sin(9 * p[0] / length) * std::sin(8 * p[1] / length + 1);
      p = (radius * (1 + bump) / length) * p;
    }
    return soup;
  };
  return test::joined(bumpy(1), bumpy(1 - gap));
}

template <class Cost = Quadric, class Placement = OptimalPlacement>
Report simplify_soup_of(Soup& soup, const auto&... arguments) {
  std::vector<std::array<double, 3>> points;
  for (const Position& p : soup.points)
    points.push_back(p.coordinates);
  const Report report = simplify<Cost, Placement>(points, soup.triangles, arguments...);
  soup.points.clear();
  for (const auto& p : points)
    soup.points.push_back({p});
  return report;
}

template <class Cost>
void check_apart(const Soup& input, double ratio, bool crosses_without = true) {
  Soup without = input, with = input;
  simplify_soup_of<Cost>(without, FaceRatio{ratio});
  if (crosses_without)
    CHECK(intersections(without) > 0);
  const Report report = simplify_soup_of<Cost>(with, FaceRatio{ratio}, NoSelfIntersection{});
  INFO(report);
  CHECK(intersections(with) == 0);
  CHECK(report.rejected(Rejection::self_intersection) > 0);
  CHECK(report.self_intersections->before == 0);
  CHECK(report.self_intersections->after == 0);
  CHECK(report.faces_after < report.faces_before / 3);
}

/// Each kind of triangle pair on a small lattice, where much is on a line or in a plane.
template <class Visit>
void for_each_lattice_pair(Visit visit) {
  test::Random random(7);
  for (int n = 0; n < 60000; ++n) {
    const double extent = n % 2 == 0 ? 3 : 6;
    std::array<Vector<3>, 6> points;
    for (Vector<3>& p : points)
      for (std::size_t i = 0; i < 3; ++i)
        p[i] = std::floor(random(0, extent)) * (i == 2 && n % 3 == 0 ? 0 : 1);
    const auto common = static_cast<Index>(n % 4 == 3 ? 0 : n % 4);
    internal::FaceCorners a{{0, 1, 2}, {points[0], points[1], points[2]}};
    internal::FaceCorners b{{3, 4, 5}, {points[3], points[4], points[5]}};
    for (Index i = 0; i < common; ++i) {
      const Index to = (i + static_cast<Index>(n / 4)) % 3, from = (i + 1) % 3;
      b.vertices[to] = a.vertices[from];
      b.points[to] = a.points[from];
    }
    visit(a, b, common);
  }
}

Kernel::Point_3 point(const Vector<3>& p) {
  return {p[0], p[1], p[2]};
}
Kernel::Triangle_3 triangle(const internal::FaceCorners& face) {
  return {point(face.points[0]), point(face.points[1]), point(face.points[2])};
}

/// By CGAL alone, without a filter: what the part beyond the common vertices meets.
bool do_intersect(const internal::FaceCorners& a, const internal::FaceCorners& b, Index common) {
  const Kernel::Triangle_3 s = triangle(a), t = triangle(b);
  if (s.is_degenerate() || t.is_degenerate())
    return false;
  if (common == 0)
    return CGAL::do_intersect(s, t);
  const auto others = [](const internal::FaceCorners& of, const internal::FaceCorners& in) {
    std::vector<Kernel::Point_3> points;
    for (std::size_t i = 0; i < 3; ++i)
      if (std::find(in.vertices.begin(), in.vertices.end(), of.vertices[i]) == in.vertices.end())
        points.push_back(point(of.points[i]));
    return points;
  };
  const auto p = others(a, b), q = others(b, a);
  if (common == 1)
    return CGAL::do_intersect(s, Kernel::Segment_3(q[0], q[1])) ||
           CGAL::do_intersect(t, Kernel::Segment_3(p[0], p[1]));
  // Of one edge: in one plane, on the same side of it. Numbers are small, so doubles are exact.
  std::vector<Vector<3>> ends;
  for (std::size_t i = 0; i < 3; ++i)
    if (point(a.points[i]) != p[0])
      ends.push_back(a.points[i]);
  const auto upright = [&](const Kernel::Point_3& apex) {
    return cross(ends[1] - ends[0], Vector<3>{{apex.x(), apex.y(), apex.z()}} - ends[0]);
  };
  return cross(upright(p[0]), upright(q[0])) == Vector<3>{} &&
         dot(upright(p[0]), upright(q[0])) > 0;
}

/// Two faces as verify() sees them.
TriangleSoup<> checked_pair(const internal::FaceCorners& a, const internal::FaceCorners& b) {
  TriangleSoup<> surface;
  surface.points.resize(6);
  for (const internal::FaceCorners& face : {a, b})
    for (std::size_t i = 0; i < 3; ++i)
      surface.points[face.vertices[i]] = face.points[i];
  surface.triangles = {{a.vertices[0], a.vertices[1], a.vertices[2]},
                       {b.vertices[0], b.vertices[1], b.vertices[2]}};
  return surface;
}

/// Two boxes side by side, each with vertices of its own where they touch, in waves that both have.
Soup boxes_that_touch() {
  const Soup box = test::surface_of_cubes(6, 6, 6, [](int, int, int) { return true; });
  Soup soup = test::joined(box, box, {{6, 0, 0}});
  for (Position& p : soup.points)
    p = p + 0.1 * (std::sin(6 * p[0]) + std::sin(7 * p[1]) + std::sin(8 * p[2])) *
                Position{{0.3, 0.4, 0.5}};
  return soup;
}

} // namespace

TEST_CASE("Triangles intersect as CGAL says, whatever they have in common") {
  std::array<int, 3> met{}, apart{}, separated{};
  for_each_lattice_pair(
      [&](const internal::FaceCorners& a, const internal::FaceCorners& b, Index common) {
        const bool expected = do_intersect(a, b, common);
        CAPTURE(common);
        REQUIRE(internal::TrianglePair(a, b).intersect() == expected);
        REQUIRE(internal::TrianglePair(b, a).intersect() == expected);
        REQUIRE(internal::is_degenerate(a) == triangle(a).is_degenerate());
        ++(expected ? met : apart)[common];
        if (internal::FaceSides(a).separate(b)) {
          REQUIRE_FALSE(expected);
          ++separated[common];
        }
      });
  for (std::size_t common = 0; common < 3; ++common)
    CHECK((met[common] > 300 && apart[common] > 300));
  CHECK((separated[0] > 300 && separated[1] > 300 && separated[2] == 0));
}

TEST_CASE("Points next to a plane lie on one side of it as CGAL says, or it is not told") {
  test::Random random(11);
  const auto vector = [&] { return Vector<3>{{random(-1, 1), random(-1, 1), random(-1, 1)}}; };
  int told = 0, on_both_sides = 0;
  for (int round = 0; round < 20000; ++round) {
    const Vector<3> a = vector(), u = vector(), v = vector();
    const std::array face{a, a + u, a + v};
    const double off = std::ldexp(random(-1, 1), -static_cast<int>(random.below(60)));
    const auto beside = [&] { return a + random(-2, 2) * u + random(-2, 2) * v + off * vector(); };
    const std::array other{beside(), beside(), beside()};
    const std::size_t but = random.below(4);
    int front = 0, back = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto side =
          CGAL::orientation(point(face[0]), point(face[1]), point(face[2]), point(other[i]));
      front += i != but && side == CGAL::POSITIVE;
      back += i != but && side == CGAL::NEGATIVE;
    }
    const bool is_on_one_side = (std::max)(front, back) == (but < 3 ? 2 : 3);
    on_both_sides += !is_on_one_side;
    if (internal::FacePlane(face).has_on_one_side(other, but)) {
      REQUIRE(is_on_one_side);
      ++told;
    }
  }
  CHECK((told > 3000 && on_both_sides > 3000));
}

TEST_CASE(
    "Triangles pass through each other as rational numbers say, and do not if they only touch") {
  std::array<int, 2> through{}, touching{};
  internal::CheckProgress progress({}, 1);
  for_each_lattice_pair(
      [&](const internal::FaceCorners& a, const internal::FaceCorners& b, Index common) {
        const bool met = internal::TrianglePair(a, b).intersect();
        if (common > 1 || !met) {
          REQUIRE_FALSE(internal::TrianglePair(a, b).pass_through());
          return;
        }
        const bool expected =
            internal::IntersectingPairs(checked_pair(a, b)).find(progress).pass_through.count == 1;
        CAPTURE(common);
        REQUIRE(internal::TrianglePair(a, b).pass_through() == expected);
        REQUIRE(internal::TrianglePair(b, a).pass_through() == expected);
        ++(expected ? through : touching)[common];
      });
  for (std::size_t common = 0; common < 2; ++common)
    CHECK((through[common] > 300 && touching[common] > 300));
}

TEST_CASE(
    "Faces that go once around a vertex do not intersect, and others are not taken for such") {
  struct Face {
    internal::FaceCorners corners;
  };
  const auto fan = [](std::size_t n, double turns, double slope) {
    std::vector<Face> faces;
    const auto corner = [&](std::size_t i) {
      const double angle = turns * 6.283185307179586 * static_cast<double>(i % n) / double(n) + 0.1;
      return Vector<3>{{std::cos(angle), std::sin(angle), slope * std::cos(3 * angle)}};
    };
    for (std::size_t i = 0; i < n; ++i)
      faces.push_back(
          {{{0, Index(1 + i), Index(1 + (i + 1) % n)}, {Vector<3>{}, corner(i), corner(i + 1)}}});
    return faces;
  };
  internal::FlatFan flat;
  CHECK(flat.is(fan(5, 1, 0)));
  CHECK(flat.is(fan(9, 1, 0.5)));
  CHECK_FALSE(flat.is(fan(7, 2, 0))); // twice around
  CHECK(flat.is(fan(9, 1, 5)));       // however steep
  std::vector<Face> open = fan(6, 1, 0);
  open.pop_back();
  CHECK_FALSE(flat.is(open)); // that it does not overlap is for others to see
  std::vector<Face> turned = fan(6, 1, 0);
  std::swap(turned[2].corners.points[1], turned[3].corners.points[2]);
  CHECK_FALSE(flat.is(turned));
}

TEST_CASE("A tree finds the boxes that meet another one, also after they have moved") {
  test::Random random(3);
  const auto box = [&](double size) {
    internal::FloatBox box = internal::FloatBox::empty();
    const double x = random(0, 10), y = random(0, 10), z = random(0, 10);
    for (int corner = 0; corner < 2; ++corner)
      box.add(std::array{float(x + corner * random(0, size)), float(y + corner * random(0, size)),
                         float(z + corner * random(0, size))});
    return box;
  };
  for (const std::size_t count : std::array<std::size_t, 7>{0, 1, 8, 9, 64, 65, 700}) {
    internal::BoxTree tree(count);
    std::vector<internal::FloatBox> boxes;
    for (std::size_t slot = 0; slot < count; ++slot)
      tree.put(slot, boxes.emplace_back(box(slot % 50 == 0 ? 8 : 1)));
    tree.fit();
    for (int round = 0; round < 50; ++round) {
      const internal::FloatBox asked = box(3);
      std::vector<std::size_t> found, expected;
      tree.for_each_meeting(asked, [&](std::size_t slot, const internal::FloatBox& its) {
        REQUIRE(its == boxes[slot]);
        found.push_back(slot);
      });
      for (std::size_t slot = 0; slot < count; ++slot)
        if (boxes[slot].meets(asked))
          expected.push_back(slot);
      REQUIRE(found == expected);
      for (std::size_t slot = static_cast<std::size_t>(round) % 7; slot < count; slot += 7)
        tree.move(slot, boxes[slot] = slot % 3 == 0 ? internal::FloatBox::empty() : box(1));
    }
  }
}

TEST_CASE("A folded sheet does not pass through itself") {
  check_apart<Quadric>(hairpin(40, 0.1), 0.02);
  check_apart<MemorylessQuadric>(hairpin(40, 0.1), 0.02);
}

TEST_CASE("Nested surfaces stay nested") {
  // Large parts keep their shape, by which one of the two stays apart by itself.
  check_apart<Quadric>(shell(0.03), 0.05, false);
  check_apart<MemorylessQuadric>(shell(0.03), 0.05, false);
}

TEST_CASE("Shells close together are simplified as far as by endpoints") {
  Soup shells;
  for (const double radius : {1.0, 0.98, 0.96})
    shells =
        test::joined(std::move(shells),
                     test::mapped(test::sphere(3), [&](const Position& p) { return radius * p; }));
  const auto faces_left = [&](auto placement) {
    Soup soup = shells;
    simplify_soup_of<Quadric, decltype(placement)>(soup, FaceCount{4}, NoSelfIntersection{});
    CHECK(intersections(mesh_of<Kernel::Point_3>(soup)) == 0);
    return soup.triangles.size();
  };
  CHECK(2 * faces_left(OptimalPlacement{}) <= 3 * faces_left(EndpointPlacement{}));
}

TEST_CASE("No shell is crushed while pairs of the others wait for it to make way") {
  Soup shells;
  for (const double radius : {1.0, 0.99, 0.98})
    shells =
        test::joined(std::move(shells),
                     test::mapped(test::sphere(4), [&](const Position& p) { return radius * p; }));
  const Report report =
      simplify_soup_of<MemorylessQuadric>(shells, FaceRatio{0.07}, NoSelfIntersection{});
  CHECK(report.self_intersections->after == 0);
  CHECK(report.faces_after < 440);
  CHECK(report.error < 0.2);
}

TEST_CASE("What is written does not intersect, in floats, far from the origin") {
  Soup soup = shell(0.01);
  for (Position& p : soup.points)
    p += Position{{1000, 0, 0}};
  const auto check = [&](auto mesh) {
    REQUIRE(intersections(mesh) == 0);
    const Report report = simplify(mesh, FaceRatio{0.1}, NoSelfIntersection{});
    mesh.collect_garbage();
    CHECK(report.self_intersections->after == 0);
    CHECK(report.rejected(Rejection::self_intersection) > 0);
    CHECK(intersections(mesh) == 0);
  };
  check(mesh_of<CGAL::Simple_cartesian<float>::Point_3>(soup));
  check(mesh_of<Kernel::Point_3>(soup));
}

TEST_CASE("A target is rounded as it will be written before it is looked at") {
  Soup soup = test::as_floats(shell(0.03));
  Soup doubles = soup;
  simplify_soup_of(soup, FaceRatio{0.2}, NoSelfIntersection{},
                   parameters::coordinates_are_floats(true));
  CHECK(test::is_identical(soup, test::as_floats(soup)));
  simplify_soup_of(doubles, FaceRatio{0.2}, NoSelfIntersection{}); // that happen to be floats
  CHECK_FALSE(test::is_identical(doubles, test::as_floats(doubles)));
}

TEST_CASE("Faces around a vertex do not fold upon each other") {
  // 5-4
  // |b|    of a letter L, from a nothing is seen of the corner 4, and from b nothing of 2
  // | 3-2
  // | a |
  // 0---1
  using Triangle = internal::TriangleComplex::Triangle;
  internal::Array<Vector<3>> points;
  for (const auto& [x, y] : std::vector<std::array<double, 2>>{
           {0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}, {1.2, 0.3}, {0.3, 1.2}})
    points.push_back({{x, y, 0}});
  internal::Array<Triangle> triangles;
  for (const Triangle& t : std::vector<Triangle>{
           {6, 0, 1}, {6, 1, 2}, {6, 2, 3}, {6, 3, 7}, {6, 7, 0}, {7, 3, 4}, {7, 4, 5}, {7, 5, 0}})
    triangles.push_back(t);
  internal::TriangleComplex complex(points.size(), triangles);
  const internal::Geometry<3> geometry(complex, points, {}, internal::Threads());
  internal::FaceIntersections<3> faces(complex, geometry);
  Report report;
  faces.begin(report);
  REQUIRE(faces.count() == 0);
  internal::PairStar star;
  star.gather(complex, 6, 7);
  CHECK(faces.makes_intersection(star, 6, 7, points[6]));
  CHECK(faces.makes_intersection(star, 6, 7, points[7]));
  CHECK_FALSE(faces.makes_intersection(star, 6, 7, {{0.75, 0.75, 0}}));
}

TEST_CASE("A surface does not pass over what it would not meet before or afterwards") {
  using Triangle = internal::TriangleComplex::Triangle;
  const auto refuses = [](const std::vector<Vector<3>>& places, const std::vector<Triangle>& faces,
                          const Vector<3>& target) {
    internal::Array<Vector<3>> points;
    for (const Vector<3>& p : places)
      points.push_back(p);
    internal::Array<Triangle> triangles;
    for (const Triangle& t : faces)
      triangles.push_back(t);
    internal::TriangleComplex complex(points.size(), triangles);
    const internal::Geometry<3> geometry(complex, points, {}, internal::Threads());
    internal::FaceIntersections<3> checked(complex, geometry);
    Report report;
    checked.begin(report);
    REQUIRE(checked.count() == 0);
    internal::PairStar star;
    star.gather(complex, 4, 5);
    return checked.makes_intersection(star, 4, 5, target);
  };
  // A pair, 4 and 5, on a square.
  std::vector<Vector<3>> places{{{-2, -2, 0}}, {{2, -2, 0}}, {{2, 2, 0}},
                                {{-2, 2, 0}},  {{-1, 0, 0}}, {{1, 0, 0}}};
  std::vector<Triangle> faces{{0, 1, 4}, {1, 5, 4}, {1, 2, 5}, {2, 3, 5}, {3, 4, 5}, {3, 0, 4}};
  SECTION("a small tetrahedron over it") {
    for (const Vector<3>& p :
         {Vector<3>{{0.1, 0.1, 0.5}}, {{0.3, 0.1, 0.5}}, {{0.1, 0.3, 0.5}}, {{0.1, 0.1, 0.7}}})
      places.push_back(p);
    for (const Triangle& t : {Triangle{6, 8, 7}, {6, 7, 9}, {7, 8, 9}, {8, 6, 9}})
      faces.push_back(t);
    CHECK_FALSE(refuses(places, faces, {{0, 0, 0.1}}));
    CHECK_FALSE(refuses(places, faces, {{0, 0, -4}}));
    CHECK(refuses(places, faces, {{0, 0, 0.6}})); // through it
    CHECK(refuses(places, faces, {{0, 0, 4}}));
  }
  SECTION("a face along the side of a tetrahedron between two") {
    places.insert(places.end(), {{{0.2, 0, 0.5}}, {{0.6, 0, 0.5}}, {{0.3, 0, 0.8}}});
    faces.push_back({6, 7, 8});
    CHECK(refuses(places, faces, {{0, 0, 4}}));
  }
  SECTION("the other side of a body that is nothing else") {
    faces.push_back({0, 2, 1}); // with a roof
    faces.push_back({0, 3, 2});
    places[4][2] = places[5][2] = 1;
    CHECK_FALSE(refuses(places, faces, {{0, 0, 0.1}}));
    CHECK_FALSE(refuses(places, faces, {{0, 0, 4}}));
    CHECK(refuses(places, faces, {{0, 0, -0.1}}));
  }
  SECTION("of two bodies that touch along an edge, one between the faces of the other") {
    places = {{{0, 0, 1}}, {{1, 0, 0.5}}, {{8.66, -5, 0.5}},   {{-10, 0, 0.5}},
              {{0, 0, 0}}, {{1, 1, -5}},  {{0.5, 0.866, 0.5}}, {{1, 0, -5}}};
    faces = {{4, 0, 1}, {4, 2, 0}, {4, 0, 3}, {4, 6, 0}, {5, 1, 7}};
    CHECK_FALSE(refuses(places, faces, {{0.1, 0.05, 0}}));
    CHECK(refuses(places, faces, {{3, -1, 0}}));
  }
  SECTION("where it goes within its plane nothing is passed over") {
    for (Vector<3>& p : places)
      p = {{p[0] + 0.3 * p[1], p[1] - 0.7 * p[0], 0.31 * p[0] + 0.17 * p[1]}};
    places.push_back({{1.9, 0.4, 0.31 * 1.9 + 0.17 * 0.4 + 1e-9}});
    places.push_back({{2.1, 0.4, 0.31 * 2.1 + 0.17 * 0.4 + 1e-9}});
    places.push_back({{2.1, 0.6, 0.31 * 2.1 + 0.17 * 0.6 + 1e-9}});
    faces.push_back({6, 7, 8}); // just over it
    CHECK_FALSE(refuses(places, faces, {{0.31, 0.2, 0.31 * 0.31 + 0.17 * 0.2}}));
  }
}

TEST_CASE("What intersects may stay so while its vertices move") {
  Soup soup = test::grid(40, 1); // all of it, through one face
  soup.points.insert(soup.points.end(), {{{-1, 0.5, -1}}, {{3, 0.5, -1}}, {{0.5, 0.5, 3}}});
  const auto end = static_cast<std::uint32_t>(soup.points.size());
  soup.triangles.push_back({end - 3, end - 2, end - 1});
  const Report report = simplify_soup_of(soup, FaceCount{5}, NoSelfIntersection{});
  INFO(report);
  CHECK(report.faces_after <= 5);
  CHECK(report.self_intersections->before == 80);
  CHECK(report.self_intersections->after == report.faces_after - 1);
}

TEST_CASE("What touches may go on touching, but does not come to pass through") {
  const Soup soup = boxes_that_touch();
  const auto check = [&]<class Placement>(Placement) {
    Soup result = soup;
    const Report report =
        simplify_soup_of<Quadric, Placement>(result, FaceRatio{0.2}, NoSelfIntersection{});
    INFO(report);
    CHECK(report.self_intersections->before > 1000);
    CHECK(report.faces_after <= report.faces_before / 5);
    const Verdict verdict = verify(test::points_of(soup), soup.triangles, test::points_of(result),
                                   result.triangles, Claims{.no_self_intersection = true});
    INFO(verdict);
    REQUIRE(verdict.findings.size() == 2);
    CHECK(verdict.findings[1].promised == 0);
    CHECK(verdict.findings[1].measured == 0);
  };
  check(OptimalPlacement{});
  check(EndpointPlacement{});
}

TEST_CASE("Pairs of the input that intersect are counted, and become no more") {
  Soup soup = test::joined(shell(0.05), test::sphere(4), {{0.7, 0.1, 0.2}});
  const std::size_t before = intersections(soup);
  REQUIRE(before > 100);
  for (double ratio : {1.0, 0.5, 0.1, 0.02}) {
    Soup result = soup;
    const Report report = simplify_soup_of(result, FaceRatio{ratio}, NoSelfIntersection{});
    INFO(report);
    CHECK(report.self_intersections->before == before);
    CHECK(report.self_intersections->after == intersections(result));
    CHECK(report.self_intersections->after <= before);
  }
}

TEST_CASE(
    "Faces are kept apart with free topology, parts that vanish, pairs and degenerate faces") {
  Soup soup = shell(0.01);
  const auto check = [](Soup result, const auto&... arguments) {
    const Report report = simplify_soup_of<MemorylessQuadric>(result, FaceRatio{0.05},
                                                              NoSelfIntersection{}, arguments...);
    INFO(report);
    CHECK(report.faces_after < report.faces_before / 2);
    CHECK(report.self_intersections->before == 0);
    CHECK(report.self_intersections->after == 0);
    if (report.non_manifold_edges + report.non_manifold_vertices == 0) // else it can be no mesh
      CHECK(intersections(result) == 0);
  };
  check(soup, Topology::free);
  check(soup, ThresholdPairs{0.02});
  for (int i = 0; i < 40; ++i)
    soup = test::joined(soup, test::tetrahedron(), {{3.0 + 2 * i, 0, 0}});
  check(soup, Topology::components_may_vanish);
  soup.triangles.push_back({0, 0, 1});              // of two vertices
  soup.triangles.push_back(soup.triangles.front()); // doubled
  auto [a, b, c] = soup.triangles[1];               // and the back of one
  soup.triangles.push_back({c, b, a});
  soup.points.push_back(0.5 * (soup.points[a] + soup.points[b]));
  check(soup);
  // A face without an area, along an edge of others.
  soup.triangles.push_back({a, b, static_cast<std::uint32_t>(soup.points.size() - 1)});
  Soup result = soup;
  CHECK_NOTHROW(simplify_soup_of(result, FaceRatio{0.1}, NoSelfIntersection{}));
}

TEST_CASE("Where nothing meets, the result is the same as without") {
  const Soup soup = test::with_noise(test::torus(60, 30), 4, 0.001);
  Soup without = soup, with = soup;
  const Report plain = simplify_soup_of(without, FaceRatio{0.2});
  const Report report = simplify_soup_of(with, FaceRatio{0.2}, NoSelfIntersection{});
  REQUIRE(report.rejected(Rejection::self_intersection) == 0);
  CHECK(test::is_identical(without, with));
  CHECK_FALSE(plain.self_intersections);
  Soup off = soup;
  CHECK_FALSE(simplify_soup_of(off, FaceRatio{0.2}, std::optional<NoSelfIntersection>())
                  .self_intersections);
}

TEST_CASE("The report tells of intersections, where that is asked for") {
  Soup soup = test::joined(test::sphere(2), test::sphere(2), {{0.5, 0, 0}});
  const Report report = simplify_soup_of(soup, FaceRatio{0.5}, NoSelfIntersection{});
  std::ostringstream text;
  text << report;
  CHECK(text.str().find("self-intersections " + std::to_string(report.self_intersections->before) +
                        " -> ") != std::string::npos);
  CHECK(to_string(Rejection::self_intersection) == "self-intersection");
}

TEST_CASE("Passes are refused, since their blocks do not see each other") {
  Soup soup = test::sphere(2);
  const Soup input = soup;
  CHECK_THROWS_WITH(simplify_soup_of(soup, NoSelfIntersection{}, AnyOrder(RelaxedOrder{})),
                    Catch::Contains("NoSelfIntersection needs GreedyOrder"));
  CHECK(test::is_identical(soup, input));
  CHECK_NOTHROW(
      simplify_soup_of(soup, std::optional<NoSelfIntersection>(), AnyOrder(RelaxedOrder{})));
  CHECK_NOTHROW(simplify_soup_of(soup, NoSelfIntersection{}, AnyOrder(GreedyOrder{})));
}
