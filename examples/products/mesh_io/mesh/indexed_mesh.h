#ifndef QUADRILLE_EXAMPLES_MESH_IO_INDEXED_MESH_H
#define QUADRILLE_EXAMPLES_MESH_IO_INDEXED_MESH_H

#include "../formats/losses.h"
#include "colors.h"
#include "face_parts.h"
#include "named_numbers.h"

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace quadrille_examples {

using Point = CGAL::Simple_cartesian<double>::Point_3;

/// Values of N numbers at the corners of triangles, as in an OBJ file.
template <std::size_t N>
struct CornerValues {
  std::vector<std::array<double, N>> values;
  std::vector<std::array<std::uint32_t, 3>> triples; ///< empty, or indices for each triangle
  bool are_double = false; ///< in a file of types; else of single precision

  bool empty() const { return triples.empty(); }
};

/// A triangle soup as a file holds it: any triangles at all, manifold or not.
struct IndexedMesh {
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Color> colors;                              ///< empty, or one per point
  ColorType color_type;                                   ///< in which the colours are
  std::vector<std::array<double, 2>> texture_coordinates; ///< empty, or one per point
  /// Of each corner, the number of its colour, texture coordinate and vertex numbers, where they
  /// have seams: the first of these are those of the points, further ones follow. Empty: there are
  /// no others.
  std::vector<std::array<std::uint32_t, 3>> value_triangles;
  CornerValues<2> corner_textures; ///< instead of these
  CornerValues<3> corner_normals;
  FaceParts parts;                           ///< of the triangles
  std::vector<NamedNumbers> vertex_numbers;  ///< each of them one per point
  std::vector<NamedNumbers> face_numbers;    ///< each of them one per triangle
  std::vector<std::string> texture_comments; ///< those of a PLY file that name textures
  std::string stl_header;                    ///< of a binary STL file, if it names a colour
  std::vector<std::string> remarks;          ///< what reading left out or changed
  Losses losses;                             ///< what the file has besides
};

/// Of each corner, the number of what a vertex has beside its place.
inline const std::vector<std::array<std::uint32_t, 3>>& value_triangles(const IndexedMesh& mesh) {
  return mesh.value_triangles.empty() ? mesh.triangles : mesh.value_triangles;
}

/// The point at which each of these numbers is.
inline std::vector<Point> points_of_values(const IndexedMesh& mesh) {
  std::vector<Point> points = mesh.points;
  for (std::size_t face = 0; face < mesh.value_triangles.size(); ++face)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t value = mesh.value_triangles[face][i];
      points.resize(std::max(points.size(), value + 1), Point(0, 0, 0));
      points[value] = mesh.points[mesh.triangles[face][i]];
    }
  return points;
}

/// The name of the face number that holds the colours of facets of a binary STL file, as they are
/// there: 0 where there is none.
inline constexpr const char* stl_color_name = "stl_color";

/// These, if a mesh has them.
inline const NamedNumbers* stl_colors(const IndexedMesh& mesh) {
  for (const NamedNumbers& numbers : mesh.face_numbers)
    if (numbers.name == stl_color_name)
      return &numbers;
  return nullptr;
}

} // namespace quadrille_examples

#endif
