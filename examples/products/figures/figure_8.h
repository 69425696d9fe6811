#ifndef QUADRILLE_EXAMPLES_FIGURES_FIGURE_8_H
#define QUADRILLE_EXAMPLES_FIGURES_FIGURE_8_H

#include "pictures.h"
#include "surfaces.h"

#include <quadrille/distance.h>
#include <quadrille/parameters.h>
#include <quadrille/quadric_form.h>
#include <quadrille/report.h>
#include <quadrille/simplify.h>
#include <quadrille/triangle_soup.h>

#include <CGAL/Polygon_mesh_processing/compute_normal.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <vector>

namespace figures {

using QuadricMap = Mesh::Property_map<Vertex, quadrille::QuadricForm<3>>;

/// The quadrics of a mesh, for `simplify` to write.
inline QuadricMap quadrics(Mesh& mesh) {
  return mesh.add_property_map<Vertex, quadrille::QuadricForm<3>>("v:quadric").first;
}

/// The quadrics of a simplified bunny as ellipsoids: thin across the surface, wide along it where
/// it is flat, and long along its creases.
struct Figure8 {
  Mesh mesh;
  quadrille::Report report;
  double level;         ///< of the ellipsoids
  double across, along; ///< medians of their radii, along the normal and in the surface
  quadrille::TriangleSoup<Point> ellipsoids;

  explicit Figure8(const fs::path& models) : mesh(read_model(models, "bunny00")) {
    using namespace quadrille;
    const double diagonal = bounding_box_diagonal(mesh);
    level = 0.002 * diagonal;
    report = simplify<Quadric, OptimalPlacement>(mesh, FaceCount{1000},
                                                 parameters::vertex_quadric_map(quadrics(mesh)));
    mesh.collect_garbage();
    measure();
    ellipsoids =
        quadric_ellipsoids(mesh, quadrics(mesh), {.level = level, .longest = 0.04 * diagonal});
  }

  void print() const {
    std::printf("vertices   level   radius across the surface   along it (medians)\n"
                "%8u %7.4f %27.4f %10.4f\n",
                mesh.number_of_vertices(), level, across, along);
  }

  void write(const fs::path& folder) const {
    figures::write(mesh, folder, "8_bunny_1000");
    figures::write(ellipsoids, folder, "8_bunny_1000_ellipsoids");
  }

private:
  void measure() {
    std::vector<double> all_across, all_along;
    for (const Vertex v : mesh.vertices()) {
      const auto n = CGAL::Polygon_mesh_processing::compute_vertex_normal(v, mesh);
      const quadrille::Vector<3> normal{{n.x(), n.y(), n.z()}};
      const auto& a = quadrics(mesh)[v].matrix();
      const double steepness = dot(normal, a * normal);
      all_across.push_back(level / std::sqrt(steepness));
      all_along.push_back(level / std::sqrt((a.trace() - steepness) / 2));
    }
    across = median(all_across);
    along = median(all_along);
  }

  static double median(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }
};

} // namespace figures

#endif
