#ifndef QUADRILLE_EXAMPLES_GLTF_MESHOPT_COMPRESSION_H
#define QUADRILLE_EXAMPLES_GLTF_MESHOPT_COMPRESSION_H

#include "accessor.h"
#include "document.h"
#include "extensions.h"
#include "json.h"
#include "uses.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace quadrille_examples {

inline std::vector<unsigned> indices_of(const GltfDocument& document, std::size_t accessor) {
  const Elements elements(document, accessor);
  std::vector<unsigned> indices;
  for (std::size_t i = 0; i < elements.size(); ++i)
    indices.push_back(static_cast<unsigned>(elements.stored(i, 0)));
  return indices;
}

/// Puts triangles and vertices, where they lie, in an order in which neighbours are close to each
/// other. So the codec, which tells what differs from the one before, has less to tell.
class MeshoptOrder {
public:
  /// Of a document of one buffer.
  static void sort(GltfDocument& document, const GltfUses& uses) {
    MeshoptOrder order(document, uses);
    for (const auto& [vertices, group] : order.groups())
      if (order.is_fit(group))
        order.sort(group);
  }

private:
  /// Primitives of the same vertices.
  struct Group {
    std::vector<std::size_t> vertices; // accessors
    std::set<std::size_t> indices;     // accessors
    bool are_triangles = true;
  };

  MeshoptOrder(GltfDocument& document, const GltfUses& uses) : document_(document), uses_(uses) {}

  std::map<std::string, Group> groups() {
    std::map<std::string, Group> groups;
    for_each_element(document_.json, "meshes", [&](const Json& mesh) {
      for_each_element(mesh, "primitives", [&](const Json& primitive) { add(primitive, groups); });
    });
    for (const auto& [vertices, group] : groups)
      for (const std::size_t accessor : group.vertices)
        ++groups_of_[accessor];
    return groups;
  }

  static void add(const Json& primitive, std::map<std::string, Group>& groups) {
    Group one;
    std::string key;
    const auto use = [&](const Json& attributes) {
      key += attributes.dump();
      for (const std::size_t accessor : GltfUses::accessors_of(attributes))
        one.vertices.push_back(accessor);
    };
    if (const Json* const attributes = member(primitive, "attributes"))
      use(*attributes);
    for_each_element(primitive, "targets", use);
    Group& group = groups.try_emplace(key, one).first->second;
    if (member(primitive, "indices"))
      group.indices.insert(count_of(primitive, "indices"));
    group.are_triangles &= member(primitive, "indices") && count_of(primitive, "mode", 4) == 4;
  }

  bool is_fit(const Group& group) const {
    const auto has_place = [&](std::size_t accessor, GltfUses::Kind kind) {
      const Json& json = element_of(document_.json, "accessors", accessor);
      return uses_.kind(accessor) == kind && member(json, "bufferView") &&
             uses_.users_of_view(count_of(json, "bufferView")).size() == 1;
    };
    return group.are_triangles && !group.vertices.empty() &&
           std::all_of(group.vertices.begin(), group.vertices.end(),
                       [&](std::size_t accessor) {
                         return has_place(accessor, GltfUses::Kind::vertices) &&
                                groups_of_.at(accessor) == 1 &&
                                count(accessor) == count(group.vertices.front());
                       }) &&
           std::all_of(group.indices.begin(), group.indices.end(), [&](std::size_t accessor) {
             return has_place(accessor, GltfUses::Kind::indices) && count(accessor) % 3 == 0;
           });
  }

  std::size_t count(std::size_t accessor) const {
    return count_of(element_of(document_.json, "accessors", accessor), "count");
  }

  void sort(const Group& group) {
    const std::size_t vertices = count(group.vertices.front());
    std::vector<unsigned> all;
    std::map<std::size_t, std::vector<unsigned>> indices;
    for (const std::size_t accessor : group.indices) {
      std::vector<unsigned>& own = indices[accessor] = indices_of(document_, accessor);
      if (*std::max_element(own.begin(), own.end()) >= vertices)
        return;
      meshopt_optimizeVertexCacheStrip(own.data(), std::vector(own).data(), own.size(), vertices);
      all.insert(all.end(), own.begin(), own.end());
    }
    std::vector<unsigned> numbers(vertices);
    auto next = static_cast<unsigned>(
        meshopt_optimizeVertexFetchRemap(numbers.data(), all.data(), all.size(), vertices));
    for (unsigned& number : numbers)
      if (number == ~0U) // nothing uses it
        number = next++;
    for (const auto& [accessor, own] : indices)
      write(accessor, own, numbers);
    for (const std::size_t accessor : std::set(group.vertices.begin(), group.vertices.end()))
      move(accessor, numbers);
  }

  /// Where the elements of an accessor begin in the buffer, and how far they are apart.
  std::pair<std::size_t, std::size_t> place_of(std::size_t accessor) const {
    const Json& json = element_of(document_.json, "accessors", accessor);
    const Json& view = element_of(document_.json, "bufferViews", count_of(json, "bufferView"));
    return {count_of(view, "byteOffset", 0) + count_of(json, "byteOffset", 0),
            count_of(view, "byteStride", ElementType(json).size())};
  }

  void write(std::size_t accessor, const std::vector<unsigned>& indices,
             const std::vector<unsigned>& numbers) {
    const auto [offset, stride] = place_of(accessor);
    std::string bytes;
    for (const unsigned index : indices)
      ElementType(element_of(document_.json, "accessors", accessor)).append(numbers[index], bytes);
    document_.buffers.front().replace(offset, bytes.size(), bytes);
  }

  void move(std::size_t accessor, const std::vector<unsigned>& numbers) {
    const auto [offset, stride] = place_of(accessor);
    const std::size_t size = ElementType(element_of(document_.json, "accessors", accessor)).size();
    const std::string old =
        document_.buffers.front().substr(offset, (numbers.size() - 1) * stride + size);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      document_.buffers.front().replace(offset + numbers[i] * stride, size, old, i * stride, size);
  }

  GltfDocument& document_;
  const GltfUses& uses_;
  std::map<std::size_t, std::size_t> groups_of_; // how many, of accessors of vertices
};

/// Puts the bytes of buffer views, compressed, into the buffer of the document, and their places
/// into a second one that has no bytes: decoders fill it.
class MeshoptCompression {
public:
  static void compress(GltfDocument& document) {
    if (document.buffers.empty())
      return;
    if (document.buffers.size() > 1)
      unite_buffers(document);
    meshopt_encodeVertexVersion(0); // the extension knows no other
    meshopt_encodeIndexVersion(1);
    MeshoptCompression(document).run();
  }

private:
  static constexpr const char* name = "EXT_meshopt_compression";

  struct Encoded {
    const char* mode;
    std::size_t count, stride;
    std::string bytes;
  };

  explicit MeshoptCompression(GltfDocument& document)
      : document_(document), json_(document.json), uses_(document.json) {}

  void run() {
    MeshoptOrder::sort(document_, uses_);
    std::string packed;
    std::size_t decoded = 0; // bytes of the second buffer
    for (std::size_t i = 0; i < size_of(json_, "bufferViews"); ++i) {
      Json& view = json_["bufferViews"][i];
      const std::string bytes(bytes_of_view(document_, i));
      std::optional<Encoded> encoded = encode(i, bytes);
      const bool is_smaller = encoded && encoded->bytes.size() < bytes.size();
      align(packed, is_smaller ? 4 : 8);
      if (is_smaller) {
        view["extensions"][name] = {{"buffer", 0},
                                    {"byteOffset", packed.size()},
                                    {"mode", encoded->mode},
                                    {"byteLength", encoded->bytes.size()},
                                    {"count", encoded->count},
                                    {"byteStride", encoded->stride}};
        decoded = (decoded + 7) / 8 * 8;
        view["buffer"] = 1;
        view["byteOffset"] = decoded;
        decoded += bytes.size();
      } else {
        view["byteOffset"] = packed.size();
      }
      packed += is_smaller ? encoded->bytes : bytes;
    }
    if (decoded > 0)
      finish(std::move(packed), decoded);
  }

  static void align(std::string& bytes, std::size_t alignment) {
    bytes.resize((bytes.size() + alignment - 1) / alignment * alignment, '\0');
  }

  void finish(std::string packed, std::size_t decoded) {
    document_.buffers.front() = std::move(packed);
    Json without_bytes = {{"byteLength", decoded}};
    without_bytes["extensions"][name] = {{"fallback", true}};
    json_["buffers"].push_back(std::move(without_bytes));
    list_extension(json_, "extensionsUsed", name);
    list_extension(json_, "extensionsRequired", name);
  }

  /// Nothing for views that are no arrays of one stride.
  std::optional<Encoded> encode(std::size_t number, const std::string& bytes) const {
    const std::vector<std::size_t> users = uses_.users_of_view(number);
    const Json& view = element_of(json_, "bufferViews", number);
    std::set<std::size_t> sizes;
    bool are_indices = !users.empty();
    for (const std::size_t user : users) {
      const Json& accessor = element_of(json_, "accessors", user);
      sizes.insert(size_of_element(accessor));
      are_indices &= uses_.kind(user) == GltfUses::Kind::indices;
    }
    if (sizes.empty() || (sizes.size() > 1 && !member(view, "byteStride")))
      return std::nullopt;
    const std::size_t stride = count_of(view, "byteStride", *sizes.begin());
    if (are_indices && users.size() == 1)
      return encode_indices(users.front(), bytes, stride);
    if (stride % 4 != 0 || stride == 0 || stride > 256 || bytes.size() % stride != 0)
      return std::nullopt;
    return encode_vertices(bytes, stride);
  }

  static std::size_t size_of_element(const Json& accessor) {
    const std::string type = text_of(accessor, "type");
    if (type.starts_with("MAT"))
      return type == "MAT4" ? 16 * component_type(accessor).size : 0;
    return ElementType(accessor).size();
  }

  static Encoded encode_vertices(const std::string& bytes, std::size_t stride) {
    Encoded encoded{"ATTRIBUTES", bytes.size() / stride, stride, ""};
    encoded.bytes.resize(meshopt_encodeVertexBufferBound(encoded.count, stride));
    encoded.bytes.resize(meshopt_encodeVertexBuffer(data(encoded.bytes), encoded.bytes.size(),
                                                    bytes.data(), encoded.count, stride));
    return encoded;
  }

  /// Of triangles, whose corners may come in another order, but the same way round.
  std::optional<Encoded> encode_indices(std::size_t accessor, const std::string& bytes,
                                        std::size_t stride) const {
    const std::vector<unsigned> indices = indices_of(document_, accessor);
    if ((stride != 2 && stride != 4) || indices.size() % 3 != 0 ||
        indices.size() * stride != bytes.size())
      return std::nullopt;
    const unsigned greatest = *std::max_element(indices.begin(), indices.end());
    Encoded encoded{"TRIANGLES", indices.size(), stride, ""};
    encoded.bytes.resize(meshopt_encodeIndexBufferBound(indices.size(), std::size_t{greatest} + 1));
    encoded.bytes.resize(meshopt_encodeIndexBuffer(data(encoded.bytes), encoded.bytes.size(),
                                                   indices.data(), indices.size()));
    return encoded;
  }

  static unsigned char* data(std::string& bytes) {
    return reinterpret_cast<unsigned char*>(bytes.data());
  }

  GltfDocument& document_;
  Json& json_;
  GltfUses uses_;
};

} // namespace quadrille_examples

#endif
