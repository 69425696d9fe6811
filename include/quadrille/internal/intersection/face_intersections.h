#ifndef QUADRILLE_INTERNAL_INTERSECTION_FACE_INTERSECTIONS_H
#define QUADRILLE_INTERNAL_INTERSECTION_FACE_INTERSECTIONS_H

#include <quadrille/internal/base/index.h>
#include <quadrille/internal/complex/star.h>
#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/intersection/box_tree.h>
#include <quadrille/internal/intersection/edge_order.h>
#include <quadrille/internal/intersection/face_sides.h>
#include <quadrille/internal/intersection/flat_fan.h>
#include <quadrille/internal/intersection/intersection_check.h>
#include <quadrille/internal/intersection/swept_space.h>
#include <quadrille/internal/intersection/tree_order.h>
#include <quadrille/internal/intersection/triangle_pair.h>
#include <quadrille/internal/surface/geometry.h>
#include <quadrille/vector.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <memory>
#include <span>
#include <vector>

namespace quadrille::internal {

/// Where the faces of a surface are, in a tree of boxes, and which of them intersect.
///
/// Once half of the faces are gone, the tree is built anew of those that are left, in the same
/// order: what was next to each other still is. So all that takes linear time, but for the first
/// sort. 36 bytes a face.
template <std::size_t N>
class FaceIntersections final : public IntersectionCheck {
public:
  FaceIntersections(const TriangleComplex& complex, const Geometry<N>& geometry)
      : complex_(complex), geometry_(geometry) {}

  void begin() override {
    sort_faces();
    plant();
  }

  bool makes_intersection(const PairStar& star, Index first, Index second,
                          const Vector<3>& target) override {
    const FloatBox around = gather(star, first, target);
    if (!fan_.is(changed_) && (meets_itself() || turns_inside_out(star, first, second)))
      return true;
    const auto is_beside = [&](Index face) {
      const auto& v = complex_.vertices(face);
      return !complex_.is_removed(face) && std::none_of(v.begin(), v.end(), [&](Index w) {
        return w != star.hub && (w == first || w == second);
      });
    };
    return (is_beside(last_met_) && is_met(last_met_)) || meets_near(around, is_beside) ||
           passes_over_near();
  }

  void follow(const PairStar& star, Index first) override {
    for (const StarFace& f : star.shared)
      forget(f.face);
    for_each_changed(star, first, [&](const StarFace& f) {
      if (complex_.is_removed(f.face))
        forget(f.face);
      else
        boxes_.move(slots_[f.face], box_of(f.face));
    });
    if (2 * left_ < faces_.size())
      replant();
  }

  void forget(std::span<const Index> faces) override {
    for (Index face : faces)
      forget(face);
  }

  std::size_t count() override {
    replant();
    std::size_t count = 0;
    for (std::size_t begin = 0; begin < faces_.size(); begin += BoxTree::width)
      for_each_pair_behind(begin, [&](Index, Index) { ++count; });
    return count;
  }

  std::array<Index, 2> first_pair() override {
    replant();
    std::array<Index, 2> first{none, none};
    for (std::size_t begin = 0; begin < faces_.size() && first[0] == none; begin += BoxTree::width)
      for_each_pair_behind(begin, [&](Index a, Index b) {
        if (first[0] == none)
          first = {a, b};
      });
    return first;
  }

private:
  // A face at the place that it has now, or is to have.
  struct PlacedFace {
    Index face;
    FloatBox box;
    FaceCorners corners;
  };

  std::array<float, 3> rounded(const Vector<3>& p) const {
    std::array<float, 3> point;
    for (std::size_t i = 0; i < 3; ++i)
      point[i] = static_cast<float>(p[i] - origin_[i]);
    return point;
  }
  FloatBox box_of(const FaceCorners& corners) const {
    FloatBox box = FloatBox::empty();
    for (const Vector<3>& p : corners.points)
      box.add(rounded(p));
    return box;
  }
  FaceCorners corners_of(Index face) const {
    const auto& v = complex_.vertices(face);
    const auto point = [&](std::size_t i) { return space(geometry_.position(v[i])); };
    return {v, {point(0), point(1), point(2)}};
  }
  FloatBox box_of(Index face) const { return box_of(corners_of(face)); }

  // In the order of the tree. Boxes are about one of their places, so that they lose no more of
  // their coordinates than they have to.
  void sort_faces() {
    for (Index face = 0; face < complex_.face_capacity(); ++face)
      if (!complex_.is_removed(face)) {
        origin_ = corners_of(face).points[0];
        break;
      }
    faces_ = faces_in_tree_order(complex_, [this](Index face) { return box_of(face); });
  }

  void plant() {
    slots_.resize(complex_.face_capacity());
    boxes_ = BoxTree(); // two at a time take more memory
    boxes_ = BoxTree(faces_.size());
    for (std::size_t slot = 0; slot < faces_.size(); ++slot) {
      slots_[faces_[slot]] = static_cast<Index>(slot);
      boxes_.put(slot, box_of(faces_[slot]));
    }
    boxes_.fit();
    left_ = faces_.size();
  }

  void replant() {
    const auto is_gone = [this](Index face) { return complex_.is_removed(face); };
    const auto end = std::remove_if(faces_.begin(), faces_.end(), is_gone);
    if (end == faces_.end())
      return;
    faces_.erase(end, faces_.end());
    plant();
  }

  void forget(Index face) {
    boxes_.move(slots_[face], FloatBox::empty());
    --left_;
  }

  // A hub keeps its place, and its faces.
  template <class Visit>
  static void for_each_changed(const PairStar& star, Index first, Visit visit) {
    if (star.hub == none)
      return star.for_each_changed(visit);
    for (const StarFace& f : star.hub == first ? star.second : star.first)
      visit(f);
  }

  // The faces that a contraction would change, where they would be; the box around them, now and
  // then.
  FloatBox gather(const PairStar& star, Index first, const Vector<3>& target) {
    changed_.clear();
    old_.clear();
    target_ = target;
    FloatBox around = FloatBox::empty();
    const Index kept = star.hub == none ? first : star.hub;
    for_each_changed(star, first, [&](const StarFace& f) {
      const FaceCorners corners{
          {kept, f.second, f.third},
          {target, space(geometry_.position(f.second)), space(geometry_.position(f.third))}};
      const FloatBox box = box_of(corners);
      changed_.push_back({f.face, box, corners});
      around.add(box);
      sweep(f.face, around);
    });
    for (const StarFace& f : star.shared)
      sweep(f.face, around);
    return around;
  }

  // Would a changed face meet one beside them? Where none does, those that are near are known then.
  template <class IsBeside>
  bool meets_near(const FloatBox& around, IsBeside is_beside) {
    near_.clear();
    sides_.clear();
    for (const PlacedFace& face : changed_)
      sides_.emplace_back(face.corners);
    return boxes_.any_meeting(around, [&](std::size_t slot, const FloatBox& box) {
      const Index face = faces_[slot];
      if (!is_beside(face))
        return false;
      near_.push_back({face, box, corners_of(face)});
      for (std::size_t i = 0; i < changed_.size(); ++i)
        if (changed_[i].box.meets(box) && !sides_[i].separate(near_.back().corners) &&
            begin_to_meet(changed_[i], near_.back())) {
          last_met_ = face;
          return true;
        }
      return false;
    });
  }

  // Another place of the same pair often meets the same face, or one beside it.
  bool is_met(Index face) const {
    const PlacedFace other{face, box_of(face), corners_of(face)};
    return std::any_of(changed_.begin(), changed_.end(), [&](const PlacedFace& changed) {
      return changed.box.meets(other.box) && !FaceSides(changed.corners).separate(other.corners) &&
             begin_to_meet(changed, other);
    });
  }

  void sweep(Index face, FloatBox& around) {
    old_.push_back(face);
    around.add(box_of(face));
  }

  // Does the surface pass over one of the faces near it? Of one that meets it neither before nor
  // afterwards a point tells, which lies on no line that is likely to be a side of something.
  bool passes_over_near() {
    if (near_.empty())
      return false;
    swept_.begin(target_);
    for (const Index face : old_)
      swept_.add(corners_of(face).points);
    return std::any_of(near_.begin(), near_.end(), [this](const PlacedFace& face) {
      const auto& [a, b, c] = face.corners.points;
      return swept_.has(0.4142 * a + 0.3183 * b + 0.2675 * c) && !is_degenerate(face.corners) &&
             std::none_of(old_.begin(), old_.end(), [&](Index old) {
               return TrianglePair(corners_of(old), face.corners).intersect();
             });
    });
  }

  // Do two faces intersect that do not now, or pass through each other that only touch?
  bool begin_to_meet(const PlacedFace& a, const PlacedFace& b) const {
    const TrianglePair then(a.corners, b.corners);
    if (!then.intersect())
      return false;
    const TrianglePair now(corners_of(a.face), corners_of(b.face));
    return !now.intersect() || (then.pass_through() && !now.pass_through());
  }

  // Do two of the changed faces, or does one lose its area? It would meet others without being
  // seen.
  bool meets_itself() const {
    for (auto a = changed_.begin(); a != changed_.end(); ++a) {
      if (is_degenerate(a->corners) && !is_degenerate(corners_of(a->face)))
        return true;
      for (auto b = std::next(a); b != changed_.end(); ++b)
        if (a->box.meets(b->box) && begin_to_meet(*a, *b))
          return true;
    }
    return false;
  }

  // Do faces change places around an edge of four or more at the new vertex? A hub has others
  // there.
  bool turns_inside_out(const PairStar& star, Index first, Index second) const {
    const auto alternates_now = [&](Index v, Index w) {
      EdgeOrder order(space(geometry_.position(v)), space(geometry_.position(w)));
      for (const Index face : old_)
        order.add(corners_of(face), v, w);
      return order.alternates();
    };
    const auto is_wrong_at = [&](const Vector<3>& target, Index w) {
      EdgeOrder order(target, space(geometry_.position(w)));
      for (const PlacedFace& face : changed_)
        order.add(face.corners, first, w);
      return !order.alternates() && alternates_now(first, w) && alternates_now(second, w);
    };
    return star.hub == none &&
           std::any_of(changed_.begin(), changed_.end(), [&](const PlacedFace& face) {
             return is_wrong_at(face.corners.points[0], face.corners.vertices[1]);
           });
  }

  // Of a face in one of eight slots and another one behind it, those that intersect.
  template <class Visit>
  void for_each_pair_behind(std::size_t begin, Visit visit) const {
    const std::size_t end = (std::min)(begin + BoxTree::width, faces_.size());
    std::vector<FaceSides> sides;
    for (std::size_t slot = begin; slot < end; ++slot)
      sides.emplace_back(corners_of(faces_[slot]));
    boxes_.for_each_meeting(
        boxes_.around(begin / BoxTree::width), [&](std::size_t slot, const FloatBox& box) {
          if (slot <= begin)
            return;
          const FaceCorners corners = corners_of(faces_[slot]);
          for (std::size_t other = begin; other < (std::min)(end, slot); ++other)
            if (const FaceSides& face = sides[other - begin];
                boxes_[other].meets(box) && !face.separate(corners) &&
                TrianglePair(face.corners(), corners).intersect())
              visit(faces_[other], faces_[slot]);
        });
  }

  const TriangleComplex& complex_;
  const Geometry<N>& geometry_;
  Vector<3> origin_{};
  std::vector<Index> faces_; // of each slot
  std::vector<Index> slots_; // of each face
  BoxTree boxes_;
  std::size_t left_ = 0;
  std::vector<PlacedFace> changed_, near_; // see gather() and meets_near()
  std::vector<FaceSides> sides_;           // of those that change
  Index last_met_ = 0;
  std::vector<Index> old_; // faces that a contraction would change, or take away
  Vector<3> target_{};     // of the last contraction
  SweptSpace swept_;       // by old_ on the way there
  FlatFan fan_;
};

/// What keeps the faces of a surface apart.
template <std::size_t N>
std::unique_ptr<IntersectionCheck> make_intersection_check(const TriangleComplex& complex,
                                                           const Geometry<N>& geometry) {
  return std::make_unique<FaceIntersections<N>>(complex, geometry);
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_INTERSECTION_FACE_INTERSECTIONS_H
