// A height field stays one with the filter HeightField, as told by areas on the map.
#include "meshes.h"

#include <quadrille/filters.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

using namespace quadrille;
using namespace test;

namespace {

constexpr std::uint32_t side = 48; // squares along each side of a tile

// A tile of the unit square with hills, so many times as high as they are wide.
Soup terrain(double steepness) {
  return mapped(grid(side, side), [steepness](const Position& p) {
    const double waves = std::sin(9 * p[0]) * std::cos(7 * p[1]) +
                         std::sin(31 * p[0] + 17 * p[1]) / 3 + std::cos(53 * p[1] - 41 * p[0]) / 5;
    return Position{{p[0], p[1], 0.1 * steepness * waves}};
  });
}

bool is_at_boundary(std::size_t point) {
  const std::size_t x = point % (side + 1), y = point / (side + 1);
  return x == 0 || x == side || y == 0 || y == side;
}

// Of the faces' outlines on the map, below.
struct OnMap {
  std::size_t bad = 0; // faces that are vertical or turned over
  double area = 0;
};
OnMap on_map(const Soup& soup) {
  OnMap map;
  for (const Triangle& t : soup.triangles) {
    const auto& [p, q, r] = std::array{soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]};
    const double doubled_area = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    map.bad += doubled_area <= 1e-9;
    map.area += doubled_area / 2;
  }
  return map;
}

// With a locked border.
template <class... Policies>
Soup tile_of(Soup soup, const Policies&... policies) {
  const auto is_fixed = boost::make_function_property_map<std::size_t>(
      [](std::size_t point) { return is_at_boundary(point); });
  simplify(soup.points, soup.triangles, FaceRatio{0.1}, policies...,
           CGAL::parameters::vertex_is_constrained_map(is_fixed));
  return soup;
}

template <class... Policies>
void check_tile(double steepness, const Policies&... policies) {
  CAPTURE(steepness);
  const Soup input = terrain(steepness);
  CHECK(on_map(tile_of(input, policies...)).bad > 0);
  const Soup tile = tile_of(input, policies..., NormalFlip{}, HeightField{});
  CHECK(tile.triangles.size() < input.triangles.size() / 9);
  CHECK(on_map(tile).bad == 0);
  CHECK(on_map(tile).area == Approx(1).epsilon(1e-12));
}

} // namespace

TEST_CASE("Tiles of terrain with a locked border have no vertical face") {
  for (double steepness : {0.1, 1.0, 8.0}) {
    check_tile(steepness);
    check_tile(steepness, MemorylessQuadric{});
    check_tile(steepness, RelaxedOrder{});
  }
}

TEST_CASE("The unit of length, the side and the length of the direction do not matter") {
  const Soup input = terrain(1);
  const Soup tile = tile_of(input, NormalFlip{}, HeightField{});
  const Soup other_side = tile_of(input, NormalFlip{}, HeightField{{{0, 0, -1e300}}});
  CHECK(is_identical(tile, other_side));
  for (double unit : {0x1p-600, 0x1p600}) {
    const auto scaled = [unit](const Position& p) { return unit * p; };
    CHECK(is_identical(mapped(tile, scaled),
                       tile_of(mapped(input, scaled), NormalFlip{}, HeightField{})));
  }
}

TEST_CASE("A direction other than upwards, in a mesh") {
  const auto turned = [](const Position& p) { return Position{{p[2], p[0], p[1]}}; };
  const auto back = [](const Position& p) { return Position{{p[1], p[2], p[0]}}; };
  const auto bad_faces = [&](const auto&... filters) {
    Mesh mesh = make_mesh<Mesh>(mapped(terrain(8), turned));
    const auto fixed = mesh.add_property_map<Mesh::Vertex_index, bool>("v:fixed").first;
    for (const Mesh::Vertex_index v : mesh.vertices())
      fixed[v] = mesh.is_border(v);
    simplify(mesh, FaceRatio{0.1}, filters..., CGAL::parameters::vertex_is_constrained_map(fixed));
    return on_map(mapped(to_soup(mesh), back)).bad;
  };
  CHECK(bad_faces() > 0);
  CHECK(bad_faces(NormalFlip{}, HeightField{{{1, 0, 0}}}) == 0);
}

TEST_CASE("Walls of the input stay vertical and show their back nowhere") {
  Soup block = surface_of_cubes(
      12, 12, 3, [](int x, int y, int z) { return z == 0 || (x > 3 && x < 8 && y > 2 && y < 9); });
  std::erase_if(block.triangles, [&](const Triangle& t) { // its bottom
    return block.points[t[0]][2] + block.points[t[1]][2] + block.points[t[2]][2] <= 0;
  });
  for (Position& p : block.points)
    p[2] += 0.02 * std::sin(40 * p[0] + 9 * p[1]);
  const auto backs = [&](const auto&... filters) {
    Soup soup = block;
    simplify(soup.points, soup.triangles, FaceCount{80}, filters...);
    return std::ranges::count_if(
        soup.triangles, [&](const Triangle& t) { return area_vector(soup, t)[2] < -1e-12; });
  };
  CHECK(backs() > 0);
  CHECK(backs(NormalFlip{}, HeightField{}) == 0);
}
