#ifndef QUADRILLE_EXAMPLES_GLTF_DRACO_COMPRESSION_H
#define QUADRILLE_EXAMPLES_GLTF_DRACO_COMPRESSION_H

#include "accessor.h"
#include "buffers.h"
#include "document.h"
#include "extensions.h"
#include "json.h"
#include "uses.h"

#include <draco/compression/expert_encode.h>
#include <draco/mesh/mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// Compresses primitives of triangles.
class DracoCompression {
public:
  static void compress(GltfDocument& document, bool is_exact) {
    DracoCompression compression(document, is_exact);
    compression.choose();
    compression.set_grid();
    for (auto& [geometry, primitives] : compression.primitives_)
      compression.compress(primitives);
    compression.finish();
  }

private:
  static constexpr const char* name = "KHR_draco_mesh_compression";
  using Place = std::pair<std::size_t, std::size_t>; // a mesh, and one of its primitives

  DracoCompression(GltfDocument& document, bool is_exact)
      : document_(document), json_(document.json), is_exact_(is_exact) {}

  Json& json_of(const Place& place) {
    return json_["meshes"][place.first]["primitives"][place.second];
  }

  // --- Which primitives --------------------------------------------------------------------------

  /// Those of triangles whose accessors are theirs alone, or also those of their twins'.
  void choose() {
    std::map<std::size_t, std::size_t> users; // of accessors, anywhere
    for (std::size_t mesh = 0; mesh < size_of(json_, "meshes"); ++mesh)
      for (std::size_t i = 0; i < size_of(element_of(json_, "meshes", mesh), "primitives"); ++i)
        add({mesh, i});
    for (const auto& [geometry, places] : primitives_)
      for (const std::size_t accessor : accessors_of(places.front()))
        ++users[accessor];
    for (const std::size_t accessor : accessors_of_others())
      ++users[accessor];
    std::erase_if(primitives_, [&](const auto& one) {
      return !is_fit(one.second.front()) || has_user(users, one.second.front());
    });
  }

  void add(const Place& place) {
    const Json& primitive = json_of(place);
    std::string geometry;
    for (const char* const key : {"attributes", "indices", "mode", "targets"})
      if (const Json* const value = member(primitive, key))
        geometry += key + value->dump();
    primitives_[geometry].push_back(place);
  }

  std::vector<std::size_t> accessors_of(const Place& place) {
    const Json& primitive = json_of(place);
    std::vector<std::size_t> accessors;
    if (const Json* const attributes = member(primitive, "attributes"))
      accessors = GltfUses::accessors_of(*attributes);
    if (member(primitive, "indices"))
      accessors.push_back(count_of(primitive, "indices"));
    return accessors;
  }

  /// Those of morph targets and animations, which Draco does not compress.
  std::vector<std::size_t> accessors_of_others() {
    std::vector<std::size_t> accessors;
    for (const auto& [geometry, places] : primitives_)
      for_each_element(json_of(places.front()), "targets", [&](const Json& target) {
        for (const std::size_t accessor : GltfUses::accessors_of(target))
          accessors.push_back(accessor);
      });
    for_each_element(json_, "animations", [&](const Json& animation) {
      for_each_element(animation, "samplers", [&](const Json& sampler) {
        for (const char* const key : {"input", "output"})
          accessors.push_back(count_of(sampler, key));
      });
    });
    return accessors;
  }

  bool has_user(const std::map<std::size_t, std::size_t>& users, const Place& place) {
    const std::vector<std::size_t> accessors = accessors_of(place);
    return std::any_of(accessors.begin(), accessors.end(),
                       [&](std::size_t accessor) { return users.at(accessor) > 1; });
  }

  bool is_fit(const Place& place) {
    const Json& primitive = json_of(place);
    if (count_of(primitive, "mode", 4) != 4 || !member(primitive, "indices") ||
        !member(primitive, "attributes") || !member(primitive["attributes"], "POSITION"))
      return false;
    const std::vector<std::size_t> accessors = accessors_of(place);
    return std::all_of(accessors.begin(), accessors.end(), [&](std::size_t accessor) {
      const Json& json = element_of(json_, "accessors", accessor);
      return member(json, "bufferView") && !member(json, "sparse") &&
             !text_of(json, "type").starts_with("MAT");
    });
  }

  // --- Numbers that are rounded ------------------------------------------------------------------

  /// A grid for the positions of all meshes, so that those that meet go on meeting; the smallest
  /// mesh has as many steps as other tools give each.
  void set_grid() {
    std::array<double, 3> low, high;
    low.fill(std::numeric_limits<double>::max());
    high.fill(std::numeric_limits<double>::lowest());
    double smallest = std::numeric_limits<double>::max();
    for (const auto& [geometry, places] : primitives_) {
      const Elements positions = elements(json_of(places.front())["attributes"], "POSITION");
      double extent = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        double least = std::numeric_limits<double>::max(), greatest = -least;
        for (std::size_t i = 0; i < positions.size(); ++i) {
          least = std::min(least, positions.stored(i, k));
          greatest = std::max(greatest, positions.stored(i, k));
        }
        low[k] = std::min(low[k], least);
        high[k] = std::max(high[k], greatest);
        extent = std::max(extent, greatest - least);
      }
      if (extent > 0)
        smallest = std::min(smallest, extent);
    }
    for (std::size_t k = 0; k < 3 && !primitives_.empty(); ++k) {
      origin_[k] = static_cast<float>(low[k]);
      range_ = std::max(range_, static_cast<float>(high[k] - low[k]));
    }
    const double more = range_ > 0 ? std::ceil(std::log2(double{range_} / smallest)) : 0;
    bits_ = 14 + static_cast<int>(std::clamp(more, 0., 10.));
  }

  Elements elements(const Json& attributes, const char* key) const {
    return Elements(document_, count_of(attributes, key));
  }

  /// Where a position is on the grid, by the numbers in which Draco decodes it.
  double on_grid(double x, std::size_t k) const {
    const auto steps = static_cast<float>((1U << static_cast<unsigned>(bits_)) - 1);
    const float place = std::floor((static_cast<float>(x) - origin_[k]) * (steps / range_) + .5F);
    return double{place * (range_ / steps) + origin_[k]};
  }

  bool is_rounded(const std::string& attribute, const ElementType& type) const {
    return type.component.is_float && !is_exact_ && !attribute.starts_with("WEIGHTS_") &&
           !attribute.starts_with("_") && attribute != "TANGENT";
  }

  void set_rounding(draco::ExpertEncoder& encoder, int id, const std::string& attribute,
                    const ElementType& type) const {
    if (!is_rounded(attribute, type))
      return;
    if (attribute == "POSITION" && range_ > 0)
      encoder.SetAttributeExplicitQuantization(id, bits_, 3, origin_.data(), range_);
    else if (attribute != "POSITION")
      encoder.SetAttributeQuantization(id, attribute == "NORMAL"                ? 10
                                           : attribute.starts_with("TEXCOORD_") ? 12
                                                                                : 8);
  }

  // --- One primitive -----------------------------------------------------------------------------

  /// A primitive as the library has it.
  struct Input {
    draco::Mesh mesh;
    std::map<std::string, int> ids; // of attributes
    std::size_t size = 0;           // in bytes, uncompressed
    bool is_in_order = false;       // must it stay so?
  };

  /// One that cannot be encoded, or would not become smaller, stays as it is.
  void compress(const std::vector<Place>& places) {
    const Json primitive = json_of(places.front());
    const Json& attributes = primitive["attributes"];
    Input input;
    if (!read(primitive, input))
      return;
    draco::ExpertEncoder encoder(input.mesh);
    for (const auto& [attribute, id] : input.ids)
      set_rounding(encoder, id, attribute, elements(attributes, attribute.c_str()).type());
    encoder.SetEncodingMethod(input.is_in_order ? draco::MESH_SEQUENTIAL_ENCODING
                                                : draco::MESH_EDGEBREAKER_ENCODING);
    encoder.SetSpeedOptions(3, 3);
    encoder.SetTrackEncodedProperties(true);
    draco::EncoderBuffer buffer;
    if (!encoder.EncodeToBuffer(&buffer).ok() || encoder.num_encoded_faces() == 0 ||
        buffer.size() >= input.size)
      return;
    Json how = {{"bufferView", views_.size()}, {"attributes", Json::object()}};
    views_.emplace_back(buffer.data(), buffer.size());
    for (const auto& [attribute, id] : input.ids) {
      how["attributes"][attribute] = input.mesh.attribute(id)->unique_id();
      leave(count_of(attributes, attribute.c_str()), encoder.num_encoded_points());
    }
    leave(count_of(primitive, "indices"), 3 * encoder.num_encoded_faces());
    set_range(count_of(attributes, "POSITION"));
    for (const Place& place : places)
      json_of(place)["extensions"][name] = how;
  }

  /// Displacements of morph targets, which stay uncompressed, are in the order of the vertices.
  bool read(const Json& primitive, Input& input) const {
    input.is_in_order = size_of(primitive, "targets") > 0;
    for (const auto& [attribute, index] : primitive["attributes"].items()) {
      const Elements values = elements(primitive["attributes"], attribute.c_str());
      input.size += values.size() * values.type().size();
      input.ids[attribute] = add_attribute(input.mesh, attribute, values);
    }
    const Elements indices = elements(primitive, "indices");
    input.size += indices.size() * indices.type().size();
    if (!add_faces(input.mesh, indices))
      return false;
    if (input.is_in_order)
      return true;
    if (!input.mesh.DeduplicateAttributeValues())
      return false;
    input.mesh.DeduplicatePointIds();
    return true;
  }

  static draco::GeometryAttribute::Type type_of(const std::string& attribute) {
    using Type = draco::GeometryAttribute;
    return attribute == "POSITION"              ? Type::POSITION
           : attribute == "NORMAL"              ? Type::NORMAL
           : attribute.starts_with("TEXCOORD_") ? Type::TEX_COORD
           : attribute.starts_with("COLOR_")    ? Type::COLOR
                                                : Type::GENERIC;
  }

  static draco::DataType number_type(const ComponentType& component) {
    switch (component.code) {
    case 5120:
      return draco::DT_INT8;
    case 5121:
      return draco::DT_UINT8;
    case 5122:
      return draco::DT_INT16;
    case 5123:
      return draco::DT_UINT16;
    case 5125:
      return draco::DT_UINT32;
    default:
      return draco::DT_FLOAT32;
    }
  }

  static int add_attribute(draco::Mesh& mesh, const std::string& semantic,
                           const Elements& elements) {
    const ElementType& type = elements.type();
    draco::GeometryAttribute attribute;
    attribute.Init(type_of(semantic), nullptr, static_cast<std::uint8_t>(type.components),
                   number_type(type.component), type.is_normalized,
                   static_cast<std::int64_t>(type.size()), 0);
    mesh.set_num_points(static_cast<std::uint32_t>(elements.size()));
    const int id = mesh.AddAttribute(attribute, true, static_cast<std::uint32_t>(elements.size()));
    for (std::uint32_t i = 0; i < elements.size(); ++i) {
      std::string bytes;
      for (std::size_t c = 0; c < type.components; ++c)
        type.append(elements.stored(i, c), bytes);
      mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i), bytes.data());
    }
    return id;
  }

  /// False if an index is out of range.
  static bool add_faces(draco::Mesh& mesh, const Elements& indices) {
    mesh.SetNumFaces(indices.size() / 3);
    for (std::uint32_t face = 0; face < indices.size() / 3; ++face) {
      draco::Mesh::Face corners;
      for (std::size_t i = 0; i < 3; ++i) {
        corners[i] = static_cast<std::uint32_t>(indices.stored(3 * std::size_t{face} + i, 0));
        if (corners[i].value() >= mesh.num_points())
          return false;
      }
      mesh.SetFace(draco::FaceIndex(face), corners);
    }
    return true;
  }

  /// What an accessor has comes out of a decoder.
  void leave(std::size_t accessor, std::size_t count) {
    Json& json = json_["accessors"][accessor];
    left_views_.insert(count_of(json, "bufferView"));
    json.erase("bufferView");
    json.erase("byteOffset");
    json["count"] = count;
  }

  void set_range(std::size_t accessor) {
    Json& json = json_["accessors"][accessor];
    if (range_ == 0 || !is_rounded("POSITION", ElementType(json)))
      return;
    for (const char* const key : {"min", "max"})
      for (std::size_t k = 0; k < 3 && size_of(json, key) == 3; ++k)
        json[key][k] = on_grid(json[key][k].get<double>(), k);
  }

  // --- The buffers -------------------------------------------------------------------------------

  /// Views that nothing uses any more take what is compressed, since the numbers of others stay.
  void finish() {
    if (views_.empty())
      return;
    const std::vector<std::size_t> numbers = numbers_of_views();
    NewViewBytes new_bytes;
    for (std::size_t i = 0; i < views_.size(); ++i) {
      json_["bufferViews"][numbers[i]] = {
          {"buffer", 0}, {"byteOffset", 0}, {"byteLength", views_[i].size()}};
      new_bytes.emplace(numbers[i], std::move(views_[i]));
    }
    for (auto& [geometry, places] : primitives_)
      for (const Place& place : places)
        if (Json& primitive = json_of(place); extension_of(primitive, name)) {
          Json& view = primitive["extensions"][name]["bufferView"];
          view = numbers[view.get<std::size_t>()];
        }
    BufferPacking::pack(document_, new_bytes);
    list_extension(json_, "extensionsUsed", name);
    list_extension(json_, "extensionsRequired", name);
  }

  std::vector<std::size_t> numbers_of_views() {
    std::set<std::size_t> used;
    add_views(json_, used);
    std::vector<std::size_t> numbers;
    for (const std::size_t view : left_views_)
      if (!used.contains(view))
        numbers.push_back(view);
    while (numbers.size() > views_.size() && numbers.back() + 1 == json_["bufferViews"].size()) {
      json_["bufferViews"].erase(numbers.back());
      numbers.pop_back();
    }
    for (std::size_t i = views_.size(); i < numbers.size(); ++i)
      json_["bufferViews"][numbers[i]] = {{"buffer", 0}, {"byteOffset", 0}, {"byteLength", 1}};
    while (numbers.size() < views_.size()) {
      numbers.push_back(json_["bufferViews"].size());
      json_["bufferViews"].push_back(Json::object());
    }
    return numbers;
  }

  /// But of what is compressed, which has no number yet.
  static void add_views(const Json& json, std::set<std::size_t>& views) {
    if (member(json, "bufferView"))
      views.insert(count_of(json, "bufferView"));
    for (const auto& [key, part] : json.items())
      if (part.is_structured() && key != name)
        add_views(part, views);
  }

  GltfDocument& document_;
  Json& json_;
  bool is_exact_;
  std::map<std::string, std::vector<Place>> primitives_; // by their geometry
  std::array<float, 3> origin_{};
  float range_ = 0;
  int bits_ = 0;
  std::vector<std::string> views_;   // new ones
  std::set<std::size_t> left_views_; // by what is compressed
};

} // namespace quadrille_examples

#endif
