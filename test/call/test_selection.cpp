// face_is_selected_map: only selected faces are simplified, and counted; others stay bit by bit.
#include "meshes.h"
#include "soups.h"

#include <boost/property_map/function_property_map.hpp>
#include <quadrille/channel_options.h>
#include <quadrille/channels.h>
#include <quadrille/edge_length.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <vector>

namespace {

using namespace quadrille;
using test::Mesh;
using test::Point;
using test::PointSoup;
using test::Soup;

using Corners = std::array<Point, 3>;

Corners corners(const PointSoup& soup, std::size_t f) {
  const auto& t = soup.triangles[f];
  return {soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]};
}

// Is the face on the right of the plane?
std::vector<bool> beyond(const PointSoup& soup, double x) {
  std::vector<bool> is_selected;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    const Corners c = corners(soup, f);
    is_selected.push_back(c[0].x() + c[1].x() + c[2].x() > 3 * x);
  }
  return is_selected;
}

auto selected(const std::vector<bool>& is_selected) {
  return parameters::face_is_selected_map(boost::make_function_property_map<std::size_t>(
      [&](std::size_t f) -> bool { return is_selected[f]; }));
}

std::multiset<Corners> others(const PointSoup& soup, const std::vector<bool>& is_selected) {
  std::multiset<Corners> faces;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    if (!is_selected[f])
      faces.insert(corners(soup, f));
  return faces;
}

std::multiset<Corners> all(const PointSoup& soup) {
  return others(soup, std::vector<bool>(soup.triangles.size(), false));
}

// Simplifies what is beyond x, and checks that as many faces are left of it as were asked for, and
// that all others are there as they were.
template <class... Policies>
Report check(const Soup& input, double x, std::size_t faces, const Policies&... policies) {
  PointSoup soup(input);
  const std::vector<bool> is_selected = beyond(soup, x);
  const auto outside = others(soup, is_selected);
  const Report report =
      simplify(soup.points, soup.triangles, FaceCount{faces}, policies..., selected(is_selected));
  CHECK(report.stop == StopReason::target_met);
  CHECK(report.faces_before == input.triangles.size());
  CHECK(report.faces_after == soup.triangles.size());
  CHECK(report.vertices_after == soup.points.size());
  CHECK(soup.triangles.size() == outside.size() + faces);
  const auto left = all(soup);
  CHECK(std::includes(left.begin(), left.end(), outside.begin(), outside.end()));
  return report;
}

} // namespace

TEST_CASE("Of a soup only selected faces are simplified and counted") {
  const Soup sphere = test::sphere(4);
  SECTION("by any cost, in any order, with any topology") {
    check(sphere, 0.1, 200);
    check(sphere, 0.1, 200, MemorylessQuadric{});
    check(sphere, 0.1, 200, RelaxedOrder{});
    check(sphere, 0.1, 200, MemorylessQuadric{}, RelaxedOrder{0.5, true});
    check(sphere, 0.1, 200, EdgeLength{}, MidpointPlacement{}, Topology::free);
  }
  SECTION("of a large one in no order") {
    check(test::shuffled(test::sphere(5), 1), 0.1, 600);
    check(test::shuffled(test::sphere(5), 2), 0.9, 60, RelaxedOrder{});
  }
  SECTION("of an open one with noise") {
    check(test::with_noise(test::grid(40, 40), 3, 0.005), 0.5, 300);
  }
}

TEST_CASE("A small selection goes as far as the same faces do alone, whatever is around it") {
  const Soup sphere = test::with_noise(test::sphere(4), 1, 0.05);
  PointSoup alone(sphere);
  const std::vector<bool> is_selected = beyond(alone, 0.9);
  std::set<Point> rim;
  for (const Corners& face : others(alone, is_selected))
    rim.insert(face.begin(), face.end());
  PointSoup part(Soup{});
  part.points = alone.points;
  for (std::size_t f = 0; f < is_selected.size(); ++f)
    if (is_selected[f])
      part.triangles.push_back(alone.triangles[f]);
  const std::vector<Point> points = part.points;
  simplify(
      part.points, part.triangles, FaceCount{0},
      CGAL::parameters::vertex_is_constrained_map(boost::make_function_property_map<std::size_t>(
          [&](std::size_t v) { return rim.count(points[v]) > 0; })));

  PointSoup soup(sphere);
  const Report report = simplify(soup.points, soup.triangles, FaceCount{0}, selected(is_selected));
  const std::size_t outside = others(alone, is_selected).size();
  CHECK(soup.triangles.size() - outside <= part.triangles.size() + 4);
  CHECK(report.faces_after < report.faces_before);
}

TEST_CASE("Ratios, counts of vertices and what a visitor sees are of the selected faces") {
  const Soup sphere = test::sphere(4);
  PointSoup soup(sphere);
  const std::vector<bool> is_selected = beyond(soup, 0);
  const auto count =
      static_cast<std::size_t>(std::count(is_selected.begin(), is_selected.end(), true));
  std::set<std::size_t> vertices;
  for (std::size_t f = 0; f < is_selected.size(); ++f)
    if (is_selected[f])
      vertices.insert(soup.triangles[f].begin(), soup.triangles[f].end());
  SECTION("ratio") {
    simplify(soup.points, soup.triangles, FaceRatio{0.25}, selected(is_selected));
    CHECK(soup.triangles.size() == is_selected.size() - count + count / 4);
  }
  SECTION("vertices") {
    const std::size_t before = soup.points.size();
    simplify(soup.points, soup.triangles, VertexCount{vertices.size() - 100},
             selected(is_selected));
    CHECK(soup.points.size() == before - 100);
  }
  SECTION("status") {
    std::vector<Status> seen;
    simplify(
        soup.points, soup.triangles,
        [&seen](const Status& status) {
          seen.push_back(status);
          return status.contractions == 10;
        },
        selected(is_selected));
    REQUIRE(!seen.empty());
    CHECK(seen.back().initial_faces == count);
    CHECK(seen.back().faces == count - 20);
    CHECK(seen.back().initial_vertices == vertices.size());
  }
}

TEST_CASE("Nothing selected is nothing done") {
  PointSoup soup(test::sphere(2));
  const auto before = all(soup);
  const Report report = simplify(soup.points, soup.triangles, FaceCount{0},
                                 selected(std::vector<bool>(soup.triangles.size(), false)));
  CHECK(report.contractions == 0);
  CHECK(all(soup) == before);
}

TEST_CASE("Labels of the same map tell what was selected; attributes elsewhere stay") {
  PointSoup soup(test::sphere(4));
  const std::vector<bool> is_selected = beyond(soup, 0);
  std::vector<int> labels(is_selected.begin(), is_selected.end());
  std::vector<std::array<double, 3>> colors;
  for (const Point& p : soup.points)
    colors.push_back({p.x() * p.y(), p.z(), 0.1});
  const std::vector<Point> points = soup.points;
  const auto old_colors = colors;
  simplify(soup.points, soup.triangles, FaceCount{300}, Labels{CGAL::make_property_map(labels)},
           Colors{CGAL::make_property_map(colors)}, selected(is_selected));
  std::size_t inside = 0;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    inside += labels[f] == 1;
    if (labels[f] == 1)
      continue;
    for (std::size_t v : soup.triangles[f]) {
      const auto old = std::find(points.begin(), points.end(), soup.points[v]);
      REQUIRE(old != points.end());
      CHECK(colors[v] == old_colors[static_cast<std::size_t>(old - points.begin())]);
    }
  }
  CHECK(inside == 300);
}

TEST_CASE("Of a mesh only selected faces are simplified and counted") {
  Mesh mesh = test::make_mesh(test::sphere(4));
  std::vector<bool> is_selected;
  std::vector<std::pair<Mesh::Face_index, Corners>> outside;
  for (const auto f : faces(mesh)) {
    Corners c;
    std::size_t i = 0;
    for (const auto v : vertices_around_face(halfedge(f, mesh), mesh))
      c[i++] = mesh.point(v);
    is_selected.push_back(c[0].z() + c[1].z() + c[2].z() > 0);
    if (!is_selected.back())
      outside.emplace_back(f, c);
  }
  const auto map = boost::make_function_property_map<Mesh::Face_index>(
      [&](Mesh::Face_index f) -> bool { return is_selected[f]; });
  const Report report = simplify(mesh, FaceCount{100}, parameters::face_is_selected_map(map));
  CHECK(report.faces_after == outside.size() + 100);
  CHECK(mesh.number_of_faces() == outside.size() + 100);
  CHECK(test::is_valid_triangle_mesh(mesh));
  for (const auto& [f, c] : outside) {
    REQUIRE(!mesh.is_removed(f));
    std::size_t i = 0;
    for (const auto v : vertices_around_face(halfedge(f, mesh), mesh))
      CHECK(mesh.point(v) == c[i++]);
  }
}
