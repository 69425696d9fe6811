#ifndef QUADRILLE_INTERNAL_GUARDS_INTERSECTION_NEAR_FACES_H
#define QUADRILLE_INTERNAL_GUARDS_INTERSECTION_NEAR_FACES_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/surface/box_tree.h>
#include <quadrille/internal/guards/intersection/triangle_pair.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace quadrille::internal {

/// A face at the place that it has now, or is to have.
struct PlacedFace {
  Index face;
  FaceCorners corners;
};

/// The faces near a star, and a box of each. They are the same for all places that are tried for
/// the vertex, so they are looked for once.
class NearFaces {
public:
  bool empty() const { return faces_.empty(); }
  void clear() {
    faces_.clear();
    boxes_.clear();
  }
  void add(const PlacedFace& face, const FloatBox& box) {
    const std::size_t lane = faces_.size() % EightBoxes::width;
    if (lane == 0)
      boxes_.emplace_back();
    boxes_.back().set(lane, box);
    faces_.push_back(face);
  }

  /// Calls visit(face) for each that meets a box, until a call says true; did one?
  template <class Visit>
  bool any_meeting(const FloatBox& box, Visit visit) const {
    for (std::size_t block = 0; block < boxes_.size(); ++block) {
      const std::array<std::int32_t, EightBoxes::width> meets = boxes_[block].meets(box);
      for (std::size_t lane = 0; lane < EightBoxes::width; ++lane)
        if (meets[lane] && visit(faces_[block * EightBoxes::width + lane]))
          return true;
    }
    return false;
  }

private:
  std::vector<PlacedFace> faces_;
  std::vector<EightBoxes> boxes_; // the last one with empty boxes
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GUARDS_INTERSECTION_NEAR_FACES_H
