// The transfer of colours and texture coordinates in examples/transfer_attributes.h.

#include "../examples/transfer_attributes.h"

#include <catch2/catch.hpp>

#include <array>
#include <vector>

using namespace quadrille_examples;

namespace {

// 2      colours and texture coordinates are linear in x and y
// | \    .
// 0---1
IndexedMesh right_triangle(double size) {
  IndexedMesh mesh;
  mesh.points = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}};
  mesh.triangles = {{0, 1, 2}};
  mesh.colors = {{0, 0, 0, 255}, {200, 0, 0, 55}, {0, 100, 0, 255}};
  mesh.texture_coordinates = {{0, 0}, {1, 0}, {0, 1}};
  return mesh;
}

} // namespace

TEST_CASE("A point takes the mean of the triangle that is closest to it", "[transfer]") {
  for (const double size : {1., 1e-310, 1e-150, 1e150, 1e300}) {
    CAPTURE(size);
    const IndexedMesh mesh = right_triangle(size);
    const std::vector<Point> points = {{size / 4, size / 2, size}, // over the inside
                                       {size / 2, -size, 0},       // beside the edge 01
                                       {2 * size, -size, 0},       // beyond the corner 1
                                       {0, size, 0}};              // the corner 2
    const std::vector<SurfacePlace> places = closest_places(mesh, points);
    CHECK(sampled(mesh.colors, places) ==
          std::vector<CGAL::IO::Color>{
              {50, 50, 0, 205}, {100, 0, 0, 155}, {200, 0, 0, 55}, {0, 100, 0, 255}});
    const auto textures = sampled(mesh.texture_coordinates, places);
    CHECK(textures[0][0] == Approx(.25));
    CHECK(textures[0][1] == Approx(.5));
    CHECK(textures[2] == std::array<double, 2>{1, 0});
  }
}

TEST_CASE("Triangles without area take no part", "[transfer]") {
  IndexedMesh mesh = right_triangle(1);
  mesh.points.emplace_back(5, 5, 5);
  mesh.colors.emplace_back(9, 9, 9);
  mesh.triangles = {{3, 3, 3}, {0, 1, 1}, {0, 1, 2}};
  CHECK(sampled(mesh.colors, closest_places(mesh, {{5, 0, 0}})) ==
        std::vector<CGAL::IO::Color>{{200, 0, 0, 55}});

  mesh.triangles.pop_back();
  CHECK(sampled(mesh.colors, closest_places(mesh, {{5, 0, 0}, {1, 0, 0}})) ==
        std::vector<CGAL::IO::Color>{{0, 0, 0}, {0, 0, 0}});
}

TEST_CASE("No attributes stay no attributes", "[transfer]") {
  const IndexedMesh mesh = right_triangle(1);
  CHECK(sampled(std::vector<CGAL::IO::Color>{}, closest_places(mesh, mesh.points)).empty());
}
