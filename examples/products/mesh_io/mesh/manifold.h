#ifndef QUADRILLE_EXAMPLES_MESH_IO_MANIFOLD_H
#define QUADRILLE_EXAMPLES_MESH_IO_MANIFOLD_H

#include "follow_triangles.h"
#include "indexed_mesh.h"

#include <quadrille/manifold.h>

#include <array>
#include <cstddef>
#include <stdexcept>

namespace quadrille_examples {

/// Cuts a mesh into manifold sheets, with what points and triangles have. In the middle of an edge
/// lies what its first end has. Throws std::runtime_error where values of points have seams.
inline quadrille::ManifoldChanges make_manifold(IndexedMesh& mesh) {
  if (!mesh.value_triangles.empty())
    throw std::runtime_error("--manifold does not know colours or textures with seams");
  quadrille::ManifoldChanges changes = quadrille::make_manifold(mesh.points, mesh.triangles);
  for (const auto& origin : changes.origins) {
    const std::size_t point = origin[0];
    if (!mesh.colors.empty())
      mesh.colors.push_back(Color(mesh.colors[point]));
    if (!mesh.texture_coordinates.empty())
      mesh.texture_coordinates.push_back(std::array(mesh.texture_coordinates[point]));
    for (NamedNumbers& numbers : mesh.vertex_numbers)
      numbers.values.push_back(double{numbers.values[point]});
  }
  follow_triangles(mesh.corner_textures.triples, changes.triangles);
  follow_triangles(mesh.corner_normals.triples, changes.triangles);
  follow_triangles(mesh.parts.of_faces, changes.triangles);
  for (NamedNumbers& numbers : mesh.face_numbers)
    follow_triangles(numbers.values, changes.triangles);
  return changes;
}

} // namespace quadrille_examples

#endif
