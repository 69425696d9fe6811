#ifndef QUADRILLE_EXAMPLES_GLTF_SCENE_MESH_H
#define QUADRILLE_EXAMPLES_GLTF_SCENE_MESH_H

#include "../gltf.h"
#include "../linear_light.h"
#include "../mesh/indexed_mesh.h"
#include "../mesh/weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// The geometry of the scene of a document as one mesh, as other formats have it: of each place at
/// which a mesh is shown, its triangles where they are there, with their normals, their first
/// texture coordinates and colours, and the names of their meshes and materials. A mesh of a skin
/// is in the pose in which it is stored.
class GltfSceneMesh {
public:
  /// Throws `std::runtime_error` as GltfMeshes::read() does.
  static IndexedMesh read(const std::filesystem::path& path) { return read(read_source(path)); }
  /// The same of a file that is in memory.
  static IndexedMesh read(const Source& source) {
    GltfMeshes meshes = GltfMeshes::read(source);
    return with_errors_of(source.path, [&] {
      GltfSceneMesh scene(meshes);
      for (const GltfSurface& surface : meshes.surfaces())
        for (const Transform& place : meshes.placements()[surface.mesh()].instances)
          scene.add(surface, place);
      scene.finish();
      return std::move(scene.mesh_);
    });
  }

private:
  explicit GltfSceneMesh(GltfMeshes& meshes) : json_(meshes.document().json) {
    mesh_.color_type = {.full = 1, .is_whole = false, .is_single = true, .has_alpha = false};
    for (const GltfSurface& surface : meshes.surfaces())
      for (const GltfPrimitive& primitive : surface.primitives())
        for (const GltfAttribute& attribute : primitive.attributes)
          see(attribute);
    for (const char* const what : {"skins", "animations", "cameras"})
      if (size_of(json_, what) > 0)
        mesh_.losses.add(what);
    if (size_of(json_, "materials") > 0)
      mesh_.losses.add("properties of materials");
    if (size_of(json_, "images") > 0)
      mesh_.losses.add("images");
  }

  void see(const GltfAttribute& attribute) {
    if (attribute.target)
      mesh_.losses.add("morph targets");
    else if (attribute.name == "COLOR_0")
      mesh_.color_type.has_alpha |= attribute.elements.type().components == 4;
    else if (attribute.kind != AttributeKind::skin && attribute.name != "POSITION" &&
             attribute.name != "NORMAL" && attribute.name != "TEXCOORD_0")
      mesh_.losses.add(attribute.name);
    has_colors_ |= attribute.name == "COLOR_0";
    has_textures_ |= attribute.name == "TEXCOORD_0";
    has_normals_ |= attribute.name == "NORMAL";
  }

  /// At one place; where that is a mirror, faces are turned.
  void add(const GltfSurface& surface, const Transform& place) {
    const auto first = static_cast<std::uint32_t>(mesh_.points.size());
    for (std::uint32_t v = 0; v < surface.points.size(); ++v) {
      const auto [x, y, z] = place(surface.place(v));
      mesh_.points.emplace_back(x, y, z);
    }
    const NormalMap normals(place);
    const bool is_mirrored = place.determinant() < 0;
    for (std::size_t face = 0; face < surface.triangles.size(); ++face) {
      auto triangle = surface.triangles[face];
      for (std::uint32_t& v : triangle)
        v += first;
      mesh_.triangles.push_back(triangle);
      add_corners(surface, face, normals);
      add_part(surface.primitives()[surface.primitive_of(face)]);
      if (is_mirrored)
        turn_last();
    }
  }

  void turn_last() {
    for (auto* const triples : {&mesh_.triangles, &mesh_.corner_textures.triples,
                                &mesh_.corner_normals.triples, &mesh_.value_triangles})
      if (!triples->empty())
        std::swap(triples->back()[1], triples->back()[2]);
  }

  /// Where a place has normals: across the images of what they were across.
  struct NormalMap {
    explicit NormalMap(const Transform& place) : origin(place({})) {
      for (std::size_t k = 0; k < 3; ++k) {
        Vector axis{};
        axis[k] = 1;
        axes[k] = place(axis);
        for (std::size_t i = 0; i < 3; ++i)
          axes[k][i] -= origin[i];
      }
      sign = place.determinant() < 0 ? -1 : 1;
    }

    Vector operator()(const Element& normal) const {
      Vector result{};
      for (std::size_t k = 0; k < 3; ++k) {
        const Vector &a = axes[(k + 1) % 3], &b = axes[(k + 2) % 3];
        for (std::size_t i = 0; i < 3; ++i)
          result[i] += sign * normal[k] *
                       (a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3]);
      }
      const double length = std::hypot(result[0], result[1], result[2]);
      for (double& component : result)
        component = length > 0 ? component / length : 0;
      return result;
    }

    Vector origin;
    std::array<Vector, 3> axes;
    double sign;
  };

  /// What the last triangle has at its corners, where any has it.
  void add_corners(const GltfSurface& surface, std::size_t face, const NormalMap& normals) {
    const GltfPrimitive& primitive = surface.primitives()[surface.primitive_of(face)];
    std::array<std::uint32_t, 3> of_textures{}, of_normals{}, of_colors{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::vector<Element> values = surface.corner(face, i);
      std::array<double, 2> texture{};
      Vector normal{};
      Color color{1, 1, 1, 1};
      for (std::size_t a = 0; a < values.size(); ++a) {
        const GltfAttribute& attribute = primitive.attributes[a];
        if (attribute.target)
          continue;
        if (attribute.name == "TEXCOORD_0")
          texture = {values[a][0], 1 - values[a][1]}; // an IndexedMesh has it as OBJ
        else if (attribute.name == "NORMAL")
          normal = normals(values[a]);
        else if (attribute.name == "COLOR_0")
          color = color_of(values[a], attribute.elements.type().components);
      }
      of_textures[i] = textures_.number(texture, mesh_.corner_textures.values);
      of_normals[i] = normals_.number(normal, mesh_.corner_normals.values);
      of_colors[i] = colors_.number(color, mesh_.triangles.back()[i], color_list_);
    }
    if (has_textures_)
      mesh_.corner_textures.triples.push_back(of_textures);
    if (has_normals_)
      mesh_.corner_normals.triples.push_back(of_normals);
    if (has_colors_)
      mesh_.value_triangles.push_back(of_colors);
  }

  static Color color_of(const Element& linear, std::size_t components) {
    Color color{};
    for (std::size_t k = 0; k < 3; ++k)
      color[k] = static_cast<double>(static_cast<float>(srgb(std::clamp(linear[k], 0., 1.))));
    color[3] = components == 4 ? linear[3] : 1;
    return color;
  }

  /// The names of its mesh, which is an object here, and of its material.
  void add_part(const GltfPrimitive& primitive) {
    const Json& mesh = element_of(json_, "meshes", primitive.mesh);
    const Json& json = element_of(mesh, "primitives", primitive.number);
    FacePart part;
    part.object = names_.name(text_of(mesh, "name"));
    if (member(json, "material"))
      part.material =
          names_.name(text_of(element_of(json_, "materials", count_of(json, "material")), "name"));
    const auto has = [&](const char* name) {
      return std::any_of(primitive.attributes.begin(), primitive.attributes.end(),
                         [&](const GltfAttribute& a) { return !a.target && a.name == name; });
    };
    part.has_textures = has("TEXCOORD_0");
    part.has_normals = has("NORMAL");
    names_.add_face(part);
  }

  /// Numbers of values, each of them once.
  template <std::size_t N>
  struct ValueTable {
    using Value = std::array<double, N>;

    std::uint32_t number(const Value& value, std::vector<Value>& values) {
      const auto next = static_cast<std::uint32_t>(values.size());
      const auto [place, is_new] = numbers.try_emplace(value, next);
      if (is_new)
        values.push_back(value);
      return place->second;
    }

    std::map<Value, std::uint32_t> numbers;
  };

  /// The same of values that belong to points.
  struct PointColors {
    std::uint32_t number(const Color& color, std::uint32_t point,
                         std::vector<std::pair<std::uint32_t, Color>>& list) {
      const auto next = static_cast<std::uint32_t>(list.size());
      const auto [place, is_new] = numbers.try_emplace({point, color}, next);
      if (is_new)
        list.emplace_back(point, color);
      return place->second;
    }

    std::map<std::pair<std::uint32_t, Color>, std::uint32_t> numbers;
  };

  void finish() {
    mesh_.parts = names_.take();
    if (!has_textures_)
      mesh_.corner_textures = {};
    if (!has_normals_)
      mesh_.corner_normals = {};
    if (has_colors_)
      set_colors();
  }

  /// As vertices of their own, which are made one where they are.
  void set_colors() {
    const std::vector<Point> points = std::move(mesh_.points);
    mesh_.points.clear();
    std::map<std::uint32_t, std::uint32_t> first_of_points;
    std::vector<std::uint32_t> firsts;
    for (std::uint32_t i = 0; i < color_list_.size(); ++i) {
      const auto& [point, color] = color_list_[i];
      mesh_.points.push_back(points[point]);
      mesh_.colors.push_back(color);
      firsts.push_back(first_of_points.try_emplace(point, i).first->second);
    }
    mesh_.triangles = std::move(mesh_.value_triangles);
    mesh_.value_triangles.clear();
    VertexJoining::join(mesh_, firsts);
  }

  const Json& json_;
  IndexedMesh mesh_;
  bool has_colors_ = false, has_textures_ = false, has_normals_ = false;
  ValueTable<2> textures_;
  ValueTable<3> normals_;
  PointColors colors_;
  std::vector<std::pair<std::uint32_t, Color>> color_list_; // with their points
  PartNumbers names_;
};

} // namespace quadrille_examples

#endif
