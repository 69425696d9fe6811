#ifndef QUADRILLE_EXAMPLES_FIGURES_FIGURE_2_H
#define QUADRILLE_EXAMPLES_FIGURES_FIGURE_2_H

#include "edges_and_pairs.h"
#include "surfaces.h"

namespace figures {

/// The bones of a foot, 4,204 → 250 faces, by edges and by pairs. By edges the small bones at the
/// ends of the toes vanish, and the toes recede; by pairs they grow together with their neighbours.
///
/// The model is 11.3 × 3.7 × 4.3 units large, and the paper clusters it in 11 × 4 × 4 cells: its
/// scale is the paper's, and so are the threshold and the weights.
struct Figure2 : EdgesAndPairs {
  explicit Figure2(const fs::path& models)
      : EdgesAndPairs("2_bones", soup_of(read_model(models, "bones")),
                      {.weighting = quadrille::Weighting::uniform}, 250, 0.318) {}
};

} // namespace figures

#endif
