#ifndef QUADRILLE_THRESHOLD_PAIRS_H
#define QUADRILLE_THRESHOLD_PAIRS_H

// This header includes CGAL's kd-tree, which is GPL: a program that includes it comes under the GPL
// (or CGAL's commercial licence). <quadrille/simplify.h> does not include it.

#include <quadrille/internal/core/pairs/close_points.h>
#include <quadrille/internal/core/pairs/kd_tree.h>
#include <quadrille/pairs.h>

namespace quadrille {

/// The edges of the surface, and all pairs of vertices that are closer than a threshold t at the
/// beginning: components that lie close to each other are joined. A pair at exactly the distance t
/// does not count.
///
/// Points that no face uses make no pairs. A t of less than 2^-1000 times the largest coordinate
/// counts as that.
///
/// The pairs are found with CGAL's kd-tree, in O(n log n + pairs) for n vertices.
/// Source: Garland and Heckbert 1997, section 3.2.
class ThresholdPairs {
public:
  static constexpr bool includes_edges = true;  ///< edges are pairs, too
  static constexpr bool ignores_indices = true; ///< the engine may reorder points

  /// t is in the mesh's units, at least 0 and finite. A vertex can have O(n) others within t, so
  /// more than 64 times as many pairs as vertices are rejected.
  explicit ThresholdPairs(double t) : threshold_(t, false) {}

  /// t as a fraction of the diagonal of the bounding box.
  static ThresholdPairs relative(double fraction) {
    ThresholdPairs pairs(fraction);
    pairs.threshold_ = {fraction, true};
    return pairs;
  }

  /// Throws std::invalid_argument for a threshold that is negative or not finite.
  void validate() const { threshold_.validate(); }

  /// Calls emit(i, j) for each pair of points i < j closer than t, ordered by i, then by j. Throws
  /// std::length_error, before the first call, if there are more of them than allowed.
  void operator()(const SurfaceView& surface, const EmitPair& emit) const {
    threshold_.emit_pairs<internal::KdTree>(surface, emit);
  }

private:
  internal::PairThreshold threshold_;
};

} // namespace quadrille

#endif // QUADRILLE_THRESHOLD_PAIRS_H
