#ifndef QUADRILLE_LEVEL_STEPS_H
#define QUADRILLE_LEVEL_STEPS_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/levels/level_track.h>
#include <quadrille/levels.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace quadrille {

/// One contraction between two levels, described in the same way forwards and backwards: an edge
/// collapse of a progressive mesh, or its vertex split. To animate it, move both ends between their
/// positions at the finer level and `after` (a geomorph).
struct LevelStep {
  /// The vertex that is left; not_recorded if faces are only removed.
  std::uint32_t kept = not_recorded;
  std::uint32_t gone = not_recorded;      ///< the vertex that is merged into it
  std::array<double, 3> kept_before = {}; ///< position of the kept vertex at the finer level
  std::array<double, 3> gone_before = {}; ///< position of the removed vertex at the finer level
  std::array<double, 3> after = {};       ///< position of the kept vertex after the contraction
  std::size_t finer_faces = 0;            ///< at the finer level; the last ones are removed
  std::size_t coarser_faces = 0;          ///< at the coarser level
  std::size_t finer_vertices = 0;         ///< at the finer level; the last ones are removed
  std::size_t coarser_vertices = 0;       ///< at the coarser level
  /// The triangles with a corner at either vertex at the finer level, or at the kept vertex at the
  /// coarser one, including the removed triangles.
  std::span<const std::uint32_t> changed;
};

/// A level that goes to the next coarser and the next finer one, contraction by contraction: a
/// progressive mesh. Its points and triangles are those of Levels::at for the same number of
/// contractions.
///
/// A step usually takes time proportional to the number of changes; at each halving of the faces it
/// takes time linear in the size of the level. Steps only have positions; for channels extract
/// whole levels.
///
/// Source: Hoppe, Progressive Meshes, 1996, sections 3 and 4.
class LevelSteps {
public:
  /// Begins at the finest level. `levels` must outlive the object.
  explicit LevelSteps(const Levels& levels) : levels_(levels) {
    levels.require_any();
    enter(0);
  }

  /// Returns the figures of the current level.
  LevelInfo info() const { return levels_.info({segment_, contractions_}); }
  /// Returns the points of the current level; they are valid until the next step.
  std::span<const std::array<double, 3>> points() const {
    return std::span(points_).first(track().items_at(contractions_));
  }
  /// Returns the triangles of the current level, as indices of points; they are valid until the
  /// next step.
  std::span<const std::array<std::uint32_t, 3>> triangles() const {
    return std::span(triangles_).first(segment().faces_at(contractions_));
  }

  /// Does the next contraction. Returns false at the coarsest level.
  bool coarsen() {
    if (contractions_ == segment().contractions()) {
      if (segment_ + 1 == levels_.segments_.size())
        return false;
      enter(segment_ + 1);
      return coarsen();
    }
    describe(contractions_++);
    apply(step_.gone, step_.kept);
    for_each_change(contractions_ - 1, [&](std::size_t change) {
      points_[track().changed[change]] = changed_point(change);
    });
    return true;
  }
  /// Undoes the last contraction. False at the finest level.
  bool refine() {
    if (contractions_ == 0) {
      if (segment_ == 0)
        return false;
      enter(segment_ - 1);
      while (contractions_ < segment().contractions())
        coarsen();
      return refine();
    }
    describe(--contractions_);
    for_each_change(contractions_, [&](std::size_t change) {
      points_[track().changed[change]] = point_before(change);
    });
    apply(step_.gone, step_.gone);
    return true;
  }

  /// Returns the last step, forwards or backwards. Its data is valid until the next step.
  const LevelStep& last_step() const { return step_; }

private:
  using Index = internal::Index;

  const internal::LevelSegment& segment() const { return levels_.segments_[segment_]; }
  const internal::LevelTrack& track() const { return segment().tracks.front(); }
  std::size_t first_to_go() const { return track().items() - track().parents.size(); }

  // Goes to the beginning of a segment.
  void enter(std::size_t segment) {
    segment_ = segment;
    contractions_ = 0;
    triangles_ = track().corners;
    points_.resize(track().items());
    for (std::size_t v = 0; v < points_.size(); ++v)
      points_[v] = point(track().values.data() + v * track().width);
    list_corners();
    list_children();
    link_changes();
  }

  // Lists for each vertex, by a counting sort, its corners at the beginning of the segment.
  void list_corners() {
    corner_begin_.assign(track().items() + 1, 0);
    for (const auto& corners : track().corners)
      for (Index v : corners)
        ++corner_begin_[v + 1];
    std::partial_sum(corner_begin_.begin(), corner_begin_.end(), corner_begin_.begin());
    std::vector<Index> end(corner_begin_.begin(), corner_begin_.end() - 1);
    corners_.resize(3 * track().corners.size());
    for (Index face = 0; face < track().corners.size(); ++face)
      for (Index i = 0; i < 3; ++i)
        corners_[end[track().corners[face][i]]++] = 3 * face + i;
  }

  // Lists for each vertex those that are merged into it within the segment.
  void list_children() {
    child_begin_.assign(track().items() + 1, 0);
    for (Index parent : track().parents)
      if (parent != internal::none)
        ++child_begin_[parent + 1];
    std::partial_sum(child_begin_.begin(), child_begin_.end(), child_begin_.begin());
    std::vector<Index> end(child_begin_.begin(), child_begin_.end() - 1);
    children_.resize(child_begin_.back());
    for (std::size_t i = 0; i < track().parents.size(); ++i)
      if (track().parents[i] != internal::none)
        children_[end[track().parents[i]]++] = static_cast<Index>(first_to_go() + i);
  }

  // Links each change to the last earlier one of the same vertex.
  void link_changes() {
    std::vector<Index> last(track().items(), internal::none);
    change_before_.clear();
    for (Index change = 0; change < track().changed.size(); ++change) {
      change_before_.push_back(last[track().changed[change]]);
      last[track().changed[change]] = change;
    }
  }

  static std::array<double, 3> point(const double* numbers) {
    return {numbers[0], numbers[1], numbers[2]};
  }
  std::array<double, 3> changed_point(std::size_t change) const {
    return point(track().changed_values.data() + change * track().width);
  }
  std::array<double, 3> point_before(std::size_t change) const {
    return change_before_[change] == internal::none
               ? point(track().values.data() + track().changed[change] * track().width)
               : changed_point(change_before_[change]);
  }
  template <class Visit>
  void for_each_change(std::size_t contraction, Visit visit) const {
    const auto& ends = track().change_ends;
    for (std::size_t i = contraction == 0 ? 0 : ends[contraction - 1]; i < ends[contraction]; ++i)
      visit(i);
  }

  // Describes the contraction, except for its triangles.
  void describe(std::size_t contraction) {
    step_ = {};
    step_.finer_faces = segment().faces_at(contraction);
    step_.coarser_faces = segment().faces_at(contraction + 1);
    step_.finer_vertices = track().items_at(contraction);
    step_.coarser_vertices = track().items_at(contraction + 1);
    for_each_change(contraction, [&](std::size_t change) {
      step_.kept = track().changed[change];
      step_.gone = static_cast<Index>(step_.finer_vertices - 1); // the first one to be removed
      step_.kept_before = point_before(change);
      step_.gone_before = points_[step_.gone];
      step_.after = changed_point(change);
    });
  }

  // Moves the corners of a removed vertex, with all that were merged into it, to another vertex, or
  // back to itself.
  void apply(Index gone, Index vertex) {
    changed_.clear();
    if (gone != internal::none) {
      pending_.assign(1, gone);
      while (!pending_.empty()) {
        const Index v = pending_.back();
        pending_.pop_back();
        for (Index i = corner_begin_[v]; i < corner_begin_[v + 1]; ++i)
          if (corners_[i] / 3 < step_.finer_faces) {
            triangles_[corners_[i] / 3][corners_[i] % 3] = vertex;
            changed_.push_back(corners_[i] / 3);
          }
        pending_.insert(pending_.end(), children_.begin() + child_begin_[v],
                        children_.begin() + child_begin_[v + 1]);
      }
    }
    std::sort(changed_.begin(), changed_.end());
    step_.changed = changed_;
  }

  const Levels& levels_;
  std::size_t segment_ = 0, contractions_ = 0; // where it is
  std::vector<std::array<double, 3>> points_;  // for removed vertices, their last positions
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<Index> corner_begin_, corners_, child_begin_, children_, change_before_;
  std::vector<Index> changed_, pending_;
  LevelStep step_;
};

} // namespace quadrille

#endif // QUADRILLE_LEVEL_STEPS_H
