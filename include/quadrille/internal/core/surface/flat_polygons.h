#ifndef QUADRILLE_INTERNAL_CORE_SURFACE_FLAT_POLYGONS_H
#define QUADRILLE_INTERNAL_CORE_SURFACE_FLAT_POLYGONS_H

#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace quadrille::internal {

/// A point of space, and where it is in a plane of projection.
struct FlatPoint {
  Vector<3> point;
  double u, v;
};

using FlatTriangle = std::array<FlatPoint, 3>;

/// Twice the area of pqy in the plane: above 0 if y is to the left of pq.
inline double flat_area(const FlatPoint& p, const FlatPoint& q, const FlatPoint& y) {
  return (q.u - p.u) * (y.v - p.v) - (q.v - p.v) * (y.u - p.u);
}

inline double flat_area(const FlatTriangle& t) {
  return flat_area(t[0], t[1], t[2]);
}

/// Is all of a triangle on the far side of an edge of the other? Both run to the left.
inline bool lies_next_to(const FlatTriangle& t, const FlatTriangle& other) {
  const auto is_outside = [](const FlatTriangle& inner, const FlatTriangle& outer) {
    for (std::size_t i = 0; i < 3; ++i) {
      const FlatPoint &p = inner[i], &q = inner[i == 2 ? 0 : i + 1];
      if (flat_area(p, q, outer[0]) < 0 && flat_area(p, q, outer[1]) < 0 &&
          flat_area(p, q, outer[2]) < 0)
        return true;
    }
    return false;
  };
  return is_outside(t, other) || is_outside(other, t);
}

/// The point at `t` between two others.
inline Vector<3> between(const Vector<3>& p, const Vector<3>& q, double t) {
  return p + t * (q - p);
}

/// Returns the parameter of the point of pq that is nearest to y: 0 at p, 1 at q.
inline double nearest_on_segment(const Vector<3>& y, const Vector<3>& p, const Vector<3>& q) {
  const Vector<3> d = q - p;
  const double squared = squared_length(d);
  return squared > 0 ? std::clamp(dot(y - p, d) / squared, 0.0, 1.0) : 0;
}

inline double squared_distance_to_segment(const Vector<3>& y, const Vector<3>& p,
                                          const Vector<3>& q) {
  return squared_distance(y, between(p, q, nearest_on_segment(y, p, q)));
}

/// From y to a point of the triangle pqr: the nearest, or next to it where the triangle is so thin
/// that roundings hide it. So the distance is never less than the true one by more than the
/// rounding of a few coordinates. Source: Ericson, Real-Time Collision Detection, 2005, 5.1.5.
inline double squared_distance_to_triangle(const Vector<3>& y, const Vector<3>& p,
                                           const Vector<3>& q, const Vector<3>& r) {
  const Vector<3> pq = q - p, pr = r - p, py = y - p, qy = y - q, ry = y - r;
  const double p1 = dot(pq, py), p2 = dot(pr, py);
  if (p1 <= 0 && p2 <= 0)
    return squared_length(py);
  const double q1 = dot(pq, qy), q2 = dot(pr, qy);
  if (q1 >= 0 && q2 <= q1)
    return squared_length(qy);
  const double r1 = dot(pq, ry), r2 = dot(pr, ry);
  if (r2 >= 0 && r1 <= r2)
    return squared_length(ry);
  const double wr = p1 * q2 - q1 * p2, wq = r1 * p2 - p1 * r2, wp = q1 * r2 - r1 * q2;
  if (wp > 0 && wq > 0 && wr > 0) {
    const double sum = wp + wq + wr;
    return squared_length(py - (wq / sum) * pq - (wr / sum) * pr);
  }
  return (std::min)({squared_distance_to_segment(y, p, q), squared_distance_to_segment(y, q, r),
                     squared_distance_to_segment(y, r, p)});
}

/// Returns the squared distance from y to the point of a triangle below it in the plane; if y is
/// outside the triangle, to a point of its boundary. This is as accurate as the line above: the
/// point belongs to the triangle.
inline double squared_height(const FlatPoint& y, const FlatTriangle& t) {
  std::array<double, 3> w{flat_area(t[1], t[2], y), flat_area(t[2], t[0], y),
                          flat_area(t[0], t[1], y)};
  double sum = 0;
  for (double& x : w)
    sum += x = (std::max)(x, 0.0);
  if (!(sum > 0))
    return squared_distance_to_triangle(y.point, t[0].point, t[1].point, t[2].point);
  Vector<3> d = y.point - t[0].point;
  const Vector<3> first = t[1].point - t[0].point, second = t[2].point - t[0].point;
  d -= (w[1] / sum) * first;
  d -= (w[2] / sum) * second;
  // Along a sliver the weights are off by as much as it is thin: one step towards y mends that.
  for (std::size_t i : {std::size_t{1}, std::size_t{2}}) {
    const Vector<3>& edge = i == 1 ? first : second;
    const double squared = squared_length(edge);
    if (sum < 0x1p-10 * squared) {
      const double step = std::clamp(dot(d, edge) / squared, -w[i] / sum, w[0] / sum);
      d -= step * edge;
      w[0] = (std::max)(w[0] - step * sum, 0.0); // rounded, it may be below
    }
  }
  return squared_length(d);
}

/// The intersection of a triangle with another one in the plane: a convex polygon.
class FlatPolygon {
  static constexpr std::size_t most_corners = 12; // even if roundings cut each edge

public:
  explicit FlatPolygon(const FlatTriangle& t) : size_(3) {
    std::copy(t.begin(), t.end(), corners_.begin());
  }

  /// Cuts it off beyond `other`, whose corners run to the left, or further out by `tolerance`.
  void clip(const FlatTriangle& other, double tolerance) {
    for (std::size_t i = 0; i < 3 && size_ > 0; ++i)
      clip(other[i], other[i == 2 ? 0 : i + 1], tolerance);
  }

  const FlatPoint* begin() const { return corners_.data(); }
  const FlatPoint* end() const { return corners_.data() + size_; }
  bool empty() const { return size_ == 0; }

  /// Twice of it.
  double area() const {
    double sum = 0;
    for (std::size_t i = 2; i < size_; ++i)
      sum += flat_area(corners_[0], corners_[i - 1], corners_[i]);
    return sum;
  }

private:
  void clip(const FlatPoint& p, const FlatPoint& q, double tolerance) {
    const double most = tolerance * (std::abs(q.u - p.u) + std::abs(q.v - p.v));
    std::array<double, most_corners> side;
    bool is_cut = false;
    for (std::size_t i = 0; i < size_; ++i) {
      side[i] = flat_area(p, q, corners_[i]) + most;
      is_cut |= side[i] < 0;
    }
    if (is_cut)
      cut(side);
  }

  void cut(const std::array<double, most_corners>& side) {
    std::array<FlatPoint, most_corners> left;
    std::size_t count = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const std::size_t next = i + 1 == size_ ? 0 : i + 1;
      if (side[i] >= 0)
        left[count++] = corners_[i];
      if ((side[i] < 0) != (side[next] < 0))
        left[count++] = crossing(corners_[i], corners_[next], side[i] / (side[i] - side[next]));
    }
    std::copy_n(left.begin(), count, corners_.begin());
    size_ = count;
  }

  static FlatPoint crossing(const FlatPoint& p, const FlatPoint& q, double t) {
    return {between(p.point, q.point, t), p.u + t * (q.u - p.u), p.v + t * (q.v - p.v)};
  }

  std::array<FlatPoint, most_corners> corners_;
  std::size_t size_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_SURFACE_FLAT_POLYGONS_H
