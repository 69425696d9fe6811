#ifndef QUADRILLE_INTERNAL_CORE_SURFACE_NEAREST_POINT_H
#define QUADRILLE_INTERNAL_CORE_SURFACE_NEAREST_POINT_H

#include <quadrille/internal/core/surface/box.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace quadrille::internal {

using TriangleCorners = std::array<Vector<3>, 3>;

/// A point of a triangle, by the weights of its corners, with its squared distance from another.
struct NearestPoint {
  std::array<double, 3> weights = {};
  double squared_distance = std::numeric_limits<double>::infinity();
};

inline Vector<3> combination(const TriangleCorners& corners, const std::array<double, 3>& weights) {
  return weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
}

inline NearestPoint point_with(const Vector<3>& p, const TriangleCorners& corners,
                               const std::array<double, 3>& weights) {
  return {weights, squared_distance(p, combination(corners, weights))};
}

/// Returns the square of the distance of p from a box: no point in the box is nearer.
inline double squared_distance_to_box(const Vector<3>& p, const Box<3>& box) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double outside = (std::max)({box.low[i] - p[i], p[i] - box.high[i], 0.});
    sum += outside * outside;
  }
  return sum;
}

/// Returns the point nearest to p of the edge from corner i.
inline NearestPoint nearest_of_edge(const Vector<3>& p, const TriangleCorners& corners,
                                    std::size_t i) {
  const std::size_t j = (i + 1) % 3;
  const Vector<3> edge = corners[j] - corners[i];
  const double length = squared_length(edge), along = dot(p - corners[i], edge);
  const double fraction = length > 0 ? std::clamp(along / length, 0., 1.) : 0;
  std::array<double, 3> weights{};
  weights[i] = 1 - fraction;
  weights[j] = fraction;
  return point_with(p, corners, weights);
}

/// Returns the point of a triangle that is nearest to p. A corner at p itself has the weight 1.
inline NearestPoint nearest_of_triangle(const Vector<3>& p, const TriangleCorners& corners) {
  const Vector<3> u = corners[1] - corners[0], v = corners[2] - corners[0], d = p - corners[0];
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), ud = dot(u, d), vd = dot(v, d);
  const double area = uu * vv - uv * uv, s = vv * ud - uv * vd, t = uu * vd - uv * ud;
  NearestPoint nearest;
  const bool is_inside = area > 0 && s >= 0 && t >= 0 && s + t <= area;
  if (is_inside) {
    const double second = s / area, third = t / area;
    nearest = point_with(p, corners, {(std::max)(0., 1 - second - third), second, third});
  }
  if (is_inside && area > 0x1p-20 * uu * vv)
    return nearest;
  for (std::size_t i = 0; i < 3; ++i) // p is outside, or rounding may decide that
    if (const NearestPoint other = nearest_of_edge(p, corners, i);
        other.squared_distance < nearest.squared_distance)
      nearest = other;
  return nearest;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_SURFACE_NEAREST_POINT_H
