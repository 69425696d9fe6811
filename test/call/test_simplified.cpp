// simplified() gives a copy without garbage, with its report and its properties; the input stays as
// it is.
#include "mesh_types.h"
#include "meshes.h"
#include "snapshot.h"
#include "soups.h"

#include <quadrille/channels.h>
#include <quadrille/edge_length.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/simplified.h>

#include <catch2/catch.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace quadrille;
using namespace test;

namespace {

const Soup& input() {
  static const Soup soup = with_noise(torus(20, 12), 1, 0.02);
  return soup;
}

using Vertex = Mesh::Vertex_index;
using ColorMap = Mesh::Property_map<Vertex, std::array<double, 3>>;

ColorMap add_colors(Mesh& mesh) {
  const ColorMap colors =
      mesh.add_property_map<Vertex, std::array<double, 3>>("v:heat", {0, 0, 0}).first;
  for (const Vertex v : mesh.vertices())
    colors[v] = {mesh.point(v).x(), mesh.point(v).y(), 1};
  return colors;
}

std::vector<std::array<double, 3>> values(const Mesh& mesh, const ColorMap& map) {
  std::vector<std::array<double, 3>> values;
  for (const Vertex v : mesh.vertices())
    values.push_back(map[v]);
  return values;
}

// What simplify leaves of a copy, tidied up.
template <class... Arguments>
Mesh expected(Mesh mesh, const Arguments&... arguments) {
  simplify(mesh, arguments...);
  mesh.collect_garbage();
  return mesh;
}

} // namespace

TEMPLATE_TEST_CASE("The copy has what is left and nothing else", "", Mesh, Polyhedron, TriMesh) {
  const auto mesh = make_mesh<TestType>(input());
  const Soup before = to_soup(mesh);
  const auto [coarse, report] = simplified(mesh, FaceCount{100});
  CHECK((to_soup(mesh).points == before.points));
  CHECK((to_soup(mesh).triangles == before.triangles));
  CHECK(report.faces_before == input().triangles.size());
  CHECK(report.faces_after == 100);
  CHECK(num_faces(coarse) == 100);
  CHECK(num_vertices(coarse) == report.vertices_after);
  CHECK(is_valid_triangle_mesh(coarse));
  auto in_place = make_mesh<TestType>(input());
  simplify(in_place, FaceCount{100});
  CHECK(is_same_surface(to_soup(coarse), to_soup(in_place), 0));

  const auto by_default = simplified(mesh);
  CHECK(num_faces(by_default.mesh) == input().triangles.size() / 2);
  const auto [by_midpoints, its_report] = simplified<EdgeLength, MidpointPlacement>(mesh);
  CHECK(its_report.error != by_default.report.error);
}

TEST_CASE("Properties of a Surface_mesh are those of the copy, also where they are written") {
  Mesh mesh = make_mesh(input());
  mesh.add_property_map<Vertex, std::array<double, 3>>("v:other", {1, 2, 3});
  const ColorMap colors = add_colors(mesh);
  const auto all_colors = values(mesh, colors);
  const auto points = mesh.points();
  const Snapshot before = snapshot(mesh);

  const auto check = [&](const Simplified<Mesh>& result, const Mesh& right) {
    CHECK((snapshot(mesh) == before));
    CHECK(values(mesh, colors) == all_colors);
    CHECK(result.mesh.number_of_faces() == right.number_of_faces());
    CHECK((to_soup(result.mesh).points == to_soup(right).points));
    const auto of = [](const Mesh& m) {
      return values(m, m.property_map<Vertex, std::array<double, 3>>("v:heat").first);
    };
    CHECK(of(result.mesh) == of(right));
  };
  Mesh copy = mesh;
  const ColorMap of_copy = copy.property_map<Vertex, std::array<double, 3>>("v:heat").first;
  simplify(copy, FaceCount{100}, Attributes{of_copy});
  copy.collect_garbage();
  check(simplified(mesh, FaceCount{100}, Attributes{colors}), copy);
  check(simplified(mesh, FaceCount{100}, CGAL::parameters::vertex_color_map(colors)), [&] {
    Mesh other = mesh;
    const auto map = other.property_map<Vertex, std::array<double, 3>>("v:heat").first;
    return expected(std::move(other), FaceCount{100}, CGAL::parameters::vertex_color_map(map));
  }());
  check(simplified(mesh, FaceCount{100}, CGAL::parameters::vertex_point_map(points)),
        expected(mesh, FaceCount{100}));
}

TEST_CASE("Maps that are only read may be over the mesh") {
  const Mesh mesh = make_mesh(input());
  std::map<Vertex, bool> fixed;
  for (const Vertex v : mesh.vertices())
    fixed[v] = v.idx() % 16 == 0;
  std::map<Mesh::Face_index, int> labels;
  for (const auto f : mesh.faces())
    labels[f] = f.idx() % 240 < 120;
  std::size_t calls = 0;
  const auto count = [&](const Status&) { return ++calls > 0; };
  struct Watcher {
    std::function<bool(const Status&)> proceed;
  };
  const Watcher watcher{count};
  const auto named =
      CGAL::parameters::vertex_is_constrained_map(boost::make_assoc_property_map(fixed))
          .visitor(std::ref(watcher));
  const auto [coarse, report] =
      simplified(mesh, FaceCount{150}, Labels{boost::make_assoc_property_map(labels)}, named);
  Mesh right = mesh;
  simplify(right, FaceCount{150}, Labels{boost::make_assoc_property_map(labels)}, named);
  right.collect_garbage();
  CHECK(to_soup(coarse).points == to_soup(right).points);
  CHECK(calls > 4);
  const auto unbound = simplified(mesh, FaceCount{150});
  CHECK(to_soup(coarse).points != to_soup(unbound.mesh).points);
}

TEST_CASE("Chains of our names go to the copy") {
  const Mesh mesh = make_mesh(input());
  Mesh right = mesh;
  const auto named_of = [](Mesh& of) {
    const auto is_selected = of.add_property_map<Mesh::Face_index, bool>("f:selected").first;
    const auto importance = of.add_property_map<Vertex, double>("v:importance").first;
    for (const auto f : of.faces())
      is_selected[f] = f.idx() % 2 == 0;
    for (const Vertex v : of.vertices())
      importance[v] = v.idx() % 3;
    return parameters::face_is_selected_map(is_selected).vertex_importance_map(importance);
  };
  Mesh read = mesh;
  const auto [coarse, report] = simplified(read, FaceRatio{0.5}, named_of(read));
  simplify(right, FaceRatio{0.5}, named_of(right));
  right.collect_garbage();
  CHECK(to_soup(coarse).points == to_soup(right).points);
  CHECK(to_soup(coarse).points != to_soup(simplified(mesh, FaceRatio{0.5}).mesh).points);
}

TEST_CASE("A copy of a soup") {
  const PointSoup soup(input());
  const PointSoup before = soup;
  const auto [points, triangles, report] =
      simplified<MemorylessQuadric>(soup.points, soup.triangles, FaceRatio{0.3});
  CHECK(soup.points == before.points);
  CHECK(soup.triangles == before.triangles);
  PointSoup right(input());
  simplify<MemorylessQuadric>(right.points, right.triangles, FaceRatio{0.3});
  CHECK(points == right.points);
  CHECK(triangles == right.triangles);
  CHECK(report.faces_after == triangles.size());
}

TEST_CASE("A copy of spans of constant numbers is vectors") {
  std::vector<float> numbers;
  std::vector<std::uint32_t> indices;
  for (const Position& p : input().points)
    for (std::size_t i = 0; i < 3; ++i)
      numbers.push_back(static_cast<float>(p[i]));
  for (const Triangle& t : input().triangles)
    indices.insert(indices.end(), t.begin(), t.end());
  const auto [points, triangles, report] = simplified(
      std::span<const float>(numbers), std::span<const std::uint32_t>(indices), FaceRatio{0.3});
  simplify(numbers, indices, FaceRatio{0.3});
  CHECK(points == numbers);
  CHECK(triangles == indices);
  CHECK(report.vertices_after == points.size() / 3);
}

TEST_CASE("What is no triangle mesh is refused, and copies of nothing are nothing") {
  Mesh mesh;
  CHECK(simplified(mesh).mesh.number_of_faces() == 0);
  std::array<Vertex, 4> corners;
  for (int i = 0; i < 4; ++i)
    corners[static_cast<std::size_t>(i)] = mesh.add_vertex(Point(i % 2, i / 2, 0));
  mesh.add_face(corners[0], corners[1], corners[3], corners[2]);
  CHECK_THROWS_WITH(simplified(mesh), Catch::StartsWith("quadrille::simplified: face 0"));
  CHECK(mesh.number_of_faces() == 1);
}
