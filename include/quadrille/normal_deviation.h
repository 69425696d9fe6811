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
/// Each contraction maps the surface onto what is left: both ends of the pair, and all faces with
/// them, go to the new vertex. No normal of the result is further than `degrees` from the normal of
/// any face of the input that all of these map into it, or onto one of its edges. NormalFlip looks
/// at a single contraction, so that a face may turn over in several; this one bounds the sum, and
/// below 90 degrees nothing folds over what it stands for.
///
/// Each face carries a cone around the normals that it stands for, so what is promised is kept, and
/// more than that may be: where a surface bends, cones are as wide as it bends there. What would
/// leave them is refused: Rejection::normal_deviation. Report::normal_bound_degrees tells the
/// greatest angle, as the cones bound it. Faces of the input without an area have no normal, and
/// those of the result have none to be compared; which these are, doubles decide. Where topology is
/// free, a contraction is refused that takes a face and leaves none at the edge that it becomes. A
/// part that goes whole, with Topology::parts_may_vanish, leaves nothing to compare.
///
/// For any order. Where points are of floats, or coordinates_are_floats, it is kept of the result
/// as rounded to floats. 16 bytes a face, and about one microsecond a contraction.
struct NormalDeviation {
  double degrees = 60; ///< in (0, 180)

  static constexpr Rejection cause = Rejection::normal_deviation; ///< what is refused counts as it
  static constexpr bool works_in_passes = true; ///< each face has a cone of its own

  /// Throws std::invalid_argument for an angle that is not in (0, 180).
  void validate() const {
    if (!(degrees > 0 && degrees < 180))
      throw std::invalid_argument("quadrille::NormalDeviation: " + internal::text_of(degrees) +
                                  " degrees are not in (0, 180)");
  }

  /// For the engine: what bounds the normals.
  template <std::size_t N>
  std::unique_ptr<internal::SurfaceGuard<N>> make_guard(const internal::GuardRoom<N>& room) const {
    return std::make_unique<internal::FaceCones<N>>(room, degrees);
  }
};

} // namespace quadrille

#endif // QUADRILLE_NORMAL_DEVIATION_H
