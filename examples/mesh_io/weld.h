#ifndef QUADRILLE_EXAMPLES_MESH_IO_WELD_H
#define QUADRILLE_EXAMPLES_MESH_IO_WELD_H

#include "indexed_mesh.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace quadrille_examples {

/// When vertices at exactly the same place become one.
enum class Weld {
  loose_faces, ///< only where no two faces share a vertex, so that there is no surface yet
  always
};

/// Removes the points that are not `kept`; no triangle uses them.
inline void keep_points(IndexedMesh& mesh, const std::vector<bool>& kept) {
  std::vector<std::uint32_t> new_index(kept.size());
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (!kept[i])
      continue;
    mesh.points[count] = mesh.points[i];
    if (!mesh.colors.empty())
      mesh.colors[count] = mesh.colors[i];
    if (!mesh.texture_coordinates.empty())
      mesh.texture_coordinates[count] = mesh.texture_coordinates[i];
    new_index[i] = count++;
  }
  mesh.points.resize(count);
  mesh.colors.resize(std::min<std::size_t>(mesh.colors.size(), count));
  mesh.texture_coordinates.resize(std::min<std::size_t>(mesh.texture_coordinates.size(), count));
  for (auto& triangle : mesh.triangles)
    for (std::uint32_t& corner : triangle)
      corner = new_index[corner];
}

/// Of the points at one place, the first stays, with its colour and texture coordinate. Returns how
/// many went. CGAL's `merge_duplicate_points_in_polygon_soup` knows of no attributes.
inline std::size_t weld_points(IndexedMesh& mesh) {
  std::vector<std::uint32_t> order(mesh.points.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return mesh.points[a] < mesh.points[b];
  });

  std::vector<std::uint32_t> first(mesh.points.size()); // of the points at the same place
  std::vector<bool> kept(mesh.points.size());
  std::size_t welded = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_first = i == 0 || mesh.points[order[i]] != mesh.points[order[i - 1]];
    first[order[i]] = is_first ? order[i] : first[order[i - 1]];
    kept[order[i]] = is_first;
    welded += !is_first;
  }
  for (auto& triangle : mesh.triangles)
    for (std::uint32_t& corner : triangle)
      corner = first[corner];
  keep_points(mesh, kept);
  return welded;
}

} // namespace quadrille_examples

#endif
