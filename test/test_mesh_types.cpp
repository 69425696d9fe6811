// Every kind of mesh, with every kernel, is simplified as any other.
#include "mesh_types.h"
#include "soups.h"

#include <catch2/catch.hpp>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_items_with_id_3.h>

#include <quadrille/simplify.h>

#include <cstddef>
#include <type_traits>

using namespace quadrille;

namespace {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using WithIds = CGAL::Polyhedron_3<Epick, CGAL::Polyhedron_items_with_id_3>;

} // namespace

TEMPLATE_TEST_CASE("Every mesh is simplified to a valid one of as many faces", "",
                   CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>, test::Mesh,
                   CGAL::Surface_mesh<Epick::Point_3>,
                   CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>,
                   test::Polyhedron, WithIds, test::CellComplex, test::PolyMesh,
                   test::FloatPolyMesh, test::FloatTriMesh) {
  for (const test::Soup& soup : {test::random_closed(1), test::random_with_borders(1)}) {
    TestType mesh = test::convert<TestType>(soup);
    if constexpr (std::is_same_v<TestType, WithIds>)
      CGAL::set_halfedgeds_items_id(mesh);
    const Report report = simplify<Quadric, OptimalPlacement>(mesh, FaceRatio{0.5});
    std::size_t faces_left = 0;
    for ([[maybe_unused]] auto f : faces(mesh))
      ++faces_left;
    CHECK(faces_left == report.faces_after);
    CHECK(2 * report.faces_after <= soup.triangles.size() + 1);
    CHECK(CGAL::is_valid_polygon_mesh(mesh));
    CHECK(CGAL::is_triangle_mesh(mesh));
  }
}
