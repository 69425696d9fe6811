#ifndef QUADRILLE_LEVEL_STEPS_H
#define QUADRILLE_LEVEL_STEPS_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/levels/corner_circles.h>
#include <quadrille/internal/levels/level_track.h>
#include <quadrille/levels.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
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
  /// The triangles with a corner at either vertex at the finer level, and the removed triangles, in
  /// ascending order.
  std::span<const std::uint32_t> changed;
};

/// A level that goes to the next coarser and the next finer one, contraction by contraction: a
/// progressive mesh. Its points and triangles are those of Levels::at for the same number of
/// contractions.
///
/// A step takes time proportional to the number of changes; at each halving of the faces it takes
/// time linear in the size of the level. Steps only have positions; for channels extract whole
/// levels.
///
/// Source: Hoppe, Progressive Meshes, 1996, sections 3 and 4.
class LevelSteps {
public:
  /// Begins at the finest level. `levels` must outlive the object.
  explicit LevelSteps(const Levels& levels) : levels_(levels) {
    levels.require_any();
    enter(0);
  }
  /// Begins at a level, in time linear in the size of the surface that is stored before it.
  LevelSteps(const Levels& levels, const LevelInfo& level) : levels_(levels) {
    const internal::LevelPlace place = levels.find(AfterContractions{level.contractions});
    enter(place.segment);
    while (contractions_ < place.contractions)
      coarsen();
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
    list_changed();
    if (step_.gone != not_recorded) {
      set_corners(step_.gone, step_.kept);
      corners_.merge(step_.kept, step_.gone);
    }
    for (std::size_t face = step_.coarser_faces; face < step_.finer_faces; ++face)
      corners_.remove(static_cast<Index>(face));
    for_each_change(contractions_ - 1, [&](std::size_t change) {
      points_[track().changed[change]] = changed_point(change);
    });
    return true;
  }
  /// Undoes the last contraction. Returns false at the finest level.
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
    for (std::size_t face = step_.finer_faces; face-- > step_.coarser_faces;)
      corners_.restore(static_cast<Index>(face));
    if (step_.gone != not_recorded) {
      corners_.split(step_.kept, step_.gone);
      set_corners(step_.gone, step_.gone);
    }
    list_changed();
    return true;
  }

  /// Returns the last step, forwards or backwards. Its data is valid until the next step.
  const LevelStep& last_step() const { return step_; }

  /// Returns the triangles that coarsen() has just removed, with the kept vertex in the place of
  /// the removed one; they are valid until the next step.
  std::span<const std::array<std::uint32_t, 3>> removed_triangles() const {
    return std::span(triangles_)
        .subspan(step_.coarser_faces, step_.finer_faces - step_.coarser_faces);
  }

  /// Calls visit(triangle) for the triangles with a corner at a vertex of the current level.
  template <class Visit>
  void for_each_triangle(std::uint32_t vertex, Visit visit) const {
    corners_.for_each(vertex, [&](Index corner) { visit(corner / 3); });
  }
  /// Returns, for each point of the current level, its vertex of the input, as Level does.
  std::span<const std::uint32_t> input_vertices() const {
    return std::span(levels_.input_vertices_).first(points().size());
  }
  /// Returns, for each triangle of the current level, its face of the input.
  std::span<const std::uint32_t> input_faces() const {
    return std::span(levels_.input_faces_).first(triangles().size());
  }

private:
  using Index = internal::Index;

  const internal::LevelSegment& segment() const { return levels_.segments_[segment_]; }
  const internal::LevelTrack& track() const { return segment().tracks.front(); }

  // Goes to the beginning of a segment.
  void enter(std::size_t segment) {
    segment_ = segment;
    contractions_ = 0;
    triangles_ = track().corners;
    points_.resize(track().items());
    for (std::size_t v = 0; v < points_.size(); ++v)
      points_[v] = point(track().values.data() + v * track().width);
    corners_.build(track().items(), triangles_);
    link_changes();
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

  // Sets the corners of a vertex to another one, or back.
  void set_corners(Index vertex, Index to) {
    corners_.for_each(vertex, [&](Index corner) { triangles_[corner / 3][corner % 3] = to; });
  }

  // Lists the triangles of the contraction, at the finer level.
  void list_changed() {
    changed_.clear();
    const auto add = [this](Index corner) { changed_.push_back(corner / 3); };
    if (step_.gone != not_recorded) {
      corners_.for_each(step_.kept, add);
      corners_.for_each(step_.gone, add);
    }
    for (std::size_t face = step_.coarser_faces; face < step_.finer_faces; ++face)
      changed_.push_back(static_cast<Index>(face));
    std::sort(changed_.begin(), changed_.end());
    changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
    step_.changed = changed_;
  }

  const Levels& levels_;
  std::size_t segment_ = 0, contractions_ = 0; // where it is
  std::vector<std::array<double, 3>> points_;  // for removed vertices, their last positions
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  internal::CornerCircles corners_;
  std::vector<Index> change_before_; // for each change, the one before it of the same vertex
  std::vector<Index> changed_;
  LevelStep step_;
};

} // namespace quadrille

#endif // QUADRILLE_LEVEL_STEPS_H
