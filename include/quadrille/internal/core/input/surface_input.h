#ifndef QUADRILLE_INTERNAL_CORE_INPUT_SURFACE_INPUT_H
#define QUADRILLE_INTERNAL_CORE_INPUT_SURFACE_INPUT_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/text.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/surface/box.h>
#include <quadrille/internal/core/surface/kept_planes.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace quadrille::internal {

/// The data that an adapter reads.
template <std::size_t N>
struct SurfaceInput {
  explicit SurfaceInput(Arena* arena = nullptr)
      : positions(arena), triangles(arena), input_vertices(arena), input_faces(arena) {}

  Array<Vector<N>> positions; ///< with attributes, all in the mesh's units
  Array<TriangleComplex::Triangle> triangles;
  Array<Index> input_vertices, input_faces;  ///< see InputIndices
  /// Has a value for each vertex; empty if none is fixed.
  std::vector<bool> is_fixed;
  /// The importances of each vertex; empty if all count alike.
  std::vector<double> importances;
  std::vector<std::array<Index, 2>> creases; ///< edges that the user named
  std::vector<bool>
      is_shared; ///< see SharedVertices; empty if none is; such vertices are fixed, too
  std::vector<std::array<Index, 2>> boundaries; ///< see SharedVertices
  /// Replaces the surface's own box where it decides about units. Empty: nothing replaces it.
  std::optional<Box<N>> given_box;
  /// Are the coordinates of the result floats once they are written?
  bool writes_floats = false;
  Array<Index> labels; ///< the labels of each face, small numbers; empty if there are none
  /// May each input face be changed? The corners of others are fixed. Empty if all may.
  std::vector<bool> is_selected;
  /// The tolerance of each vertex, in the mesh's units; empty if there are none. See
  /// ToleranceLimit.
  std::vector<double> tolerances;
  PlanesOfInput planes;     ///< in which vertices have to stay; there may be none
  std::vector<Index> moved; ///< vertices that are no longer where the user's are
  /// May it have faces on the same three vertices? One of those is left, or with
  /// may_have_reverse_faces one of each orientation.
  bool has_duplicate_faces = false;
  bool may_have_reverse_faces = false;

  /// Reserves room. For positions it is a little more than requested, so that arrays of one number
  /// per vertex fit into the space that positions leave in the arena.
  void reserve(std::size_t vertices, std::size_t faces) {
    positions.reserve(vertices + 16);
    triangles.reserve(faces);
  }

  /// Returns the box of the vertices that faces use: others may lie anywhere.
  Box<N> box() const {
    Array<unsigned char> is_used(positions.size(), 0,
                                 positions.get_allocator()); // no bits: these take longer to set
    for (const auto& [a, b, c] : triangles)
      if (a != b && b != c && c != a)
        is_used[a] = is_used[b] = is_used[c] = 1;
    return Box<N>(positions, [&](std::size_t v) { return is_used[v] != 0; });
  }

  /// The least of all that a vertex is given is its own. Throws std::invalid_argument for one that
  /// is no distance; `point` is how its user calls the vertex.
  void limit(Index v, double tolerance, std::size_t point) {
    if (!(tolerance >= 0))
      throw std::invalid_argument("quadrille::simplify: the tolerance " + text_of(tolerance) +
                                  " of vertex " + std::to_string(point) + " is not a distance");
    tolerances.resize(positions.size(), std::numeric_limits<double>::infinity());
    tolerances[v] = (std::min)(tolerances[v], tolerance);
  }

  void fix(Index v) {
    is_fixed.resize(positions.size(), false);
    is_fixed[v] = true;
  }

  /// Fixes a vertex that other chunks have as well.
  void share(Index v) {
    is_shared.resize(positions.size(), false);
    is_shared[v] = true;
    fix(v);
  }
};

/// Input with channels: see input_with_channels.h, which calls with channels include.
struct InputWithChannels;
template <std::size_t N, bool has_channels>
using InputOf = std::conditional_t<has_channels, InputWithChannels, SurfaceInput<N>>;

template <std::size_t N>
void require_finite(const Vector<N>& position, std::size_t vertex) {
  if (is_finite(position))
    return;
  throw std::invalid_argument(
      "quadrille::simplify: vertex " + std::to_string(vertex) +
      (is_finite(space(position)) ? " has an attribute that is not finite" : " is not finite"));
}

/// The corners of a box, in words.
template <std::size_t N>
std::string text_of_box(const Box<N>& box) {
  const auto corner = [](const Vector<N>& p) {
    return "(" + text_of(p[0]) + ", " + text_of(p[1]) + ", " + text_of(p[2]) + ")";
  };
  return corner(box.low) + " to " + corner(box.high);
}

/// Throws std::invalid_argument for a box of which a side is negative or not finite.
template <std::size_t N>
void require_box(const Box<N>& box) {
  for (std::size_t i = 0; i < 3; ++i)
    if (!(box.low[i] <= box.high[i]) || !std::isfinite(box.low[i]) || !std::isfinite(box.high[i]))
      throw std::invalid_argument("quadrille::simplify: bounding_box, from " + text_of_box(box) +
                                  ", is not a box");
}

/// The box that decides about the units in which a surface is simplified: its own, or the one that
/// is given instead. Throws std::invalid_argument if it reaches out of that by more than half of
/// the diagonal: a little may come of an earlier simplification, which moves vertices.
template <std::size_t N>
Box<N> box_of_units(const SurfaceInput<N>& input, const Box<N>& own) {
  if (!input.given_box)
    return own;
  const Box<N>& given = *input.given_box;
  require_box(given);
  const double margin = given.diagonal() / 2;
  for (std::size_t i = 0; i < 3 && !input.triangles.empty(); ++i)
    if (own.low[i] < given.low[i] - margin || own.high[i] > given.high[i] + margin)
      throw std::invalid_argument("quadrille::simplify: the surface, from " + text_of_box(own) +
                                  ", is not inside bounding_box, from " + text_of_box(given));
  return given;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_INPUT_SURFACE_INPUT_H
