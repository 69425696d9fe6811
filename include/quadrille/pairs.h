#ifndef QUADRILLE_PAIRS_H
#define QUADRILLE_PAIRS_H

#include <quadrille/triangle_soup.h>

#include <cstddef>
#include <functional>

namespace quadrille {

/// What a pair policy calls for each pair (i, j) of indices of points that it selects, in any
/// order.
using EmitPair = std::function<void(std::size_t, std::size_t)>;

/// The edges of the surface: those that it has at the beginning and those that contractions make.
/// Disjoint parts are never joined.
struct EdgePairs {
  /// Every edge is a pair at any time, and there is nothing more to select.
  static constexpr bool includes_edges = true;
  static constexpr bool ignores_indices = true; ///< points may come in another order

  /// Emits nothing.
  void operator()(const SurfaceView& /*surface*/, const EmitPair& /*emit*/) const {}
};

class ThresholdPairs; // is in <quadrille/threshold_pairs.h>: include that to use it

} // namespace quadrille

#endif // QUADRILLE_PAIRS_H
