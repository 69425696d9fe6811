#ifndef QUADRILLE_INTERNAL_GUARDS_INTERSECTION_FACE_INTERSECTIONS_H
#define QUADRILLE_INTERNAL_GUARDS_INTERSECTION_FACE_INTERSECTIONS_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/guard/surface_guard.h>
#include <quadrille/internal/core/surface/box_tree.h>
#include <quadrille/internal/core/surface/geometry.h>
#include <quadrille/internal/guards/intersection/edge_order.h>
#include <quadrille/internal/guards/intersection/face_sides.h>
#include <quadrille/internal/guards/intersection/flat_fan.h>
#include <quadrille/internal/guards/intersection/swept_space.h>
#include <quadrille/internal/guards/intersection/triangle_pair.h>
#include <quadrille/quadric_form.h>
#include <quadrille/report.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <vector>

namespace quadrille::internal {

/// The faces of a surface in the order in which a tree of their boxes has them: box_of(face).
template <class BoxOf>
std::vector<Index> faces_in_tree_order(const TriangleComplex& complex, BoxOf box_of) {
  struct Centre {
    Index face;
    std::array<float, 3> point;
    bool operator<(const Centre& other) const { return face < other.face; }
  };
  std::vector<Centre> centres;
  for (Index face = 0; face < complex.face_capacity(); ++face) {
    if (complex.is_removed(face))
      continue;
    const FloatBox box = box_of(face);
    Centre centre{face, {}};
    for (std::size_t i = 0; i < 3; ++i)
      centre.point[i] = box.low[i] + box.high[i];
    centres.push_back(centre);
  }
  sort_for_box_tree(centres.data(), centres.data() + centres.size(),
                    [](const Centre& centre) { return centre.point; });
  std::vector<Index> faces;
  faces.reserve(centres.size());
  for (const Centre& centre : centres)
    faces.push_back(centre.face);
  return faces;
}

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

/// The faces of a surface in a tree of boxes, and a test which of them intersect.
///
/// Once half of the faces are gone, the tree is rebuilt from those that are left, in the same
/// order: neighbours in it are still neighbours. So all that takes linear time, except for the
/// first sort. It uses 44 bytes a face.
template <std::size_t N>
class FaceIntersections : public SurfaceGuard<N> {
public:
  FaceIntersections(const TriangleComplex& complex, const Geometry<N>& geometry)
      : complex_(complex), geometry_(geometry) {}

  void begin(Report& report) override {
    forget_pair();
    met_before_.assign(complex_.vertex_capacity(), {none, none, none, none});
    sort_faces();
    plant();
    report.self_intersections = {count(), 0};
  }

  bool rejects(const GuardedPair<N>& pair) override {
    return makes_intersection(pair.star, pair.first, pair.second, space(pair.target));
  }
  bool makes_intersection(const PairStar& star, Index first, Index second,
                          const Vector<3>& target) {
    if (pair_ != std::array{first, second})
      look_at(star, first, second);
    for (const TriedPlace& tried : tried_)
      if (tried.target == target) {
        obstacle_ = tried.obstacle;
        return tried.intersects;
      }
    place_at(target);
    obstacle_ = none;
    const bool intersects = meets_or_passes(star, first, second);
    tried_.push_back({target, intersects, obstacle_});
    return intersects;
  }

  bool has_obstacles() const override { return true; }
  Index obstacle() const override { return obstacle_; }

  void follow(const GuardedPair<N>& pair, Index) override { follow(pair.star, pair.first); }
  void follow(const PairStar& star, Index first) {
    forget_pair();
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
    forget_pair();
    for (Index face : faces)
      forget(face);
  }

  void end(Report& report) override { report.self_intersections->after = count(); }

  /// How many pairs of faces intersect, now.
  std::size_t count() {
    replant();
    std::size_t count = 0;
    for (std::size_t begin = 0; begin < faces_.size(); begin += BoxTree::width)
      for_each_pair_from(begin, [&](Index, Index) { ++count; });
    return count;
  }

  /// One of these, of which there is at least one: the first in an order of its own.
  std::array<Index, 2> first_pair() {
    replant();
    std::array<Index, 2> first{none, none};
    for (std::size_t begin = 0; begin < faces_.size() && first[0] == none; begin += BoxTree::width)
      for_each_pair_from(begin, [&](Index a, Index b) {
        if (first[0] == none)
          first = {a, b};
      });
    return first;
  }

private:
  // The result for a position of the current pair: several positions are tried, and some twice.
  struct TriedPlace {
    Vector<3> target;
    bool intersects;
    Index obstacle;
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

  // A high-valence vertex keeps its place, and its faces.
  template <class Visit>
  static void for_each_changed(const PairStar& star, Index first, Visit visit) {
    if (star.high_valence == none)
      return star.for_each_changed(visit);
    for (const StarFace& f : star.high_valence == first ? star.second : star.first)
      visit(f);
  }

  void forget_pair() { pair_ = {none, none}; }

  // The star of a pair as it is now, which is the same for all places that are tried.
  void look_at(const PairStar& star, Index first, Index second) {
    pair_ = {first, second};
    const Index kept = star.high_valence == none ? first : star.high_valence;
    moving_ = {star.high_valence == first ? second : first,
               star.high_valence == second ? first : second};
    tried_.clear();
    changed_.clear();
    old_.clear();
    for_each_changed(star, first, [&](const StarFace& f) {
      changed_.push_back({f.face,
                          {{kept, f.second, f.third},
                           {Vector<3>{}, space(geometry_.position(f.second)),
                            space(geometry_.position(f.third))}}});
      old_.push_back(f.face);
    });
    for (const StarFace& f : star.shared)
      old_.push_back(f.face);
    around_old_ = searched_ = FloatBox::empty();
    for (const Index face : old_)
      around_old_.add(boxes_[slots_[face]]);
  }

  // Puts the new vertex there.
  void place_at(const Vector<3>& target) {
    target_ = target;
    changed_boxes_.clear();
    for (PlacedFace& face : changed_) {
      face.corners.points[0] = target;
      changed_boxes_.push_back(box_of(face.corners));
    }
  }

  bool meets_or_passes(const PairStar& star, Index first, Index second) {
    if (meets_one_met_before(first))
      return true;
    if (!fan_.is(changed_) && (meets_itself() || turns_inside_out(star, first, second)))
      return true;
    FloatBox around = around_old_;
    around.add(rounded(target_));
    search(around);
    return !near_.empty() && (meets_near() || passes_over_near(around));
  }

  // Does a face stay as it is?
  bool is_next_to(Index face) const {
    const auto& v = complex_.vertices(face);
    return !complex_.is_removed(face) && std::none_of(v.begin(), v.end(), [&](Index w) {
      return w == moving_[0] || w == moving_[1];
    });
  }

  // A pair that has been rejected is tried again and again, at several places, and mostly meets
  // faces that it met before, or that a pair of the same vertex did.
  bool meets_one_met_before(Index vertex) {
    if (is_next_to(last_met_) && is_met(last_met_)) {
      obstacle_ = last_met_;
      return true;
    }
    auto& met = met_before_[vertex];
    for (std::size_t i = 0; i < met.size() && met[i] != none; ++i)
      if (met[i] != last_met_ && is_next_to(met[i]) && is_met(met[i])) {
        obstacle_ = last_met_ = met[i];
        std::rotate(met.begin(), met.begin() + i, met.begin() + i + 1);
        return true;
      }
    return false;
  }
  void note_met(Index vertex, Index face) {
    obstacle_ = last_met_ = face;
    auto& met = met_before_[vertex];
    std::rotate(met.begin(), met.end() - 1, met.end());
    met.front() = face;
  }

  bool is_met(Index face) const {
    const FloatBox box = boxes_[slots_[face]];
    const PlacedFace other{face, corners_of(face)};
    for (std::size_t i = 0; i < changed_.size(); ++i)
      if (changed_boxes_[i].meets(box) && begin_to_meet(changed_[i], other))
        return true;
    return false;
  }

  // Finds the faces that stay as they are in a box, or partly in it.
  void search(const FloatBox& around) {
    if (searched_.contains(around))
      return;
    searched_ = around;
    near_.clear();
    boxes_.for_each_meeting(around, [&](std::size_t slot, const FloatBox& box) {
      if (const Index face = faces_[slot]; is_next_to(face))
        near_.add({face, corners_of(face)}, box);
    });
  }

  // Would a changed face meet one that is near?
  bool meets_near() {
    for (std::size_t i = 0; i < changed_.size(); ++i) {
      const FaceSides sides(changed_[i].corners);
      if (near_.any_meeting(changed_boxes_[i], [&](const PlacedFace& other) {
            if (sides.separate(other.corners) || !begin_to_meet(changed_[i], other))
              return false;
            note_met(pair_[0], other.face);
            return true;
          }))
        return true;
    }
    return false;
  }

  // Does the surface pass over one of the faces near it? For a face that it meets neither before
  // nor afterwards, one point decides, which lies on no line that is likely to be a side of
  // something.
  bool passes_over_near(const FloatBox& around) {
    swept_.begin(target_);
    for (const Index face : old_)
      swept_.add(corners_of(face).points);
    return near_.any_meeting(around, [this](const PlacedFace& face) {
      const auto& [a, b, c] = face.corners.points;
      if (!swept_.has(0.4142 * a + 0.3183 * b + 0.2675 * c) || is_degenerate(face.corners) ||
          std::any_of(old_.begin(), old_.end(), [&](Index old) {
            const FaceCorners corners = corners_of(old);
            return TrianglePair(corners, face.corners).intersect();
          }))
        return false;
      obstacle_ = face.face;
      return true;
    });
  }

  // Do two faces intersect that do not now, or pass through each other that only touch?
  bool begin_to_meet(const PlacedFace& a, const PlacedFace& b) const {
    const TrianglePair then(a.corners, b.corners);
    if (!then.intersect())
      return false;
    const FaceCorners a_now = corners_of(a.face), b_now = corners_of(b.face);
    const TrianglePair now(a_now, b_now);
    return !now.intersect() || (then.pass_through() && !now.pass_through());
  }

  // Do two of the changed faces, or does one lose its area? It would meet others without being
  // seen.
  bool meets_itself() const {
    for (std::size_t i = 0; i < changed_.size(); ++i) {
      if (is_degenerate(changed_[i].corners) && !is_degenerate(corners_of(changed_[i].face)))
        return true;
      for (std::size_t j = i + 1; j < changed_.size(); ++j)
        if (changed_boxes_[i].meets(changed_boxes_[j]) && begin_to_meet(changed_[i], changed_[j]))
          return true;
    }
    return false;
  }

  // Do faces change places around an edge of four or more at the new vertex? A high-valence vertex
  // has others there.
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
    return star.high_valence == none &&
           std::any_of(changed_.begin(), changed_.end(), [&](const PlacedFace& face) {
             return is_wrong_at(face.corners.points[0], face.corners.vertices[1]);
           });
  }

  // Visits the intersecting pairs of a face in one of eight slots and another one after it.
  template <class Visit>
  void for_each_pair_from(std::size_t begin, Visit visit) const {
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
  Index last_met_ = 0, obstacle_ = none;
  std::vector<std::array<Index, 4>> met_before_; // by pairs of each vertex, the last one first

  // The pair at hand, of which several places may be tried: see look_at() and place_at().
  std::array<Index, 2> pair_{none, none};
  std::array<Index, 2> moving_{none, none}; // its ends, but for a high-valence vertex
  std::vector<TriedPlace> tried_;
  std::vector<Index> old_; // faces that the contraction would change, or take away
  FloatBox around_old_ = FloatBox::empty();
  std::vector<PlacedFace> changed_;
  std::vector<FloatBox> changed_boxes_;
  Vector<3> target_{};
  FloatBox searched_ = FloatBox::empty(); // by search()
  NearFaces near_;
  SweptSpace swept_; // by old_ on the way to target_
  FlatFan fan_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GUARDS_INTERSECTION_FACE_INTERSECTIONS_H
