// What the vertices, corners and faces of a mesh have on its way through `simplify`:
// examples/products/mesh_io/attributes/mesh_channels.h.

#include "../examples/products/mesh_io/attributes/mesh_channels.h"

#include <quadrille/compiled.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

using namespace quadrille_examples;

namespace {

/// A bumpy sheet of n x n squares with a colour and a texture coordinate at each vertex.
IndexedMesh sheet(std::uint32_t n) {
  IndexedMesh mesh;
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= n; ++j) {
      const double x = i, y = j;
      mesh.points.emplace_back(x, y, std::sin(x * y / 9));
      mesh.colors.push_back({x / n, y / n, 1. / 3, (x + y) / 40});
      mesh.texture_coordinates.push_back({x / 7, y / 11});
    }
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t v = i * (n + 1) + j;
      mesh.triangles.push_back({v, v + n + 1, v + n + 2});
      mesh.triangles.push_back({v, v + n + 2, v + 1});
    }
  mesh.color_type = {1, false, false, true};
  return mesh;
}

constexpr NumberType single = {4, false, true}, whole = {4, true, true}, byte = {1, true, false};

/// The sheet with numbers of vertices: x, x where that is one, which label a place has, a constant.
IndexedMesh sheet_with_numbers(std::uint32_t n) {
  IndexedMesh mesh = sheet(n);
  mesh.vertex_numbers = {
      {"x", single, {}}, {"gaps", single, {}}, {"label", whole, {}}, {"one", single, {}}};
  for (const Point& p : mesh.points) {
    mesh.vertex_numbers[0].values.push_back(p.x());
    mesh.vertex_numbers[1].values.push_back(p.y() > 3 ? p.x()
                                                      : std::numeric_limits<double>::quiet_NaN());
    mesh.vertex_numbers[2].values.push_back(p.x() < 4.5 ? 1000 : -7);
    mesh.vertex_numbers[3].values.push_back(1);
  }
  return mesh;
}

quadrille::Report simplify_channels(IndexedMesh& mesh, double ratio) {
  return MeshChannels(mesh).simplify({.ratio = ratio}, {});
}

/// How many regions the faces of the sheet have if one has a number of its own by value_of(face).
template <class ValueOf>
std::size_t count_regions(const std::string& name, const NumberType& type, ValueOf value_of) {
  IndexedMesh mesh = sheet(16);
  mesh.face_numbers = {{name, type, {}}};
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face)
    mesh.face_numbers[0].values.push_back(static_cast<double>(value_of(face)));
  const std::vector<std::uint32_t> labels = FaceRegions(mesh).labels();
  const std::size_t regions = std::set(labels.begin(), labels.end()).size();
  CHECK(regions != 1); // there are no labels then
  return std::max<std::size_t>(regions, 1);
}

/// The vertex of the mesh at a place.
std::size_t vertex_at(const IndexedMesh& mesh, const Point& place) {
  const auto found = std::find(mesh.points.begin(), mesh.points.end(), place);
  REQUIRE(found != mesh.points.end());
  return static_cast<std::size_t>(found - mesh.points.begin());
}

} // namespace

TEST_CASE("Attributes that hardly count are carried along every cost", "[mesh_attributes]") {
  using Cost = quadrille::SoupOptions::Cost;
  const Cost cost = GENERATE(Cost::quadric, Cost::memoryless_quadric, Cost::thin_feature_quadric,
                             Cost::edge_length);
  const quadrille::SoupOptions options{
      .ratio = 0.2, .cost = cost, .placement = quadrille::SoupOptions::Placement::endpoint};
  const IndexedMesh input = sheet(16);
  quadrille::SoupPoints points = soup_points(input.points);
  auto triangles = input.triangles;
  quadrille::simplify_soup(points, triangles, options);

  IndexedMesh mesh = input;
  MeshChannels(mesh).simplify(options, {.of_colors = 1e-9, .of_textures = 1e-9});
  CHECK(mesh.triangles.size() == triangles.size());
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const std::size_t before = vertex_at(input, mesh.points[v]);
    CHECK(mesh.colors[v] == input.colors[before]);
    CHECK(mesh.texture_coordinates[v] == input.texture_coordinates[before]);
  }
}

TEST_CASE("What varies is carried, at any size of model and attributes", "[mesh_attributes]") {
  for (const double unit : {1e-310, 1e-150, 1., 1e150, 1e300})
    for (const double size : {1e-150, 1e-5, 1., 1e150}) {
      CAPTURE(unit, size);
      IndexedMesh mesh = sheet(8);
      for (Point& p : mesh.points)
        p = Point(size * p.x(), size * p.y(), size * p.z());
      for (auto& [u, v] : mesh.texture_coordinates)
        u = 5 * unit + unit * u, v *= unit;
      simplify_channels(mesh, 0.5);
      CHECK(mesh.triangles.size() <= 64);
      CHECK(mesh.triangles.size() >= 63); // a boundary edge takes one face along
      for (const auto& [u, v] : mesh.texture_coordinates) {
        CHECK(u / unit > 4.9);
        CHECK(u / unit < 6.3);
      }
      for (const Color& color : mesh.colors)
        CHECK(color[2] == 1. / 3);
    }
}

TEST_CASE("Constant attributes are those of the points that faces use", "[mesh_attributes]") {
  IndexedMesh mesh = sheet(2);
  std::fill(mesh.colors.begin(), mesh.colors.end(), Color{1, 2, 3, 4});
  std::fill(mesh.texture_coordinates.begin(), mesh.texture_coordinates.end(),
            std::array<double, 2>{.1, .2});
  mesh.points.insert(mesh.points.begin(), Point(9, 9, 9));
  mesh.colors.insert(mesh.colors.begin(), Color{});
  mesh.texture_coordinates.insert(mesh.texture_coordinates.begin(), std::array<double, 2>{});
  for (auto& triangle : mesh.triangles)
    for (std::uint32_t& corner : triangle)
      ++corner;
  simplify_channels(mesh, 0.25);
  REQUIRE(mesh.points.size() < 10);
  CHECK(mesh.colors == std::vector<Color>(mesh.points.size(), {1, 2, 3, 4}));
  CHECK(mesh.texture_coordinates ==
        std::vector<std::array<double, 2>>(mesh.points.size(), {.1, .2}));
}

TEST_CASE("Numbers of vertices follow them, and labels are of those that there were",
          "[mesh_attributes]") {
  for (const double ratio : {1., 0.5, 0.1}) {
    CAPTURE(ratio);
    IndexedMesh mesh = sheet_with_numbers(16);
    const IndexedMesh input = mesh;
    REQUIRE(needs_channels(mesh));
    simplify_channels(mesh, ratio);
    for (const NamedNumbers& numbers : mesh.vertex_numbers)
      REQUIRE(numbers.values.size() == mesh.points.size());
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      const double x = mesh.points[v].x();
      const double value = mesh.vertex_numbers[0].values[v];
      CHECK(value == static_cast<float>(value));
      CHECK(std::abs(value - x) < 1);
      const double label = mesh.vertex_numbers[2].values[v];
      CHECK((label == 1000 || label == -7));
      CHECK((label == 1000 ? x < 7.5 : x > 1.5));
      const double gap = mesh.vertex_numbers[1].values[v];
      CHECK((std::isnan(gap) ? mesh.points[v].y() < 6 : gap == std::round(gap)));
      CHECK(mesh.vertex_numbers[3].values[v] == 1);
      CHECK(std::abs(mesh.colors[v][0] - x / 16) < 0.1);
      CHECK(std::abs(mesh.texture_coordinates[v][0] - x / 7) < 0.2);
    }
    if (ratio == 1) {
      CHECK(mesh.points == input.points);
      CHECK(mesh.vertex_numbers[0].values == input.vertex_numbers[0].values);
      CHECK(mesh.vertex_numbers[2].values == input.vertex_numbers[2].values);
    }
  }
}

TEST_CASE("Numbers stay in the range that there was, and more than a few are kept",
          "[mesh_attributes]") {
  IndexedMesh mesh = sheet(12);
  for (int i = 0; i < 12; ++i) {
    mesh.vertex_numbers.push_back({std::to_string(i), single, {}});
    for (const Point& p : mesh.points)
      mesh.vertex_numbers.back().values.push_back(i + (p.x() > 6 && p.y() < 6));
  }
  mesh.vertex_numbers[3].values[0] = 1e200; // weighs nothing beside a length
  simplify_channels(mesh, 0.2);
  for (int i = 0; i < 12; ++i)
    for (const double value : mesh.vertex_numbers[static_cast<std::size_t>(i)].values)
      CHECK((value == 1e200 || (value >= i && value <= i + 1)));
}

TEST_CASE("Constant numbers need no channels", "[mesh_attributes]") {
  IndexedMesh mesh = sheet(4);
  CHECK(needs_channels(mesh));
  mesh.texture_coordinates.clear();
  CHECK(needs_channels(mesh));
  mesh.colors.clear();
  CHECK(!needs_channels(mesh));
  mesh.vertex_numbers = {{"one", single, std::vector<double>(25, 1)}};
  mesh.face_numbers = {{"flags", whole, std::vector<double>(32, 7)}};
  CHECK(!needs_channels(mesh));
  mesh.points.resize(9);
  mesh.triangles.resize(8);
  resize_constants(mesh);
  CHECK(mesh.vertex_numbers[0].values == std::vector<double>(9, 1));
  CHECK(mesh.face_numbers[0].values == std::vector<double>(8, 7));
  mesh.face_numbers[0].values[3] = 8;
  CHECK(needs_channels(mesh));
}

TEST_CASE("Integers and a few colours of faces are regions, numbers and pictures none",
          "[mesh_attributes]") { // of 512 faces
  const auto by = [](std::size_t divisor) {
    return [divisor](std::size_t face) { return face / divisor; };
  };
  CHECK(count_regions("part", whole, by(100)) == 6);
  CHECK(count_regions("part", whole, by(2)) == 256);
  CHECK(count_regions("part", whole, by(1)) == 1);
  CHECK(count_regions("part", single, by(100)) == 1);
  CHECK(count_regions("flags", whole, by(100)) == 1);
  CHECK(count_regions("red", byte, by(8)) == 64);
  CHECK(count_regions("red", byte, by(7)) == 1);
  CHECK(count_regions("green", single, by(100)) == 6);
}

TEST_CASE("Each face keeps its own, and the borders of regions hold", "[mesh_attributes]") {
  IndexedMesh mesh = sheet(16);
  const std::size_t faces = mesh.triangles.size();
  mesh.face_numbers = {{"id", whole, {}}, {"part", whole, {}}, {"area", single, {}}};
  for (std::size_t face = 0; face < faces; ++face) {
    mesh.face_numbers[0].values.push_back(static_cast<double>(face));
    mesh.face_numbers[1].values.push_back(face < faces / 2 ? 1 : 2);
    mesh.face_numbers[2].values.push_back(static_cast<double>(face) / 3);
  }
  simplify_channels(mesh, 0.1);
  CHECK(mesh.triangles.size() < 55);
  const auto& ids = mesh.face_numbers[0].values;
  CHECK(ids.size() == mesh.triangles.size());
  CHECK(std::is_sorted(ids.begin(), ids.end()));
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
    const bool is_first = ids[face] < static_cast<double>(faces / 2);
    CHECK(mesh.face_numbers[1].values[face] == (is_first ? 1 : 2));
    CHECK(mesh.face_numbers[2].values[face] == ids[face] / 3);
    for (const std::uint32_t v : mesh.triangles[face]) // the border is at x = 8
      CHECK((is_first ? mesh.points[v].x() < 8.5 : mesh.points[v].x() > 7.5));
  }
}
TEST_CASE("Sides of a seam keep their values, on one surface", "[mesh_attributes]") {
  // The sheet in two halves, each with vertices of its own along the cut, another colour and label.
  IndexedMesh mesh = sheet_with_numbers(16);
  const auto side_of = [&](std::size_t face) {
    const auto& t = mesh.triangles[face];
    return mesh.points[t[0]].x() + mesh.points[t[1]].x() + mesh.points[t[2]].x() > 24;
  };
  mesh.value_triangles = mesh.triangles;
  std::map<std::uint32_t, std::uint32_t> further;
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face)
    for (std::uint32_t& corner : mesh.value_triangles[face])
      if (side_of(face) && mesh.points[corner].x() == 8)
        corner = further
                     .try_emplace(corner,
                                  static_cast<std::uint32_t>(mesh.points.size() + further.size()))
                     .first->second;
  const auto extend = [&](auto& values) { values.resize(mesh.points.size() + further.size()); };
  extend(mesh.colors);
  extend(mesh.texture_coordinates);
  for (NamedNumbers& numbers : mesh.vertex_numbers)
    extend(numbers.values);
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face)
    for (const std::uint32_t value : mesh.value_triangles[face]) {
      mesh.colors[value] = side_of(face) ? Color{1, 0, 0, 1} : Color{0, 0, 1, 1};
      mesh.vertex_numbers[2].values[value] = side_of(face) ? 5 : 6;
    }

  simplify_channels(mesh, 0.25);
  CHECK(mesh.triangles.size() <= 128);
  REQUIRE(mesh.value_triangles.size() == mesh.triangles.size());
  CHECK(mesh.colors.size() > mesh.points.size());
  CHECK(mesh.vertex_numbers[2].values.size() == mesh.colors.size());
  std::size_t mixed = 0;
  for (const auto& [a, b, c] : mesh.value_triangles)
    for (const std::uint32_t other : {b, c})
      mixed += mesh.colors[a] != mesh.colors[other] ||
               mesh.vertex_numbers[2].values[a] != mesh.vertex_numbers[2].values[other] ||
               (mesh.colors[a][0] == 1) != (mesh.vertex_numbers[2].values[a] == 5);
  CHECK(mixed == 0);
}
