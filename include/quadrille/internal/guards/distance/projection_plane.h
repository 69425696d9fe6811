#ifndef QUADRILLE_INTERNAL_GUARDS_DISTANCE_PROJECTION_PLANE_H
#define QUADRILLE_INTERNAL_GUARDS_DISTANCE_PROJECTION_PLANE_H

#include <quadrille/internal/core/surface/flat_pieces.h>
#include <quadrille/vector.h>

#include <cmath>
#include <cstddef>

namespace quadrille::internal {

/// A plane on which points of space are projected, with coordinates u and v in it.
class ProjectionPlane {
public:
  /// The plane gets this normal. False if it has no length.
  bool look_along(const Vector<3>& normal) {
    const double length = std::sqrt(squared_length(normal));
    if (!(length > 0))
      return false;
    const Vector<3> n = (1 / length) * normal;
    const std::size_t least = std::abs(n[0]) < std::abs(n[1])
                                  ? (std::abs(n[0]) < std::abs(n[2]) ? 0 : 2)
                                  : (std::abs(n[1]) < std::abs(n[2]) ? 1 : 2);
    Vector<3> axis;
    axis[least] = 1;
    u_ = cross(axis, n);
    u_ = (1 / std::sqrt(squared_length(u_))) * u_;
    v_ = cross(n, u_);
    return true;
  }
  /// The point has the coordinates 0 and 0.
  void pass_through(const Vector<3>& point) { zero_ = point; }

  FlatPoint flat(const Vector<3>& p) const {
    const Vector<3> d = p - zero_;
    return {p, dot(d, u_), dot(d, v_)};
  }

private:
  Vector<3> zero_, u_, v_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GUARDS_DISTANCE_PROJECTION_PLANE_H
