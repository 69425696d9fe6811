#ifndef QUADRILLE_EXAMPLES_FIGURES_FIGURE_2_H
#define QUADRILLE_EXAMPLES_FIGURES_FIGURE_2_H

#include "surfaces.h"

#include <quadrille/distance.h>
#include <quadrille/report.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <cstdio>
#include <string>

namespace figures {

/// The bones of a foot, 4,204 → 250 faces, by edges and by pairs. By edges the small bones at the
/// ends of the toes vanish, and the toes recede; by pairs they grow together with their neighbours.
///
/// The model is 11.3 × 3.7 × 4.3 units large, and the paper clusters it in 11 × 4 × 4 cells: its
/// scale is the paper's, and so is the threshold.
struct Figure2 {
  static constexpr double threshold = 0.318;

  struct Result {
    Soup soup;
    quadrille::Report report;
    quadrille::SurfaceDistance error;
  };
  Soup original;
  Result by_edges, by_pairs;

  explicit Figure2(const fs::path& models)
      : original(soup_of(read_model(models, "bones"))),
        by_edges(simplified(quadrille::EdgePairs{})),
        by_pairs(simplified(quadrille::ThresholdPairs{threshold})) {}

  void print() const {
    std::printf("             faces  components  non-manifold edges  Hausdorff, %% of diagonal\n");
    print_row("edges", by_edges);
    print_row("pairs", by_pairs);
  }

  void write(const fs::path& folder) const {
    figures::write(original, folder, "2_bones");
    figures::write(by_edges.soup, folder, "2_bones_250_edges");
    figures::write(by_pairs.soup, folder, "2_bones_250_pairs");
  }

private:
  Result simplified(const auto& pairs) const {
    using namespace quadrille;
    Result result{original, {}, {}};
    auto& [points, triangles] = result.soup;
    const Quadric as_in_1997{.weighting = Weighting::uniform};
    result.report = simplify(points, triangles, as_in_1997, FaceCount{250}, pairs);
    result.error = surface_distance(original.points, original.triangles, points, triangles);
    return result;
  }

  void print_row(const char* pairs, const Result& result) const {
    const quadrille::Report& report = result.report;
    std::printf("%-10s %7zu %7zu -> %-2zu %15zu %22.2f\n", pairs, report.faces_after,
                report.components_before, report.components_after, report.non_manifold_edges,
                100 * result.error.hausdorff / quadrille::bounding_box_diagonal(original.points));
  }
};

} // namespace figures

#endif
