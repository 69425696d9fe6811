#ifndef QUADRILLE_INTERNAL_GUARDS_INTERSECTION_FACE_PLANE_H
#define QUADRILLE_INTERNAL_GUARDS_INTERSECTION_FACE_PLANE_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/guards/intersection/triangle_pair.h>
#include <quadrille/vector.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace quadrille::internal {

/// The plane of a face. What is on one side of it does not meet the face: where layers lie close
/// together, that tells most of the faces near one of them apart from it.
///
/// The side is the sign of CGAL's orientation(), by doubles with a bound of their roundings, where
/// that which all points have in common is computed once.
class FacePlane {
public:
  explicit FacePlane(const std::array<Vector<3>, 3>& face) : origin_(face[0]) {
    const Vector<3> u = difference(face[1], origin_), v = difference(face[2], origin_);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = k == 2 ? 0 : k + 1, j = 3 - k - i;
      const double plus = u[i] * v[j], minus = u[j] * v[i];
      normal_[k] = plus - minus;
      doubt_[k] = RoundedSum::tolerance * (std::abs(plus) + std::abs(minus)) + RoundedSum::least;
    }
  }

  /// Is it certain that the corners of another face are on the same side, all of them or all but
  /// one?
  QUADRILLE_ALWAYS_INLINE bool has_on_one_side(const std::array<Vector<3>, 3>& other,
                                               std::size_t but = 3) const {
    const std::size_t first = but == 0 ? 1 : 0;
    const double side = side_of(other[first]);
    if (side == 0)
      return false;
    for (std::size_t i = first + 1; i < 3; ++i)
      if (i != but && !(side * side_of(other[i]) > 0))
        return false;
    return true;
  }

private:
  // 1 in front, −1 behind; 0 where doubles cannot tell.
  QUADRILLE_ALWAYS_INLINE double side_of(const Vector<3>& point) const {
    const Vector<3> way = difference(point, origin_);
    const double height = dot(normal_, way);
    const double doubt = RoundedSum::least + std::abs(way[0]) * doubt_[0] +
                         std::abs(way[1]) * doubt_[1] + std::abs(way[2]) * doubt_[2];
    return height > doubt ? 1 : height < -doubt ? -1 : 0;
  }

  Vector<3> origin_, normal_;
  Vector<3> doubt_; // by how much a coordinate of the normal may be wrong
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GUARDS_INTERSECTION_FACE_PLANE_H
