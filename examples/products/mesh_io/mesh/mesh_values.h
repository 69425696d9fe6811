#ifndef QUADRILLE_EXAMPLES_MESH_IO_MESH_VALUES_H
#define QUADRILLE_EXAMPLES_MESH_IO_MESH_VALUES_H

#include "follow_triangles.h"
#include "indexed_mesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/// \file
/// What points and triangles of a mesh have beside places and corners. An array is empty if the
/// mesh has none.

namespace quadrille_examples {

/// Calls visit(values) for each array with a value for each point, and for further values of
/// seams.
template <class Visit>
void for_each_values_of_points(IndexedMesh& mesh, Visit visit) {
  visit(mesh.colors);
  visit(mesh.texture_coordinates);
  for (NamedNumbers& numbers : mesh.vertex_numbers)
    visit(numbers.values);
}

/// Calls visit(values) for each array with a value for each triangle.
template <class Visit>
void for_each_values_of_triangles(IndexedMesh& mesh, Visit visit) {
  visit(mesh.value_triangles);
  visit(mesh.corner_textures.triples);
  visit(mesh.corner_normals.triples);
  visit(mesh.parts.of_faces);
  for (NamedNumbers& numbers : mesh.face_numbers)
    visit(numbers.values);
}

/// Gives points that were added to a mesh, behind `count` others, the values of those from which
/// they come first, and triangles those of the triangles that they are part of or next to. Where
/// values have seams, a triangle that is not among the first `unchanged` ones has those of its
/// points.
inline void follow(IndexedMesh& mesh, std::size_t count,
                   const std::vector<std::array<std::size_t, 2>>& origins,
                   const std::vector<std::size_t>& triangles, std::size_t unchanged) {
  for_each_values_of_points(mesh, [&](auto& values) {
    if (values.empty() || origins.empty())
      return;
    auto added = values; // of the type of the array
    added.clear();
    for (const auto& origin : origins)
      added.push_back(origin[0] < count ? values[origin[0]] : added[origin[0] - count]);
    values.insert(values.begin() + static_cast<std::ptrdiff_t>(count), added.begin(), added.end());
  });
  for_each_values_of_triangles(mesh, [&](auto& values) { follow_triangles(values, triangles); });
  for (std::size_t face = 0; face < mesh.value_triangles.size(); ++face)
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& value = mesh.value_triangles[face][k];
      if (face >= unchanged)
        value = mesh.triangles[face][k];
      else if (value >= count)
        value += static_cast<std::uint32_t>(origins.size());
    }
}

} // namespace quadrille_examples

#endif
