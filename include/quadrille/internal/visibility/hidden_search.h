#ifndef QUADRILLE_INTERNAL_VISIBILITY_HIDDEN_SEARCH_H
#define QUADRILLE_INTERNAL_VISIBILITY_HIDDEN_SEARCH_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/threads.h>
#include <quadrille/internal/visibility/depth_pictures.h>
#include <quadrille/internal/visibility/face_rays.h>
#include <quadrille/internal/visibility/ray_tree.h>
#include <quadrille/quadric_form.h>
#include <quadrille/triangle_soup.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Decides which faces of a surface are seen: those with a fraction of free rays above a threshold.
///
/// Every face first gets the rays of pictures. Those that are not seen there get a few more of
/// their own, in other directions for each of their neighbours, and those that are in too few
/// pictures get all rays. Faces of which only a few are free, and unseen ones next to seen ones,
/// are *refined*: they get several times as many, until nothing more turns out to be seen. So what
/// is seen through an opening is found where one of its faces is. Refined neighbours on a smooth
/// surface have about the same fraction, so it counts for them together, too.
class HiddenSearch {
public:
  /// Triangles of `surface` are connected if they name the same point. A face is seen if its
  /// fraction of free rays is above the threshold.
  HiddenSearch(const SurfaceView& surface, std::size_t directions, double threshold,
               bool is_front_only)
      : tree_(surface), rays_(tree_, directions, {is_front_only, threshold}),
        pictures_(tree_, rays_, directions / 2), threshold_(threshold), counts_(tree_.size()),
        is_seen_(tree_.size()), is_refined_(tree_.size()), vertex_is_seen_(surface.points.size()) {
    for (std::size_t slot = 0; slot < tree_.size(); ++slot)
      triangles_.push_back(surface.triangles[tree_.face(slot)]);
    list_corners();
  }

  /// Returns false if the caller has ended it.
  bool run(Threads threads, const std::function<bool(double)>& progress) {
    FaceWork work(threads, progress);
    std::vector<Index> slots(tree_.size());
    std::iota(slots.begin(), slots.end(), Index{0});
    if (!pictures_.look(threads, counts_,
                        [&](double done) { return !progress || progress(picture_share * done); }))
      return false;
    if (!look(work, unseen_slots(true), {0, 1, pictured_share}, picture_share, pictured_end) ||
        !look(work, unseen_slots(false), {0, 1}, pictured_end, first_share))
      return false;
    if (!look(work, doubtful_slots(), {1, refinement}, first_share, second_share))
      return false;
    std::vector<Index> seen = newly_seen(slots);
    for (std::vector<Index> next; !(next = unseen_next_to(seen)).empty();) {
      if (!look(work, next, {1, refinement}, second_share, 1))
        return false;
      seen = newly_seen(next);
    }
    return !progress || progress(1);
  }

  /// Returns for each face of the surface whether it is hidden.
  std::vector<bool> hidden() const {
    std::vector<bool> is_hidden(tree_.size());
    for (std::size_t slot = 0; slot < tree_.size(); ++slot)
      is_hidden[tree_.face(slot)] = !is_seen_[slot];
    return is_hidden;
  }

private:
  static constexpr std::size_t refinement = 16;
  static constexpr std::size_t pictured_share = 8; // of the rays of others
  static constexpr double picture_share = 0.5, pictured_end = 0.75, first_share = 0.8,
                          second_share = 0.9; // shares of the time

  bool look(FaceWork& work, std::span<const Index> slots, const FaceRays::Sets& sets, double begin,
            double end) {
    return work(slots, begin, end, [&](std::span<const Index> some) {
      rays_.look(some, sets, [&](Index slot) -> RayCounts& { return counts_[slot]; });
    });
  }

  // Returns faces that are not certainly seen in pictures, and are in enough of them, or are not.
  std::vector<Index> unseen_slots(bool are_pictured) {
    std::vector<Index> slots;
    for (Index slot = 0; slot < tree_.size(); ++slot) {
      if (pictures_.is_tied(slot))
        counts_[slot] = {};
      if (!rays_.is_enough(counts_[slot]) && is_pictured(slot) == are_pictured)
        slots.push_back(slot);
    }
    return slots;
  }
  bool is_pictured(Index slot) const {
    const std::size_t sides = rays_.is_covered(slot) ? 1 : 2,
                      most = sides * pictures_.size() * rays_.units(slot);
    return 2 * std::size_t{counts_[slot].all()} >= most;
  }

  // Without a threshold, one free ray is enough.
  std::vector<Index> doubtful_slots() {
    std::vector<Index> slots;
    for (Index slot = 0; slot < tree_.size() && threshold_ > 0; ++slot)
      if (counts_[slot].most_free() > 0 && !rays_.is_enough(counts_[slot])) {
        slots.push_back(slot);
        is_refined_[slot] = true;
      }
    return slots;
  }

  // The faces of a vertex are a range of faces_at_.
  void list_corners() {
    begins_.assign(vertex_is_seen_.size() + 1, 0);
    for (const auto& triangle : triangles_)
      for (const Index v : triangle)
        ++begins_[v + 1];
    std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
    faces_at_.resize(3 * triangles_.size());
    std::vector<std::size_t> end(begins_.begin(), begins_.end() - 1);
    for (Index slot = 0; slot < triangles_.size(); ++slot)
      for (const Index v : triangles_[slot])
        faces_at_[end[v]++] = slot;
  }

  /// Calls visit(other) for each face that has a vertex in common with one, and for itself.
  template <class Visit>
  void for_each_neighbor(Index slot, Visit visit) const {
    for (const Index v : triangles_[slot])
      for (std::size_t i = begins_[v]; i < begins_[v + 1]; ++i)
        visit(faces_at_[i]);
  }

  /// Returns those that are now known to be seen, among some faces and refined ones next to them.
  std::vector<Index> newly_seen(std::span<const Index> slots) {
    std::vector<Index> seen, doubtful;
    const auto add = [&](Index slot) {
      is_seen_[slot] = true;
      seen.push_back(slot);
    };
    for (const Index slot : slots)
      if (counts_[slot].fraction() > threshold_)
        add(slot);
    for (const Index slot : slots)
      if (is_refined_[slot])
        for_each_neighbor(slot, [&](Index other) {
          if (is_refined_[other] && !is_seen_[other])
            doubtful.push_back(other);
        });
    std::sort(doubtful.begin(), doubtful.end());
    doubtful.erase(std::unique(doubtful.begin(), doubtful.end()), doubtful.end());
    for (const Index slot : doubtful)
      if (joint_counts(slot).fraction() > threshold_)
        add(slot);
    return seen;
  }

  // Faces that are seen well are not refined, and do not count.
  RayCounts joint_counts(Index slot) const {
    constexpr double least_cosine = 0.5;
    const Vector<3> normal = rays_.normal(slot);
    RayCounts joint;
    for_each_neighbor(slot, [&](Index other) {
      const Vector<3> n = rays_.normal(other);
      const double cosine = dot(normal, n),
                   least = least_cosine * std::sqrt(squared_length(normal) * squared_length(n));
      if (is_refined_[other] && std::abs(cosine) >= least)
        joint.add(counts_[other], cosine < 0);
    });
    return joint;
  }

  /// Returns the faces that have not been refined, have not been seen, and have a vertex in common
  /// with one that has been.
  std::vector<Index> unseen_next_to(std::span<const Index> seen) {
    std::vector<Index> unseen;
    for (const Index slot : seen)
      for (const Index v : triangles_[slot]) {
        if (vertex_is_seen_[v])
          continue;
        vertex_is_seen_[v] = true;
        for (std::size_t i = begins_[v]; i < begins_[v + 1]; ++i)
          if (const Index other = faces_at_[i]; !is_seen_[other] && !is_refined_[other]) {
            is_refined_[other] = true;
            unseen.push_back(other);
          }
      }
    return unseen;
  }

  RayTree tree_;
  FaceRays rays_;
  DepthPictures pictures_;
  double threshold_;
  std::vector<RayCounts> counts_;               // by slots
  std::vector<std::array<Index, 3>> triangles_; // by slots
  std::vector<bool> is_seen_, is_refined_;      // by slots
  std::vector<bool> vertex_is_seen_;
  std::vector<std::size_t> begins_;
  std::vector<Index> faces_at_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VISIBILITY_HIDDEN_SEARCH_H
