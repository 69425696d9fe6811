#ifndef QUADRILLE_INTERNAL_GUARDS_NORMALS_NORMAL_CONE_H
#define QUADRILLE_INTERNAL_GUARDS_NORMALS_NORMAL_CONE_H

#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace quadrille::internal {

/// The angle between two vectors in radians; it is wrong by far less than NormalCone::arithmetic.
/// Source: Kahan, How futile are mindless assessments of roundoff, 2006: no digits are lost at
/// small angles.
inline double angle_between(const Vector<3>& a, const Vector<3>& b) {
  return std::atan2(std::sqrt(squared_length(cross(a, b))), dot(a, b));
}

/// The normal of a face, of any length, and by how much its direction may be wrong, in radians.
struct FaceNormal {
  Vector<3> direction;
  double error;

  FaceNormal(const Vector<3>& a, const Vector<3>& b, const Vector<3>& c)
      : direction(cross(b - a, c - a)) {
    const double length = std::sqrt(squared_length(direction));
    const double product = std::sqrt(squared_length(b - a) * squared_length(c - a));
    error = length > 0 ? 0x1p-49 * product / length : infinite;
  }

  /// Is the area of the face distinguishable from zero in doubles?
  bool is_known() const { return error < 0.1; }
  /// Has it none, as doubles see it?
  bool is_null() const { return error == infinite; }

private:
  static constexpr double infinite = 1e300;
};

/// Directions within an angle of an axis: those of all faces of the input that a face stands for,
/// and maybe more. 16 bytes.
class NormalCone {
public:
  /// More than what is lost when an axis and an angle are rounded to floats.
  static constexpr double rounding = 0x1p-21;
  /// More than what is lost in computing an angle.
  static constexpr double arithmetic = 0x1p-44;

  /// Makes a cone without directions.
  NormalCone() = default;
  explicit NormalCone(const FaceNormal& normal) {
    if (normal.is_known())
      set((1 / std::sqrt(squared_length(normal.direction))) * normal.direction, normal.error);
  }

  bool is_empty() const { return half_angle_ < 0; }
  double half_angle() const { return static_cast<double>(half_angle_); }

  /// How far a direction is from any in the cone at most, in radians; it has at least one.
  double greatest_angle(const Vector<3>& direction) const {
    return angle_between(axis(), direction) + half_angle() + arithmetic;
  }

  /// Takes in all directions of another cone: becomes the smallest one around both, rounded up.
  void add(const NormalCone& other) {
    if (other.is_empty())
      return;
    if (is_empty()) {
      *this = other;
      return;
    }
    const Vector<3> a = axis(), b = other.axis();
    const double angle = angle_between(a, b);
    if (angle + other.half_angle() + arithmetic <= half_angle())
      return;
    if (angle + half_angle() + arithmetic <= other.half_angle()) {
      *this = other;
      return;
    }
    const double half = 0.5 * (angle + half_angle() + other.half_angle());
    const double turn = std::clamp(half - half_angle(), 0.0, angle); // of a, towards b
    const double sine = std::sin(angle);
    if (half >= std::numbers::pi || sine < 0x1p-30)
      set(a, sine < 0x1p-30 && angle < 1 ? angle + (std::max)(half_angle(), other.half_angle())
                                         : std::numbers::pi);
    else
      set((std::sin(angle - turn) / sine) * a + (std::sin(turn) / sine) * b, half);
  }

private:
  Vector<3> axis() const {
    return {{static_cast<double>(axis_[0]), static_cast<double>(axis_[1]),
             static_cast<double>(axis_[2])}};
  }
  void set(const Vector<3>& axis, double half_angle) {
    for (std::size_t i = 0; i < 3; ++i)
      axis_[i] = static_cast<float>(axis[i]);
    half_angle_ = static_cast<float>((std::min)(half_angle + rounding, 4.0)); // 4 is all of them
  }

  std::array<float, 3> axis_{}; // nearly of length 1
  float half_angle_ = -1;       // in radians; negative: no direction
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GUARDS_NORMALS_NORMAL_CONE_H
