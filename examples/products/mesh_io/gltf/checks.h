#ifndef QUADRILLE_EXAMPLES_GLTF_CHECKS_H
#define QUADRILLE_EXAMPLES_GLTF_CHECKS_H

#include "../text.h"
#include "document.h"
#include "images.h"
#include "json.h"
#include "primitive.h"
#include "surface.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille_examples {

/// What is wrong with a document and goes through as it is, or cannot be known.
class GltfChecks {
public:
  /// A remark for each kind; `path` is the file of the document.
  static std::vector<std::string> remarks(const GltfDocument& document,
                                          const std::vector<GltfSurface>& surfaces,
                                          const std::filesystem::path& path) {
    GltfChecks checks;
    checks.look_at_extensions(document.json);
    checks.look_at_images(document.json, path);
    checks.look_at_joints(document.json, surfaces);
    return std::move(checks.remarks_);
  }

private:
  /// Does an extension say nothing that a simplification could break, or is it done justice to?
  static bool is_known(std::string_view name) {
    constexpr std::array<std::string_view, 7> looks{
        "KHR_materials_", "EXT_materials_", "KHR_texture_", "EXT_texture_",
        "KHR_lights_",    "EXT_lights_",    "KHR_xmp"};
    constexpr std::array<std::string_view, 13> known{"KHR_mesh_quantization",
                                                     "KHR_draco_mesh_compression",
                                                     "EXT_meshopt_compression",
                                                     "KHR_meshopt_compression",
                                                     "KHR_animation_pointer",
                                                     "KHR_node_visibility",
                                                     "EXT_mesh_gpu_instancing",
                                                     "EXT_mesh_features",
                                                     "EXT_instance_features",
                                                     "EXT_structural_metadata",
                                                     "MSFT_lod",
                                                     "MSFT_texture_dds",
                                                     "CESIUM_RTC"};
    return std::find(known.begin(), known.end(), name) != known.end() ||
           std::any_of(looks.begin(), looks.end(),
                       [&](std::string_view prefix) { return name.starts_with(prefix); });
  }

  void look_at_extensions(const Json& json) {
    const Json* const required = member(json, "extensionsRequired");
    for (const Json& name : required && required->is_array() ? *required : Json::array())
      if (name.is_string() && !is_known(name.get<std::string>()))
        remarks_.push_back(
            "IN requires the extension " + in_quotes(name.get<std::string>(), 60) +
            ", which Quadrille does not know: its data are passed through unchanged");
  }

  void look_at_images(const Json& json, const std::filesystem::path& path) {
    for_each_element(json, "images", [&](const Json& image) {
      if (GltfImageFiles::is_file(image) && !exists(text_of(image, "uri"), path))
        remarks_.push_back("the image " + in_quotes(text_of(image, "uri"), 100) + " is not there");
    });
  }
  static bool exists(const std::string& uri, const std::filesystem::path& path) {
    try {
      return std::filesystem::exists(path.parent_path() / decoded_uri(uri));
    } catch (const std::exception&) { // it names no file
      return false;
    }
  }

  /// Of each mesh, the least number of joints of the skins with which nodes show it.
  void look_at_joints(const Json& json, const std::vector<GltfSurface>& surfaces) {
    std::map<std::size_t, std::size_t> counts;
    for_each_element(json, "nodes", [&](const Json& node) {
      if (!member(node, "mesh") || !member(node, "skin"))
        return;
      const std::size_t count =
          size_of(element_of(json, "skins", count_of(node, "skin")), "joints");
      const auto [place, is_new] = counts.try_emplace(count_of(node, "mesh"), count);
      place->second = std::min(place->second, count);
    });
    for (const GltfSurface& surface : surfaces)
      if (const auto found = counts.find(surface.mesh()); found != counts.end())
        for (const GltfPrimitive& primitive : surface.primitives())
          look_at_joints(primitive, found->second);
  }

  void look_at_joints(const GltfPrimitive& primitive, std::size_t count) {
    std::set<std::size_t> beyond;
    for (const GltfAttribute& attribute : primitive.attributes)
      if (attribute.name.starts_with("JOINTS_"))
        for (std::size_t v = 0; v < attribute.elements.size(); ++v)
          for (const double joint : attribute.elements[v])
            if (joint >= static_cast<double>(count))
              beyond.insert(static_cast<std::size_t>(joint));
    if (!beyond.empty())
      remarks_.push_back("vertices of mesh " + std::to_string(primitive.mesh) + " refer to joint " +
                         std::to_string(*beyond.begin()) + ", but their skin has " +
                         std::to_string(count) + " joints");
  }

  std::vector<std::string> remarks_;
};

} // namespace quadrille_examples

#endif
