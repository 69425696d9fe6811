#ifndef QUADRILLE_EXAMPLES_GLTF_PRIMITIVE_H
#define QUADRILLE_EXAMPLES_GLTF_PRIMITIVE_H

#include "accessor.h"
#include "document.h"
#include "json.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// What the values of an attribute are, by which they go through a simplification.
enum class AttributeKind {
  position,
  texture,
  normal,
  tangent, ///< a direction, and a sign that has no value in between
  color,
  number, ///< of any meaning; also the displacements of morph targets
  name,   ///< integers, which have no values in between; here also the signs of tangents
  skin    ///< joints and their weights, which go together
};

/// An attribute of the vertices of a primitive, or of one of its morph targets.
struct GltfAttribute {
  std::string name;
  std::optional<std::size_t> target;
  AttributeKind kind;
  Elements elements;
  ElementType written; ///< how new ones are stored; as the old ones, unless somebody says otherwise
  bool is_label = false; ///< do faces of different values lie in different regions, which stay?
};

/// The triangles of a primitive, and its vertices.
struct GltfPrimitive {
  std::size_t mesh, number;              ///< where it is in the document
  std::vector<GltfAttribute> attributes; ///< of which the first are the positions
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// The kind of an attribute, which has a type that goes with it, else it throws.
inline AttributeKind attribute_kind(const std::string& name, const ElementType& type) {
  const auto is_a = [&](std::string_view semantic) { return name.starts_with(semantic); };
  const auto require = [&](bool is_right) {
    if (!is_right)
      throw std::runtime_error(in_quotes(name) + " has elements of " +
                               std::to_string(type.components) + " components");
  };
  if (is_a("JOINTS_") || is_a("WEIGHTS_")) {
    require(type.components == 4);
    return AttributeKind::skin;
  }
  if (name == "POSITION" || name == "NORMAL") {
    require(type.components == 3);
    return name == "NORMAL" ? AttributeKind::normal : AttributeKind::position;
  }
  if (name == "TANGENT") {
    require(type.components == 4);
    return AttributeKind::tangent;
  }
  if (is_a("TEXCOORD_")) {
    require(type.components == 2);
    return AttributeKind::texture;
  }
  if (is_a("COLOR_")) {
    require(type.components >= 3);
    return AttributeKind::color;
  }
  return type.is_continuous() ? AttributeKind::number : AttributeKind::name;
}

/// Reads a primitive of triangles.
class PrimitiveReader {
public:
  /// Nothing, if the primitive is of points or lines.
  static std::optional<GltfPrimitive> read(const GltfDocument& document, std::size_t mesh,
                                           std::size_t number) {
    const Json& json = element_of(element_of(document.json, "meshes", mesh), "primitives", number);
    if (count_of(json, "mode", triangles) < triangles)
      return std::nullopt;
    PrimitiveReader reader(document, json);
    reader.require_known_extensions();
    reader.read_attributes();
    reader.read_triangles();
    return GltfPrimitive{mesh, number, std::move(reader.attributes_), std::move(reader.triangles_)};
  }

private:
  enum Mode : std::size_t { triangles = 4, strip = 5, fan = 6 };

  PrimitiveReader(const GltfDocument& document, const Json& json)
      : document_(document), json_(json) {}

  /// What an unknown extension says may be of vertices by their numbers, or of compressed ones.
  void require_known_extensions() const {
    constexpr std::array<std::string_view, 3> harmless{
        "KHR_materials_variants", "EXT_mesh_features", "EXT_structural_metadata"};
    const Json* const extensions = member(json_, "extensions");
    if (!extensions || !extensions->is_object())
      return;
    for (const auto& [name, content] : extensions->items())
      if (std::find(harmless.begin(), harmless.end(), name) == harmless.end())
        throw std::runtime_error("a primitive with the extension " + in_quotes(name, 40) +
                                 " is not simplified");
  }

  void read_attributes() {
    const Json* const attributes = member(json_, "attributes");
    if (!attributes || !member(*attributes, "POSITION"))
      throw std::runtime_error("a primitive has no 'POSITION'");
    add("POSITION", *attributes, std::nullopt);
    for (const auto& [name, index] : attributes->items())
      if (name != "POSITION")
        add(name, *attributes, std::nullopt);
    for (std::size_t target = 0; target < size_of(json_, "targets"); ++target) {
      const Json& displacements = element_of(json_, "targets", target);
      for (const auto& [name, index] : displacements.items())
        add(name, displacements, target);
    }
  }

  void add(const std::string& name, const Json& attributes, std::optional<std::size_t> target) {
    Elements elements(document_, count_of(attributes, name.c_str()), vertex_count());
    elements.require_finite();
    const AttributeKind kind =
        target ? AttributeKind::number : attribute_kind(name, elements.type());
    const ElementType type = elements.type();
    attributes_.push_back({name, target, kind, std::move(elements), type});
  }

  /// 0 as long as there are no positions.
  std::size_t vertex_count() const {
    return attributes_.empty() ? 0 : attributes_.front().elements.size();
  }

  void read_triangles() {
    const std::vector<std::uint32_t> corners = read_corners();
    const std::size_t mode = count_of(json_, "mode", triangles);
    const std::size_t step = mode == triangles ? 3 : 1;
    for (std::size_t i = 0; i + 3 <= corners.size(); i += step) {
      const std::size_t odd = mode == strip ? i % 2 : 0;
      triangles_.push_back(
          {mode == fan ? corners[0] : corners[i], corners[i + 1 + odd], corners[i + 2 - odd]});
    }
    if (mode > fan || (mode == triangles && corners.size() % 3 != 0))
      throw std::runtime_error("a primitive of mode " + std::to_string(mode) + " and " +
                               std::to_string(corners.size()) + " corners");
  }

  std::vector<std::uint32_t> read_corners() const {
    std::vector<std::uint32_t> corners;
    if (!member(json_, "indices")) {
      for (std::size_t i = 0; i < vertex_count(); ++i)
        corners.push_back(static_cast<std::uint32_t>(i));
      return corners;
    }
    const Elements indices(document_, count_of(json_, "indices"));
    const ElementType& type = indices.type();
    if (type.components != 1 || type.component.is_signed)
      throw std::runtime_error("the indices of " + indices.name() + " are not unsigned integers");
    for (std::size_t i = 0; i < indices.size(); ++i) {
      const double index = indices.stored(i, 0);
      if (index >= static_cast<double>(vertex_count()))
        throw std::runtime_error(
            out_of_range("vertex", static_cast<std::int64_t>(index), vertex_count()));
      corners.push_back(static_cast<std::uint32_t>(index));
    }
    return corners;
  }

  const GltfDocument& document_;
  const Json& json_;
  std::vector<GltfAttribute> attributes_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

} // namespace quadrille_examples

#endif
