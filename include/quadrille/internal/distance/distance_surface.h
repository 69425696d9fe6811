#ifndef QUADRILLE_INTERNAL_DISTANCE_DISTANCE_SURFACE_H
#define QUADRILLE_INTERNAL_DISTANCE_DISTANCE_SURFACE_H

#include <quadrille/internal/base/points.h>
#include <quadrille/internal/base/safe_length.h>
#include <quadrille/vector.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <ranges>
#include <stdexcept>
#include <vector>

namespace quadrille::internal {

using DistancePoint = CGAL::Simple_cartesian<double>::Point_3;
using DistanceVector = CGAL::Simple_cartesian<double>::Vector_3;
using DistanceTriangle = CGAL::Simple_cartesian<double>::Triangle_3;

/// A surface as distances see it: triangles, and the vertices that they use.
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

template <class Point>
DistancePoint to_distance_point(const Point& p) {
  const Vector<3> q = position_of(p);
  if (!is_finite(q))
    throw std::invalid_argument("quadrille: a coordinate of a measured surface is not finite");
  return {q[0], q[1], q[2]};
}

inline void require_triangles(const DistanceSurface& surface) {
  if (surface.triangles.empty())
    throw std::invalid_argument("quadrille: a surface without faces is at no distance");
}

template <class Mesh>
DistanceSurface distance_surface(const Mesh& mesh) {
  using Traits = boost::graph_traits<Mesh>;
  const auto position = get(CGAL::vertex_point, mesh);
  DistanceSurface surface;
  for (const auto v : vertices(mesh))
    if (halfedge(v, mesh) != Traits::null_halfedge())
      surface.vertices.push_back(to_distance_point(get(position, v)));
  for (const auto f : faces(mesh)) {
    std::array<DistancePoint, 3> corners;
    std::size_t degree = 0;
    for (const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh)) {
      if (degree < 3)
        corners[degree] = to_distance_point(get(position, v));
      ++degree;
    }
    if (degree != 3)
      throw std::invalid_argument("quadrille: a face of a measured surface is not a triangle");
    surface.triangles.emplace_back(corners[0], corners[1], corners[2]);
  }
  require_triangles(surface);
  return surface;
}

/// How many elements there are: std::ranges::distance is not in every library.
template <class Range>
std::size_t length_of(const Range& range) {
  std::size_t length = 0;
  for (auto i = std::ranges::begin(range); i != std::ranges::end(range); ++i)
    ++length;
  return length;
}

template <class Points, class Triangles>
DistanceSurface distance_surface(const Points& points, const Triangles& triangles) {
  const std::size_t count = length_of(points);
  const auto first = std::ranges::begin(points);
  using Step = std::iter_difference_t<decltype(first)>;
  DistanceSurface surface;
  std::vector<bool> used(count, false);
  for (const auto& triangle : triangles) {
    if (length_of(triangle) != 3)
      throw std::invalid_argument("quadrille: a face of a measured surface is not a triangle");
    std::array<DistancePoint, 3> corners;
    std::size_t corner = 0;
    for (const auto vertex : triangle) {
      const auto v = static_cast<std::size_t>(vertex);
      if (v >= count)
        throw std::out_of_range("quadrille: a triangle names a point that does not exist");
      used[v] = true;
      corners[corner++] = to_distance_point(first[static_cast<Step>(v)]);
    }
    surface.triangles.emplace_back(corners[0], corners[1], corners[2]);
  }
  require_triangles(surface);
  for (std::size_t v = 0; v < count; ++v)
    if (used[v])
      surface.vertices.push_back(to_distance_point(first[static_cast<Step>(v)]));
  return surface;
}

inline CGAL::Bbox_3 bounding_box(const std::vector<DistancePoint>& points) {
  CGAL::Bbox_3 box;
  for (const DistancePoint& p : points)
    box += p.bbox();
  return box;
}

/// At most the greatest double.
inline double diagonal(const CGAL::Bbox_3& box) {
  const auto half = [&](int i) { return 0.5 * (box.max)(i)-0.5 * (box.min)(i); };
  return 2 * (std::min)(safe_length(half(0), half(1), half(2)),
                        (std::numeric_limits<double>::max)() / 2);
}

/// Where distances are measured: around the origin, so that far-away coordinates cost no digits,
/// and in a unit in which the given box has a size of about 1, so that no product of lengths over-
/// or underflows. The unit is a power of two, which is exact both ways.
class DistanceFrame {
public:
  explicit DistanceFrame(const CGAL::Bbox_3& box) {
    std::array<double, 3> middle{}; // g++ does not see that the loop fills it
    double extent = 0;
    for (int i = 0; i < 3; ++i) {
      // By halves: sums and differences of the ends could overflow.
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

#endif // QUADRILLE_INTERNAL_DISTANCE_DISTANCE_SURFACE_H
