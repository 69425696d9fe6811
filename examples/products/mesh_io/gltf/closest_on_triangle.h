#ifndef QUADRILLE_EXAMPLES_GLTF_CLOSEST_ON_TRIANGLE_H
#define QUADRILLE_EXAMPLES_GLTF_CLOSEST_ON_TRIANGLE_H

#include "transform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace quadrille_examples {

/// The barycentric coordinates of the place of a triangle that is nearest to a point, and how far
/// that is. Of a triangle without area it is on one of its sides.
inline std::pair<Vector, double> closest_on_triangle(const Vector& point,
                                                     const std::array<Vector, 3>& corners) {
  const auto minus = [](const Vector& a, const Vector& b) {
    return Vector{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  };
  const auto dot = [](const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  const auto distance = [&](const Vector& coordinates) {
    Vector way = point;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t c = 0; c < 3; ++c)
        way[c] -= coordinates[i] * corners[i][c];
    return std::sqrt(dot(way, way));
  };
  const Vector u = minus(corners[1], corners[0]), v = minus(corners[2], corners[0]),
               w = minus(point, corners[0]);
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), wu = dot(w, u), wv = dot(w, v);
  const double area = uu * vv - uv * uv;
  if (area > 0) {
    const double b = (vv * wu - uv * wv) / area, c = (uu * wv - uv * wu) / area;
    if (b >= 0 && c >= 0 && b + c <= 1)
      return {{1 - b - c, b, c}, distance({1 - b - c, b, c})};
  }
  std::pair<Vector, double> best{{1, 0, 0}, distance({1, 0, 0})};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector side = minus(corners[(i + 1) % 3], corners[i]);
    const double length = dot(side, side);
    const double t =
        length > 0 ? std::clamp(dot(minus(point, corners[i]), side) / length, 0., 1.) : 0;
    Vector coordinates{};
    coordinates[i] = 1 - t;
    coordinates[(i + 1) % 3] += t;
    if (const double found = distance(coordinates); found < best.second)
      best = {coordinates, found};
  }
  return best;
}

} // namespace quadrille_examples

#endif
