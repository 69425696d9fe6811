#ifndef QUADRILLE_EXAMPLES_FIGURES_FIGURE_7_H
#define QUADRILLE_EXAMPLES_FIGURES_FIGURE_7_H

#include "surfaces.h"

#include <quadrille/distance.h>
#include <quadrille/report.h>
#include <quadrille/simplify.h>

#include <cstdio>
#include <string>

namespace figures {

/// The bunny of 75,408 faces to 100, and how long that takes.
struct Figure7 {
  Mesh mesh;
  quadrille::Report report;
  double rms; ///< of the distance to the original, of its diagonal

  explicit Figure7(const fs::path& models) : mesh(read_model(models, "bunny00")) {
    using namespace quadrille;
    const Mesh original = mesh;
    report = simplify<Quadric, OptimalPlacement>(mesh, FaceCount{100});
    mesh.collect_garbage();
    rms = surface_distance(original, mesh).rms / bounding_box_diagonal(original);
  }

  void print() const {
    std::printf("faces            seconds   of 1997 (69,451 faces)   RMS, %% of diagonal\n"
                "%zu -> %zu %10.3f %24d %21.3f\n",
                report.faces_before, report.faces_after, report.seconds.total(), 15, 100 * rms);
  }

  void write(const fs::path& folder) const { figures::write(mesh, folder, "7_bunny_100"); }
};

} // namespace figures

#endif
