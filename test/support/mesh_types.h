#ifndef QUADRILLE_TEST_MESH_TYPES_H
#define QUADRILLE_TEST_MESH_TYPES_H

#include "meshes.h"
#include "soups.h"

#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include <cstddef>
#include <vector>

/// \file
/// The four kinds of mesh.

namespace test {

using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using CellComplex = CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<
    2, 3, CGAL::Linear_cell_complex_traits<3, Kernel>>::type;

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
};
#ifdef _GLIBCXX_DEBUG // has vectors of another layout than those in OpenMesh's compiled library
using PolyMesh = Mesh;
using TriMesh = Mesh;
using FloatPolyMesh = Mesh;
using FloatTriMesh = Mesh;
#else
using PolyMesh = OpenMesh::PolyMesh_ArrayKernelT<DoubleTraits>;
using TriMesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;
using FloatPolyMesh = OpenMesh::PolyMesh_ArrayKernelT<>;
using FloatTriMesh = OpenMesh::TriMesh_ArrayKernelT<>;
#endif

/// The soup as any kind of mesh.
template <class M>
M convert(const Soup& soup) {
  using P = typename boost::property_traits<
      typename boost::property_map<M, CGAL::vertex_point_t>::type>::value_type;
  std::vector<P> points;
  for (const auto& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  std::vector<std::vector<std::size_t>> triangles;
  for (const auto& t : soup.triangles)
    triangles.push_back({t[0], t[1], t[2]});
  M mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, triangles, mesh);
  return mesh;
}

} // namespace test

#endif // QUADRILLE_TEST_MESH_TYPES_H
