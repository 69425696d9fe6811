#ifndef QUADRILLE_EXAMPLES_GLTF_MESH_DOCUMENT_H
#define QUADRILLE_EXAMPLES_GLTF_MESH_DOCUMENT_H

#include "../format.h"
#include "../formats/material_library.h"
#include "../linear_light.h"
#include "../mesh/indexed_mesh.h"
#include "../text.h"
#include "document.h"
#include "images.h"
#include "json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// What a document can hold of a mesh, which is made another way than files of formats.
inline constexpr MeshFormat gltf_format{".glb", nullptr, nullptr, true, true, true, false, false};

/// Makes a document of a mesh of another format: a node for each object, of one mesh, with a
/// primitive for each material, and what its corners have. Materials show both sides of their
/// faces, since other formats know no back that is hidden.
class GltfMeshDocument {
public:
  /// `source` is the file that the mesh comes from, beside which its materials and images are.
  /// `remarks` gets what is missing. Images that are left stay files, which the document names.
  /// Throws `std::runtime_error` for coordinates beyond single precision.
  static GltfDocument of(const IndexedMesh& mesh, const std::filesystem::path& source,
                         bool leaves_images, std::vector<std::string>& remarks) {
    GltfMeshDocument made(mesh, source, leaves_images, remarks);
    made.read_materials();
    made.group_faces();
    for (const auto& [object, parts] : made.faces_)
      made.add_object(object, parts);
    return std::move(made.document_);
  }

private:
  /// What the faces of a primitive have in common.
  struct Part {
    std::uint32_t material = 0; ///< a name
    bool has_textures = false, has_normals = false;
    friend auto operator<=>(const Part&, const Part&) = default;
  };
  using Faces = std::vector<std::size_t>;
  /// What a corner has: numbers of a point, of values of vertices, of a texture coordinate and of a
  /// normal.
  using Corner = std::array<std::uint32_t, 4>;

  enum ViewTarget { of_vertices = 34962, of_indices = 34963 };
  enum Type : std::size_t { unsigned_short = 5123, unsigned_int = 5125, single = 5126 };

  GltfMeshDocument(const IndexedMesh& mesh, const std::filesystem::path& source, bool leaves_images,
                   std::vector<std::string>& remarks)
      : mesh_(mesh), source_(source), leaves_images_(leaves_images), remarks_(remarks) {
    json_["asset"] = {{"version", "2.0"}, {"generator", "quadrille"}};
    json_["scene"] = 0;
    json_["scenes"] = Json::array({{{"nodes", Json::array()}}});
    json_["buffers"] = Json::array({Json::object()});
    document_.buffers.emplace_back();
  }

  // --- Materials
  // -----------------------------------------------------------------------------------

  void read_materials() {
    for (const std::string& library : mesh_.parts.libraries)
      try {
        MaterialLibrary::read(read_content(source_.parent_path() / library), library_);
      } catch (const std::runtime_error&) {
        remarks_.push_back("the material file " + in_quotes(library, 100) +
                           " is missing: materials have only their names");
      }
  }

  /// The number of the material of that name; there is one without.
  std::size_t material(std::uint32_t name) {
    const std::size_t next = size_of(json_, "materials");
    const auto [place, is_new] = materials_.try_emplace(name, next);
    if (is_new) {
      Json json;
      set_name(json, text_of_name(name));
      json["pbrMetallicRoughness"] = {{"metallicFactor", 0}};
      json["doubleSided"] = true;
      if (const auto found = library_.find(text_of_name(name)); found != library_.end())
        set_looks(json, found->second);
      else if (const std::string image = image_of_comment(); !image.empty())
        set_texture(json["pbrMetallicRoughness"], "baseColorTexture", image);
      json_["materials"].push_back(std::move(json));
    }
    return place->second;
  }

  void set_looks(Json& json, const ObjMaterial& material) {
    Json& surface = json["pbrMetallicRoughness"];
    if (!material.image.empty())
      set_texture(surface, "baseColorTexture", material.image);
    // Where there is an image, programs that write files put anything into Kd.
    const std::array<double, 3> color =
        member(surface, "baseColorTexture") ? std::array<double, 3>{1, 1, 1} : material.color;
    surface["baseColorFactor"] = {color[0], color[1], color[2], material.opacity};
    if (material.opacity < 1)
      json["alphaMode"] = "BLEND";
    if (!material.normal_image.empty())
      set_texture(json, "normalTexture", material.normal_image);
  }

  /// The image that a PLY file names, if it is one: "TextureFile a.png".
  std::string image_of_comment() const {
    const std::string keyword = "TextureFile ";
    if (mesh_.texture_comments.size() != 1 ||
        !equal_ignoring_case(mesh_.texture_comments[0].substr(0, keyword.size()), keyword))
      return "";
    return mesh_.texture_comments[0].substr(keyword.size());
  }

  void set_texture(Json& json, const char* key, const std::string& file) {
    const auto found = textures_.find(file);
    const std::optional<std::size_t> texture =
        found != textures_.end() ? found->second : textures_[file] = read_texture(file);
    if (texture)
      json[key] = {{"index", *texture}};
  }

  std::optional<std::size_t> read_texture(const std::string& file) {
    try {
      const std::string bytes = read_content(source_.parent_path() / file);
      const std::string name = valid_text(file);
      const std::size_t image = leaves_images_ ? GltfImageFiles::name(document_, name)
                                               : GltfImageFiles::add(document_, name, bytes);
      json_["textures"].push_back({{"source", image}});
      return json_["textures"].size() - 1;
    } catch (const std::runtime_error&) {
      remarks_.push_back("the image " + in_quotes(file, 100) + " is missing, or is not an image");
      return std::nullopt;
    }
  }

  // --- Faces
  // ---------------------------------------------------------------------------------------

  void group_faces() {
    for (std::size_t face = 0; face < mesh_.triangles.size(); ++face) {
      FacePart part;
      if (!mesh_.parts.of_faces.empty())
        part = mesh_.parts.of(face);
      faces_[part.object][{part.material, !mesh_.corner_textures.empty() && part.has_textures,
                           !mesh_.corner_normals.empty() && part.has_normals}]
          .push_back(face);
    }
  }

  void add_object(std::uint32_t object, const std::map<Part, Faces>& parts) {
    Json node, mesh;
    set_name(node, text_of_name(object));
    set_name(mesh, text_of_name(object));
    for (const auto& [part, faces] : parts)
      mesh["primitives"].push_back(primitive(part, faces));
    node["mesh"] = size_of(json_, "meshes");
    json_["scenes"][0]["nodes"].push_back(size_of(json_, "nodes"));
    json_["nodes"].push_back(std::move(node));
    json_["meshes"].push_back(std::move(mesh));
  }

  Json primitive(const Part& part, const Faces& faces) {
    std::vector<Corner> vertices;
    std::vector<std::uint32_t> indices;
    std::map<Corner, std::uint32_t> numbers;
    for (const std::size_t face : faces)
      for (std::size_t i = 0; i < 3; ++i) {
        const Corner corner = corner_of(part, face, i);
        const auto next = static_cast<std::uint32_t>(vertices.size());
        const auto [place, is_new] = numbers.try_emplace(corner, next);
        if (is_new)
          vertices.push_back(corner);
        indices.push_back(place->second);
      }
    Json attributes;
    attributes["POSITION"] = add_positions(vertices);
    if (part.has_normals)
      attributes["NORMAL"] = add_normals(vertices);
    if (part.has_textures || !mesh_.texture_coordinates.empty())
      attributes["TEXCOORD_0"] = add_textures(vertices, part.has_textures);
    if (!mesh_.colors.empty())
      attributes["COLOR_0"] = add_colors(vertices);
    Json result;
    result["attributes"] = std::move(attributes);
    result["indices"] = add_indices(indices, vertices.size());
    result["material"] = material(part.material);
    return result;
  }

  Corner corner_of(const Part& part, std::size_t face, std::size_t i) const {
    return {mesh_.triangles[face][i], value_triangles(mesh_)[face][i],
            part.has_textures ? mesh_.corner_textures.triples[face][i] : 0,
            part.has_normals ? mesh_.corner_normals.triples[face][i] : 0};
  }

  // --- Accessors
  // -----------------------------------------------------------------------------------

  /// Of N numbers for each vertex.
  template <std::size_t N, class ValueOf>
  std::size_t add_floats(const std::vector<Corner>& vertices, ValueOf value_of, bool has_range) {
    std::string bytes;
    std::array<float, N> low, high;
    low.fill(std::numeric_limits<float>::max());
    high.fill(std::numeric_limits<float>::lowest());
    for (const Corner& vertex : vertices) {
      const std::array<double, N> value = value_of(vertex);
      for (std::size_t k = 0; k < N; ++k) {
        if (!(std::abs(value[k]) <= std::numeric_limits<float>::max()))
          throw std::runtime_error("a number is too large for glTF, which uses single precision");
        const auto number = static_cast<float>(value[k]);
        low[k] = std::min(low[k], number);
        high[k] = std::max(high[k], number);
        append_little_endian(bytes, number);
      }
    }
    Json accessor = {{"componentType", std::size_t{single}},
                     {"count", vertices.size()},
                     {"type", "VEC" + std::to_string(N)}};
    if (has_range) {
      accessor["min"] = low;
      accessor["max"] = high;
    }
    return add_accessor(std::move(accessor), bytes, of_vertices);
  }

  std::size_t add_positions(const std::vector<Corner>& vertices) {
    return add_floats<3>(
        vertices,
        [&](const Corner& vertex) {
          const Point& p = mesh_.points[vertex[0]];
          return std::array{p.x(), p.y(), p.z()};
        },
        true);
  }

  /// Of length 1.
  std::size_t add_normals(const std::vector<Corner>& vertices) {
    return add_floats<3>(
        vertices,
        [&](const Corner& vertex) {
          const auto [x, y, z] = mesh_.corner_normals.values[vertex[3]];
          const double length = std::hypot(x, y, z);
          return length > 0 && std::isfinite(length)
                     ? std::array{x / length, y / length, z / length}
                     : std::array{0., 0., 1.};
        },
        false);
  }

  /// From the top down, where others count from the bottom up.
  std::size_t add_textures(const std::vector<Corner>& vertices, bool are_of_corners) {
    return add_floats<2>(
        vertices,
        [&](const Corner& vertex) {
          const auto [u, v] = are_of_corners ? mesh_.corner_textures.values[vertex[2]]
                                             : mesh_.texture_coordinates[vertex[1]];
          return std::array{u, 1 - v};
        },
        false);
  }

  std::size_t add_colors(const std::vector<Corner>& vertices) {
    const auto color = [&](const Corner& vertex) {
      std::array<double, 4> result{};
      for (std::size_t k = 0; k < 4; ++k) {
        const double part = std::clamp(mesh_.colors[vertex[1]][k] / mesh_.color_type.full, 0., 1.);
        result[k] = k == 3 ? part : linear_light(part);
      }
      return result;
    };
    if (mesh_.color_type.has_alpha)
      return add_floats<4>(vertices, color, false);
    return add_floats<3>(
        vertices,
        [&](const Corner& vertex) {
          const auto [red, green, blue, alpha] = color(vertex);
          return std::array{red, green, blue};
        },
        false);
  }

  std::size_t add_indices(const std::vector<std::uint32_t>& indices, std::size_t vertices) {
    const bool is_short = vertices <= std::numeric_limits<std::uint16_t>::max();
    std::string bytes;
    for (const std::uint32_t index : indices)
      if (is_short)
        append_little_endian(bytes, static_cast<std::uint16_t>(index));
      else
        append_little_endian(bytes, index);
    const std::size_t type = is_short ? unsigned_short : unsigned_int;
    return add_accessor({{"componentType", type}, {"count", indices.size()}, {"type", "SCALAR"}},
                        bytes, of_indices);
  }

  std::size_t add_accessor(Json accessor, const std::string& bytes, ViewTarget target) {
    std::string& buffer = document_.buffers.front();
    buffer.resize((buffer.size() + 3) / 4 * 4, '\0');
    accessor["bufferView"] = size_of(json_, "bufferViews");
    json_["bufferViews"].push_back({{"buffer", 0},
                                    {"byteOffset", buffer.size()},
                                    {"byteLength", bytes.size()},
                                    {"target", static_cast<int>(target)}});
    buffer += bytes;
    json_["accessors"].push_back(std::move(accessor));
    return json_["accessors"].size() - 1;
  }

  // --- Names
  // ---------------------------------------------------------------------------------------

  const std::string& text_of_name(std::uint32_t name) const { return mesh_.parts.names[name]; }

  static void set_name(Json& json, const std::string& name) {
    json = Json::object();
    if (!name.empty())
      json["name"] = valid_text(name);
  }

  /// JSON is of UTF-8; what is none becomes a sign that says so.
  static std::string valid_text(const std::string& text) {
    return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace))
        .get<std::string>();
  }

  const IndexedMesh& mesh_;
  std::filesystem::path source_;
  bool leaves_images_; // as files
  std::vector<std::string>& remarks_;
  GltfDocument document_;
  Json& json_ = document_.json;
  std::map<std::string, ObjMaterial> library_;
  std::map<std::string, std::optional<std::size_t>> textures_; // by names of files
  std::map<std::uint32_t, std::size_t> materials_;             // by numbers of names
  std::map<std::uint32_t, std::map<Part, Faces>> faces_;       // of each object
};

} // namespace quadrille_examples

#endif
