#ifndef QUADRILLE_EXAMPLES_FIGURES_FIGURE_2_H
#define QUADRILLE_EXAMPLES_FIGURES_FIGURE_2_H

#include "edges_and_pairs.h"
#include "surfaces.h"

#include <quadrille/cluster.h>

namespace figures {

/// The bones of a foot, 4,204 → 250 faces, by clustering, by edges and by pairs. By edges the small
/// bones at the ends of the toes vanish, and the toes recede; by pairs they grow together with
/// their neighbours. Clustering joins them as well, wherever they share a cell, and at the same
/// number of faces it keeps the shape of none.
///
/// The model is 11.3 × 3.7 × 4.3 units large, and the paper clusters it in 11 × 4 × 4 cells: its
/// scale is the paper's, and so are the threshold and the weights.
struct Figure2 : EdgesAndPairs {
  quadrille::ClusterReport clustering;
  Result by_clustering, by_clustering_with_quadrics;

  explicit Figure2(const fs::path& models)
      : EdgesAndPairs("2_bones", soup_of(read_model(models, "bones")),
                      {.weighting = quadrille::Weighting::uniform}, 250, 0.318),
        by_clustering(clustered(quadrille::ClusterPlacement::mean)),
        by_clustering_with_quadrics(clustered(quadrille::ClusterPlacement::quadric)) {}

  void print() const {
    EdgesAndPairs::print();
    print_row("cells", by_clustering);
    print_row("cells, quadrics", by_clustering_with_quadrics);
    std::printf("\nCells, doubled faces not removed: %zu faces\n",
                clustering.faces_after + clustering.doubled_faces);
  }

  void write(const fs::path& folder) const {
    EdgesAndPairs::write(folder);
    figures::write(by_clustering.soup, folder, name + "_cells");
    figures::write(by_clustering_with_quadrics.soup, folder, name + "_cells_quadrics");
  }

private:
  Result clustered(quadrille::ClusterPlacement placement) {
    Soup soup = original;
    clustering =
        cluster_vertices(soup.points, soup.triangles, quadrille::Grid{11, 4, 4}, placement);
    return measured(std::move(soup));
  }
};

} // namespace figures

#endif
