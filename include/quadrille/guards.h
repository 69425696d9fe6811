#ifndef QUADRILLE_GUARDS_H
#define QUADRILLE_GUARDS_H

// This header includes CGAL's kernel for exact predicates, which is LGPL like the parts of CGAL
// that <quadrille/simplify.h> includes. simplify.h does not include this header, so that calls
// without these guards need not compile it.

#include <quadrille/internal/core/base/text.h>
#include <quadrille/internal/core/guard/surface_guard.h>
#include <quadrille/internal/guards/intersection/face_intersections.h>
#include <quadrille/internal/guards/intersection/solid_guard.h>
#include <quadrille/internal/guards/normals/face_cones.h>
#include <quadrille/pairs.h>
#include <quadrille/report.h>

#include <cstddef>
#include <memory>
#include <stdexcept>

namespace quadrille {

/// A guard, an argument of `simplify`: the surface gets no new self-intersections.
///
/// Two faces intersect if they have a point in common outside of their common vertices and edges.
/// This includes faces that overlap in a plane, and faces that touch where they have no common
/// vertex. No pair of faces of the result intersects that did not in the input. Pairs of the input
/// that intersect may stay or vanish, but pairs that only touch or overlap in a plane will not pass
/// through each other. Report::self_intersections has the numbers of pairs before and after. Faces
/// without an area do not intersect others, and no face loses its area.
///
/// A contraction that would make faces intersect is rejected: Rejection::self_intersection. CGAL's
/// predicates decide this exactly, for the coordinates that will be written to the mesh: as floats
/// if its points are floats, or with parameters::coordinates_are_floats. If faces obstruct the
/// position of least cost, the vertex moves to an end of its pair.
///
/// It works with GreedyOrder only. It takes O(log n) expected time for each contraction and 44
/// bytes per face; the whole simplification takes three to five times as long.
struct NoSelfIntersection {
  static constexpr const char* name = "quadrille::NoSelfIntersection"; ///< for messages
  static constexpr Rejection cause = Rejection::self_intersection;     ///< counts its rejections

  /// Used by the engine: makes the guard that keeps the faces apart.
  template <std::size_t N>
  std::unique_ptr<internal::SurfaceGuard<N>> make_guard(const internal::GuardRoom<N>& room) const {
    return std::make_unique<internal::FaceIntersections<N>>(room.complex, room.geometry);
  }
};

/// A guard, an argument of `simplify`: a solid stays a solid, as needed for printing and
/// simulation.
///
/// It is Topology::kept and NoSelfIntersection{}, and it requires an input that is closed, each
/// edge with as many faces on one side as on the other, and of which no two faces intersect. Then
/// the result is closed and has no faces that intersect; it has the components of the input, each
/// with its genus, nested as in the input; and it bounds a volume if the input does, which means in
/// addition that components inside others have the opposite orientation. Report::volume_before and
/// volume_after are the volumes, and Report::self_intersections confirms that no faces intersect.
///
/// `simplify` throws std::invalid_argument for any other input, with the number of open edges or of
/// intersecting pairs of faces and the position of the first one, and for a call with another
/// Topology. It works with GreedyOrder only, and takes the time and the memory of
/// NoSelfIntersection. Two touching components of a solid are closed if they share the vertices or
/// edges where they touch, and intersect if each has its own.
struct KeepSolid {
  static constexpr const char* name = "quadrille::KeepSolid";      ///< for messages
  static constexpr Rejection cause = Rejection::self_intersection; ///< counts its rejections
  static constexpr Topology topology = Topology::kept;             ///< excludes any other topology
  static constexpr bool asks_for_volume = true;                    ///< a solid encloses a volume

  /// Used by the engine: rejects an input that is not a solid before anything is changed, and makes
  /// the guard that keeps faces apart.
  template <std::size_t N>
  std::unique_ptr<internal::SurfaceGuard<N>> make_guard(const internal::GuardRoom<N>& room) const {
    return std::make_unique<internal::SolidGuard<N>>(room);
  }
};

/// A guard, an argument of `simplify`: normals stay within an angle of those of the input.
///
/// Each contraction maps the old surface onto the new one: both ends of the pair, with their faces,
/// move to the new vertex. No normal of the result deviates by more than `degrees` from the normal
/// of any input face that the composed maps take into its face, or onto one of the face's edges.
/// NormalFlip only tests single contractions, so that a face may flip in several steps; this guard
/// bounds the sum, and below 90 degrees no face folds over the input faces that it stands for.
///
/// Each face has a cone around the normals that it stands for. This is conservative: where a
/// surface bends, the cones are as wide as the bend. A contraction that would exceed the angle is
/// rejected: Rejection::normal_deviation. Report::normal_bound_degrees is the greatest angle, as
/// bounded by the cones. Faces without an area, in the input or the result, have no normal and are
/// ignored; this is decided in doubles. If topology is free, a contraction is rejected that removes
/// a face and leaves no face at the edge that it becomes. A component that is removed, with
/// Topology::components_may_vanish, has nothing to compare.
///
/// It works with any order. If points are floats, or with coordinates_are_floats, it holds for the
/// result as rounded to floats. It takes 16 bytes per face, and about one microsecond per
/// contraction.
struct NormalDeviation {
  double degrees = 60; ///< in (0, 180)

  static constexpr Rejection cause = Rejection::normal_deviation; ///< counts its rejections
  static constexpr bool works_in_passes = true; ///< each face has a cone of its own

  /// Throws std::invalid_argument for an angle that is not in (0, 180).
  void validate() const {
    if (!(degrees > 0 && degrees < 180))
      throw std::invalid_argument("quadrille::NormalDeviation: " + internal::text_of(degrees) +
                                  " degrees are not in (0, 180)");
  }

  /// Used by the engine: makes the guard that bounds the normals.
  template <std::size_t N>
  std::unique_ptr<internal::SurfaceGuard<N>> make_guard(const internal::GuardRoom<N>& room) const {
    return std::make_unique<internal::FaceCones<N>>(room, degrees);
  }
};

} // namespace quadrille

#endif // QUADRILLE_GUARDS_H
