#ifndef QUADRILLE_INTERNAL_GUARDS_DISTANCE_FACE_OF_STAR_H
#define QUADRILLE_INTERNAL_GUARDS_DISTANCE_FACE_OF_STAR_H

#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/surface/flat_polygons.h>
#include <quadrille/quadric_form.h>

#include <array>
#include <cstddef>
#include <utility>

namespace quadrille::internal {

/// A face of a star before the contraction.
struct FaceOfStar {
  std::array<Vector<3>, 3> corners; // an end of the pair comes first
  Vector<3> area;
  Index second, third;
  double bound;
  std::size_t end;
  bool is_shared;
  FlatTriangle flat = {}; // in the plane of the fan at hand

  /// Winds it the other way.
  void turn_over() {
    std::swap(corners[1], corners[2]);
    std::swap(second, third);
    area = -1.0 * area;
  }
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GUARDS_DISTANCE_FACE_OF_STAR_H
