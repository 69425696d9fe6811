// Every kind of mesh, with every kernel, is simplified as any other.
#include "meshes.h"
#include "soups.h"

#include <catch2/catch.hpp>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include <quadrille/simplify.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

using namespace quadrille;

namespace {

using Double = CGAL::Simple_cartesian<double>;
using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using WithIds = CGAL::Polyhedron_3<Epick, CGAL::Polyhedron_items_with_id_3>;
using Complex = CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<
    2, 3, CGAL::Linear_cell_complex_traits<3, Double>>::type;

template <class Mesh>
Mesh make(const test::Soup& soup) {
  using Point = typename boost::property_traits<
      typename boost::property_map<Mesh, CGAL::vertex_point_t>::type>::value_type;
  std::vector<Point> points;
  for (const auto& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  std::vector<std::vector<std::size_t>> triangles;
  for (const auto& t : soup.triangles)
    triangles.push_back({t[0], t[1], t[2]});
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, triangles, mesh);
  return mesh;
}

} // namespace

TEMPLATE_TEST_CASE("Every mesh is simplified to a valid one of as many faces", "",
                   CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>,
                   CGAL::Surface_mesh<Double::Point_3>, CGAL::Surface_mesh<Epick::Point_3>,
                   CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>,
                   CGAL::Polyhedron_3<Double>,
                   WithIds, Complex,
                   OpenMesh::PolyMesh_ArrayKernelT<>, OpenMesh::TriMesh_ArrayKernelT<>) {
  for (const test::Soup& soup : {test::random_closed(1), test::random_with_borders(1)}) {
    TestType mesh = make<TestType>(soup);
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
