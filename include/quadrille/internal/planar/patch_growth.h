#ifndef QUADRILLE_INTERNAL_PLANAR_PATCH_GROWTH_H
#define QUADRILLE_INTERNAL_PLANAR_PATCH_GROWTH_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/planar/flatness.h>
#include <quadrille/internal/planar/surface_sides.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// A region of a surface whose faces are connected across edges and lie in one plane.
struct PlanarPatch {
  std::vector<Index> faces; ///< ascending
  Vector<3> normal;         ///< a vector of length 1; 0 for a single face without area
};

/// Finds planar patches by growing each from the largest remaining face.
///
/// A patch takes in faces that fit across edges that may be crossed. Then its plane is computed
/// again from all of its faces, and the patch grows again from the same face, as long as it becomes
/// larger: so a small first face need not determine the plane to the last bit.
template <class MayCross>
class PatchGrowth {
public:
  /// may_cross(side) says whether a patch may have the faces on both sides of an edge. It is called
  /// for sides that have a mate.
  PatchGrowth(const PatchSurface& surface, const FlatLimits& limits, MayCross may_cross)
      : surface_(surface), flatness_(surface, limits), may_cross_(may_cross),
        patch_of_(surface.sides.face_count(), none), round_of_(patch_of_.size(), 0) {}

  /// Calls visit(patch) for each patch; each triangle is in exactly one.
  template <class Visit>
  void for_each_patch(Visit visit) {
    Index count = 0;
    for (Index seed : by_area())
      if (patch_of_[seed] == none) {
        PlanarPatch patch = patch_at(seed);
        for (Index f : patch.faces)
          patch_of_[f] = count;
        visit(std::move(patch));
        ++count;
      }
  }
  /// Returns all patches.
  std::vector<PlanarPatch> patches() {
    std::vector<PlanarPatch> patches;
    for_each_patch([&](PlanarPatch patch) { patches.push_back(std::move(patch)); });
    return patches;
  }
  /// Returns the patch of each face, after patches() has been called; none for a face that is not a
  /// triangle.
  std::vector<Index> take_patch_of() { return std::move(patch_of_); }

private:
  std::vector<Index> by_area() const {
    std::vector<Index> seeds;
    std::vector<double> area(patch_of_.size());
    for (Index f = 0; f < patch_of_.size(); ++f)
      if (surface_.sides.is_triangle(f)) {
        area[f] = squared_length(surface_.area_vector(f));
        seeds.push_back(f);
      }
    std::stable_sort(seeds.begin(), seeds.end(),
                     [&](Index f, Index g) { return area[f] > area[g]; });
    return seeds;
  }

  PlanarPatch patch_at(Index seed) {
    std::optional<AffinePatch> plane = flatness_.patch_of(seed);
    if (!plane)
      return {{seed}, {}};
    std::vector<Index> faces = grown(seed, *plane);
    for (int round = 0; round < most_rounds && faces.size() > 1; ++round) {
      const auto next = flatness_.patch_of(faces);
      if (!next || !flatness_.fits(seed, *next))
        break;
      std::vector<Index> more = grown(seed, *next);
      if (more.size() <= faces.size())
        break;
      faces = std::move(more);
      plane = next;
    }
    std::sort(faces.begin(), faces.end());
    return {std::move(faces), plane->plane().normal};
  }

  std::vector<Index> grown(Index seed, const AffinePatch& patch) {
    std::vector<Index> faces{seed};
    round_of_[seed] = ++round_;
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (Index s = 3 * faces[i]; s < 3 * faces[i] + 3; ++s) {
        const Index mate = surface_.sides.mate(s);
        if (mate == none || !may_cross_(s))
          continue;
        const Index next = SurfaceSides::face(mate);
        if (patch_of_[next] != none || round_of_[next] == round_ || !flatness_.fits(next, patch))
          continue;
        round_of_[next] = round_;
        faces.push_back(next);
      }
    return faces;
  }

  static constexpr int most_rounds = 4;

  PatchSurface surface_;
  Flatness flatness_;
  MayCross may_cross_;
  std::vector<Index> patch_of_;
  std::vector<Index> round_of_; // the round in which a face was last taken
  Index round_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_PLANAR_PATCH_GROWTH_H
