#ifndef QUADRILLE_EXAMPLES_GLTF_H
#define QUADRILLE_EXAMPLES_GLTF_H

/// \file
/// Reads glTF documents, hands out each of their meshes as a surface, and writes documents: .gltf
/// with its buffers in the text or in files, and .glb.
///
/// Each mesh is one surface. All of them go through `simplify` at once, as a scene, with their
/// attributes as channels and their primitives as labels. All else of a document is passed on.
/// Simplified copies may become levels of detail beside it.

#include "gltf/checks.h"
#include "gltf/document.h"
#include "gltf/images.h"
#include "gltf/json.h"
#include "gltf/levels.h"
#include "gltf/placement.h"
#include "gltf/primitive.h"
#include "gltf/rewrite.h"
#include "gltf/scene_surface.h"
#include "gltf/surface.h"
#include "gltf/twins.h"
#include "replace_file.h"
#include "text.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// Does something, and tells what is wrong of a file.
template <class Work>
auto with_errors_of(const std::filesystem::path& path, Work work) {
  try {
    return work();
  } catch (const Json::exception& error) {
    fail(path, error.what());
  } catch (const std::runtime_error& error) {
    fail(path, error.what());
  }
}

/// A document and the surfaces of its meshes, but of those that have no triangles.
class GltfMeshes {
public:
  /// `labels` are names of attributes of integers: regions of their values stay, as those of
  /// primitives do. Throws `std::runtime_error` with one line for a file that is missing, broken,
  /// or has what cannot be taken through a simplification, and for a name that no such attribute
  /// has.
  static GltfMeshes read(const std::filesystem::path& path,
                         const std::set<std::string>& labels = {}) {
    return read(read_source(path), labels);
  }
  /// The same of a file that is in memory.
  static GltfMeshes read(const Source& source, const std::set<std::string>& labels = {}) {
    return with_errors_of(source.path, [&] {
      return GltfMeshes(GltfReader(source).read(), source.path, labels, GltfTwins::Firsts());
    });
  }

  /// The same, but of meshes that share all that they have but their materials only the first is a
  /// surface, which is where all of them are; the others get what becomes of it.
  static GltfMeshes read_shared(const std::filesystem::path& path,
                                const std::set<std::string>& labels = {}) {
    return read_shared(read_source(path), labels);
  }
  static GltfMeshes read_shared(const Source& source, const std::set<std::string>& labels = {}) {
    return with_errors_of(source.path, [&] {
      GltfDocument document = GltfReader(source).read();
      GltfTwins::Firsts firsts = GltfTwins::of(document.json);
      return GltfMeshes(std::move(document), source.path, labels, std::move(firsts));
    });
  }

  std::vector<GltfSurface>& surfaces() { return surfaces_; }
  const GltfDocument& document() const { return document_; }
  /// How many bytes its buffers have.
  std::size_t size() const { return document_.size(); }
  /// Where all meshes of the document are, by their numbers.
  const std::vector<GltfPlacement>& placements() const { return placements_; }

  /// The images that the document names as files.
  std::vector<std::string> image_files() const {
    std::vector<std::string> files;
    for_each_element(document_.json, "images", [&](const Json& image) {
      if (GltfImageFiles::is_file(image))
        files.push_back(text_of(image, "uri"));
    });
    return files;
  }

  /// The document with the surfaces as they are now.
  GltfDocument take() {
    with_errors_of(path_, [&] { GltfRewriting::rewrite(document_, surfaces_, firsts_); });
    return std::move(document_);
  }

  /// Throws `std::runtime_error` for a document that cannot take levels of detail.
  void require_fit_for_levels() const {
    with_errors_of(path_, [&] {
      GltfLevels::require_none(document_.json);
      GltfLevels::require_shown(document_.json, surfaces_, firsts_);
    });
  }

  /// The document with its meshes as they were, and these as their levels of detail, the finest
  /// first: each has all surfaces.
  GltfDocument take_with(std::vector<std::vector<GltfSurface>> levels) {
    with_errors_of(path_, [&] {
      const GltfLevels::Added added =
          GltfLevels::add(document_.json, surfaces_, firsts_, std::move(levels));
      GltfRewriting::rewrite(document_, added.surfaces, added.firsts);
    });
    return std::move(document_);
  }

private:
  GltfMeshes(GltfDocument document, const std::filesystem::path& path,
             const std::set<std::string>& labels, GltfTwins::Firsts firsts)
      : document_(std::move(document)), path_(path), firsts_(std::move(firsts)) {
    require_sound_views();
    std::set<std::string> missing = labels;
    for (std::size_t i = 0; i < size_of(document_.json, "meshes"); ++i) {
      if (firsts_.contains(i))
        continue;
      std::vector<GltfPrimitive> primitives = read_primitives(i);
      for (GltfPrimitive& primitive : primitives)
        call_labels(primitive, labels, missing);
      if (!primitives.empty())
        surfaces_.emplace_back(std::move(primitives));
    }
    if (!missing.empty())
      throw std::runtime_error("there is no integer attribute named " +
                               in_quotes(*missing.begin()));
    placements_ = GltfPlacements::of(document_);
    for (const auto& [twin, first] : firsts_)
      GltfPlacements::add(placements_[twin], placements_[first]);
  }

  /// Those that are not within their buffers are not.
  void require_sound_views() const {
    for (std::size_t i = 0; i < size_of(document_.json, "bufferViews"); ++i)
      bytes_of_view(document_, i);
  }

  static void call_labels(GltfPrimitive& primitive, const std::set<std::string>& labels,
                          std::set<std::string>& missing) {
    for (GltfAttribute& attribute : primitive.attributes)
      if (attribute.kind == AttributeKind::name && labels.contains(attribute.name)) {
        attribute.is_label = true;
        missing.erase(attribute.name);
      }
  }

  std::vector<GltfPrimitive> read_primitives(std::size_t mesh) const {
    std::vector<GltfPrimitive> primitives;
    const Json& json = element_of(document_.json, "meshes", mesh);
    for (std::size_t i = 0; i < size_of(json, "primitives"); ++i)
      if (std::optional<GltfPrimitive> primitive = PrimitiveReader::read(document_, mesh, i))
        primitives.push_back(std::move(*primitive));
    return primitives;
  }

  GltfDocument document_;
  std::filesystem::path path_;
  GltfTwins::Firsts firsts_;
  std::vector<GltfSurface> surfaces_;
  std::vector<GltfPlacement> placements_;
};

/// What the document of one file will not have, or not find, when it is written to another.
inline std::vector<std::string> remarks_of(GltfMeshes& meshes, const std::filesystem::path& in,
                                           const std::filesystem::path& out, bool leaves_images) {
  std::vector<std::string> remarks;
  const auto remark = [&](const char* what, std::size_t count) {
    if (count > 0)
      remarks.push_back(what + (": " + std::to_string(count)));
  };
  std::size_t left_out = 0;
  for (const GltfSurface& surface : meshes.surfaces())
    left_out += surface.count_left_out();
  remark("triangles left out (two equal corners, or duplicates of another one)", left_out);
  for (const std::string& one : GltfChecks::remarks(meshes.document(), meshes.surfaces(), in))
    remarks.push_back(one);
  if (leaves_images && folder_of(in) != folder_of(out))
    remark("the images of IN are files, to which OUT refers by the same names, but from another "
           "folder",
           meshes.image_files().size());
  return remarks;
}

/// Writes a document of such an extension: all of it, or, throwing `std::runtime_error`, nothing.
inline void write_gltf(const std::filesystem::path& path, GltfDocument document,
                       const std::string& extension, bool is_forced = false) {
  with_errors_of(path, [&] {
    FileReplacement(path, is_forced).write(encode_document(std::move(document), extension));
  });
}

} // namespace quadrille_examples

#endif
