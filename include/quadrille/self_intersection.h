#ifndef QUADRILLE_SELF_INTERSECTION_H
#define QUADRILLE_SELF_INTERSECTION_H

// This header includes CGAL's kernel for exact predicates, which is LGPL as the parts are that
// <quadrille/simplify.h> includes. That does not include this one, so that calls that do without
// need not compile it.

#include <quadrille/internal/core/guard/surface_guard.h>
#include <quadrille/internal/guards/intersection/face_intersections.h>
#include <quadrille/internal/guards/intersection/solid_guard.h>
#include <quadrille/pairs.h>
#include <quadrille/report.h>

#include <cstddef>
#include <memory>

namespace quadrille {

/// A guard, an argument of `simplify`: the surface does not pass through itself where it did not
/// before.
///
/// Two faces intersect if they have a point in common beside the vertices and edges that both have:
/// so do faces that lie on each other in a plane, and those that touch where they have no common
/// vertex. No pair of faces of the result intersects that did not in the input. Pairs of the input
/// that intersect may stay or vanish, but those that only touch or overlap in a plane do not come
/// to pass through each other: Report::self_intersections says how many there were, and how
/// many are left. Faces without an area intersect none, and no face loses its area.
///
/// What would make faces intersect is refused: Rejection::self_intersection. All is decided
/// exactly, by CGAL's predicates, on the coordinates that will be written to the mesh: as floats
/// where its points are of floats, or with parameters::coordinates_are_floats. Where faces are in
/// the way of the place of least cost, the vertex goes to an end of its pair.
///
/// For GreedyOrder only. O(log n) for each contraction, as a rule, and 44 bytes a face: all takes
/// three to five times as long.
struct NoSelfIntersection {
  static constexpr const char* name = "quadrille::NoSelfIntersection"; ///< in messages
  static constexpr Rejection cause = Rejection::self_intersection; ///< what is refused counts as it

  /// For the engine: what keeps the faces apart.
  template <std::size_t N>
  std::unique_ptr<internal::SurfaceGuard<N>> make_guard(const internal::GuardRoom<N>& room) const {
    return std::make_unique<internal::FaceIntersections<N>>(room.complex, room.geometry);
  }
};

/// A guard, an argument of `simplify`: a solid stays one, as for printing and simulation.
///
/// It is Topology::kept and NoSelfIntersection{}, and it requires an input that is closed, each
/// edge with as many faces on one side as on the other, and of which no two faces intersect. Then
/// the result is closed and has no faces that intersect; it has the parts of the input, each of its
/// genus, inside of others or beside them as there; and it bounds a volume if the input does, which
/// is all of the above and that parts which lie in others are oriented the other way than these.
/// Report::volume_before and volume_after tell the volume, Report::self_intersections that no faces
/// intersect.
///
/// `simplify` throws std::invalid_argument for an input that is no such surface, with the number of
/// edges that are open, or pairs of faces that intersect, and where the first is; and if it is
/// asked for another Topology. Otherwise it is for GreedyOrder only, and takes the time and the
/// memory of NoSelfIntersection. Solids of two parts that touch each other are closed where they
/// have these vertices or edges in common, and intersect where each has its own.
struct KeepSolid {
  static constexpr const char* name = "quadrille::KeepSolid";      ///< in messages
  static constexpr Rejection cause = Rejection::self_intersection; ///< what is refused counts as it
  static constexpr Topology topology = Topology::kept;             ///< no other one goes with it
  static constexpr bool asks_for_volume = true;                    ///< a solid encloses one

  /// For the engine: refuses what is no solid before anything is changed, and keeps faces apart.
  template <std::size_t N>
  std::unique_ptr<internal::SurfaceGuard<N>> make_guard(const internal::GuardRoom<N>& room) const {
    return std::make_unique<internal::SolidGuard<N>>(room);
  }
};

} // namespace quadrille

#endif // QUADRILLE_SELF_INTERSECTION_H
