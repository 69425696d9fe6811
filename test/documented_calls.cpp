// What the calls in the documents speak of; documented.sh makes the included file of them.
#include "../examples/products/figures/pictures.h"

#include <CGAL/IO/Color.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iostream>
#include <quadrille/attribute_quadric.h>
#include <quadrille/boundaries.h>
#include <quadrille/calibrated.h>
#include <quadrille/channels.h>
#include <quadrille/cluster.h>
#include <quadrille/cut_handles.h>
#include <quadrille/distance.h>
#include <quadrille/edge_length.h>
#include <quadrille/file.h>
#include <quadrille/file_distance.h>
#include <quadrille/filters.h>
#include <quadrille/guards.h>
#include <quadrille/hidden.h>
#include <quadrille/hull.h>
#include <quadrille/importance.h>
#include <quadrille/join_gaps.h>
#include <quadrille/level_maps.h>
#include <quadrille/level_splits.h>
#include <quadrille/keep_planes.h>
#include <quadrille/levels.h>
#include <quadrille/levels_file.h>
#include <quadrille/manifold.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/placement.h>
#include <quadrille/planar_patches.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplified.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>
#include <quadrille/verify.h>
#include <quadrille/voxel_size.h>
#include <quadrille/weighted.h>
#include <span>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using ColorMap = Mesh::Property_map<Mesh::Vertex_index, CGAL::IO::Color>;
using TextureMap = Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2>;
using MaterialMap = Mesh::Property_map<Mesh::Face_index, int>;

void documented_calls(Mesh& mesh, std::vector<Point>& points,
                      std::vector<std::array<std::size_t, 3>>& triangles, const ColorMap& colors,
                      const TextureMap& uv, const MaterialMap& materials,
                      quadrille::Levels& levels) {
  using namespace quadrille;
  using namespace figures;
  const auto selected = mesh.property_map<Mesh::Face_index, bool>("f:selected").first;
  const auto importance = [](const Vector<3>& place) { return place[2] > 0 ? 4.0 : 1.0; };
#include "documented_calls.inc"
}
