#ifndef QUADRILLE_EXAMPLES_FIGURES_FIGURE_1_H
#define QUADRILLE_EXAMPLES_FIGURES_FIGURE_1_H

#include "generate.h"
#include "surfaces.h"

#include <quadrille/distance.h>
#include <quadrille/edge_length.h>
#include <quadrille/simplify.h>

#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace figures {

/// The shortest edge first against quadrics: a large difference on a cow, a small one on a sphere.
struct Figure1 {
  struct Row {
    std::string model;
    std::size_t faces_before;
    Mesh by_length, by_quadric;
    quadrille::SurfaceDistance length_error, quadric_error;
    double diagonal;
  };
  std::vector<Row> rows;

  explicit Figure1(const fs::path& models) {
    const Mesh cow = read_model(models, "cow");
    compare("cow", cow, 2000);
    compare("cow", cow, 500);
    compare("sphere", sphere(32, 32), 496);
  }

  void print() const {
    std::printf("                            RMS, %% of diagonal        Hausdorff, %% of d.\n"
                "model      before   after   EdgeLength  Quadric       EdgeLength  Quadric\n");
    for (const Row& row : rows) {
      const double percent = 100 / row.diagonal;
      std::printf("%-8s %8zu %7u %12.4f %8.4f %16.3f %8.3f\n", row.model.c_str(), row.faces_before,
                  row.by_quadric.number_of_faces(), percent * row.length_error.rms,
                  percent * row.quadric_error.rms, percent * row.length_error.hausdorff,
                  percent * row.quadric_error.hausdorff);
    }
  }

  void write(const fs::path& folder) const {
    for (const Row& row : rows) {
      const std::string name =
          "1_" + row.model + "_" + std::to_string(row.by_quadric.number_of_faces());
      figures::write(row.by_length, folder, name + "_edge_length");
      figures::write(row.by_quadric, folder, name + "_quadric");
    }
  }

private:
  void compare(const std::string& model, const Mesh& mesh, std::size_t faces) {
    using namespace quadrille;
    Mesh by_length = mesh, by_quadric = mesh;
    const NormalFlip as_in_the_paper(90, FoldOvers::allowed);
    simplify<EdgeLength, MidpointPlacement>(by_length, FaceCount{faces}, as_in_the_paper);
    simplify<Quadric, OptimalPlacement>(by_quadric, FaceCount{faces}, as_in_the_paper);
    by_length.collect_garbage();
    by_quadric.collect_garbage();
    const SurfaceDistance length_error = surface_distance(mesh, by_length);
    const SurfaceDistance quadric_error = surface_distance(mesh, by_quadric);
    rows.push_back({model, mesh.number_of_faces(), std::move(by_length), std::move(by_quadric),
                    length_error, quadric_error, bounding_box_diagonal(mesh)});
  }
};

} // namespace figures

#endif
