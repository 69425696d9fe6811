#ifndef QUADRILLE_LEVEL_MAPS_H
#define QUADRILLE_LEVEL_MAPS_H

#include <quadrille/internal/levels/place_tracker.h>
#include <quadrille/levels.h>
#include <quadrille/recorded.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

/// \file
/// Maps between the surfaces of two levels, through all contractions between them, as places or as
/// sparse matrices. They transfer fields, skin weights and textures:
///
/// ```cpp
/// Levels levels;
/// simplify(mesh, FaceCount{1000}, record_into(levels));
/// const SparseRows rows = old_to_new(levels, levels.coarsest());
/// const std::vector<double> values = rows * values_at_result; // for each input vertex
/// ```

namespace quadrille {

/// A place on the surface of a level: a face with the weights of its corners.
struct SurfacePlace {
  /// The face, as an index of the input; not_recorded if the surface there has vanished.
  std::uint32_t face = not_recorded;
  /// The weights of the corners of this face, in their order: at least 0, of the sum 1.
  std::array<double, 3> weights = {};
};

/// A sparse matrix by rows (CSR): row i has the entries from begins[i] to begins[i + 1]. Each row
/// has up to three weights above 0, of the sum 1 up to rounding, with ascending columns; or none.
struct SparseRows {
  std::size_t columns = 0;           ///< the number of columns
  std::vector<std::int64_t> begins;  ///< for each row its first entry, and their number at the end
  std::vector<std::int64_t> indices; ///< for each entry, its column
  std::vector<double> weights;       ///< for each entry, its weight

  std::size_t rows() const { return begins.size() - 1; } ///< the number of rows

  /// Multiplies a value for each column: returns one for each row; 0 for an empty one. `Value` has
  /// `+=` and the product with a double.
  template <class Value>
  std::vector<Value> operator*(const std::vector<Value>& values) const {
    std::vector<Value> result(rows());
    for (std::size_t row = 0; row < rows(); ++row)
      for (auto i = static_cast<std::size_t>(begins[row]);
           i < static_cast<std::size_t>(begins[row + 1]); ++i)
        result[row] += weights[i] * values[static_cast<std::size_t>(indices[i])];
    return result;
  }
};

/// Carries places from a level to another one, which may be coarser or finer.
///
/// Each contraction replaces the faces around its two ends. A place on them moves to the point of
/// the new faces that is nearest to where it was at first. Faces that are turned by less than 90
/// degrees are preferred if they are hardly further, so that both sides of a thin part stay apart.
/// If no face is left there, it moves to the faces next to those that were removed; if there are
/// none either, its face becomes not_recorded. At the end, each place moves over edges as long as
/// the surface comes nearer. Places whose surroundings do not change keep their bits.
///
/// Takes time proportional to the number of contractions between the levels, and to the number of
/// places times the logarithm of the ratio of their faces. Throws std::invalid_argument for a place
/// on a face that the level `from` does not have.
///
/// Source: Cohen, Manocha and Olano, Simplifying Polygonal Models Using Successive Mappings, 1997,
/// for the composition; the nearest point takes the place of their projection.
inline std::vector<SurfacePlace> carried_places(const Levels& levels, const LevelInfo& from,
                                                const LevelInfo& to,
                                                std::span<const SurfacePlace> places) {
  internal::PlaceTracker tracker(levels, from, places);
  tracker.carry_to(to);
  return tracker.places<SurfacePlace>();
}

namespace internal {

/// The corners of each face of the input on a surface; not_recorded for faces that it lacks.
using CornersByFace = std::vector<std::array<std::uint32_t, 3>>;

/// The vertices of a surface at the corners of its faces.
struct NumberedSurface {
  std::size_t vertices = 0;
  CornersByFace corners;

  /// Returns a place for each vertex: the corner of the first face that has it.
  std::vector<SurfacePlace> places() const {
    std::vector<SurfacePlace> places(vertices);
    for (std::uint32_t face = 0; face < corners.size(); ++face)
      for (std::size_t i = 0; i < 3; ++i)
        if (const std::uint32_t v = corners[face][i];
            v != not_recorded && places[v].face == not_recorded) {
          places[v].face = face;
          places[v].weights[i] = 1;
        }
    return places;
  }
};

/// Returns the corners of faces whose indices of the input are given.
template <class Triangles, class InputFaces>
CornersByFace corners_by_face(const Triangles& triangles, const InputFaces& input_faces) {
  CornersByFace corners;
  for (std::size_t i = 0; i < input_faces.size(); ++i) {
    if (input_faces[i] >= corners.size())
      corners.resize(std::size_t{input_faces[i]} + 1, {not_recorded, not_recorded, not_recorded});
    for (std::size_t k = 0; k < 3; ++k)
      corners[input_faces[i]][k] = triangles[i][k];
  }
  return corners;
}

/// Returns places as rows of weights of the vertices of a surface.
inline SparseRows rows_of(std::span<const SurfacePlace> places, const NumberedSurface& surface) {
  SparseRows rows;
  rows.columns = surface.vertices;
  rows.begins.push_back(0);
  for (const SurfacePlace& place : places) {
    std::array<std::pair<std::int64_t, double>, 3> entries;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3 && place.face != not_recorded; ++i)
      if (place.weights[i] > 0)
        entries[count++] = {surface.corners[place.face][i], place.weights[i]};
    std::sort(entries.begin(), entries.begin() + static_cast<std::ptrdiff_t>(count));
    for (std::size_t i = 0; i < count; ++i) {
      rows.indices.push_back(entries[i].first);
      rows.weights.push_back(entries[i].second);
    }
    rows.begins.push_back(static_cast<std::int64_t>(rows.indices.size()));
  }
  return rows;
}

/// Returns, for each vertex of a surface at a level, the weights of those of another one.
inline SparseRows vertex_rows(const Levels& levels, const LevelInfo& from,
                              const NumberedSurface& from_surface, const LevelInfo& to,
                              const NumberedSurface& to_surface) {
  return rows_of(carried_places(levels, from, to, from_surface.places()), to_surface);
}

/// Returns the input with its own numbers.
inline NumberedSurface surface_of_input(const Levels& levels) {
  Level level = levels.at(AfterContractions{0});
  for (auto& triangle : level.triangles)
    for (std::uint32_t& v : triangle)
      v = level.input_vertices[v];
  return {levels.input_vertex_count(), corners_by_face(level.triangles, level.input_faces)};
}

/// Returns a level with the numbers of in_input_order().
inline NumberedSurface surface_in_input_order(const Levels& levels, const LevelInfo& info) {
  const Level level = in_input_order(levels.at(AfterContractions{info.contractions}));
  return {level.points.size(), corners_by_face(level.triangles, level.input_faces)};
}

} // namespace internal

/// Returns for each vertex of the input its place on a level, as weights of the points of
/// in_input_order(level), which are those of the result of `simplify`. Rows of vertices without a
/// face, or whose part of the surface has vanished, are empty. See carried_places().
inline SparseRows old_to_new(const Levels& levels, const LevelInfo& level) {
  return internal::vertex_rows(levels, levels.finest(), internal::surface_of_input(levels), level,
                               internal::surface_in_input_order(levels, level));
}

/// Returns for each point of in_input_order(level) its place on the input, as weights of the
/// vertices of the input. No row is empty. See carried_places().
inline SparseRows new_to_old(const Levels& levels, const LevelInfo& level) {
  return internal::vertex_rows(levels, level, internal::surface_in_input_order(levels, level),
                               levels.finest(), internal::surface_of_input(levels));
}

} // namespace quadrille

#endif // QUADRILLE_LEVEL_MAPS_H
