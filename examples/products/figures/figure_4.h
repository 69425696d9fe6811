#ifndef QUADRILLE_EXAMPLES_FIGURES_FIGURE_4_H
#define QUADRILLE_EXAMPLES_FIGURES_FIGURE_4_H

#include "generate.h"
#include "surfaces.h"

#include <quadrille/simplify.h>

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace figures {

/// The border of a mesh: how long it is, and how far its vertices lie at most from the two circles
/// of radius 1 around the z axis at 0 and at a height.
struct Border {
  double length = 0, distance = 0;

  Border(const Mesh& mesh, double height) {
    for (const auto h : mesh.halfedges()) {
      if (!mesh.is_border(h))
        continue;
      const Point p = mesh.point(mesh.source(h)), q = mesh.point(mesh.target(h));
      length += std::sqrt(CGAL::squared_distance(p, q));
      const double along = std::min(std::abs(p.z()), std::abs(p.z() - height));
      distance = std::max(distance, std::hypot(std::hypot(p.x(), p.y()) - 1, along));
    }
  }
};

/// The wall of a cylinder, 7,960 → 2,460 faces, with and without constraint planes at its borders.
/// Without them the borders recede: along the wall nothing holds them.
struct Figure4 {
  static constexpr double height = 1;

  Mesh original, with, without;

  explicit Figure4(const fs::path& /*models*/)
      : original(cylinder_wall(199, 20, height)), with(simplified(100)), without(simplified(0)) {}

  void print() const {
    std::printf("constraint planes   faces   border's length   its distance from where it was\n");
    print_row("original", original);
    print_row("with", with);
    print_row("without", without);
  }

  void write(const fs::path& folder) const {
    figures::write(original, folder, "4_cylinder");
    figures::write(with, folder, "4_cylinder_with");
    figures::write(without, folder, "4_cylinder_without");
  }

private:
  Mesh simplified(double boundary_weight) const {
    using namespace quadrille;
    Mesh mesh = original;
    simplify(mesh, Quadric{.boundary_weight = boundary_weight}, FaceCount{2460});
    mesh.collect_garbage();
    return mesh;
  }

  static void print_row(const char* name, const Mesh& mesh) {
    const Border border(mesh, height);
    std::printf("%-16s %8u %17.4f %32.4f\n", name, mesh.number_of_faces(), border.length,
                border.distance);
  }
};

} // namespace figures

#endif
