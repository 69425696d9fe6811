#ifndef QUADRILLE_EXAMPLES_GLTF_REWRITE_H
#define QUADRILLE_EXAMPLES_GLTF_REWRITE_H

#include "accessor.h"
#include "buffers.h"
#include "document.h"
#include "json.h"
#include "primitive.h"
#include "surface.h"
#include "twins.h"
#include "vertices.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// Numbers of elements of a document.
using NumberSet = std::set<std::size_t>;

/// Puts surfaces in place of the primitives from which they stem.
///
/// What else the document has keeps its number, since extensions that nobody here knows may refer
/// to it. The new accessors and buffer views take the numbers of the old ones that nothing else
/// refers to, and further ones.
class GltfRewriting {
public:
  /// Twins of meshes, by their first ones, get what these have.
  static void rewrite(GltfDocument& document, const std::vector<GltfSurface>& surfaces,
                      const GltfTwins::Firsts& firsts = {}) {
    GltfRewriting rewriting(document);
    rewriting.free_what_is_replaced(surfaces, firsts);
    for (const GltfSurface& surface : surfaces)
      rewriting.write(surface);
    rewriting.share(surfaces, firsts);
    rewriting.fill_gaps();
    BufferPacking::pack(document, rewriting.new_bytes_);
  }

private:
  enum ViewTarget { of_vertices = 34962, of_indices = 34963 };
  enum Type : std::size_t { unsigned_byte = 5121, unsigned_short = 5123, unsigned_int = 5125 };

  explicit GltfRewriting(GltfDocument& document)
      : json_(document.json), old_accessors_(json_["accessors"]) {
    if (document.buffers.empty()) { // all was zeros
      document.buffers.emplace_back();
      json_["buffers"].push_back(Json::object());
    }
  }

  // --- What is replaced --------------------------------------------------------------------------

  using PrimitiveNumbers = std::set<std::pair<std::size_t, std::size_t>>; // meshes, primitives

  static PrimitiveNumbers primitives_of(const std::vector<GltfSurface>& surfaces) {
    PrimitiveNumbers numbers;
    for (const GltfSurface& surface : surfaces)
      for (const GltfPrimitive& primitive : surface.primitives())
        numbers.emplace(primitive.mesh, primitive.number);
    return numbers;
  }

  /// Calls visit(twin, first, number) for each primitive of a twin of which the first has one.
  template <class Visit>
  void for_each_twin(const PrimitiveNumbers& numbers, const GltfTwins::Firsts& firsts,
                     Visit visit) const {
    for (const auto& [twin, first] : firsts)
      for (std::size_t i = 0; i < size_of(element_of(json_, "meshes", twin), "primitives"); ++i)
        if (numbers.contains({first, i}))
          visit(twin, first, i);
  }

  void share(const std::vector<GltfSurface>& surfaces, const GltfTwins::Firsts& firsts) {
    for_each_twin(primitives_of(surfaces), firsts,
                  [&](std::size_t twin, std::size_t first, std::size_t i) {
                    GltfTwins::copy(json_["meshes"][first]["primitives"][i],
                                    json_["meshes"][twin]["primitives"][i]);
                  });
  }

  void free_what_is_replaced(const std::vector<GltfSurface>& surfaces,
                             const GltfTwins::Firsts& firsts) {
    PrimitiveNumbers replaced = primitives_of(surfaces);
    for_each_twin(PrimitiveNumbers(replaced), firsts,
                  [&](std::size_t twin, std::size_t, std::size_t i) { replaced.emplace(twin, i); });
    NumberSet kept = accessors_of_animations_and_skins();
    for (std::size_t mesh = 0; mesh < size_of(json_, "meshes"); ++mesh) {
      const Json& primitives = element_of(json_, "meshes", mesh);
      for (std::size_t i = 0; i < size_of(primitives, "primitives"); ++i)
        add_accessors(element_of(primitives, "primitives", i),
                      replaced.contains({mesh, i}) ? free_accessors_ : kept);
    }
    for (const std::size_t accessor : kept)
      free_accessors_.erase(accessor);
    for (const std::size_t accessor : free_accessors_)
      add_views(std::exchange(json_["accessors"][accessor], Json()), free_views_);
    NumberSet kept_views;
    add_views(json_, kept_views);
    for (const std::size_t view : kept_views)
      free_views_.erase(view);
    for (const std::size_t view : free_views_)
      json_["bufferViews"][view] = Json();
  }

  static void add_accessors(const Json& primitive, NumberSet& accessors) {
    const auto add_all = [&](const Json& attributes) {
      for (const auto& [name, index] : attributes.items())
        accessors.insert(count_of(attributes, name.c_str()));
    };
    if (const Json* const attributes = member(primitive, "attributes"))
      add_all(*attributes);
    for_each_element(primitive, "targets", add_all);
    if (member(primitive, "indices"))
      accessors.insert(count_of(primitive, "indices"));
  }

  NumberSet accessors_of_animations_and_skins() const {
    NumberSet accessors;
    const auto add = [&](const Json& user, const char* key) {
      if (member(user, key))
        accessors.insert(count_of(user, key));
    };
    for_each_element(json_, "skins", [&](const Json& skin) { add(skin, "inverseBindMatrices"); });
    for_each_element(json_, "animations", [&](const Json& animation) {
      for_each_element(animation, "samplers", [&](const Json& sampler) {
        add(sampler, "input");
        add(sampler, "output");
      });
    });
    return accessors;
  }

  /// Of all members of that name, wherever they are, extensions included.
  static void add_views(const Json& json, NumberSet& views) {
    if (member(json, "bufferView"))
      views.insert(count_of(json, "bufferView"));
    for (const Json& part : json)
      if (part.is_structured())
        add_views(part, views);
  }

  // --- What is new -------------------------------------------------------------------------------

  void write(const GltfSurface& surface) {
    std::vector<GltfVertices> vertices(surface.primitives().begin(), surface.primitives().end());
    for (std::size_t face = 0; face < surface.triangles.size(); ++face)
      vertices[surface.primitive_of(face)].add_face(surface, face);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (vertices[i].size() == 0)
        vertices[i].add_nothing();
      write(surface.primitives()[i], vertices[i]);
    }
  }

  void write(const GltfPrimitive& primitive, const GltfVertices& vertices) {
    Json& json = json_["meshes"][primitive.mesh]["primitives"][primitive.number];
    const std::size_t buffer = buffer_of(primitive.attributes.front().elements.index(), 0);
    for (std::size_t a = 0; a < primitive.attributes.size(); ++a) {
      const GltfAttribute& attribute = primitive.attributes[a];
      Json& attributes = attribute.target ? json["targets"][*attribute.target] : json["attributes"];
      attributes[attribute.name] = add_attribute(attribute, vertices, a, buffer);
    }
    std::optional<std::size_t> old_indices;
    if (member(json, "indices"))
      old_indices = count_of(json, "indices");
    json["indices"] = add_indices(vertices, old_indices, buffer);
    if (member(json, "mode"))
      json["mode"] = std::size_t{4}; // triangles, one by one
  }

  std::size_t add_attribute(const GltfAttribute& attribute, const GltfVertices& vertices,
                            std::size_t number, std::size_t buffer) {
    const std::size_t old = attribute.elements.index();
    const ElementType& type = attribute.written;
    const std::string& bytes = vertices.column(number);
    const std::size_t stride = vertices.stride(number);
    Json view = new_view(buffer_of(old, buffer), of_vertices);
    if (stride != type.size())
      view["byteStride"] = stride;
    Json accessor = old_accessors_[old];
    const bool are_unsaid = !member(accessor, "bufferView") && !member(accessor, "sparse") &&
                            bytes.find_first_not_of('\0') == std::string::npos;
    for (const char* const key : {"sparse", "byteOffset"})
      accessor.erase(key);
    if (type.component.code != attribute.elements.type().component.code) {
      accessor["componentType"] = type.component.code;
      accessor.erase("normalized");
    }
    if (!are_unsaid) // zeros need no bytes, and normals that are none are none then as well
      accessor["bufferView"] = add_view(std::move(view), bytes);
    accessor["count"] = vertices.size();
    if (attribute.kind == AttributeKind::position || member(accessor, "min") ||
        member(accessor, "max"))
      set_range(accessor, type, bytes, stride);
    return add_accessor(std::move(accessor), old);
  }

  static void set_range(Json& accessor, const ElementType& type, const std::string& bytes,
                        std::size_t stride) {
    accessor["min"] = accessor["max"] = Json::array();
    for (std::size_t c = 0; c < type.components; ++c) {
      double least = std::numeric_limits<double>::max(), greatest = -least;
      for (std::size_t at = c * type.component.size; at < bytes.size(); at += stride) {
        least = std::min(least, type.stored_at(bytes, at));
        greatest = std::max(greatest, type.stored_at(bytes, at));
      }
      for (const auto& [key, value] : {std::pair("min", least), std::pair("max", greatest)})
        accessor[key].push_back(type.component.is_float ? Json(value)
                                                        : Json(static_cast<std::int64_t>(value)));
    }
  }

  std::size_t add_indices(const GltfVertices& vertices, std::optional<std::size_t> old,
                          std::size_t buffer) {
    Json accessor = old ? old_accessors_[*old] : Json::object();
    for (const char* const key : {"sparse", "byteOffset", "min", "max"})
      accessor.erase(key);
    accessor["componentType"] = index_type(vertices.size(), accessor);
    accessor["type"] = "SCALAR";
    accessor["count"] = vertices.corners().size();
    const ElementType type(accessor);
    std::string bytes;
    for (const std::uint32_t corner : vertices.corners())
      type.append(corner, bytes);
    accessor["bufferView"] =
        add_view(new_view(old ? buffer_of(*old, buffer) : buffer, of_indices), std::move(bytes));
    return add_accessor(std::move(accessor), old);
  }

  /// The smallest type that can count so many vertices; bytes, which not all hardware takes, only
  /// where the old indices were bytes. The greatest number of a type stands for no vertex.
  static Type index_type(std::size_t vertices, const Json& old) {
    if (vertices <= 255 && count_of(old, "componentType", unsigned_int) == unsigned_byte)
      return unsigned_byte;
    return vertices <= 65535 ? unsigned_short : unsigned_int;
  }

  /// The buffer that an old accessor was in; `otherwise`, if it was in none.
  std::size_t buffer_of(std::size_t accessor, std::size_t otherwise) const {
    if (!member(old_accessors_[accessor], "bufferView"))
      return otherwise;
    return old_buffers_[count_of(old_accessors_[accessor], "bufferView")];
  }

  static Json new_view(std::size_t buffer, ViewTarget target) {
    Json view;
    view["buffer"] = buffer;
    view["byteOffset"] = 0;
    view["byteLength"] = 0;
    view["target"] = static_cast<int>(target);
    return view;
  }

  std::size_t add_view(Json view, std::string bytes) {
    const std::size_t number = put(json_["bufferViews"], std::move(view), free_views_, {});
    new_bytes_.emplace(number, std::move(bytes));
    return number;
  }
  std::size_t add_accessor(Json accessor, std::optional<std::size_t> old) {
    return put(json_["accessors"], std::move(accessor), free_accessors_, old);
  }

  /// Puts an element where one is free, there where the old one was if it is; else at the end.
  static std::size_t put(Json& array, Json element, NumberSet& free,
                         std::optional<std::size_t> old) {
    if (free.empty()) {
      array.push_back(std::move(element));
      return array.size() - 1;
    }
    const auto place = old && free.contains(*old) ? free.find(*old) : free.begin();
    const std::size_t number = *place;
    free.erase(place);
    array[number] = std::move(element);
    return number;
  }

  /// Numbers that nothing has taken are left out at the end of an array; before that they get the
  /// least that is allowed.
  void fill_gaps() {
    fill_gaps(json_["accessors"], free_accessors_,
              {{"componentType", std::size_t{unsigned_byte}}, {"count", 1}, {"type", "SCALAR"}});
    fill_gaps(json_["bufferViews"], free_views_,
              {{"buffer", 0}, {"byteOffset", 0}, {"byteLength", 1}});
  }
  static void fill_gaps(Json& array, NumberSet& free, const Json& filling) {
    for (; free.contains(array.size() - 1); array.erase(array.size() - 1))
      free.erase(array.size() - 1);
    for (const std::size_t number : free)
      array[number] = filling;
  }

  Json& json_;
  const Json old_accessors_;
  std::vector<std::size_t> old_buffers_ = buffers_of_views(); // of the old buffer views
  NumberSet free_accessors_, free_views_;
  NewViewBytes new_bytes_;

  std::vector<std::size_t> buffers_of_views() const {
    std::vector<std::size_t> buffers;
    for_each_element(json_, "bufferViews",
                     [&](const Json& view) { buffers.push_back(count_of(view, "buffer")); });
    return buffers;
  }
};

} // namespace quadrille_examples

#endif
