#ifndef QUADRILLE_INTERNAL_VERIFY_FACE_TREE_H
#define QUADRILLE_INTERNAL_VERIFY_FACE_TREE_H

#include <quadrille/internal/verify/distance_surface.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace quadrille::internal {

inline double squared_distance(const CGAL::Bbox_3& box, const DistancePoint& p) {
  std::array<double, 3> d{};
  for (int i = 0; i < 3; ++i)
    d[static_cast<std::size_t>(i)] = (std::max)({(box.min)(i)-p[i], 0.0, p[i] - (box.max)(i)});
  return d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
}

/// A tree of boxes around faces. Each node halves its faces along the longest side of its box,
/// until a few are left.
class FaceTree {
public:
  struct Node {
    CGAL::Bbox_3 box;
    std::size_t begin, end; ///< the range of its faces in order()
    std::size_t second = 0; ///< the node of the second half; that of the first half follows this
                            ///< node directly. It is 0 in a leaf.
    bool is_leaf() const { return second == 0; }
  };

  /// triangle_of(face) is a triangle; step() is called for each node, and may throw. It takes
  /// O(n log n) for n faces; there must be at least one.
  template <class TriangleOf, class Step>
  FaceTree(std::size_t faces, const TriangleOf& triangle_of, const Step& step) : order_(faces) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    build(0, faces, triangle_of, step);
  }

  const std::vector<Node>& nodes() const { return nodes_; } ///< the first one has all faces
  const std::vector<std::size_t>& order() const { return order_; }

  /// Calls visit(a, b) once for each pair of faces that lie in one leaf or in two whose boxes meet.
  template <class Visit>
  void for_each_near_pair(Visit visit) const {
    for_each_pair_within(0, visit);
  }

private:
  static constexpr std::size_t leaf_size = 4;

  template <class TriangleOf, class Step>
  void build(std::size_t begin, std::size_t end, const TriangleOf& triangle_of, const Step& step) {
    step();
    Node node{.box = {}, .begin = begin, .end = end};
    for (std::size_t i = begin; i < end; ++i)
      node.box += triangle_of(order_[i]).bbox();
    const std::size_t at = nodes_.size();
    nodes_.push_back(node);
    if (end - begin <= leaf_size)
      return;
    const std::size_t middle = halve(node, triangle_of);
    build(begin, middle, triangle_of, step);
    nodes_[at].second = nodes_.size();
    build(middle, end, triangle_of, step);
  }

  template <class TriangleOf>
  std::size_t halve(const Node& node, const TriangleOf& triangle_of) {
    int axis = 0;
    const auto extent = [&](int i) { return (node.box.max)(i) - (node.box.min)(i); };
    for (int i = 1; i < 3; ++i)
      if (extent(i) > extent(axis))
        axis = i;
    const auto place = [&](std::size_t face) {
      const DistanceTriangle& t = triangle_of(face);
      return t[0][axis] + t[1][axis] + t[2][axis];
    };
    const std::size_t middle = node.begin + (node.end - node.begin) / 2;
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(node.begin), at(middle), at(node.end),
                     [&](std::size_t a, std::size_t b) { return place(a) < place(b); });
    return middle;
  }

  template <class Visit>
  void for_each_pair_within(std::size_t at, Visit& visit) const {
    const Node& node = nodes_[at];
    if (!node.is_leaf()) {
      for_each_pair_within(at + 1, visit);
      for_each_pair_within(node.second, visit);
      for_each_pair_between(at + 1, node.second, visit);
      return;
    }
    for (std::size_t i = node.begin; i < node.end; ++i)
      for (std::size_t j = i + 1; j < node.end; ++j)
        visit(order_[i], order_[j]);
  }

  // The node with more faces is halved first.
  template <class Visit>
  void for_each_pair_between(std::size_t first, std::size_t second, Visit& visit) const {
    const Node &a = nodes_[first], &b = nodes_[second];
    if (!CGAL::do_overlap(a.box, b.box))
      return;
    if (a.is_leaf() && b.is_leaf()) {
      for (std::size_t i = a.begin; i < a.end; ++i)
        for (std::size_t j = b.begin; j < b.end; ++j)
          visit(order_[i], order_[j]);
    } else if (b.is_leaf() || (!a.is_leaf() && a.end - a.begin > b.end - b.begin)) {
      for_each_pair_between(first + 1, second, visit);
      for_each_pair_between(a.second, second, visit);
    } else {
      for_each_pair_between(first, second + 1, visit);
      for_each_pair_between(first, b.second, visit);
    }
  }

  std::vector<std::size_t> order_; // faces, such that those of a node follow each other
  std::vector<Node> nodes_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VERIFY_FACE_TREE_H
