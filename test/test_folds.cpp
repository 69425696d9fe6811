// Faces that many turns by less than a right angle fold over their neighbours become rare.

#include "meshes.h"

#include <quadrille/simplify.h>

#include <CGAL/boost/graph/iterator.h>
#include <catch2/catch.hpp>

#include <cstddef>
#include <vector>

namespace {

using namespace quadrille;
using test::Mesh;

// Faces that are more than 90 degrees from one neighbour over a ridge, and from another over a
// valley.
std::size_t folded_faces(const Mesh& mesh) {
  std::size_t count = 0;
  for (const auto face : mesh.faces()) {
    bool over_ridge = false, over_valley = false;
    for (const auto h : CGAL::halfedges_around_face(mesh.halfedge(face), mesh))
      if (!mesh.is_border(mesh.opposite(h))) {
        const auto& p = mesh.point(mesh.source(h));
        const auto& q = mesh.point(mesh.target(h));
        const auto& r = mesh.point(mesh.target(mesh.next(h)));
        const auto& s = mesh.point(mesh.target(mesh.next(mesh.opposite(h))));
        const double dihedral = CGAL::approximate_dihedral_angle(p, q, r, s);
        over_ridge |= dihedral > 0 && dihedral < 90;
        over_valley |= dihedral < 0 && dihedral > -90;
      }
    count += over_ridge && over_valley;
  }
  return count;
}

template <class Cost, class... Order>
std::size_t folds_after(Mesh mesh, const NormalFlip& filter, const Order&... order) {
  simplify<Cost, OptimalPlacement>(mesh, FaceRatio{0.1}, filter, order...);
  return folded_faces(mesh);
}

template <class Cost, class... Order>
void require_few_folds(const std::vector<Mesh>& meshes, const Order&... order) {
  std::size_t allowed = 0, refused = 0;
  for (const Mesh& mesh : meshes) {
    allowed += folds_after<Cost>(mesh, NormalFlip(90, Folds::allowed), order...);
    refused += folds_after<Cost>(mesh, NormalFlip(90), order...);
  }
  CAPTURE(allowed, refused);
  CHECK(allowed > 0);
  CHECK(refused <= allowed / 2);
}

} // namespace

TEST_CASE("Folds that many small turns make are refused") {
  const std::vector<Mesh> meshes{test::read_model("armadillo"), test::read_model("lion-head")};
  for (const Mesh& mesh : meshes)
    REQUIRE(folded_faces(mesh) == 0);
  require_few_folds<Quadric>(meshes);
  require_few_folds<MemorylessQuadric>(meshes);
  require_few_folds<Quadric>(meshes, RelaxedOrder{});
}
