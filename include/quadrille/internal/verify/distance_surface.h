#ifndef QUADRILLE_INTERNAL_VERIFY_DISTANCE_SURFACE_H
#define QUADRILLE_INTERNAL_VERIFY_DISTANCE_SURFACE_H

#include <quadrille/internal/core/base/read_surface.h>
#include <quadrille/internal/core/base/safe_length.h>
#include <quadrille/quadric_form.h>
#include <quadrille/triangle_soup.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace quadrille::internal {

using DistancePoint = CGAL::Simple_cartesian<double>::Point_3;
using DistanceVector = CGAL::Simple_cartesian<double>::Vector_3;
using DistanceTriangle = CGAL::Simple_cartesian<double>::Triangle_3;

/// A surface for distance measurements: its triangles, and the vertices that they use.
struct DistanceSurface {
  std::vector<DistanceTriangle> triangles;
  std::vector<DistancePoint> vertices;

  double area() const {
    double sum = 0;
    for (const DistanceTriangle& t : triangles)
      sum += std::sqrt(t.squared_area());
    return sum;
  }
};

inline DistancePoint distance_point(const Vector<3>& p) {
  return {p[0], p[1], p[2]};
}

inline DistanceSurface distance_surface(const SurfaceView& surface) {
  DistanceSurface result;
  std::vector<bool> is_used(surface.points.size(), false);
  result.triangles.reserve(surface.triangles.size());
  for (const auto& [a, b, c] : surface.triangles) {
    is_used[a] = is_used[b] = is_used[c] = true;
    result.triangles.emplace_back(distance_point(surface.points[a]),
                                  distance_point(surface.points[b]),
                                  distance_point(surface.points[c]));
  }
  for (std::size_t v = 0; v < surface.points.size(); ++v)
    if (is_used[v])
      result.vertices.push_back(distance_point(surface.points[v]));
  return result;
}

/// Returns the surface of a mesh, or of points and triangles. Throws as read_surface() does, and
/// std::invalid_argument if there is no face.
template <class... Surface>
DistanceSurface measured_surface(const char* caller, const Surface&... surface) {
  DistanceSurface result = distance_surface(read_surface(caller, surface...));
  if (result.triangles.empty())
    throw std::invalid_argument(
        caller + std::string(": the distance to a surface without faces is undefined"));
  return result;
}

inline CGAL::Bbox_3 bounding_box(const std::vector<DistancePoint>& points) {
  CGAL::Bbox_3 box;
  for (const DistancePoint& p : points)
    box += p.bbox();
  return box;
}

/// The result is at most the greatest double.
inline double diagonal(const CGAL::Bbox_3& box) {
  const auto half = [&](int i) { return 0.5 * (box.max)(i)-0.5 * (box.min)(i); };
  return 2 * (std::min)(safe_length(half(0), half(1), half(2)),
                        (std::numeric_limits<double>::max)() / 2);
}

/// The frame in which distances are measured. It lies around the origin, so that far-away
/// coordinates cost no digits, and its unit gives the box a size of about 1, so that no product of
/// lengths overflows or underflows. The unit is a power of two, so conversion is exact both ways.
class DistanceFrame {
public:
  explicit DistanceFrame(const CGAL::Bbox_3& box) {
    std::array<double, 3> middle{}; // g++ does not see that the loop fills it
    double extent = 0;
    for (int i = 0; i < 3; ++i) {
      // The ends are halved first, because their sums and differences could overflow.
      middle[static_cast<std::size_t>(i)] = 0.5 * (box.min)(i) + 0.5 * (box.max)(i);
      extent = (std::max)(extent, 0.5 * (box.max)(i)-0.5 * (box.min)(i));
    }
    origin_ = DistanceVector(middle[0], middle[1], middle[2]);
    if (extent > 0)
      exponent_ = -std::ilogb(extent);
  }

  double to(double length) const { return std::ldexp(length, exponent_); }
  double from(double length) const { return std::ldexp(length, -exponent_); }

  DistancePoint to(const DistancePoint& p) const {
    const DistancePoint q = p - origin_;
    return DistancePoint(to(q.x()), to(q.y()), to(q.z()));
  }

  DistancePoint from(const DistancePoint& p) const {
    return DistancePoint(from(p.x()), from(p.y()), from(p.z())) + origin_;
  }

  void apply(DistanceSurface& surface) const {
    for (DistancePoint& p : surface.vertices)
      p = to(p);
    for (DistanceTriangle& t : surface.triangles)
      t = DistanceTriangle(to(t[0]), to(t[1]), to(t[2]));
  }

private:
  DistanceVector origin_;
  int exponent_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VERIFY_DISTANCE_SURFACE_H
