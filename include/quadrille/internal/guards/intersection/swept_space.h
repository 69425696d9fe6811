#ifndef QUADRILLE_INTERNAL_GUARDS_INTERSECTION_SWEPT_SPACE_H
#define QUADRILLE_INTERNAL_GUARDS_INTERSECTION_SWEPT_SPACE_H

#include <quadrille/internal/guards/intersection/triangle_pair.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace quadrille::internal {

/// The space between faces and a point to which they all move: a tetrahedron for each. The old star
/// of a contraction and the new one are its boundary, so the surface passes over a face that meets
/// neither if a point of it lies inside. It would change sides, though no faces intersect before or
/// afterwards.
///
/// It uses doubles: a tetrahedron that is flat up to roundings has no inside. Its sides belong to
/// it, as far as roundings reach, since a face may lie along the one between two of them.
class SweptSpace {
public:
  void begin(const Vector<3>& target) {
    target_ = target;
    cones_.clear();
  }

  /// Another face that goes there.
  void add(const std::array<Vector<3>, 3>& face) {
    const Vector<3> u = face[0] - target_, v = face[1] - target_, w = face[2] - target_;
    const Vector<3> across = cross(v, w);
    const double volume = dot(u, across);
    const double longest2 = (std::max)({squared_length(u), squared_length(v), squared_length(w)});
    const double bound = 0x1p-46 * longest2 * std::sqrt(longest2);
    if (std::abs(volume) > 8 * bound)
      cones_.push_back(
          {{(1 / volume) * across, (1 / volume) * cross(w, u), (1 / volume) * cross(u, v)},
           bound / std::abs(volume)});
  }

  /// Do the faces pass over this point?
  bool has(const Vector<3>& p) const {
    const Vector<3> q = p - target_;
    return std::any_of(cones_.begin(), cones_.end(), [&](const Cone& cone) {
      const double a = dot(q, cone.heights[0]), b = dot(q, cone.heights[1]),
                   c = dot(q, cone.heights[2]);
      return a > -cone.error && b > -cone.error && c > -cone.error && a + b + c < 1 + cone.error;
    });
  }

private:
  /// A tetrahedron by what gives the barycentric coordinates of a point, and by how much these may
  /// be wrong.
  struct Cone {
    std::array<Vector<3>, 3> heights;
    double error;
  };
  Vector<3> target_{};
  std::vector<Cone> cones_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GUARDS_INTERSECTION_SWEPT_SPACE_H
