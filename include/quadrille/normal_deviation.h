#ifndef QUADRILLE_NORMAL_DEVIATION_H
#define QUADRILLE_NORMAL_DEVIATION_H

#include <quadrille/internal/core/base/text.h>
#include <quadrille/internal/core/guard/surface_guard.h>
#include <quadrille/internal/guards/normals/face_cones.h>
#include <quadrille/report.h>

#include <cstddef>
#include <memory>
#include <stdexcept>

namespace quadrille {

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

#endif // QUADRILLE_NORMAL_DEVIATION_H
