#ifndef QUADRILLE_EXAMPLES_GLTF_LEVELS_H
#define QUADRILLE_EXAMPLES_GLTF_LEVELS_H

#include "../text.h"
#include "extensions.h"
#include "json.h"
#include "surface.h"
#include "twins.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// Adds coarser meshes to a document, and nodes that show them, by the extension MSFT_lod: such a
/// node takes the place of the one that names it, so it has the same transform and is below the
/// same parent, though it is no child of it.
///
/// A coarser node is a leaf. So where a node has more than its mesh (children, a camera, other
/// extensions) or is moved (by an animation, or as a joint), its mesh goes to a new child, which
/// stays with it: that one has the levels.
///
/// Source: https://github.com/KhronosGroup/glTF/tree/main/extensions/2.0/Vendor/MSFT_lod
class GltfLevels {
public:
  /// Throws for nodes that have levels already: where these were to go is not told.
  static void require_none(const Json& document) {
    for_each_element(document, "nodes", [](const Json& node) {
      if (extension_of(node, extension))
        throw std::runtime_error("its nodes already have levels of detail (MSFT_lod)");
    });
  }

  /// Throws if no node shows one of the surfaces, or a twin of one.
  static void require_shown(const Json& document, const std::vector<GltfSurface>& surfaces,
                            const GltfTwins::Firsts& firsts) {
    if (std::none_of(surfaces.begin(), surfaces.end(), [&](const GltfSurface& surface) {
          return !shown_of(document, surface.mesh(), firsts).empty();
        }))
      throw std::runtime_error(
          "it has no node with a triangle mesh, so there is nothing to make levels of");
  }

  /// Surfaces that have got meshes of their own, and the meshes that share what these have.
  struct Added {
    std::vector<GltfSurface> surfaces;
    GltfTwins::Firsts firsts;
  };

  /// Each of the levels, the finest first, has the surfaces in the order of `input`, of which the
  /// meshes have such twins. Other surfaces than those that are returned are no coarser than the
  /// level before, or no node shows them.
  static Added add(Json& document, const std::vector<GltfSurface>& input,
                   const GltfTwins::Firsts& firsts, std::vector<std::vector<GltfSurface>> levels) {
    GltfLevels adding(document);
    std::vector<GltfSurface> added;
    for (const GltfSurface& surface : input) {
      const auto i = static_cast<std::size_t>(&surface - input.data());
      const std::vector<std::size_t> shown = shown_of(document, surface.mesh(), firsts);
      for (std::vector<GltfSurface>& level : levels)
        if (!shown.empty() && adding.add_meshes(shown, surface, level[i]))
          added.push_back(std::move(level[i]));
    }
    adding.add_nodes();
    return {std::move(added), std::move(adding.firsts_)};
  }

private:
  static constexpr const char* extension = "MSFT_lod";
  static constexpr const char* instancing = "EXT_mesh_gpu_instancing"; // is of the mesh

  /// A coarser mesh.
  struct CoarseMesh {
    std::size_t mesh, faces;
    double part; ///< of the faces of the input
  };

  explicit GltfLevels(Json& document) : document_(document) {
    for_each_element(document, "skins", [&](const Json& skin) {
      if (const Json* const joints = member(skin, "joints"))
        for (const Json& joint : *joints)
          moved_nodes_.insert(joint.get<std::size_t>());
    });
    for_each_target([&](Json& target) {
      if (const auto [node, path] = animated(target); path != "weights")
        moved_nodes_.insert(node);
    });
  }

  /// Which of a mesh and its twins nodes show, in the order of their numbers.
  static std::vector<std::size_t> shown_of(const Json& document, std::size_t mesh,
                                           const GltfTwins::Firsts& firsts) {
    std::set<std::size_t> meshes;
    for_each_element(document, "nodes", [&](const Json& node) {
      if (!member(node, "mesh"))
        return;
      const std::size_t shown = count_of(node, "mesh");
      const auto first = firsts.find(shown);
      if (mesh == (first == firsts.end() ? shown : first->second))
        meshes.insert(shown);
    });
    return {meshes.begin(), meshes.end()};
  }

  std::size_t append(const char* array, Json element) {
    document_[array].push_back(std::move(element));
    return document_[array].size() - 1;
  }

  static void rename(Json& object, std::size_t level) {
    if (const std::string name = text_of(object, "name"); !name.empty())
      object["name"] = name + "_LOD" + std::to_string(level);
  }

  /// One for each of the meshes, which are twins; the surface belongs to the first. False if it is
  /// no coarser than the one before.
  bool add_meshes(const std::vector<std::size_t>& twins, const GltfSurface& input,
                  GltfSurface& surface) {
    const std::vector<CoarseMesh>& before = coarse_meshes_[twins.front()];
    const std::size_t faces = surface.triangles.size();
    const std::size_t faces_of_input = input.triangles.size();
    if (faces >= (before.empty() ? faces_of_input : before.back().faces))
      return false;
    for (const std::size_t twin : twins) {
      std::vector<CoarseMesh>& coarse = coarse_meshes_[twin];
      Json copy = element_of(document_, "meshes", twin);
      rename(copy, coarse.size() + 1);
      const std::size_t mesh = append("meshes", std::move(copy));
      if (twin == twins.front())
        surface.belong_to(mesh);
      else
        firsts_.emplace(mesh, surface.mesh());
      coarse.push_back(
          {mesh, faces, static_cast<double>(faces) / static_cast<double>(faces_of_input)});
    }
    return true;
  }

  // --- Nodes -------------------------------------------------------------------------------------

  void add_nodes() {
    bool has_any = false;
    const std::size_t count = size_of(document_, "nodes");
    for (std::size_t node = 0; node < count; ++node) {
      const Json& json = element_of(document_, "nodes", node);
      if (!member(json, "mesh"))
        continue;
      const std::vector<CoarseMesh>& coarse = coarse_meshes_[count_of(json, "mesh")];
      if (coarse.empty())
        continue;
      add_levels(is_nothing_but_mesh(node) ? node : give_child(node), coarse);
      has_any = true;
    }
    if (has_any)
      list_extension(document_, "extensionsUsed", extension);
  }

  bool is_nothing_but_mesh(std::size_t node) const {
    const Json& json = element_of(document_, "nodes", node);
    if (moved_nodes_.contains(node) || size_of(json, "children") > 0 || member(json, "camera"))
      return false;
    const Json* const extensions = member(json, "extensions");
    return !extensions || extensions->empty() ||
           (extensions->size() == 1 && member(*extensions, instancing));
  }

  /// Gives a node a child at its place, which has its mesh. Returns the child.
  std::size_t give_child(std::size_t parent) {
    Json& json = document_["nodes"][parent];
    Json child = Json::object();
    if (member(json, "name"))
      child["name"] = json["name"];
    for (const char* const key : {"mesh", "skin", "weights"})
      move_member(json, child, key);
    if (extension_of(json, instancing)) {
      move_member(json["extensions"], child["extensions"], instancing);
      if (json["extensions"].empty())
        json.erase("extensions");
    }
    const std::size_t number = append("nodes", std::move(child));
    document_["nodes"][parent]["children"].push_back(number);
    for_each_target([&](Json& target) {
      if (animated(target) == std::pair(parent, std::string("weights")))
        animate(target, parent, number);
    });
    return number;
  }
  static void move_member(Json& from, Json& to, const char* key) {
    if (!member(from, key))
      return;
    to[key] = std::move(from[key]);
    from.erase(key);
  }

  void add_levels(std::size_t node, const std::vector<CoarseMesh>& coarse) {
    Json ids = Json::array(), coverage = Json::array();
    for (const CoarseMesh& mesh : coarse) {
      ids.push_back(append(
          "nodes", level_of(element_of(document_, "nodes", node), mesh.mesh, ids.size() + 1)));
      coverage.push_back(mesh.part);
      copy_animations(node, ids.back().get<std::size_t>());
    }
    coverage.push_back(0); // the coarsest is shown however small it is
    Json& json = document_["nodes"][node];
    json["extensions"][extension]["ids"] = std::move(ids);
    if (!member(json, "extras") || json["extras"].is_object())
      json["extras"]["MSFT_screencoverage"] = std::move(coverage);
  }

  /// A node that takes the place of another one.
  static Json level_of(const Json& node, std::size_t mesh, std::size_t level) {
    Json result = Json::object();
    for (const char* const key :
         {"name", "matrix", "translation", "rotation", "scale", "skin", "weights"})
      if (const Json* const value = member(node, key))
        result[key] = *value;
    if (const Json* const instances = extension_of(node, instancing))
      result["extensions"][instancing] = *instances;
    result["mesh"] = mesh;
    rename(result, level);
    return result;
  }

  // --- Animations --------------------------------------------------------------------------------

  template <class Visit>
  void for_each_target(Visit visit) {
    for (std::size_t a = 0; a < size_of(document_, "animations"); ++a)
      for (std::size_t c = 0; c < size_of(element_of(document_, "animations", a), "channels"); ++c)
        if (Json& channel = document_["animations"][a]["channels"][c]; member(channel, "target"))
          visit(channel["target"]);
  }

  /// The node that a target of an animation names, and what of it: a path, or the first word of a
  /// pointer behind "/nodes/N/" (KHR_animation_pointer).
  static std::pair<std::size_t, std::string> animated(const Json& target) {
    constexpr auto none = static_cast<std::size_t>(-1);
    if (member(target, "node"))
      return {count_of(target, "node"), text_of(target, "path")};
    const std::string pointer = pointer_of(target);
    if (!pointer.starts_with(nodes))
      return {none, ""};
    const std::size_t slash = pointer.find('/', nodes.size());
    const std::optional<std::int64_t> node =
        parse_integer(std::string_view(pointer).substr(nodes.size(), slash - nodes.size()));
    if (!node || slash == std::string::npos)
      return {none, ""};
    const std::size_t end = pointer.find('/', slash + 1);
    return {static_cast<std::size_t>(*node), pointer.substr(slash + 1, end - slash - 1)};
  }

  static std::string pointer_of(const Json& target) {
    const Json* const by_pointer = extension_of(target, "KHR_animation_pointer");
    return by_pointer ? text_of(*by_pointer, "pointer") : std::string();
  }

  /// Turns a target of one node into the same of another.
  static void animate(Json& target, std::size_t old, std::size_t node) {
    if (member(target, "node")) {
      target["node"] = node;
      return;
    }
    const std::string rest = pointer_of(target).substr(nodes.size() + std::to_string(old).size());
    target["extensions"]["KHR_animation_pointer"]["pointer"] =
        std::string(nodes) + std::to_string(node) + rest;
  }

  /// What moves the vertices of a node moves those of another one as well.
  void copy_animations(std::size_t node, std::size_t copy) {
    for (std::size_t a = 0; a < size_of(document_, "animations"); ++a) {
      Json& channels = document_["animations"][a]["channels"];
      const std::size_t count = channels.size();
      for (std::size_t c = 0; c < count; ++c)
        if (member(channels[c], "target") &&
            animated(channels[c]["target"]) == std::pair(node, std::string("weights"))) {
          Json channel = channels[c];
          animate(channel["target"], node, copy);
          channels.push_back(std::move(channel));
        }
    }
  }

  static constexpr std::string_view nodes = "/nodes/";

  Json& document_;
  std::set<std::size_t> moved_nodes_;
  std::map<std::size_t, std::vector<CoarseMesh>> coarse_meshes_; // of the meshes of the input
  GltfTwins::Firsts firsts_;                                     // among coarser meshes
};

} // namespace quadrille_examples

#endif
