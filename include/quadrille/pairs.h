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

/// Whether contractions may change the topology of the surface.
enum class Topology {
  kept, ///< the link condition is asked: a manifold stays one, with its genus, borders and parts
  /// As in the 1997 paper: parts join, holes close, edges of three faces may arise. Of faces that
  /// come to lie on the same three vertices the lower one is left, whichever way round they are.
  free,

  /// Kept, but that a part, what no vertex connects with the rest, may vanish whole where that is
  /// the cheapest thing to do. It costs the square of how far it lies from all parts that are no
  /// smaller, from one to four radii of it, as it was in the input, times the weight of all that
  /// its vertices remember, as if each of their planes were so far away: where it touches the rest,
  /// with `Quadric` and without borders three times the radius² times the area, which is what
  /// contracting a sphere to its centre costs. A cost without a weight (EdgeLength) is asked for
  /// the contraction of the whole part to its centre instead, and says at least that square.
  ///
  /// The radius is that of a sphere around the centre of the part's bounding box, in all dimensions
  /// of the cost. A duplicate of a large sheet costs as much as the sheet. Where the target is a
  /// count, a part more than two radii away that would move the surface by more than a hundredth of
  /// the diagonal comes behind all that moves it less, and stays where most of what is left is
  /// held; a contraction that moves a large part by more than a fiftieth of its size comes last. A
  /// large part stays, whose box has a twentieth of the diagonal of the whole or more, and one with
  /// a constrained vertex or edge, and so does the part that costs most. The last faces of a label
  /// may go with their part. Where the stop policy asks for distances, as DistanceLimit does, no
  /// part vanishes whose diameter (twice the radius, in space) it would stop at. Filters are not
  /// asked. Takes eight bytes more a vertex, and time that is linear at the beginning and after
  /// each pass of RelaxedOrder.
  parts_may_vanish
};

} // namespace quadrille

#endif // QUADRILLE_PAIRS_H
