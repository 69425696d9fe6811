#ifndef QUADRILLE_INTERNAL_GUARDS_INTERSECTION_FACE_SIDES_H
#define QUADRILLE_INTERNAL_GUARDS_INTERSECTION_FACE_SIDES_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/guards/intersection/triangle_pair.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace quadrille::internal {

/// The plane of a face. An object on one side of it does not meet the face: if layers lie close
/// together, that separates most of the faces near one of them from it.
///
/// The side is the sign of CGAL's orientation(), in doubles with a bound of their roundings; the
/// terms that all points have in common are computed once.
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
  // Returns 1 in front, −1 behind; 0 if doubles cannot decide it.
  QUADRILLE_ALWAYS_INLINE double side_of(const Vector<3>& point) const {
    const Vector<3> displacement = difference(point, origin_);
    const double height = dot(normal_, displacement);
    const double doubt = RoundedSum::least + std::abs(displacement[0]) * doubt_[0] +
                         std::abs(displacement[1]) * doubt_[1] +
                         std::abs(displacement[2]) * doubt_[2];
    return height > doubt ? 1 : height < -doubt ? -1 : 0;
  }

  Vector<3> origin_, normal_;
  Vector<3> doubt_; // by how much a coordinate of the normal may be wrong
};

/// Planes through the corners of a face, perpendicular to it, with the face on one side: nearly
/// along each edge, but turned away from it a little about the corner, so that rounding does not
/// matter. An object behind one of them does not meet the face, and neither do faces of which one
/// lies on one side of the other's plane. Most of the faces near it satisfy one of these tests:
/// that takes less time than TrianglePair does.
class FaceSides {
public:
  explicit FaceSides(const FaceCorners& face) : face_(face), plane_(face.points) {
    const auto& p = face_.points;
    const std::array<Vector<3>, 3> edges{difference(p[1], p[0]), difference(p[2], p[1]),
                                         difference(p[0], p[2])};
    const Vector<3> normal = cross(edges[0], edges[1]);
    const double turn =
        0x1p-20 * (std::max)({std::abs(normal[0]), std::abs(normal[1]), std::abs(normal[2])});
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t end = next(i), before = next(end);
      const Vector<3> outwards = cross(edges[i], normal), away = turn * edges[i];
      at_begin_[i] = outwards - away;
      at_end_[end] = outwards + away;
      const Vector<3>&to_next = edges[i], &from_previous = edges[before], &beyond = edges[end];
      is_certain_ &= rounded_dot(at_begin_[i], to_next).is_negative() &&
                     rounded_dot(at_begin_[i], from_previous).is_positive() &&
                     rounded_dot(at_end_[end], to_next).is_positive() &&
                     rounded_dot(at_end_[end], beyond).is_negative();
    }
  }

  const FaceCorners& corners() const { return face_; }

  /// Is it certain that another face meets this one in nothing, or in one vertex of both?
  bool separate(const FaceCorners& other) const {
    std::size_t common = 0, ours = 3, theirs = 3; // 3 of three: none
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        if (face_.vertices[i] == other.vertices[j])
          ++common, ours = i, theirs = j;
    return common < 2 && (plane_.has_on_one_side(other.points, theirs) ||
                          (is_certain_ && is_outside_side(other.points, ours, theirs)) ||
                          FacePlane(other.points).has_on_one_side(face_.points, ours));
  }

private:
  static constexpr std::size_t next(std::size_t i) { return i == 2 ? 0 : i + 1; }

  // Is another face, of which we may have a corner, behind a side?
  bool is_outside_side(const std::array<Vector<3>, 3>& other, std::size_t ours,
                       std::size_t theirs) const {
    if (ours == 3)
      return is_outside(at_begin_[0], 0, other) || is_outside(at_begin_[1], 1, other) ||
             is_outside(at_begin_[2], 2, other);
    return is_outside(at_begin_[ours], ours, other, theirs) ||
           is_outside(at_end_[ours], ours, other, theirs);
  }
  // Are points on the other side of a plane through a corner?
  bool is_outside(const Vector<3>& outwards, std::size_t corner, const Vector<3>& point) const {
    return rounded_dot(outwards, difference(point, face_.points[corner])).is_positive();
  }
  bool is_outside(const Vector<3>& outwards, std::size_t corner,
                  const std::array<Vector<3>, 3>& points) const {
    return is_outside(outwards, corner, points[0]) && is_outside(outwards, corner, points[1]) &&
           is_outside(outwards, corner, points[2]);
  }
  // All of them but one.
  bool is_outside(const Vector<3>& outwards, std::size_t corner,
                  const std::array<Vector<3>, 3>& points, std::size_t but) const {
    return is_outside(outwards, corner, points[next(but)]) &&
           is_outside(outwards, corner, points[next(next(but))]);
  }

  FaceCorners face_;
  FacePlane plane_;
  // for each corner: across the edge that begins there, and the one that ends there
  std::array<Vector<3>, 3> at_begin_, at_end_;
  bool is_certain_ = true;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GUARDS_INTERSECTION_FACE_SIDES_H
