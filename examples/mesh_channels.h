#ifndef QUADRILLE_EXAMPLES_MESH_CHANNELS_H
#define QUADRILLE_EXAMPLES_MESH_CHANNELS_H

#include "mesh_io/colors.h"
#include "mesh_io/face_parts.h"
#include "mesh_io/indexed_mesh.h"

#include <quadrille/channels.h>
#include <quadrille/labels.h>
#include <quadrille/report.h>

#include <CGAL/property_map.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// How much attributes count, as quadrille::ChannelOptions has it.
struct ChannelImportance {
  double of_colors = 1, of_textures = 1, of_normals = 1;
};

/// Has a mesh what MeshChannels takes along and MeshAttributes does not?
inline bool needs_channels(const IndexedMesh& mesh) {
  return !mesh.corner_textures.empty() || !mesh.corner_normals.empty() || mesh.parts.differ();
}

/// The values at the corners of a mesh, its colours and the parts of its faces, on their way
/// through `simplify`. One type of call serves all meshes: a channel without values is none, and so
/// are labels that are all the same.
class MeshChannels {
public:
  explicit MeshChannels(IndexedMesh& mesh) : mesh_(mesh), labels_(mesh.parts.labels()) {
    if (mesh.colors.empty())
      return;
    colors_.values = std::move(mesh.colors);
    colors_.triples = mesh.triangles;
  }

  /// Calls simplify(argument...) with arguments for `quadrille::simplify`, and gives the mesh what
  /// that leaves of them.
  template <class Simplify>
  quadrille::Report take_through(Simplify simplify, const ChannelImportance& importance) {
    const quadrille::Report report = simplify(
        quadrille::Texture(mesh_.corner_textures.values, mesh_.corner_textures.triples,
                           {.importance = importance.of_textures}),
        quadrille::Normals(mesh_.corner_normals.values, mesh_.corner_normals.triples,
                           {.importance = importance.of_normals}),
        quadrille::Colors(colors_.values, colors_.triples, {.importance = importance.of_colors}),
        quadrille::Labels{CGAL::make_property_map(labels_)});
    restore_colors();
    mesh_.parts.take(labels_, mesh_.triangles.size());
    return report;
  }

private:
  void restore_colors() {
    if (colors_.empty())
      return;
    mesh_.colors.resize(mesh_.points.size());
    for (std::size_t face = 0; face < mesh_.triangles.size(); ++face)
      for (std::size_t i = 0; i < 3; ++i)
        mesh_.colors[mesh_.triangles[face][i]] = colors_.values[colors_.triples[face][i]];
  }

  IndexedMesh& mesh_;
  CornerValues<4> colors_;
  std::vector<PartLabel> labels_;
};

} // namespace quadrille_examples

#endif
