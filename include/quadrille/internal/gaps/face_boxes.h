#ifndef QUADRILLE_INTERNAL_GAPS_FACE_BOXES_H
#define QUADRILLE_INTERNAL_GAPS_FACE_BOXES_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/state/distance_to_rest.h>
#include <quadrille/internal/core/surface/box_tree.h>
#include <quadrille/internal/core/surface/nearest_point.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Faces with their boxes in a tree.
class FaceBoxes {
public:
  FaceBoxes() = default;
  /// Keeps the corners of all faces.
  explicit FaceBoxes(std::vector<TriangleCorners> faces)
      : faces_(std::move(faces)), order_(faces_.size()), tree_(faces_.size()) {
    std::iota(order_.begin(), order_.end(), Index{0});
    std::vector<FloatBox> box;
    std::vector<std::array<float, 3>> centre;
    for (const TriangleCorners& face : faces_) {
      const auto& [low, high] = box.emplace_back(box_of(face));
      centre.push_back({low[0] + high[0], low[1] + high[1], low[2] + high[2]});
    }
    sort_for_box_tree(
        order_.data(),
        order_.data() + order_.size(), [&](Index face) -> const auto& { return centre[face]; });
    for (std::size_t slot = 0; slot < order_.size(); ++slot) {
      tree_.put(slot, box[order_[slot]]);
      whole_.add(box[order_[slot]]);
    }
    tree_.fit();
  }

  static FloatBox box_of(const TriangleCorners& corners, double margin = 0) {
    FloatBox box = FloatBox::empty();
    for (const Vector<3>& corner : corners)
      box.add(cube_around(corner, margin));
    return box;
  }

  const TriangleCorners& operator[](Index face) const { return faces_[face]; }
  Index size() const { return static_cast<Index>(faces_.size()); }
  const FloatBox& whole() const { return whole_; }

  /// Visits the faces of which the boxes meet another one, until a call returns true; did one?
  template <class Visit>
  bool any_meeting(const FloatBox& box, Visit visit) const {
    return tree_.any_meeting(
        box, [&](std::size_t slot, const FloatBox&) { return visit(order_[slot]); });
  }

private:
  std::vector<TriangleCorners> faces_;
  std::vector<Index> order_; // the face of each slot of the tree
  BoxTree tree_;
  FloatBox whole_ = FloatBox::empty();
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GAPS_FACE_BOXES_H
