#ifndef QUADRILLE_INTERNAL_VERIFY_PART_SHAPE_H
#define QUADRILLE_INTERNAL_VERIFY_PART_SHAPE_H

#include <quadrille/internal/verify/checked_surface.h>
#include <quadrille/vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace quadrille::internal {

inline double length(const Vector<3>& v) {
  return std::sqrt(squared_length(v));
}

/// The corners of a face of a surface, less a point.
inline std::array<Vector<3>, 3> corners_seen_from(const SurfaceView& surface, std::size_t face,
                                                  const Vector<3>& p) {
  std::array<Vector<3>, 3> corners;
  for (std::size_t i = 0; i < 3; ++i)
    corners[i] = surface.points[surface.triangles[face][i]] - p;
  return corners;
}

/// Where a part of a surface is, how it extends, and on which side of it its inside is.
class PartShape {
public:
  PartShape() = default;
  PartShape(const SurfaceView& surface, const std::vector<std::size_t>& faces) {
    for (const std::size_t face : faces)
      for (const Vector<3>& p : corners_seen_from(surface, face, {}))
        for (std::size_t i = 0; i < 3; ++i) {
          low_[i] = (std::min)(low_[i], p[i]);
          high_[i] = (std::max)(high_[i], p[i]);
        }
    place_ = corners_seen_from(surface, faces.front(), {})[0];
    measure(surface, faces);
  }

  /// 1 if it is oriented outward, -1 if it is inside out, 0 if its volume is none beyond roundings.
  int orientation() const { return orientation_; }
  /// A point of it.
  const Vector<3>& place() const { return place_; }

  bool box_holds(const PartShape& other) const {
    return low_[0] <= other.low_[0] && low_[1] <= other.low_[1] && low_[2] <= other.low_[2] &&
           high_[0] >= other.high_[0] && high_[1] >= other.high_[1] && high_[2] >= other.high_[2];
  }

  /// A distance of which little is known but that a part which has hardly changed is at a small
  /// one: by boxes, by centres, and by the spread around these.
  double apart(const PartShape& other) const {
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i)
      most =
          (std::max)({most, std::abs(low_[i] - other.low_[i]), std::abs(high_[i] - other.high_[i]),
                      std::abs(centre_[i] - other.centre_[i])});
    const double size = std::sqrt(trace()) + std::sqrt(other.trace());
    for (std::size_t i = 0; i < 6 && size > 0; ++i)
      most = (std::max)(most, std::abs(spread_[i] - other.spread_[i]) / size);
    return most;
  }

private:
  double trace() const { return spread_[0] + spread_[1] + spread_[2]; }

  /// Integrals over the faces. A volume counts if it is more than what the roundings of the
  /// coordinates, and of the sum, can make.
  void measure(const SurfaceView& surface, const std::vector<std::size_t>& faces) {
    double area = 0, volume = 0, terms = 0;
    Vector<3> first{};
    std::array<double, 6> second{};
    for (const std::size_t face : faces) {
      const auto [a, b, c] = corners_seen_from(surface, face, place_);
      const double double_area = length(cross(b - a, c - a)), term = dot(a, cross(b, c));
      const Vector<3> middle = 1.0 / 3 * (a + b + c);
      area += double_area;
      volume += term;
      terms += std::abs(term);
      first += double_area * middle;
      for (std::size_t i = 0; i < 6; ++i)
        second[i] += double_area * middle[rows[i]] * middle[columns[i]];
    }
    for (std::size_t i = 0; i < 3; ++i)
      centre_[i] = area > 0 ? first[i] / area : 0;
    for (std::size_t i = 0; i < 6 && area > 0; ++i)
      spread_[i] = second[i] / area - centre_[rows[i]] * centre_[columns[i]];
    centre_ += place_;
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    const double rounding = 8 * epsilon * (greatest_coordinate() * area + terms);
    orientation_ = std::abs(volume) <= rounding ? 0 : volume > 0 ? 1 : -1;
  }

  double greatest_coordinate() const {
    double greatest = 0;
    for (std::size_t i = 0; i < 3; ++i)
      greatest = (std::max)({greatest, std::abs(low_[i]), std::abs(high_[i])});
    return greatest;
  }

  static constexpr std::array<std::size_t, 6> rows{0, 1, 2, 0, 1, 2}, columns{0, 1, 2, 1, 2, 0};
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  Vector<3> low_{{infinity, infinity, infinity}}, high_{{-infinity, -infinity, -infinity}};
  Vector<3> place_{}, centre_{};
  std::array<double, 6> spread_{};
  int orientation_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VERIFY_PART_SHAPE_H
