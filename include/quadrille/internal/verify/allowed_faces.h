#ifndef QUADRILLE_INTERNAL_VERIFY_ALLOWED_FACES_H
#define QUADRILLE_INTERNAL_VERIFY_ALLOWED_FACES_H

#include <quadrille/internal/verify/check_progress.h>
#include <quadrille/internal/verify/distance_surface.h>
#include <quadrille/internal/verify/distance_tree.h>
#include <quadrille/internal/verify/face_tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// A set of faces, each of which allows points up to a distance from it. Each node of a tree of
/// boxes stores the greatest distance that a face in it allows. The tree finds the face that a
/// point exceeds least: it takes O(n log n) to build and about O(log n) per query.
class AllowedFaces {
public:
  struct Face {
    DistanceTriangle triangle;
    double allowance; ///< a distance, at least 0; infinity allows all
  };
  struct Nearest {
    std::size_t face;
    double excess; ///< the point's distance beyond the allowance; negative if the point is within
                   ///< it
  };

  /// There must be at least one face. The constructor reports steps.
  AllowedFaces(std::vector<Face> faces, CheckProgress& progress)
      : faces_(std::move(faces)),
        tree_(
            faces_.size(),
            [this](std::size_t face) -> const DistanceTriangle& { return faces_[face].triangle; },
            [&] { progress.step(); }) {
    for (const FaceTree::Node& node : tree_.nodes()) {
      double& greatest = allowances_.emplace_back(0);
      for (std::size_t i = node.begin; i < node.end; ++i)
        greatest = (std::max)(greatest, faces_[tree_.order()[i]].allowance);
    }
  }

  const DistanceTriangle& triangle(std::size_t face) const { return faces_[face].triangle; }
  double excess(std::size_t face, const DistancePoint& p) const {
    const DistancePoint nearest = nearest_on_triangle(faces_[face].triangle, p);
    return std::sqrt(CGAL::squared_distance(p, nearest)) - faces_[face].allowance;
  }

  /// Returns the face that a point exceeds least; a good estimate of that face makes the search
  /// faster.
  Nearest nearest(const DistancePoint& p, std::size_t hint = 0) const {
    Nearest best{hint, excess(hint, p)};
    look_into(0, p, best);
    return best;
  }

private:
  /// Returns a lower bound: the point exceeds every face of the node by at least this much.
  double least_excess(std::size_t node, const DistancePoint& p) const {
    return std::sqrt(squared_distance(tree_.nodes()[node].box, p)) - allowances_[node];
  }

  void look_into(std::size_t at, const DistancePoint& p, Nearest& best) const {
    const FaceTree::Node& node = tree_.nodes()[at];
    if (node.is_leaf()) {
      for (std::size_t i = node.begin; i < node.end; ++i)
        if (const double e = excess(tree_.order()[i], p); e < best.excess)
          best = {tree_.order()[i], e};
      return;
    }
    std::array<std::pair<double, std::size_t>, 2> halves{
        {{least_excess(at + 1, p), at + 1}, {least_excess(node.second, p), node.second}}};
    if (halves[1].first < halves[0].first)
      std::swap(halves[0], halves[1]);
    for (const auto& [least, half] : halves)
      if (least < best.excess)
        look_into(half, p, best);
  }

  std::vector<Face> faces_;
  FaceTree tree_;
  std::vector<double> allowances_; // of each node, the greatest one of its faces
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VERIFY_ALLOWED_FACES_H
