#ifndef QUADRILLE_LEVEL_SPLITS_H
#define QUADRILLE_LEVEL_SPLITS_H

#include <quadrille/level_steps.h>
#include <quadrille/levels.h>
#include <quadrille/recorded.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace quadrille {

/// Levels as flat arrays: the coarsest level, and the vertex splits that refine it to the input.
///
/// Level s has the vertices 0 … vertex_counts[s] − 1 and the faces 0 … face_counts[s] − 1. Level 0
/// is the coarsest one, with the first points and faces. Split s leads from level s to level s + 1:
///
/// 1. The corners corners[corner_begins[s]] … corners[corner_begins[s + 1] − 1] become children[s].
/// 2. The next points and the next faces are appended, up to the counts of level s + 1.
/// 3. The vertex parents[s] moves from merged_points[s] to parent_points[s].
///
/// A split that only restores faces, such as a component that has vanished, has not_recorded as its
/// parent and child. Channels are not included.
struct VertexSplits {
  /// For each vertex, its position when it appears: at level 0, or after the split that makes it.
  std::vector<std::array<double, 3>> points;
  /// For each face, its vertices when it appears.
  std::vector<std::array<std::uint32_t, 3>> faces;
  std::vector<std::uint32_t> input_vertices; ///< for each vertex, its index in the input
  std::vector<std::uint32_t> input_faces;    ///< for each face, its index in the input
  std::vector<std::uint32_t> vertex_counts;  ///< for each level
  std::vector<std::uint32_t> face_counts;    ///< for each level
  std::vector<double> errors;                ///< for each level: see LevelInfo::error
  std::vector<std::uint32_t> parents;        ///< for each split, the vertex that is split
  std::vector<std::uint32_t> children;       ///< for each split, the last vertex that it adds
  std::vector<std::array<double, 3>> merged_points; ///< for each split, its parent before it
  std::vector<std::array<double, 3>> parent_points; ///< for each split, its parent after it
  std::vector<std::uint32_t> corner_begins;         ///< for each split its first one; their number
  std::vector<std::uint32_t> corners;               ///< corners of faces: 3 · face + corner
};

namespace internal {

/// Adds the split that a step backwards has just done.
inline void add_split(VertexSplits& splits, const LevelSteps& steps) {
  const LevelStep& step = steps.last_step();
  for (std::size_t v = step.coarser_vertices; v < step.finer_vertices; ++v)
    splits.points.push_back(steps.points()[v]);
  for (std::size_t face = step.coarser_faces; face < step.finer_faces; ++face)
    splits.faces.push_back(steps.triangles()[face]);
  splits.parents.push_back(step.kept);
  splits.children.push_back(step.gone);
  splits.merged_points.push_back(step.after);
  splits.parent_points.push_back(step.kept_before);
  for (const std::uint32_t face : step.changed)
    for (std::uint32_t i = 0; i < 3 && face < step.coarser_faces; ++i)
      if (steps.triangles()[face][i] == step.gone)
        splits.corners.push_back(3 * face + i);
  splits.corner_begins.push_back(static_cast<std::uint32_t>(splits.corners.size()));
}

} // namespace internal

/// Returns all levels as vertex splits, in time linear in the size of the recording. Throws
/// std::logic_error if nothing has been recorded.
///
/// Source: Hoppe, Progressive Meshes, 1996, for vertex splits; here they restore surfaces that are
/// not manifold as well.
inline VertexSplits vertex_splits(const Levels& levels) {
  LevelSteps steps(levels, levels.coarsest());
  VertexSplits splits;
  splits.points.assign(steps.points().begin(), steps.points().end());
  splits.faces.assign(steps.triangles().begin(), steps.triangles().end());
  splits.corner_begins.push_back(0);
  for (;;) {
    const LevelInfo level = steps.info();
    splits.vertex_counts.push_back(static_cast<std::uint32_t>(level.vertices));
    splits.face_counts.push_back(static_cast<std::uint32_t>(level.faces));
    splits.errors.push_back(level.error);
    if (!steps.refine())
      break;
    internal::add_split(splits, steps);
  }
  splits.input_vertices.assign(steps.input_vertices().begin(), steps.input_vertices().end());
  splits.input_faces.assign(steps.input_faces().begin(), steps.input_faces().end());
  return splits;
}

} // namespace quadrille

#endif // QUADRILLE_LEVEL_SPLITS_H
