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

/// Distances of points from a surface of any kind, to the last bits.
class Nearest {
public:
  explicit Nearest(const Soup& soup) {
    for (const auto& [a, b, c] : soup.triangles)
      triangles_.emplace_back(to_point<Point>(soup.points[a]), to_point<Point>(soup.points[b]),
                              to_point<Point>(soup.points[c]));
    tree_.insert(triangles_.begin(), triangles_.end());
    tree_.build();
  }
  double distance(const Position& p) const {
    return std::sqrt(tree_.squared_distance(to_point<Point>(p)));
  }

private:
  using Triangles = std::vector<Kernel::Triangle_3>;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;

  Triangles triangles_;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree_;
};

/// Calls visit(point) for points of a triangle, corners and points between, `steps` along each
/// edge.
template <class Visit>
void for_each_point(const Soup& soup, const Triangle& t, int steps, Visit visit) {
  const auto& [a, b, c] = t;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; i + j <= steps; ++j)
      visit(1.0 / steps *
            (i * soup.points[a] + j * soup.points[b] + (steps - i - j) * soup.points[c]));
}

/// How far points of one surface are from the other at most, corners and points between, `steps`
/// along each edge: never more than it is. For surfaces of any kind.
inline double farthest(const Soup& from, const Soup& to, int steps) {
  const Nearest nearest(to);
  double most = 0;
  for (const Triangle& t : from.triangles)
    for_each_point(from, t, steps,
                   [&](const Position& p) { most = std::max(most, nearest.distance(p)); });
  return most;
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
