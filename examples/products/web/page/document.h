#ifndef QUADRILLE_EXAMPLES_WEB_PAGE_DOCUMENT_H
#define QUADRILLE_EXAMPLES_WEB_PAGE_DOCUMENT_H

#include "../../mesh_io/attributes/mesh_channels.h"
#include "../../mesh_io/gltf.h"
#include "../../mesh_io/gltf/mesh_document.h"
#include "../../mesh_io/gltf/scene_mesh.h"
#include "../../page/gltf_scene.h"
#include "../../page/shown_mesh.h"

#include <quadrille/compiled.h>
#include <quadrille/report.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// A glTF document that a page has been given. It is read anew for each use.
class PageDocument {
public:
  explicit PageDocument(Source source) : source_(std::move(source)) {}

  /// The scene as the viewer shows it.
  ShownMesh shown() const { return GltfScene::read(source_); }
  /// The geometry of the scene, as other formats have it.
  IndexedMesh mesh() const { return GltfSceneMesh::read(source_); }

  /// The document with simplified meshes and all else that it has, as a file of an extension. The
  /// number of faces in the options is one of `shown_faces`: what several nodes show is shown as
  /// often, and is in the document once.
  std::string simplified(quadrille::SoupOptions options, const ChannelChoices& channels,
                         std::size_t shown_faces, const std::string& extension,
                         quadrille::Report& report) const {
    GltfMeshes meshes = GltfMeshes::read_shared(source_);
    GltfSceneSurface scene(meshes.surfaces(), meshes.placements());
    options.coordinates_are_floats = scene.is_of_floats();
    options.faces = part(*options.faces, scene.triangles().size(), shown_faces);
    report = scene.simplify(options, channels);
    if (options.relative_error)
      for (GltfSurface& surface : meshes.surfaces())
        surface.write_positions_as_floats();
    return encode_document(meshes.take(), extension);
  }

private:
  static std::size_t part(std::size_t faces, std::size_t all, std::size_t shown) {
    return static_cast<std::size_t>(std::llround(
        static_cast<double>(faces) * static_cast<double>(all) / static_cast<double>(shown)));
  }

  Source source_;
};

/// A mesh of another format as a document.
inline std::string encoded_document(const std::string& name, const IndexedMesh& mesh,
                                    const std::string& extension) {
  std::vector<std::string> remarks; // the files beside it are not here
  return encode_document(GltfMeshDocument::of(mesh, name, true, remarks), extension);
}

} // namespace quadrille_examples

#endif
