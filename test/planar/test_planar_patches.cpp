// Planar patches: on voxels, of which the corners and what is covered can be counted, and what is
// promised of any surface.

#include "farthest.h"
#include "meshes.h"
#include "soups.h"
#include "textured.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/property_map.h>
#include <quadrille/channels.h>
#include <quadrille/planar_patches.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using Catch::Contains;
using test::Position;
using test::Soup;
using test::Triangle;

PlanarReport remesh(Soup& soup,
                    const PlanarTolerance& tolerance = PlanarTolerance::relative(1e-9)) {
  test::PointSoup points(soup);
  const PlanarReport report = remesh_planar_patches(points.points, points.triangles, tolerance);
  soup = test::to_soup(points);
  return report;
}

// --- Voxels --------------------------------------------------------------------------------------

constexpr int side = 6;
using Cubes = std::set<std::array<int, 3>>;

Cubes random_cubes(std::uint64_t seed, double density) {
  test::Random random(seed);
  Cubes cubes;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z)
        if (random(0, 1) < density)
          cubes.insert({x, y, z});
  return cubes;
}

Soup surface_of(const Cubes& cubes) {
  return test::surface_of_cubes(side, side, side, [&](int x, int y, int z) {
    return cubes.contains({x, y, z});
  });
}

/// Where the eight cubes around a point of the grid are not the same ones after a step along any
/// axis, there is a corner: an edge or a plane through the point goes on.
std::size_t count_corners(const Cubes& cubes) {
  std::size_t count = 0;
  for (int x = 0; x <= side; ++x)
    for (int y = 0; y <= side; ++y)
      for (int z = 0; z <= side; ++z) {
        bool goes_on = false;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          bool is_same = true;
          for (int k = 0; k < 4; ++k) {
            std::array<int, 3> cube{x, y, z};
            cube[(axis + 1) % 3] -= k % 2;
            cube[(axis + 2) % 3] -= k / 2;
            std::array<int, 3> other = cube;
            --other[axis];
            is_same &= cubes.contains(cube) == cubes.contains(other);
          }
          goes_on |= is_same;
        }
        count += !goes_on;
      }
  return count;
}

/// Two points in each unit square of the planes of the grid, and how often triangles cover them:
/// axis, coordinate, the way they look, two coordinates of the square, which point, a label.
using Covered = std::map<std::array<int, 7>, int>;

template <class Visit>
void for_each_covered(const Soup& soup, const Triangle& t, Visit visit) {
  const std::array p{soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]};
  const Position n = double_area_vector(p[0], p[1], p[2]);
  const std::size_t axis = n[0] != 0   ? 0
                           : n[1] != 0 ? 1
                                       : 2,
                    u = (axis + 1) % 3, v = (axis + 2) % 3;
  REQUIRE((p[0][axis] == p[1][axis] && p[0][axis] == p[2][axis] && n[axis] != 0));
  const auto area = [&](const Position& a, const Position& b, const Position& c) {
    return ((b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u])) / n[axis];
  };
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      for (int k = 0; k < 2; ++k) {
        Position x = p[0];
        x[u] = i + (k == 0 ? 0.3125 : 0.890625);
        x[v] = j + (k == 0 ? 0.71875 : 0.234375);
        const std::array weights{area(x, p[1], p[2]), area(p[0], x, p[2]), area(p[0], p[1], x)};
        if (weights[0] > 0 && weights[1] > 0 && weights[2] > 0)
          visit(std::array{int(axis), int(p[0][axis]), n[axis] > 0 ? 1 : 0, i, j, k, 0}, x,
                weights);
      }
}

template <class LabelOf>
Covered covered(const Soup& soup, LabelOf label_of) {
  Covered result;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    for_each_covered(soup, soup.triangles[t], [&](auto square, const auto&, const auto&) {
      square[6] = label_of(t);
      ++result[square];
    });
  return result;
}
Covered covered(const Soup& soup) {
  return covered(soup, [](std::size_t) { return 0; });
}

/// Once from each side, as all edges of a closed surface are.
bool is_balanced(const Soup& soup) {
  std::map<std::array<std::uint32_t, 2>, int> balance;
  for (const Triangle& t : soup.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = t[i], w = t[(i + 1) % 3];
      balance[{std::min(v, w), std::max(v, w)}] += v < w ? 1 : -1;
    }
  return std::all_of(balance.begin(), balance.end(), [](const auto& e) { return e.second == 0; });
}

TEST_CASE("voxels get their corners and no other vertex") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Cubes cubes = random_cubes(seed, 0.1 + 0.02 * double(seed));
    const Soup before = surface_of(cubes);
    Soup after = before;
    const PlanarReport report = remesh(after);
    INFO(seed << ": " << report);
    CHECK(after.points.size() == count_corners(cubes));
    CHECK(report.faces_after == after.triangles.size());
    CHECK(report.vertices_after == after.points.size());
    CHECK(report.patches_with_boundary + report.patches_unchanged == 0);
    CHECK(covered(after) == covered(before));
    CHECK(is_balanced(after));
    CHECK(test::topology_of(after).euler() == test::topology_of(before).euler());
    CHECK_FALSE(test::topology_of(after).has_duplicate_faces);
  }
}

TEST_CASE("a second time, nothing is left to do") {
  Soup once = surface_of(random_cubes(3, 0.6));
  remesh(once);
  Soup twice = once;
  remesh(twice);
  CHECK(test::is_identical(once, twice));
}

TEST_CASE("rotated voxels get as few, in doubles, in floats and in any size") {
  const Cubes cubes = random_cubes(5, 0.5);
  const Soup before = test::tilted(surface_of(cubes));
  for (double size : {1.0, 1e150, 1e-150}) {
    Soup after = test::mapped(before, [&](const Position& p) { return size * p; });
    remesh(after);
    CHECK(after.points.size() == count_corners(cubes));
  }
  Soup after = test::as_floats(before);
  remesh(after);
  CHECK(after.points.size() == count_corners(cubes));
  std::vector<float> points;
  std::vector<std::uint32_t> triangles;
  for (const Position& p : before.points)
    for (double x : p.coordinates)
      points.push_back(float(x));
  for (const Triangle& t : before.triangles)
    triangles.insert(triangles.end(), t.begin(), t.end());
  remesh_planar_patches(points, triangles);
  CHECK(points.size() == 3 * count_corners(cubes));
}

TEST_CASE("an edge of which little is needed stays in one piece on both sides") {
  Soup plate = test::plate_with_holes(3, 4);
  const Soup before = plate;
  const PlanarReport report = remesh(plate);
  CHECK(report.patches == 2 + 4 * 4); // each hole and the rim have four sides
  CHECK(plate.points.size() == 8 * 4);
  CHECK(is_same_topology(test::topology_of(plate), test::topology_of(before)));
  CHECK(test::volume(plate) == Approx(test::volume(before)));
}

// --- Labels, channels ----------------------------------------------------------------------------

int label_at(const Soup& soup, std::size_t triangle) {
  return test::centre(soup, soup.triangles[triangle])[0] < 3.2 ? 7 : 4;
}

TEST_CASE("labels stay where they were") {
  const Soup before = surface_of(random_cubes(8, 0.5));
  std::vector<int> labels;
  for (std::size_t t = 0; t < before.triangles.size(); ++t)
    labels.push_back(label_at(before, t));
  const auto old = labels;
  test::PointSoup soup(before);
  remesh_planar_patches(soup.points, soup.triangles, Labels{CGAL::make_property_map(labels)});
  const Soup after = test::to_soup(soup);
  CHECK(after.triangles.size() < before.triangles.size());
  CHECK(covered(after, [&](std::size_t t) { return labels[t]; }) ==
        covered(before, [&](std::size_t t) { return old[t]; }));
}

/// Affine on each side of x = 3, with another function on each axis.
Vector<2> place_at(const Position& p, int axis, bool is_low) {
  return {{p[0] + 0.5 * p[1] + 10 * axis, p[2] - 0.25 * p[0] + (is_low ? 0 : 100)}};
}
std::array<Vector<2>, 3> places_of(const Soup& soup, const Triangle& t) {
  const Position n = test::area_vector(soup, t);
  const int axis = n[0] != 0 ? 0 : n[1] != 0 ? 1 : 2;
  const bool is_low = test::centre(soup, t)[0] < 3;
  std::array<Vector<2>, 3> places;
  for (std::size_t i = 0; i < 3; ++i)
    places[i] = place_at(soup.points[t[i]], axis, is_low);
  return places;
}
test::CornerValues<2> places_of(const Soup& soup) {
  test::CornerValues<2> places;
  for (const Triangle& t : soup.triangles)
    places.push_back(places_of(soup, t));
  return places;
}

/// How far values at corners, interpolated, are from place_at().
double greatest_difference(const Soup& soup, const test::CornerValues<2>& corners) {
  double greatest = 0;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    for_each_covered(soup, soup.triangles[t],
                     [&](const auto& square, const Position& x, const auto& weights) {
                       Vector<2> value;
                       for (std::size_t i = 0; i < 3; ++i)
                         value += weights[i] * corners[t][i];
                       const Vector<2> wanted = place_at(x, square[0], x[0] < 3);
                       greatest = std::max(greatest, squared_distance(value, wanted));
                     });
  return std::sqrt(greatest);
}

TEST_CASE("a texture is as it was at each point, in every form") {
  const Soup before = surface_of(random_cubes(9, 0.6));
  const auto places = places_of(before);
  Soup plain = before;
  remesh(plain);

  auto texture = test::indexed(places);
  test::PointSoup soup(before);
  remesh_planar_patches(soup.points, soup.triangles, Texture{texture.values, texture.triples});
  const Soup after = test::to_soup(soup);
  CHECK(after.triangles.size() < before.triangles.size());
  CHECK(after.triangles.size() > plain.triangles.size()); // seams need vertices
  CHECK(covered(after) == covered(before));
  CHECK(greatest_difference(after, test::at_corners(texture.values, texture.triples)) < 1e-9);
  CHECK(texture.values.size() ==
        test::indexed(test::at_corners(texture.values, texture.triples)).values.size());

  auto parts = test::split(before, places);
  auto& values = std::get<0>(parts.values);
  test::PointSoup split(parts.soup);
  remesh_planar_patches(split.points, split.triangles, SplitVertices{},
                        Texture{CGAL::make_property_map(values)});
  const Soup left = test::to_soup(split);
  CHECK(left.triangles.size() == after.triangles.size());
  CHECK(covered(left) == covered(before));
  CHECK(greatest_difference(left, test::at_corners(values, left.triangles)) < 1e-9);

  // What else a point has goes along with it.
  parts = test::split(before, places);
  std::vector<std::pair<test::Point, std::size_t>> points;
  for (const Position& p : parts.soup.points)
    points.emplace_back(test::to_point<test::Point>(p), points.size());
  remesh_planar_patches(
      points, parts.soup.triangles, SplitVertices{}, Texture{CGAL::make_property_map(values)},
      CGAL::parameters::point_map(
          CGAL::First_of_pair_property_map<std::pair<test::Point, std::size_t>>()));
  CHECK(points.size() == left.points.size());
  for (const auto& [p, number] : points)
    CHECK(test::to_position(p) == parts.soup.points[number]);
}

TEST_CASE("a mesh keeps the values of its halfedges, labels and what is not removed") {
  Soup before = test::plate_with_holes(1, 2); // 6 × 6 × 2 half units
  before = test::mapped(before, [](const Position& p) { return 2 * p; });
  test::Mesh mesh = test::make_mesh(before);
  auto uv = mesh.add_property_map<test::Mesh::Halfedge_index, std::array<double, 2>>("uv").first;
  auto label = mesh.add_property_map<test::Mesh::Face_index, int>("label").first;
  for (const auto f : faces(mesh)) {
    label[f] = label_at(before, f);
    const auto places = places_of(before, before.triangles[f]);
    auto h = mesh.halfedge(f);
    for (int i = 0; i < 3; ++i, h = mesh.next(h))
      for (std::size_t k = 0; k < 3; ++k)
        if (std::uint32_t(mesh.target(h)) == before.triangles[f][k])
          uv[h] = places[k].coordinates;
  }
  const test::Mesh old = mesh;
  const PlanarReport report = remesh_planar_patches(mesh, Texture{uv}, Labels{label});
  CHECK(report.patches_unchanged == 0);
  CHECK(test::is_valid_triangle_mesh(mesh));
  CHECK(CGAL::is_closed(mesh));
  for (const auto v : vertices(mesh))
    CHECK(mesh.point(v) == old.point(v));
  Soup after;
  test::CornerValues<2> corners;
  std::vector<int> labels;
  for (const auto& p : old.points())
    after.points.push_back(test::to_position(p));
  for (const auto f : faces(mesh)) {
    after.triangles.emplace_back();
    corners.emplace_back();
    auto h = mesh.halfedge(f);
    for (std::size_t i = 0; i < 3; ++i, h = mesh.next(h)) {
      after.triangles.back()[i] = mesh.target(h);
      corners.back()[i].coordinates = uv[h];
    }
    labels.push_back(label[f]);
  }
  CHECK(after.triangles.size() < before.triangles.size());
  CHECK(greatest_difference(after, corners) < 1e-9);
  CHECK(covered(after, [&](std::size_t t) { return labels[t]; }) ==
        covered(before, [&](std::size_t t) { return label_at(before, t); }));
  CHECK(is_same_topology(test::topology_of(after), test::topology_of(before)));
}

TEST_CASE("a Polyhedron_3 too") {
  auto mesh = test::make_mesh<CGAL::Polyhedron_3<test::Kernel>>(test::plate_with_holes(2, 3));
  remesh_planar_patches(mesh);
  CHECK(test::is_valid_triangle_mesh(mesh));
  CHECK(mesh.is_closed());
  CHECK(mesh.size_of_vertices() == 8 * 3);
}

TEST_CASE("colours that are no affine function of the place are left") {
  const Soup before = test::grid(8, 8);
  std::vector<std::array<double, 3>> colors;
  for (const Position& p : before.points)
    colors.push_back({p[0] < 0.6 ? p[0] : 0.6, p[1], 0});
  test::PointSoup soup(before);
  remesh_planar_patches(soup.points, soup.triangles, Colors{CGAL::make_property_map(colors)});
  // In [0, 0.5], in (0.5, 0.625) and from there on: the strip has other slopes, and is a patch.
  CHECK(soup.points.size() == 8);
  for (std::size_t i = 0; i < soup.points.size(); ++i)
    CHECK(colors[i][0] == std::min(soup.points[i].x(), 0.6));
}

// --- What must stay, and what can't be done ------------------------------------------------------

TEST_CASE("what is constrained stays") {
  const Soup before = test::grid(8, 8);
  std::vector<unsigned char> is_fixed(before.points.size(), 0);
  const std::uint32_t inside = 4 * 9 + 4, beside = 3;
  is_fixed[inside] = is_fixed[beside] = 1;
  test::PointSoup soup(before);
  remesh_planar_patches(
      soup.points, soup.triangles,
      CGAL::parameters::vertex_is_constrained_map(CGAL::make_property_map(is_fixed)));
  const std::set<test::Point> left(soup.points.begin(), soup.points.end());
  CHECK(left.size() == 6);
  CHECK(left.contains(test::to_point<test::Point>(before.points[inside])));
  CHECK(left.contains(test::to_point<test::Point>(before.points[beside])));
  CHECK(soup.triangles.size() == 5); // three of a polygon of five corners, and two for one inside

  // The long diagonal of a parallelogram between its other two corners, which edges beside it hold.
  test::Mesh mesh = test::make_mesh(test::mapped(before, [](const Position& p) {
    return Position{{p[0] + 0.5 * p[1], p[1], 0}};
  }));
  auto is_met = mesh.add_property_map<test::Mesh::Edge_index, bool>("held", false).first;
  const auto held = [&](std::uint32_t v, std::uint32_t w) {
    const auto h = mesh.halfedge(test::Mesh::Vertex_index(v), test::Mesh::Vertex_index(w));
    REQUIRE(h != test::Mesh::null_halfedge());
    is_met[mesh.edge(h)] = true;
    return mesh.edge(h);
  };
  const auto edge = held(inside, inside + 10);
  held(inside + 1, inside + 2);
  held(inside + 9, inside + 8);
  remesh_planar_patches(mesh, CGAL::parameters::edge_is_constrained_map(is_met));
  CHECK(test::is_valid_triangle_mesh(mesh));
  REQUIRE_FALSE(mesh.is_removed(edge));
  CHECK(std::set<std::uint32_t>{mesh.vertex(edge, 0), mesh.vertex(edge, 1)} ==
        std::set<std::uint32_t>{inside, inside + 10});
  CHECK(mesh.number_of_vertices() == 4 + 6);
}

TEST_CASE("an edge of three faces, and parts that touch, stay as they hang together") {
  // Three sheets at one edge, of which two are in one plane.
  Soup fan = test::grid(4, 4);
  const auto add = [&](const Soup& sheet) { fan = test::joined(fan, sheet); };
  add(test::mapped(test::grid(4, 4), [](const Position& p) {
    return Position{{p[0] - 1, p[1], 0}};
  }));
  add(test::mapped(test::grid(4, 4), [](const Position& p) { return Position{{0, p[1], p[0]}}; }));
  fan = test::welded(fan);
  const Soup before = fan;
  remesh(fan);
  CHECK(fan.points.size() == 2 + 3 * 2);
  CHECK(fan.triangles.size() == 6);
  CHECK(test::topology_of(fan).boundary_edges == 9);
  CHECK(test::topology_of(fan).euler() == test::topology_of(before).euler());

  // Two sheets that meet in a vertex: inside of one, and inside or on the border of the other.
  for (std::uint32_t vertex : {12U, 2U}) {
    const Position place = test::grid(4, 4).points[vertex];
    Soup cross = test::joined(
        test::grid(4, 4), test::mapped(test::grid(4, 4), [&](const Position& p) {
          return place + Position{{0.7 * (p[0] - 0.5), 0.2 * (p[1] - 0.5), p[1] - 0.5}};
        }));
    for (Triangle& t : cross.triangles)
      for (std::uint32_t& v : t)
        v = v == 25 + 12 ? vertex : v;
    const auto before_it = test::topology_of(cross);
    REQUIRE(before_it.components == 1);
    remesh(cross);
    CHECK(is_same_topology(test::topology_of(cross), before_it));
    CHECK(cross.points.size() == 4 + 4 + 1);
  }

  // Two cubes of a mesh that touch along an edge, each with vertices of its own there.
  const Soup cubes =
      test::surface_of_cubes(4, 4, 2, [](int x, int y, int) { return x / 2 == y / 2; });
  test::Mesh mesh = test::make_mesh(test::joined(test::cube(2), test::cube(3), {{1, 1, 0}}));
  remesh_planar_patches(mesh);
  CHECK(test::is_valid_triangle_mesh(mesh));
  CHECK(mesh.number_of_vertices() == 16);
  Soup welded = cubes;
  remesh(welded);
  CHECK(welded.points.size() == 14);
}

TEST_CASE("a border without a corner keeps its vertices, or three") {
  const Soup annulus = test::mapped(test::open_cylinder(48, 3), [](const Position& p) {
    return Position{{p[0] * (1 + p[2]), p[1] * (1 + p[2]), 0}};
  });
  Soup exact = annulus;
  CHECK(remesh(exact).patches == 1);
  CHECK(exact.points.size() == 2 * 48);
  CHECK(exact.triangles.size() == 2 * 48);
  CHECK(is_same_topology(test::topology_of(exact), test::topology_of(annulus)));

  Soup disc = test::open_cylinder(48, 1); // its upper border becomes the centre
  for (Triangle& t : disc.triangles)
    for (std::uint32_t& v : t)
      v = std::min(v, 48U);
  disc.points.resize(49);
  disc.points[48] = {};
  remesh(disc, PlanarTolerance(10));
  CHECK(disc.points.size() == 3);
  CHECK(disc.triangles.size() == 1);

  Soup frame = test::grid(8, 8);
  std::erase_if(frame.triangles, [&](const Triangle& t) {
    const Position p = test::centre(frame, t);
    return std::max(std::abs(p[0] - 0.5), std::abs(p[1] - 0.5)) < 0.25;
  });
  remesh(frame);
  CHECK(frame.points.size() == 8);
  CHECK(frame.triangles.size() == 8);
}

TEST_CASE("sheets that would fall on each other stay apart") {
  // Closed bags of two sheets in one plane.
  for (std::uint32_t corners : {3U, 8U}) {
    Soup bag = test::mapped(test::uv_sphere(corners, 6), [](const Position& p) {
      return Position{{2 * p[0] + 0.3 * p[1], p[1], 0}};
    });
    const auto before = test::topology_of(bag);
    REQUIRE(before.euler() == 2);
    const PlanarReport report = remesh(bag);
    CHECK(report.patches == 2);
    CHECK(is_same_topology(test::topology_of(bag), before));
    CHECK_FALSE(test::topology_of(bag).has_duplicate_faces);
  }

  // A slit in the middle of a sheet: its three inner vertices are there twice, at the same places.
  Soup slit = test::grid(6, 2);
  for (std::uint32_t v : {9U, 10U, 11U})
    slit.points.push_back(slit.points[v]);
  for (Triangle& t : slit.triangles)
    if (test::centre(slit, t)[1] > 0.5)
      for (std::uint32_t& v : t)
        v = v >= 9 && v <= 11 ? v - 9 + 21 : v;
  const auto open = test::topology_of(slit);
  REQUIRE(open.boundary_loops == 2);
  Soup closed = slit;
  remesh(closed);
  CHECK(is_same_topology(test::topology_of(closed), open));
  CHECK(closed.points.size() == 4 + 2 + 2 * 3);
  // The same along a fold, open by less than the tolerance: both sides would become one edge.
  for (Position& p : slit.points)
    p[2] = std::max(p[1] - 0.5, 0.0);
  for (std::uint32_t v : {21U, 22U, 23U})
    slit.points[v][2] += 1e-3;
  remesh(slit, PlanarTolerance(0.05));
  CHECK(is_same_topology(test::topology_of(slit), open));
  CHECK(slit.points.size() == 4 + 2 + 2 + 2 * 3);
}

TEST_CASE("where straight borders would cross, or a patch lies over itself, more is left") {
  // A hole in a bulge of the border that is flatter than the tolerance.
  Soup sheet = test::grid(8, 8);
  std::erase_if(sheet.triangles, [&](const Triangle& t) {
    const Position p = test::centre(sheet, t);
    return p[0] > 0.375 && p[0] < 0.625 && p[1] > 0.125 && p[1] < 0.25;
  });
  sheet = test::mapped(sheet, [](const Position& p) {
    const double y = p[1] * p[1];
    return Position{{p[0], y - 0.4 * (1 - y) * p[0] * (1 - p[0]), 0}};
  });
  Soup after = sheet;
  PlanarReport report = remesh(after, PlanarTolerance(0.3));
  CHECK(report.patches_with_boundary == 1);
  CHECK(report.patches_unchanged == 0);
  CHECK(after.points.size() == 4 * 8 + 6);
  CHECK(is_same_topology(test::topology_of(after), test::topology_of(sheet)));

  // The same with a wall below, of which the faces are larger or smaller than those of the sheet:
  // the border that they share is the same for both.
  for (double height : {1.0, 0.2}) {
    Soup edge =
        test::joined(sheet, test::mapped(test::grid(8, 3), [&](const Position& p) {
                       return Position{{p[0], -0.4 * p[0] * (1 - p[0]), height * (p[1] - 1)}};
                     }));
    edge = test::welded(edge);
    const auto with_wall = test::topology_of(edge);
    PlanarTolerance tolerance(0.3);
    tolerance.degrees = 40;
    report = remesh(edge, tolerance);
    CHECK(report.patches == 2);
    CHECK(edge.points.size() == 4 * 8 + 6 + 3); // below, both ends and the middle
    CHECK(is_same_topology(test::topology_of(edge), with_wall));
  }

  // A ramp of two turns, in a slab that is no higher than the tolerance.
  const Soup ramp = test::mapped(test::grid(60, 4), [](const Position& p) {
    const double angle = 12.5 * p[0], radius = 1 + p[1];
    return Position{{radius * std::cos(angle), radius * std::sin(angle), 0.02 * angle}};
  });
  after = ramp;
  report = remesh(after, PlanarTolerance(1));
  CHECK(report.patches == 1);
  CHECK(report.patches_unchanged == 1);
  CHECK(test::is_identical(after, ramp));
}

TEST_CASE("with a tolerance the surface moves no further, and keeps its topology") {
  const std::vector<std::pair<Soup, double>> surfaces{
      {test::with_noise(test::cube(12), 3, 1e-3), 0.01},
      {test::with_noise(test::grid(30, 30), 4, 2e-3), 0.008},
      {test::tilted(test::torus(60, 30)), 0.05},
      {test::with_noise(test::plate_with_holes(2, 5), 5, 5e-3), 0.05}};
  for (const auto& [before, distance] : surfaces) {
    Soup after = before;
    PlanarTolerance tolerance(distance);
    tolerance.degrees = 30;
    const PlanarReport report = remesh(after, tolerance);
    INFO(report);
    CHECK(after.triangles.size() < before.triangles.size() / 2);
    CHECK(test::farthest(after, before, 8) <= distance);
    CHECK(test::farthest(before, after, 4) <= distance);
    CHECK(is_same_topology(test::topology_of(after), test::topology_of(before)));
  }
}

TEST_CASE("a border bends where it is further from straight than the tolerance") {
  Soup sheet = test::grid(4, 4);
  sheet.points[2][1] = -0.05;
  const auto vertices = [&](double distance) {
    Soup after = sheet;
    return remesh(after, PlanarTolerance(std::sqrt(5.0) * distance)).vertices_after;
  };
  CHECK(vertices(0.049) == 5);
  CHECK(vertices(0.051) == 4);
}

TEST_CASE("texture coordinates that a file has rounded lie on one patch within a tolerance") {
  const Soup before = test::grid(10, 10); // of the unit square
  const auto faces = [&](const PlanarTolerance& tolerance) {
    std::vector<std::array<double, 2>> values; // of four digits
    for (const Position& p : before.points)
      values.push_back(
          {std::round(1e4 * (2 * p[0] + p[1]) / 3) / 1e4, std::round(1e4 * p[1] / 1.3) / 1e4});
    test::PointSoup soup(before);
    return remesh_planar_patches(soup.points, soup.triangles, SplitVertices{},
                                 Texture{CGAL::make_property_map(values)}, tolerance)
        .faces_after;
  };
  CHECK(faces(PlanarTolerance::relative(1e-9)) > 20);
  CHECK(faces(PlanarTolerance::relative(3e-4)) == 2);
}

TEST_CASE("normals that differ by more than the angle end a patch") {
  const Soup before = test::open_cylinder(72, 4); // of 5 degrees a column
  const auto patches = [&](double degrees) {
    Soup after = before;
    PlanarTolerance tolerance(0.1);
    tolerance.degrees = degrees;
    return remesh(after, tolerance).patches;
  };
  CHECK(patches(4.9) == 72);
  CHECK(patches(5.1) <= 36); // two or three columns each
}

TEST_CASE("soups with all that is bad") {
  Soup soup = test::grid(3, 3);
  soup.points.push_back({{7, 7, 7}});
  soup.triangles.push_back({0, 0, 1});
  PlanarReport report = remesh(soup);
  CHECK(report.faces_before == 19);
  CHECK(soup.points.size() == 4);
  CHECK(soup.triangles.size() == 2);
  Soup empty;
  report = remesh(empty);
  CHECK(report.faces_after == 0);
  Soup flat{{{{0, 0, 0}}, {{1, 0, 0}}, {{2, 0, 0}}}, {{0, 1, 2}}}; // without an area
  remesh(flat);
  CHECK(flat.triangles.size() == 1);
  std::ostringstream text;
  text << report;
  CHECK(text.str() ==
        "0 -> 0 faces, 0 -> 0 vertices, 0 planar patches, 0 with their entire boundaries, "
        "0 unchanged");
}

TEST_CASE("slivers on borders go with the patches beside them") {
  // A fold along x = 0 with a face without area between the sheets: 1 lies on the edge from 0 to 2.
  Soup soup{{{{0, 0, 0}}, {{0, 1, 0}}, {{0, 2, 0}}, {{2, 1, 0}}, {{-2, 1, 1}}},
            {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {1, 2, 4}}};
  const auto before = test::topology_of(soup);
  remesh(soup);
  CHECK(soup.points.size() == 4);
  CHECK(soup.triangles.size() == 2);
  CHECK(is_same_topology(test::topology_of(soup), before));
}

TEST_CASE("what makes no sense is refused before anything changes") {
  const Soup good = test::grid(3, 3);
  const auto refused = [](Soup soup, const PlanarTolerance& tolerance, const std::string& why) {
    const Soup before = soup;
    test::PointSoup points(soup);
    CHECK_THROWS_WITH(remesh_planar_patches(points.points, points.triangles, tolerance),
                      Contains(why));
    CHECK(points.triangles == before.triangles);
    CHECK(points.points.size() == before.points.size());
  };
  const PlanarTolerance usual = PlanarTolerance::relative(1e-9);
  refused(good, PlanarTolerance(-1), "PlanarTolerance");
  refused(good, PlanarTolerance(std::nan("")), "PlanarTolerance");
  PlanarTolerance steep = usual;
  steep.degrees = 90;
  refused(good, steep, "degrees 90");
  Soup bad = good;
  bad.points[3][1] = std::numeric_limits<double>::infinity();
  refused(bad, usual, "quadrille::remesh_planar_patches: vertex 3 is not finite");
  bad = good;
  bad.triangles[2][1] = 99;
  refused(bad, usual, "99");
}

} // namespace
