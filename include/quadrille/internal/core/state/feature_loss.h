#ifndef QUADRILLE_INTERNAL_CORE_STATE_FEATURE_LOSS_H
#define QUADRILLE_INTERNAL_CORE_STATE_FEATURE_LOSS_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/state/contraction.h>
#include <quadrille/internal/core/surface/flat_polygons.h>
#include <quadrille/internal/core/surface/geometry.h>
#include <quadrille/internal/core/surface/scale.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace quadrille::internal {

/// The extent of the surface that a contraction moves, times the square of the distance, as a
/// fraction of the fourth power of the diagonal: its error² · (one-ring radius)², or its cost if
/// that is less, as it is for narrow faces. (Lines along boundaries weigh much in a cost, so it is
/// no measure by itself.) It is an integer, so that the sum of many does not depend on their order,
/// and threads may add them up in any.
class Displacement {
public:
  /// `diagonal` of the surface in the mesh's unit, `length` the same in the engine's.
  Displacement(double diagonal, double length)
      : to_engine_(diagonal > 0 ? length / diagonal : 0),
        factor_(length > 0 ? one / length / length / length / length : 0) {}

  /// `error` in the mesh's unit, the others in the engine's.
  std::uint64_t operator()(double error, double squared_ring_radius, double cost) const {
    const double displacement = to_engine_ * error;
    const double fraction =
        factor_ * (std::min)(cost, displacement * displacement * squared_ring_radius);
    return fraction > 0 && fraction < most ? static_cast<std::uint64_t>(fraction)
                                           : 0; // else it is no distance
  }

  /// Returns a sum of displacements as a fraction of the fourth power of the diagonal.
  static double fraction(std::uint64_t sum) { return static_cast<double>(sum) / one; }

private:
  static constexpr double one = 0x1p52, most = 4 * one;

  double to_engine_, factor_;
};

inline constexpr double coarse_error = 1. / 50; // of the diagonal: see is_measured()

/// From a place that an end of a contraction leaves to the nearest face around it; to the target
/// where there is none.
template <class Cost>
double distance_left(const Vector<3>& place, const Contraction<Cost>& contraction,
                     const Geometry<Cost::dimension>& geometry) {
  const Vector<3> target = space(contraction.target());
  const auto at = [&](Index v) { return space(geometry.position(v)); };
  double squared = squared_distance(place, target);
  contraction.star().for_each_changed([&](const StarFace& f) {
    squared =
        (std::min)(squared, squared_distance_to_triangle(place, target, at(f.second), at(f.third)));
  });
  return std::sqrt(squared);
}

template <class Cost>
QUADRILLE_NOINLINE double displacement_where_thin(const Contraction<Cost>& contraction,
                                                  const Geometry<Cost::dimension>& geometry) {
  const auto of_end = [&](Index end, const auto& place) {
    return geometry.feature_loss(end) + distance_left(space(place), contraction, geometry);
  };
  return (std::max)(of_end(contraction.first(), contraction.pair().first),
                    of_end(contraction.second(), contraction.pair().second));
}

/// Returns how far the faces that a contraction leaves lie from those that it changes: measured in
/// the middles of the faces and of their edges. The planes in the state of a vertex do not cover
/// faces that come to span a hole.
template <class Cost>
QUADRILLE_NOINLINE double deviation_of(const Contraction<Cost>& contraction,
                                       const Geometry<Cost::dimension>& geometry) {
  const Vector<3> target = space(contraction.target());
  const PairStar& star = contraction.star();
  const auto at = [&](Index v) { return space(geometry.position(v)); };
  const auto squared_from_star = [&](const Vector<3>& place) {
    double squared = std::numeric_limits<double>::infinity();
    const auto look_at = [&](const AppendBuffer<StarFace>& faces, Index end) {
      for (const StarFace& f : faces)
        squared = (std::min)(
            squared, squared_distance_to_triangle(place, at(end), at(f.second), at(f.third)));
    };
    look_at(star.first, contraction.first());
    look_at(star.shared, contraction.first());
    look_at(star.second, contraction.second());
    return squared;
  };
  double greatest = squared_from_star(target);
  star.for_each_changed([&](const StarFace& f) {
    const Vector<3> second = at(f.second), third = at(f.third);
    for (const Vector<3>& place :
         {0.5 * (target + second), 0.5 * (target + third), 1. / 3 * (target + second + third)})
      greatest = (std::max)(greatest, squared_from_star(place));
  });
  return std::sqrt(greatest);
}

/// Is the error of a contraction so great, compared with the whole surface, that its effect is
/// measured? A mean over planes is no measure of such coarse faces.
template <class Cost>
bool is_measured(const Contraction<Cost>& contraction, const Scale<Cost::dimension>& scale) {
  return contraction.error() > coarse_error * scale.diagonal();
}

/// An upper limit of the distance from places that have been contracted to the ends of a
/// contraction to the faces around it: the sum of the displacements of these places. It is measured
/// where the surface is or was thin, and 0 elsewhere.
///
/// The planes of a thin wall have little weight, as its area is small. The mean distance of a
/// vertex to the planes in its state therefore hides it if a corner moves far away from such a
/// wall.
template <class Cost>
QUADRILLE_ALWAYS_INLINE inline FeatureLoss
feature_loss_of(const Contraction<Cost>& contraction, const Geometry<Cost::dimension>& geometry,
                const Scale<Cost::dimension>& scale) {
  double displacement = 0, error = contraction.error();
  if (geometry.is_thin(contraction.first()) || geometry.is_thin(contraction.second())) [[unlikely]]
    displacement = displacement_where_thin(contraction, geometry);
  if (is_measured(contraction, scale)) [[unlikely]]
    error = (std::max)(error, scale.length_of_mesh(deviation_of(contraction, geometry)));
  return {displacement, (std::max)(error, scale.length_of_mesh(displacement))};
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_STATE_FEATURE_LOSS_H
