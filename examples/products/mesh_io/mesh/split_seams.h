#ifndef QUADRILLE_EXAMPLES_MESH_IO_SPLIT_SEAMS_H
#define QUADRILLE_EXAMPLES_MESH_IO_SPLIT_SEAMS_H

#include "indexed_mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// The mesh with a vertex for each side of a seam of IndexedMesh::value_triangles.
inline IndexedMesh with_vertices_of_values(IndexedMesh mesh) {
  if (mesh.value_triangles.empty())
    return mesh;
  mesh.points = points_of_values(mesh);
  mesh.triangles = std::move(mesh.value_triangles);
  mesh.value_triangles.clear();
  return mesh;
}

/// Gives a mesh with values at its corners one for each vertex, as many formats have them: a vertex
/// at which they differ becomes several.
template <std::size_t N>
class SeamSplitter {
public:
  using Value = std::array<double, N>;

  struct Split {
    IndexedMesh mesh;          ///< of more vertices, with nothing else changed
    std::vector<Value> values; ///< of the vertices; zeros where no corner has one
  };

  /// Faces of which the part does not have what `has_values` says go with any vertex.
  static Split split(const IndexedMesh& mesh, const CornerValues<N>& corners,
                     bool FacePart::*has_values) {
    SeamSplitter splitter(mesh);
    for (std::size_t face = 0; face < mesh.triangles.size(); ++face)
      if (mesh.parts.of(face).*has_values)
        for (std::size_t i = 0; i < 3; ++i) {
          std::uint32_t& corner = splitter.mesh_.triangles[face][i];
          corner = splitter.vertex_with(corner, corners.values[corners.triples[face][i]]);
        }
    return {std::move(splitter.mesh_), std::move(splitter.values_)};
  }

private:
  explicit SeamSplitter(const IndexedMesh& mesh)
      : mesh_(mesh), values_(mesh.points.size()), is_set_(mesh.points.size()) {}

  std::uint32_t vertex_with(std::uint32_t v, const Value& value) {
    if (!is_set_[v]) {
      values_[v] = value;
      is_set_[v] = true;
    }
    if (values_[v] == value)
      return v;
    const auto next = static_cast<std::uint32_t>(mesh_.points.size());
    const auto [place, is_new] = further_.try_emplace({v, value}, next);
    if (is_new)
      copy(v, value);
    return place->second;
  }

  void copy(std::uint32_t v, const Value& value) {
    const auto append_copy = [v](auto& values) {
      if (!values.empty())
        values.push_back(values[v]);
    };
    append_copy(mesh_.points);
    append_copy(mesh_.colors);
    append_copy(mesh_.texture_coordinates);
    for (NamedNumbers& numbers : mesh_.vertex_numbers)
      append_copy(numbers.values);
    values_.push_back(value);
  }

  IndexedMesh mesh_;
  std::vector<Value> values_;
  std::vector<bool> is_set_;                                         // has the vertex a value?
  std::map<std::pair<std::uint32_t, Value>, std::uint32_t> further_; // vertices, where they went
};

/// The mesh with texture coordinates of its vertices instead of its corners.
inline IndexedMesh with_vertex_textures(const IndexedMesh& mesh) {
  auto split = SeamSplitter<2>::split(mesh, mesh.corner_textures, &FacePart::has_textures);
  split.mesh.texture_coordinates = std::move(split.values);
  split.mesh.corner_textures = {};
  return std::move(split.mesh);
}

} // namespace quadrille_examples

#endif
