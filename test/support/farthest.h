#ifndef TEST_SUPPORT_FARTHEST_H
#define TEST_SUPPORT_FARTHEST_H

// How far one surface is from another, by CGAL's tree and by points of its triangles.
#include "meshes.h"
#include "soups.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace test {

/// How far points of one surface are from the other at most, corners and points between, `steps`
/// along each edge: to the last bits, and never more than it is. For surfaces of any kind.
inline double farthest(const Soup& from, const Soup& to, int steps) {
  using Triangles = std::vector<Kernel::Triangle_3>;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
  Triangles triangles;
  for (const auto& [a, b, c] : to.triangles)
    triangles.emplace_back(to_point<Point>(to.points[a]), to_point<Point>(to.points[b]),
                           to_point<Point>(to.points[c]));
  const CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree(triangles.begin(),
                                                                   triangles.end());
  double squared = 0;
  for (const auto& [a, b, c] : from.triangles)
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; i + j <= steps; ++j) {
        const Position y =
            1.0 / steps *
            (i * from.points[a] + j * from.points[b] + (steps - i - j) * from.points[c]);
        squared = std::max(squared, tree.squared_distance(to_point<Point>(y)));
      }
  return std::sqrt(squared);
}

/// The greatest coordinate of a soup.
inline double greatest_coordinate(const Soup& soup) {
  double greatest = 0;
  for (const Position& p : soup.points)
    for (double x : p.coordinates)
      greatest = std::max(greatest, std::abs(x));
  return greatest;
}

} // namespace test

#endif // TEST_SUPPORT_FARTHEST_H
