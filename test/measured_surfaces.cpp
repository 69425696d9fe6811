// Each call of <quadrille/distance.h>, for what only has to compile.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <quadrille/bounded_hausdorff.h>
#include <quadrille/distance.h>

#include <array>
#include <cstddef>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Points = std::vector<std::array<double, 3>>;
using Triangles = std::vector<std::array<std::size_t, 3>>;

double measure(const Mesh& mesh, const Points& points, const Triangles& triangles) {
  using namespace quadrille;
  return surface_distance(mesh, mesh).rms + bounded_hausdorff(mesh, mesh, 0.1) +
         surface_distance(points, triangles, points, triangles).hausdorff +
         bounding_box_diagonal(mesh) + bounding_box_diagonal(points);
}
