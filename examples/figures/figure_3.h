#ifndef QUADRILLE_EXAMPLES_FIGURES_FIGURE_3_H
#define QUADRILLE_EXAMPLES_FIGURES_FIGURE_3_H

#include "generate.h"
#include "surfaces.h"

#include <quadrille/distance.h>
#include <quadrille/report.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <cstddef>
#include <cstdio>
#include <string>

namespace figures {

/// A hundred cubes that lie close together, by edges and by pairs. By edges they vanish one after
/// the other; by pairs they become one block.
struct Figure3 {
  static constexpr double gap = 0.1;

  struct Result {
    Soup soup;
    quadrille::Report report;
    quadrille::SurfaceDistance error;
  };
  Soup original;
  Result by_edges, by_pairs;

  explicit Figure3(const fs::path& /*models*/)
      : original(cubes(10, 10, gap)), by_edges(simplified(quadrille::EdgePairs{})),
        by_pairs(simplified(quadrille::ThresholdPairs{1.5 * gap})) {}

  void print() const {
    std::printf("          faces  components  Hausdorff, %% of diagonal\n");
    print_row("edges", by_edges);
    print_row("pairs", by_pairs);
  }

  void write(const fs::path& folder) const {
    figures::write(original, folder, "3_cubes");
    figures::write(by_edges.soup, folder, "3_cubes_edges");
    figures::write(by_pairs.soup, folder, "3_cubes_pairs");
  }

private:
  static constexpr std::size_t faces = 840; // of a block of 10 × 10 cubes, its inner walls once

  Result simplified(const auto& pairs) const {
    using namespace quadrille;
    Result result{original, {}, {}};
    auto& [points, triangles] = result.soup;
    result.report = simplify<Quadric, OptimalPlacement>(points, triangles, FaceCount{faces}, pairs);
    result.error = surface_distance(original.points, original.triangles, points, triangles);
    return result;
  }

  void print_row(const char* pairs, const Result& result) const {
    const quadrille::Report& report = result.report;
    std::printf("%-8s %6zu %6zu -> %-3zu %20.2f\n", pairs, report.faces_after,
                report.components_before, report.components_after,
                100 * result.error.hausdorff / quadrille::bounding_box_diagonal(original.points));
  }
};

} // namespace figures

#endif
