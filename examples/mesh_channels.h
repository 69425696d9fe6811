#ifndef QUADRILLE_EXAMPLES_MESH_CHANNELS_H
#define QUADRILLE_EXAMPLES_MESH_CHANNELS_H

#include "face_labels.h"
#include "mesh_io/face_parts.h"
#include "mesh_io/indexed_mesh.h"
#include "mesh_io/named_numbers.h"
#include "vertex_values.h"

#include <quadrille/channels.h>
#include <quadrille/labels.h>
#include <quadrille/parameters.h>
#include <quadrille/report.h>

#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// How much attributes count, and what becomes of the seams of textures, as
/// quadrille::ChannelOptions has it.
struct ChannelChoices {
  double of_colors = 1, of_textures = 1, of_normals = 1, of_numbers = 1;
  std::optional<quadrille::Seams> texture_seams = {};
};

/// Has a mesh what MeshChannels takes along and MeshAttributes does not?
inline bool needs_channels(const IndexedMesh& mesh) {
  const auto differ = [](const NamedNumbers& numbers) { return numbers.differ(); };
  return !mesh.corner_textures.empty() || !mesh.corner_normals.empty() || mesh.parts.differ() ||
         std::any_of(mesh.vertex_numbers.begin(), mesh.vertex_numbers.end(), differ) ||
         std::any_of(mesh.face_numbers.begin(), mesh.face_numbers.end(), differ);
}

/// What the vertices, the corners and the faces of a mesh have, on its way through `simplify`. One
/// type of call serves all meshes: a channel without values is none, and so are labels that are all
/// the same.
class MeshChannels {
public:
  explicit MeshChannels(IndexedMesh& mesh)
      : mesh_(mesh), colors_(std::move(mesh.colors), mesh),
        textures_(std::move(mesh.texture_coordinates), mesh), numbers_(mesh),
        labels_(FaceRegions(mesh).labels()) {}

  /// Calls simplify(argument...) with arguments for `quadrille::simplify`, and gives the mesh what
  /// that leaves of them.
  template <class Simplify>
  quadrille::Report take_through(Simplify simplify, const ChannelChoices& choices) {
    const quadrille::Report report =
        call(simplify, choices, std::make_index_sequence<VertexNumbers::most_channels>());
    mesh_.colors = colors_.of_points(mesh_);
    mesh_.texture_coordinates = textures_.of_points(mesh_);
    numbers_.restore(mesh_);
    take_faces(mesh_, labels_);
    return report;
  }

private:
  template <class Simplify, std::size_t... I>
  quadrille::Report call(Simplify simplify, const ChannelChoices& choices,
                         std::index_sequence<I...>) {
    auto& textures = textures_.empty() ? mesh_.corner_textures : textures_.corners;
    auto& normals = mesh_.corner_normals;
    auto& colors = colors_.corners;
    return simplify(
        quadrille::Texture(textures.values, textures.triples,
                           {.importance = choices.of_textures, .seams = choices.texture_seams}),
        quadrille::Normals(normals.values, normals.triples, {.importance = choices.of_normals}),
        quadrille::Colors(colors.values, colors.triples, {.importance = choices.of_colors}),
        quadrille::Attributes(numbers_.channel(I).values, numbers_.channel(I).triples,
                              {.importance = choices.of_numbers})...,
        quadrille::Labels{CGAL::make_property_map(labels_)},
        quadrille::parameters::vertex_image_map(CGAL::make_property_map(numbers_.images())));
  }

  IndexedMesh& mesh_;
  VertexValues<4> colors_;
  VertexValues<2> textures_;
  VertexNumbers numbers_;
  std::vector<FaceLabel> labels_;
};

} // namespace quadrille_examples

#endif
