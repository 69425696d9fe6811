#ifndef QUADRILLE_INTERNAL_VERIFY_DISTANCE_TREE_H
#define QUADRILLE_INTERNAL_VERIFY_DISTANCE_TREE_H

#include <quadrille/internal/verify/distance_surface.h>
#include <quadrille/internal/verify/face_tree.h>

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
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

/// A surface that is prepared for queries of its nearest point: it takes O(n log n) to build and
/// about O(log n) per query.
class DistanceTree {
public:
  /// There must be at least one triangle.
  explicit DistanceTree(const std::vector<DistanceTriangle>& triangles)
      : tree_(
            triangles.size(),
            [&](std::size_t face) -> const DistanceTriangle& { return triangles[face]; }, [] {}) {
    triangles_.reserve(triangles.size());
    for (const std::size_t face : tree_.order())
      triangles_.push_back(triangles[face]);
  }

  double squared_distance(const DistancePoint& query) const {
    double least = std::numeric_limits<double>::infinity();
    look_into(0, query, least);
    return least;
  }

private:
  void look_into(std::size_t at, const DistancePoint& query, double& least) const {
    const FaceTree::Node& node = tree_.nodes()[at];
    if (node.is_leaf()) {
      for (std::size_t i = node.begin; i < node.end; ++i)
        look_at(triangles_[i], query, least);
      return;
    }
    const auto half = [&](std::size_t which) {
      return std::pair(internal::squared_distance(tree_.nodes()[which].box, query), which);
    };
    std::array<std::pair<double, std::size_t>, 2> halves{half(at + 1), half(node.second)};
    if (halves[1].first < halves[0].first)
      std::swap(halves[0], halves[1]);
    for (const auto& [distance2, which] : halves)
      if (distance2 < least)
        look_into(which, query, least);
  }

  static void look_at(const DistanceTriangle& t, const DistancePoint& query, double& least) {
    if (internal::squared_distance(t.bbox(), query) < least)
      least = (std::min)(least, CGAL::squared_distance(query, nearest_on_triangle(t, query)));
  }

  FaceTree tree_;
  std::vector<DistanceTriangle> triangles_; // in the tree's order
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VERIFY_DISTANCE_TREE_H
