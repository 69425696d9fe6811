#ifndef QUADRILLE_EXAMPLES_PAGE_GLTF_SCENE_H
#define QUADRILLE_EXAMPLES_PAGE_GLTF_SCENE_H

#include "../mesh_io/gltf.h"
#include "materials.h"
#include "shown_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// The scene of a document as one mesh: of each node that shows a mesh, its triangles where it puts
/// them, in the pose in which they are stored. It has the base colours and images of materials,
/// and the first set of texture coordinates and of colours.
class GltfScene {
public:
  static ShownMesh read(const std::filesystem::path& path) { return read(read_source(path)); }
  /// The same of a file that is in memory.
  static ShownMesh read(const Source& source) {
    GltfMeshes meshes = GltfMeshes::read(source);
    return with_errors_of(source.path, [&] {
      GltfScene scene(meshes, source.path);
      scene.add_scene();
      return std::move(scene.shown_);
    });
  }

private:
  GltfScene(GltfMeshes& meshes, const std::filesystem::path& path)
      : meshes_(meshes), json_(meshes.document().json), path_(path), images_(shown_.looks) {
    shown_.has_linear_colors = true;
    shown_.looks.materials.clear();
    shown_.mesh.color_type = {.full = 1, .is_whole = false, .is_single = true};
    for (const GltfSurface& surface : meshes.surfaces())
      for (const GltfPrimitive& primitive : surface.primitives())
        for (const GltfAttribute& attribute : primitive.attributes) {
          has_colors_ |= attribute.name == "COLOR_0";
          has_textures_ |= attribute.name == "TEXCOORD_0";
        }
  }

  void add_scene() {
    if (size_of(json_, "scenes") > 0)
      visit_nodes(element_of(json_, "scenes", count_of(json_, "scene", 0)), "nodes", Transform(),
                  0);
    else
      for (const GltfSurface& surface : meshes_.surfaces())
        add(surface, Transform());
    if (shown_.looks.materials.empty())
      shown_.looks.materials.emplace_back();
  }

  void visit_nodes(const Json& parent, const char* key, const Transform& map, int depth) {
    if (depth > 200)
      throw std::runtime_error("its nodes are nested too deeply");
    for (std::size_t i = 0; i < size_of(parent, key); ++i) {
      const Json& number = parent.at(key).at(i);
      if (!number.is_number_unsigned())
        throw std::runtime_error("a node is referred to by something other than a number");
      const Json& node = element_of(json_, "nodes", number.get<std::size_t>());
      const Transform of_node = map * transform_of_node(node);
      if (member(node, "mesh"))
        add_mesh(count_of(node, "mesh"), member(node, "skin") ? Transform() : of_node);
      visit_nodes(node, "children", of_node, depth + 1);
    }
  }

  void add_mesh(std::size_t mesh, const Transform& map) {
    for (const GltfSurface& surface : meshes_.surfaces())
      if (surface.mesh() == mesh)
        add(surface, map);
  }

  void add(const GltfSurface& surface, const Transform& map) {
    IndexedMesh& mesh = shown_.mesh;
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (const auto& [x, y, z] : surface.points) {
      const auto [u, v, w] = map({double{x}, double{y}, double{z}});
      mesh.points.emplace_back(u, v, w);
    }
    if (has_colors_)
      mesh.colors.resize(mesh.points.size(), Color{1, 1, 1, 1});
    for (std::size_t face = 0; face < surface.triangles.size(); ++face) {
      auto triangle = surface.triangles[face];
      for (std::uint32_t& v : triangle)
        v += first;
      mesh.triangles.push_back(triangle);
      add_corners(surface, face);
      add_material(surface.primitives()[surface.primitive_of(face)]);
    }
  }

  /// What the last triangle has at its corners.
  void add_corners(const GltfSurface& surface, std::size_t face) {
    const GltfPrimitive& primitive = surface.primitives()[surface.primitive_of(face)];
    std::array<std::uint32_t, 3> textures{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::vector<Element> values = surface.corner(face, i);
      std::array<double, 2> texture{};
      for (std::size_t a = 0; a < values.size(); ++a) {
        const GltfAttribute& attribute = primitive.attributes[a];
        if (attribute.target)
          continue;
        if (attribute.name == "COLOR_0")
          shown_.mesh.colors[shown_.mesh.triangles.back()[i]] = {values[a][0], values[a][1],
                                                                 values[a][2], 1};
        if (attribute.name == "TEXCOORD_0")
          texture = {values[a][0], 1 - values[a][1]}; // an IndexedMesh has it as OBJ
      }
      textures[i] = number_of(texture);
    }
    if (has_textures_)
      shown_.mesh.corner_textures.triples.push_back(textures);
  }

  std::uint32_t number_of(const std::array<double, 2>& texture) {
    auto& values = shown_.mesh.corner_textures.values;
    const auto [place, is_new] =
        textures_.try_emplace(texture, static_cast<std::uint32_t>(values.size()));
    if (is_new)
      values.push_back(texture);
    return place->second;
  }

  /// The last triangle has the material of its primitive; one without has the first of all numbers.
  void add_material(const GltfPrimitive& primitive) {
    const Json& json =
        element_of(element_of(json_, "meshes", primitive.mesh), "primitives", primitive.number);
    const std::size_t material = member(json, "material") ? count_of(json, "material") + 1 : 0;
    const auto [place, is_new] =
        materials_.try_emplace(material, static_cast<std::uint32_t>(shown_.looks.materials.size()));
    FaceParts& parts = shown_.mesh.parts;
    if (is_new) {
      shown_.looks.materials.push_back(material == 0 ? PageMaterial{}
                                                     : read_material(material - 1));
      parts.names.push_back(std::to_string(material));
      parts.parts.push_back({.material = static_cast<std::uint32_t>(parts.names.size() - 1),
                             .has_textures = has_textures_});
    }
    shown_.looks.of_faces.push_back(place->second);
    parts.of_faces.push_back(place->second);
  }

  PageMaterial read_material(std::size_t number) {
    PageMaterial material;
    const Json& json = element_of(json_, "materials", number);
    if (text_of(json, "alphaMode") == "MASK")
      material.cutoff = json.value("alphaCutoff", 0.5);
    const Json* const surface = member(json, "pbrMetallicRoughness");
    if (!surface)
      return material;
    const auto color = numbers_of<4>(*surface, "baseColorFactor", {1, 1, 1, 1});
    for (std::size_t i = 0; i < 3; ++i)
      material.color[i] = std::clamp(color[i], 0., 1.);
    const Json* const texture = member(*surface, "baseColorTexture");
    if (texture && has_textures_)
      material.image = read_texture(*texture);
    return material;
  }

  std::optional<std::size_t> read_texture(const Json& use) {
    const std::size_t number = count_of(use, "index");
    const std::string name = "of texture " + std::to_string(number);
    if (count_of(use, "texCoord", 0) != 0) {
      shown_.looks.notes.push_back("The image " + name +
                                   " is not shown: it does not use the first " +
                                   "texture coordinates");
      return std::nullopt;
    }
    return images_.add(name, [&] {
      const Json& texture = element_of(json_, "textures", number);
      const Json& image = element_of(json_, "images", count_of(texture, "source"));
      if (member(image, "bufferView"))
        return std::string(bytes_of_view(meshes_.document(), count_of(image, "bufferView")));
      return bytes_of_uri(text_of(image, "uri"), path_);
    });
  }

  GltfMeshes& meshes_;
  const Json& json_;
  std::filesystem::path path_;
  ShownMesh shown_;
  PageImages images_;
  bool has_colors_ = false, has_textures_ = false;
  std::map<std::array<double, 2>, std::uint32_t> textures_;
  std::map<std::size_t, std::uint32_t> materials_; // by number in the document, from 1
};

} // namespace quadrille_examples

#endif
