#ifndef QUADRILLE_EXAMPLES_FIGURES_FIGURE_5_H
#define QUADRILLE_EXAMPLES_FIGURES_FIGURE_5_H

#include "coloured.h"
#include "measures.h"
#include "surfaces.h"

#include <quadrille/attribute_quadric.h>
#include <quadrille/channels.h>
#include <quadrille/distance.h>
#include <quadrille/simplify.h>

#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace figures {

/// Colours in the quadric against colours interpolated: a globe of 18,000 → 1,000 faces and a room
/// of 73,728 → 20,000 and 3,000 faces.
struct Figure5 {
  struct Result {
    Mesh mesh;
    double color_rms; ///< of 255
    double rms;       ///< of the distance to the original, of its diagonal
  };
  struct Row {
    std::string model;
    std::size_t faces_before;
    Result by_quadric, by_color_quadric;
  };
  Mesh original_globe = globe(), original_room = Room::make();
  std::vector<Row> rows;

  explicit Figure5(const fs::path& /*models*/) {
    compare("globe", original_globe, {1000});
    compare("room", original_room, {20'000, 3000});
  }

  void print() const {
    std::printf("                             RMS of colour, of 255     RMS, %% of diagonal\n"
                "model      before   after    Quadric  ColorQuadric     Quadric  ColorQuadric\n");
    for (const Row& row : rows)
      std::printf("%-8s %8zu %7u %10.2f %13.2f %11.4f %13.4f\n", row.model.c_str(),
                  row.faces_before, row.by_quadric.mesh.number_of_faces(), row.by_quadric.color_rms,
                  row.by_color_quadric.color_rms, 100 * row.by_quadric.rms,
                  100 * row.by_color_quadric.rms);
  }

  void write(const fs::path& folder) const {
    figures::write(original_globe, folder, "5_globe");
    figures::write(original_room, folder, "5_room");
    for (const Row& row : rows) {
      const std::string name =
          "5_" + row.model + "_" + std::to_string(row.by_quadric.mesh.number_of_faces());
      figures::write(row.by_quadric.mesh, folder, name + "_quadric");
      figures::write(row.by_color_quadric.mesh, folder, name + "_color_quadric");
    }
  }

private:
  using Colors = Field<3>;

  void compare(const std::string& model, Mesh& mesh, const std::vector<std::size_t>& targets) {
    using namespace quadrille;
    const Colors original(mesh, colors(mesh));
    const auto measured = [&](Mesh& result) -> Result {
      result.collect_garbage();
      const double color_rms = rms_difference(original, Colors(result, colors(result)));
      const double rms = surface_distance(mesh, result).rms / bounding_box_diagonal(mesh);
      return {std::move(result), color_rms, rms};
    };
    for (const std::size_t faces : targets) {
      Mesh by_quadric = mesh, by_color_quadric = mesh;
      simplify<Quadric, OptimalPlacement>(by_quadric, FaceCount{faces});
      transfer(original, by_quadric, colors(by_quadric));
      simplify<ColorQuadric, OptimalPlacement>(
          by_color_quadric, FaceCount{faces},
          CGAL::parameters::vertex_color_map(colors(by_color_quadric)));
      rows.push_back(
          {model, mesh.number_of_faces(), measured(by_quadric), measured(by_color_quadric)});
    }
  }
};

} // namespace figures

#endif
