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

/// Gives a mesh with texture coordinates at its corners one for each vertex, as most formats have
/// them: a vertex on a seam becomes one for each side.
class SeamSplitter {
public:
  static IndexedMesh split(const IndexedMesh& mesh) {
    SeamSplitter splitter(mesh);
    for (std::size_t face = 0; face < mesh.triangles.size(); ++face)
      if (mesh.parts.of(face).has_textures) // others go with any side
        splitter.split_face(face);
    splitter.result_.corner_textures = {};
    return std::move(splitter.result_);
  }

private:
  using Texture = std::array<double, 2>;

  explicit SeamSplitter(const IndexedMesh& mesh) : result_(mesh), is_set_(mesh.points.size()) {
    result_.texture_coordinates.assign(mesh.points.size(), Texture{});
  }

  void split_face(std::size_t face) {
    const auto& [values, triples] = result_.corner_textures;
    for (std::size_t i = 0; i < 3; ++i) {
      std::uint32_t& corner = result_.triangles[face][i];
      corner = vertex_with(corner, values[triples[face][i]]);
    }
  }

  std::uint32_t vertex_with(std::uint32_t v, const Texture& texture) {
    if (!is_set_[v]) {
      result_.texture_coordinates[v] = texture;
      is_set_[v] = true;
    }
    if (result_.texture_coordinates[v] == texture)
      return v;
    const auto next = static_cast<std::uint32_t>(result_.points.size());
    const auto [place, is_new] = further_.try_emplace({v, texture}, next);
    if (is_new)
      copy(v, texture);
    return place->second;
  }

  void copy(std::uint32_t v, const Texture& texture) {
    result_.points.push_back(result_.points[v]);
    result_.texture_coordinates.push_back(texture);
    if (!result_.colors.empty())
      result_.colors.push_back(result_.colors[v]);
  }

  IndexedMesh result_;
  std::vector<bool> is_set_; // has the vertex a texture coordinate?
  std::map<std::pair<std::uint32_t, Texture>, std::uint32_t> further_; // vertices, where they went
};

} // namespace quadrille_examples

#endif
