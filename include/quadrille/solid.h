#ifndef QUADRILLE_SOLID_H
#define QUADRILLE_SOLID_H

// This header includes what <quadrille/self_intersection.h> does.

#include <quadrille/internal/core/guard/surface_guard.h>
#include <quadrille/internal/guards/intersection/solid_guard.h>
#include <quadrille/report.h>
#include <quadrille/self_intersection.h>
#include <quadrille/topology.h>

#include <cstddef>
#include <memory>

namespace quadrille {

/// What keep_solid() makes: a guard, an argument of `simplify`.
struct KeepSolid {
  static constexpr const char* name = "quadrille::keep_solid";     ///< in messages
  static constexpr Rejection cause = Rejection::self_intersection; ///< what is refused counts as it
  static constexpr Topology topology = Topology::kept;             ///< no other one goes with it
  static constexpr bool asks_for_volume = true;                    ///< a solid encloses one

  /// For the engine: refuses what is no solid before anything is changed, and keeps faces apart.
  template <std::size_t N>
  std::unique_ptr<internal::SurfaceGuard<N>> make_guard(const internal::GuardRoom<N>& room) const {
    return std::make_unique<internal::SolidGuard<N>>(room);
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
inline KeepSolid keep_solid() {
  return {};
}

} // namespace quadrille

#endif // QUADRILLE_SOLID_H
