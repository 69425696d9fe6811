#ifndef QUADRILLE_PAIRS_H
#define QUADRILLE_PAIRS_H

#include <quadrille/triangle_soup.h>

#include <cstddef>
#include <functional>

namespace quadrille {

/// The function that a pair policy calls for each pair (i, j) of point indices that it selects, in
/// any order.
using EmitPair = std::function<void(std::size_t, std::size_t)>;

/// The edges of the surface: the original ones and those that contractions create. Disconnected
/// components are never joined.
struct EdgePairs {
  /// Every edge is always a pair, so the call operator selects nothing.
  static constexpr bool includes_edges = true;
  static constexpr bool ignores_indices = true; ///< the engine may reorder points

  /// Emits nothing.
  void operator()(const SurfaceView& /*surface*/, const EmitPair& /*emit*/) const {}
};

struct KeepPlanes;    // is in <quadrille/keep_planes.h>: include that to use it
struct VoxelSize;     // is in <quadrille/voxel_size.h>: include that to use it
class ThresholdPairs; // is in <quadrille/threshold_pairs.h>: include that to use it

/// The ways in which contractions may change the topology of the surface.
enum class Topology {
  kept, ///< the link condition is tested: a manifold stays a manifold, with its genus, boundaries
        ///< and components
  /// As in the 1997 paper: components join, holes close, and edges of three faces may arise. Of
  /// faces that come to have the same three vertices, in either orientation, the one with the lower
  /// index is left.
  free,

  /// Topology is kept, but a connected component may be removed entirely where that is the cheapest
  /// step. Its cost is the square of its distance in the input from all components that are not
  /// smaller, clamped to one to four of its radii, times the total weight of its vertex quadrics,
  /// as if each of their planes were that far away. For a component that touches the rest, with
  /// `Quadric` and without boundaries, this is three times the radius² times the area, the cost of
  /// contracting a sphere to its centre. For a cost without a weight (EdgeLength) it is the cost of
  /// contracting the whole component to its centre, but at least that square.
  ///
  /// The radius is that of a sphere around the centre of the component's bounding box, in all
  /// dimensions of the cost. A duplicate of a large component costs as much as the original. If the
  /// target is a count, a component more than two radii away whose removal would move the surface
  /// by more than a hundredth of the diagonal comes after all steps that move it less, and it stays
  /// if constraints keep most of the remaining surface; a contraction that moves a large component
  /// by more than a fiftieth of its size comes last. A component stays if it is large (its box has
  /// at least a twentieth of the diagonal of the whole), if it has a constrained vertex or edge, or
  /// if it is the most costly one. The last faces of a label may vanish with their component. If
  /// the stop policy needs distances, as DistanceLimit does, no component vanishes whose diameter
  /// (twice the radius, in space) would exceed its limit. Filters are not called. It takes eight
  /// more bytes per vertex, and linear time at the beginning and after each pass of RelaxedOrder.
  components_may_vanish
};

} // namespace quadrille

#endif // QUADRILLE_PAIRS_H
