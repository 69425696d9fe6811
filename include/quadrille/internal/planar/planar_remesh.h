#ifndef QUADRILLE_INTERNAL_PLANAR_PLANAR_REMESH_H
#define QUADRILLE_INTERNAL_PLANAR_PLANAR_REMESH_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/points.h>
#include <quadrille/internal/core/input/input_with_channels.h>
#include <quadrille/internal/core/surface/box.h>
#include <quadrille/internal/core/surface/scale.h>
#include <quadrille/internal/planar/boundary_chains.h>
#include <quadrille/internal/planar/flatness.h>
#include <quadrille/internal/planar/patch_boundaries.h>
#include <quadrille/internal/planar/patch_growth.h>
#include <quadrille/internal/planar/patch_remesher.h>
#include <quadrille/internal/planar/remeshed_surface.h>
#include <quadrille/internal/planar/surface_sides.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The number of patches, and of those that kept more than their corners.
struct PatchCounts {
  std::size_t all = 0, with_boundary = 0, unchanged = 0;
};

/// Finds for each side whether a patch may have the faces on both sides of its edge. This excludes
/// boundaries of labels and named edges.
inline std::vector<unsigned char> crossable_sides(const SurfaceInput<3>& input,
                                                  const SurfaceSides& sides) {
  std::vector<std::array<Index, 2>> barred;
  for (const auto& [v, w] : input.creases)
    barred.push_back({(std::min)(v, w), (std::max)(v, w)});
  std::sort(barred.begin(), barred.end());
  std::vector<unsigned char> may_cross(sides.size(), 0);
  for (Index s = 0; s < sides.size(); ++s) {
    const Index mate = sides.mate(s);
    if (mate == none || (!input.labels.empty() && input.labels[SurfaceSides::face(s)] !=
                                                      input.labels[SurfaceSides::face(mate)]))
      continue;
    const auto [low, high] = std::minmax({sides.from(s), sides.to(s)});
    may_cross[s] = !std::binary_search(barred.begin(), barred.end(), std::array{low, high});
  }
  return may_cross;
}

/// Finds the planar patches of an input and triangulates them again, with the limits in the unit of
/// the input.
///
/// Vertices are within limits.height of the plane of their patch, and of the straight boundary on
/// which they have been.
inline std::pair<RemeshedSurface, PatchCounts> remesh(InputWithChannels input, FlatLimits limits) {
  const Scale<3> scale(input.box(), true);
  const double rounding = rounding_of(input.positions);
  limits.height = scale.length_from_mesh((std::max)(limits.height, 8 * rounding));
  limits.thinnest = (std::min)(
      limits.height, scale.length_from_mesh((std::max)(1e-9 * scale.diagonal(), 8 * rounding)));
  const Array<Vector<3>> scaled = scale.scaled(input.positions);
  const std::span<const Vector<3>> positions(scaled);

  const SurfaceSides sides(input.triangles);
  const std::vector<unsigned char> may_cross = crossable_sides(input, sides);
  PatchGrowth growth(PatchSurface{positions, sides, input.channels}, limits,
                     [&](Index side) { return may_cross[side] != 0; });
  std::vector<PlanarPatch> patches = growth.patches();
  const std::vector<Index> patch_of = growth.take_patch_of();

  const auto is_inside = [&](Index side) {
    return may_cross[side] != 0 &&
           patch_of[SurfaceSides::face(side)] == patch_of[SurfaceSides::face(sides.mate(side))];
  };
  PatchBoundaries boundaries(positions, sides, is_inside,
                             [&](Index v) { return !input.is_fixed.empty() && input.is_fixed[v]; });
  BoundaryChains(boundaries, positions, limits.height).straighten();

  PatchRemesher remesher(positions, sides, std::move(patches), patch_of, boundaries);
  remesher.remesh();
  const PatchCounts counts{remesher.patch_count(), remesher.count(PatchRemesher::Kept::boundary),
                           remesher.count(PatchRemesher::Kept::all)};
  Array<RemeshedFace> faces = remesher.faces(); // before the input is released
  return {RemeshedSurface(std::move(input), std::move(faces)), counts};
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_PLANAR_PLANAR_REMESH_H
