#ifndef QUADRILLE_INTERNAL_VERIFY_DISTANCE_TREE_H
#define QUADRILLE_INTERNAL_VERIFY_DISTANCE_TREE_H

// CGAL's AABB tree is GPL: see <quadrille/distance.h>, the only header that includes this one.

#include <quadrille/internal/verify/distance_surface.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Kernel/global_functions.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000 // since 6.0 the names say that space has three dimensions
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

#include <algorithm>
#include <vector>

namespace quadrille::internal {

inline DistancePoint nearest_on_segment(const DistancePoint& a, const DistancePoint& b,
                                        const DistancePoint& query) {
  const DistanceVector ab = b - a;
  const double length2 = ab.squared_length();
  if (!(length2 > 0))
    return a;
  return a + std::clamp(((query - a) * ab) / length2, 0.0, 1.0) * ab;
}

/// Returns the nearest point of a triangle, which may be a sliver or a point. If the foot of the
/// perpendicular is inside, it is the answer; otherwise the best point of the three edges is. The
/// normal of a sliver is noise, so the foot is computed as a convex combination of the corners and
/// must be nearer than the edges: the answer is always a point of the triangle.
inline DistancePoint nearest_on_triangle(const DistanceTriangle& t, const DistancePoint& query) {
  DistancePoint best = nearest_on_segment(t[0], t[1], query);
  double best_distance = CGAL::squared_distance(query, best);
  const auto offer = [&](const DistancePoint& candidate) {
    const double distance = CGAL::squared_distance(query, candidate);
    if (distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  };
  offer(nearest_on_segment(t[1], t[2], query));
  offer(nearest_on_segment(t[2], t[0], query));

  const DistanceVector ab = t[1] - t[0], ac = t[2] - t[0], aq = query - t[0];
  const DistanceVector normal = CGAL::cross_product(ab, ac);
  const double scale = normal.squared_length();
  const double v = normal * CGAL::cross_product(aq, ac);
  const double w = normal * CGAL::cross_product(ab, aq);
  if (scale > 0 && v >= 0 && w >= 0 && v + w <= scale)
    offer(t[0] + (v / scale) * ab + (w / scale) * ac);
  return best;
}

/// The plain kernel with a projection onto triangles that accepts degenerate ones.
struct DistanceKernel : CGAL::Simple_cartesian<double> {
  struct Construct_projected_point_3 {
    using result_type = DistancePoint;
    DistancePoint operator()(const DistanceTriangle& t, const DistancePoint& query) const {
      return nearest_on_triangle(t, query);
    }
  };
  Construct_projected_point_3 construct_projected_point_3_object() const { return {}; }
};

/// A surface that is prepared for queries of its nearest point: it takes O(n log n) to build and
/// about O(log n) per query.
class DistanceTree {
public:
  explicit DistanceTree(const std::vector<DistanceTriangle>& triangles)
      : tree_(triangles.begin(), triangles.end()) {
    tree_.build();
    tree_.accelerate_distance_queries();
  }

  double squared_distance(const DistancePoint& query) const {
    return CGAL::squared_distance(query, tree_.closest_point(query));
  }

private:
  using Iterator = std::vector<DistanceTriangle>::const_iterator;
#if CGAL_VERSION_NR >= 1060000000
  using Primitive = CGAL::AABB_triangle_primitive_3<DistanceKernel, Iterator>;
  using Traits = CGAL::AABB_traits_3<DistanceKernel, Primitive>;
#else
  using Primitive = CGAL::AABB_triangle_primitive<DistanceKernel, Iterator>;
  using Traits = CGAL::AABB_traits<DistanceKernel, Primitive>;
#endif
  CGAL::AABB_tree<Traits> tree_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VERIFY_DISTANCE_TREE_H
