#ifndef QUADRILLE_INTERNAL_CORE_STATE_SCRATCH_H
#define QUADRILLE_INTERNAL_CORE_STATE_SCRATCH_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/pairs/pair_tools.h>
#include <quadrille/internal/core/state/counters.h>

#include <cstddef>
#include <vector>

namespace quadrille::internal {

/// Scratch space that contractions share, one after the other. Threads that work in regions of a
/// surface with no vertex in common have one each.
struct Scratch : PairTools {
  using PairTools::PairTools;

  std::size_t number = 0; // of the thread
  PairStar star;          // of the contraction at hand
  Counters counters;
  std::vector<StarFace> faces;   // that the contraction at hand changes, see Cleanup
  std::vector<Index> duplicates; // faces that the contraction at hand has removed as such
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_STATE_SCRATCH_H
