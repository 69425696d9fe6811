#ifndef QUADRILLE_EXAMPLES_FIGURES_FIGURE_3_H
#define QUADRILLE_EXAMPLES_FIGURES_FIGURE_3_H

#include "edges_and_pairs.h"
#include "generate.h"
#include "surfaces.h"

#include <cstddef>

namespace figures {

/// A hundred cubes that lie close together, by edges and by pairs. By edges they vanish one after
/// the other; by pairs they become one block.
struct Figure3 : EdgesAndPairs {
  static constexpr double gap = 0.1;
  static constexpr std::size_t faces = 840; // of a block of 10 × 10 cubes, its inner walls once

  explicit Figure3(const fs::path& /*models*/)
      : EdgesAndPairs("3_cubes", cubes(10, 10, gap), {}, faces, 1.5 * gap) {}
};

} // namespace figures

#endif
