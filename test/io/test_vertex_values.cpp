// Named numbers of vertices on their way through a simplification.
#include "../../examples/products/mesh_io/attributes/vertex_values.h"

#include <catch2/catch.hpp>

#include <vector>

using namespace quadrille_examples;

TEST_CASE("Numbers of vertices stay in the range that faces have of them") {
  IndexedMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}, {6, 6, 6}};
  mesh.triangles = {{0, 1, 2}};
  mesh.vertex_numbers = {{"quality", {4, false, true}, {0.25, 0.5, 1, 1e9, -1e9}}};
  VertexNumbers numbers(mesh);
  REQUIRE(numbers.channels().size() == 1);
  numbers.channels()[0].corners.values = {{-3.0}, {0.75}, {7.0}, {1e9}, {-1e9}};
  numbers.restore(mesh, {0, 1, 2, 3, 4});
  CHECK(mesh.vertex_numbers[0].values[0] == 0.25);
  CHECK(mesh.vertex_numbers[0].values[1] == 0.75);
  CHECK(mesh.vertex_numbers[0].values[2] == 1);
}
