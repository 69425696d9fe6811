#ifndef QUADRILLE_INTERNAL_VISIBILITY_VISIBLE_FRACTIONS_H
#define QUADRILLE_INTERNAL_VISIBILITY_VISIBLE_FRACTIONS_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/threads.h>
#include <quadrille/internal/visibility/face_rays.h>
#include <quadrille/internal/visibility/hidden_groups.h>
#include <quadrille/internal/visibility/ray_tree.h>
#include <quadrille/triangle_soup.h>

#include <cstddef>
#include <functional>
#include <numeric>
#include <span>
#include <vector>

namespace quadrille::internal {

/// Computes how much of each face of a surface, and of what is around each vertex, is seen.
class VisibleFractions {
public:
  VisibleFractions(const SurfaceView& surface, const SurfaceView& joined, std::size_t directions,
                   bool is_front_only)
      : surface_(surface), joined_(joined), tree_(joined),
        rays_(tree_, directions, {is_front_only, 1}), fractions_(tree_.size()) {}

  /// Returns false if the caller has ended it.
  bool run(Threads threads, const std::function<bool(double)>& progress) {
    std::vector<Index> slots(tree_.size());
    std::iota(slots.begin(), slots.end(), Index{0});
    std::vector<RayCounts> counts(tree_.size());
    FaceWork work(threads, progress);
    const bool is_done = work(slots, 0, 1, [&](std::span<const Index> some) {
      rays_.look(some, {0, 1}, [&](Index slot) -> RayCounts& { return counts[slot]; });
    });
    for (std::size_t slot = 0; slot < tree_.size(); ++slot)
      fractions_[tree_.face(slot)] = counts[slot].fraction();
    return is_done;
  }

  const std::vector<double>& faces() const { return fractions_; }

  /// Returns means over the areas of faces: those of all faces at a place, for each point there.
  std::vector<double> vertices() const {
    std::vector<double> sum(joined_.points.size()), area(joined_.points.size());
    for (std::size_t face = 0; face < fractions_.size(); ++face)
      for (const Index v : joined_.triangles[face]) {
        area[v] += FaceGroups::area(joined_, face);
        sum[v] += FaceGroups::area(joined_, face) * fractions_[face];
      }
    std::vector<double> means(sum.size());
    for (std::size_t face = 0; face < fractions_.size(); ++face)
      for (std::size_t i = 0; i < 3; ++i)
        if (const Index v = joined_.triangles[face][i]; area[v] > 0)
          means[surface_.triangles[face][i]] = sum[v] / area[v];
    return means;
  }

private:
  SurfaceView surface_, joined_; // the second one has one point at each place
  RayTree tree_;
  FaceRays rays_;
  std::vector<double> fractions_; // by faces
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VISIBILITY_VISIBLE_FRACTIONS_H
