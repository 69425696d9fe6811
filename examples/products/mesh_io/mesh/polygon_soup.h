#ifndef QUADRILLE_EXAMPLES_MESH_IO_POLYGON_SOUP_H
#define QUADRILLE_EXAMPLES_MESH_IO_POLYGON_SOUP_H

/// \file
/// What a reader collects from a file, before it is checked and triangulated.

#include "indexed_mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace quadrille_examples {

/// More points than this do not fit the 32-bit indices of a triangle.
inline constexpr std::uint64_t most_points = std::numeric_limits<std::uint32_t>::max() - 1;

struct PolygonSoup {
  static constexpr std::uint32_t no_value = std::numeric_limits<std::uint32_t>::max();

  std::vector<Point> points;
  std::vector<Color> colors; ///< empty or one per point; the alpha may be `opaque`
  ColorType color_type;
  bool is_color_unit_certain = true; ///< else `color_type.full` is to be guessed
  /// One per point for the formats that keep them there.
  std::vector<std::array<double, 2>> texture_coordinates;

  /// The corners of all polygons, one polygon after the other; all smaller than `points.size()`.
  std::vector<std::uint32_t> corners;
  std::vector<std::size_t> polygon_ends; ///< where in `corners` each polygon ends
  /// For the formats that keep them at the corners: a table, and an index into it for each corner
  /// of the polygons whose parts have such values.
  std::vector<std::array<double, 2>> texture_table;
  std::vector<std::uint32_t> corner_textures;
  std::vector<std::array<double, 3>> normal_table;
  std::vector<std::uint32_t> corner_normals;
  bool are_textures_double = false; ///< see CornerValues
  bool are_normals_double = false;
  FaceParts parts; ///< of the polygons; empty for the formats that have none

  std::vector<NamedNumbers> vertex_numbers; ///< each of them one per point
  std::vector<NamedNumbers> face_numbers;   ///< each of them one per polygon
  std::vector<std::string> texture_comments;
  std::string stl_header; ///< see IndexedMesh

  std::vector<std::string> remarks;
  Losses losses;

  /// Ends the polygon of the corners that have been appended since the last one.
  void end_polygon() { polygon_ends.push_back(corners.size()); }

  /// Where in `corners` a polygon begins.
  std::size_t begin_of(std::size_t polygon) const {
    return polygon == 0 ? 0 : polygon_ends[polygon - 1];
  }
};

} // namespace quadrille_examples

#endif
