#ifndef QUADRILLE_INTERNAL_CONTRACTION_RECESSION_H
#define QUADRILLE_INTERNAL_CONTRACTION_RECESSION_H

#include <quadrille/internal/base/compiler.h>
#include <quadrille/internal/base/index.h>
#include <quadrille/internal/complex/star_face.h>
#include <quadrille/internal/contraction/contraction.h>
#include <quadrille/internal/distance/flat_pieces.h>
#include <quadrille/internal/surface/geometry.h>
#include <quadrille/internal/surface/scale.h>
#include <quadrille/vector.h>

#include <algorithm>
#include <cmath>

namespace quadrille::internal {

/// From a place that an end of a contraction leaves to the nearest face around it; to the target
/// where there is none.
template <class Cost>
double distance_left_behind(const Vector<3>& place, const Contraction<Cost>& contraction,
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
QUADRILLE_NOINLINE double way_where_thin(const Contraction<Cost>& contraction,
                                         const Geometry<Cost::dimension>& geometry) {
  const auto of_end = [&](Index end, const auto& place) {
    return geometry.recession(end) + distance_left_behind(space(place), contraction, geometry);
  };
  return (std::max)(of_end(contraction.first(), contraction.pair().first),
                    of_end(contraction.second(), contraction.pair().second));
}

/// How far places that have been contracted to the ends of a contraction will be from the faces
/// around it, at most: the sum of the ways that these have receded. Measured where the surface is
/// or was thin, else 0.
///
/// The planes of a thin wall weigh as little as its area is. The mean distance of a vertex to the
/// planes that it remembers therefore hides it if a corner leaves such a wall far behind.
template <class Cost>
QUADRILLE_ALWAYS_INLINE inline Recession recession_of(const Contraction<Cost>& contraction,
                                                      const Geometry<Cost::dimension>& geometry,
                                                      const Scale<Cost::dimension>& scale) {
  if (!geometry.is_thin(contraction.first()) && !geometry.is_thin(contraction.second())) [[likely]]
    return {0, contraction.error()};
  const double way = way_where_thin(contraction, geometry);
  return {way, (std::max)(contraction.error(), scale.length_of_mesh(way))};
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CONTRACTION_RECESSION_H
