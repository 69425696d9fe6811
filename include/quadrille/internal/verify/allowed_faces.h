#ifndef QUADRILLE_INTERNAL_VERIFY_ALLOWED_FACES_H
#define QUADRILLE_INTERNAL_VERIFY_ALLOWED_FACES_H

#include <quadrille/internal/verify/check_progress.h>
#include <quadrille/internal/verify/distance_surface.h>
#include <quadrille/internal/verify/distance_tree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
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
      : faces_(std::move(faces)), order_(faces_.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    build(0, order_.size(), progress);
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
  struct Node {
    CGAL::Bbox_3 box;
    double allowance = 0; ///< the greatest one in the box
    std::size_t begin, end;
    std::size_t second =
        0; ///< the node of the second half, after the first half, which follows directly; or 0
  };
  static constexpr std::size_t leaf_size = 4;

  void build(std::size_t begin, std::size_t end, CheckProgress& progress) {
    progress.step();
    Node node{.box = {}, .begin = begin, .end = end};
    for (std::size_t i = begin; i < end; ++i) {
      node.box += faces_[order_[i]].triangle.bbox();
      node.allowance = (std::max)(node.allowance, faces_[order_[i]].allowance);
    }
    const std::size_t at = nodes_.size();
    nodes_.push_back(node);
    if (end - begin <= leaf_size)
      return;
    const std::size_t middle = halve(node);
    build(begin, middle, progress);
    nodes_[at].second = nodes_.size();
    build(middle, end, progress);
  }

  /// Halves the faces of a node along the longest side of its box.
  std::size_t halve(const Node& node) {
    int axis = 0;
    const auto extent = [&](int i) { return (node.box.max)(i) - (node.box.min)(i); };
    for (int i = 1; i < 3; ++i)
      if (extent(i) > extent(axis))
        axis = i;
    const auto place = [&](std::size_t face) {
      const DistanceTriangle& t = faces_[face].triangle;
      return t[0][axis] + t[1][axis] + t[2][axis];
    };
    const std::size_t middle = node.begin + (node.end - node.begin) / 2;
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(node.begin), at(middle), at(node.end),
                     [&](std::size_t a, std::size_t b) { return place(a) < place(b); });
    return middle;
  }

  /// Returns a lower bound: the point exceeds every face of the node by at least this much.
  static double least_excess(const Node& node, const DistancePoint& p) {
    std::array<double, 3> d{};
    for (int i = 0; i < 3; ++i)
      d[static_cast<std::size_t>(i)] =
          (std::max)({(node.box.min)(i)-p[i], 0.0, p[i] - (node.box.max)(i)});
    return std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) - node.allowance;
  }

  void look_into(std::size_t at, const DistancePoint& p, Nearest& best) const {
    const Node& node = nodes_[at];
    if (node.second == 0) {
      for (std::size_t i = node.begin; i < node.end; ++i)
        if (const double e = excess(order_[i], p); e < best.excess)
          best = {order_[i], e};
      return;
    }
    std::array<std::pair<double, std::size_t>, 2> halves{
        {{least_excess(nodes_[at + 1], p), at + 1},
         {least_excess(nodes_[node.second], p), node.second}}};
    if (halves[1].first < halves[0].first)
      std::swap(halves[0], halves[1]);
    for (const auto& [least, half] : halves)
      if (least < best.excess)
        look_into(half, p, best);
  }

  std::vector<Face> faces_;
  std::vector<std::size_t> order_;
  std::vector<Node> nodes_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VERIFY_ALLOWED_FACES_H
