#ifndef QUADRILLE_INTERNAL_CONTRACTION_ISOLATION_H
#define QUADRILLE_INTERNAL_CONTRACTION_ISOLATION_H

#include <quadrille/internal/base/index.h>
#include <quadrille/internal/contraction/distance_to_rest.h>
#include <quadrille/internal/distance/flat_pieces.h>
#include <quadrille/internal/intersection/box_tree.h>
#include <quadrille/vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// How many of its radii the centre of each part lies away from the faces of all parts of higher
/// ranks: from 1 to `farthest`. Boxes of what is looked for stand in a tree, and shrink as it is
/// found; so a face costs a logarithm of the count of parts, and nothing of all faces is kept.
class Isolation {
public:
  static constexpr double farthest = 4;

  /// A radius of 0 stands for a part that nobody asks about.
  Isolation(std::vector<Trace> parts, std::vector<Index> ranks)
      : parts_(std::move(parts)), ranks_(std::move(ranks)), order_(parts_.size()),
        tree_(parts_.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    sort_for_box_tree(order_.data(), order_.data() + order_.size(),
                      [&](Index part) { return as_floats(parts_[part].centre); });
    for (std::size_t slot = 0; slot < order_.size(); ++slot) {
      const Trace& part = parts_[order_[slot]];
      distances_.push_back(farthest * part.radius);
      tree_.put(slot, box_of(part, distances_.back()));
    }
    tree_.fit();
  }

  /// Looks at a face of a part with this rank.
  void see(const std::array<Vector<3>, 3>& face, Index rank) {
    FloatBox box = FloatBox::empty();
    for (const Vector<3>& p : face)
      box.add(as_floats(p));
    tree_.for_each_meeting(box, [&](std::size_t slot, const FloatBox&) {
      const Trace& part = parts_[order_[slot]];
      if (ranks_[order_[slot]] >= rank)
        return;
      const double distance =
          std::sqrt(squared_distance_to_triangle(part.centre, face[0], face[1], face[2]));
      if (distance < distances_[slot]) {
        distances_[slot] = distance;
        tree_.move(slot, box_of(part, distance));
      }
    });
  }

  /// Of each part, once all faces have been seen.
  std::vector<double> of_parts() const {
    std::vector<double> result(parts_.size(), 1);
    for (std::size_t slot = 0; slot < order_.size(); ++slot)
      if (const double radius = parts_[order_[slot]].radius; radius > 0)
        result[order_[slot]] = (std::max)(1., distances_[slot] / radius);
    return result;
  }

private:
  // In which something nearer lies; nothing counts that is nearer than the radius.
  static FloatBox box_of(const Trace& part, double distance) {
    return distance > part.radius ? cube_around(part.centre, distance) : FloatBox::empty();
  }

  std::vector<Trace> parts_;
  std::vector<Index> ranks_;
  std::vector<Index> order_; // of the slots of the tree
  BoxTree tree_;
  std::vector<double> distances_; // of slots
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CONTRACTION_ISOLATION_H
