#include "decompression.h"

#include "accessor.h"
#include "document.h"
#include "extensions.h"
#include "json.h"

#ifdef QUADRILLE_WITH_DRACO
#include <draco/compression/decode.h>
#include <draco/mesh/mesh.h>
#endif
#ifdef QUADRILLE_WITH_MESHOPT
#include <meshoptimizer.h>
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quadrille_examples {

namespace {

constexpr const char* draco_name = "KHR_draco_mesh_compression";
constexpr const char* meshopt_names[] = {"EXT_meshopt_compression", "KHR_meshopt_compression"};

[[noreturn, maybe_unused]] void refuse(const std::string& library, const std::string& tool) {
  throw std::runtime_error("it is compressed, and this program was built without " + library +
                           ", which reading it needs; decompress it first: " + tool);
}

/// Does something, and tells what is wrong of an extension.
template <class Work>
void with_errors_of_extension(const std::string& name, Work work) {
  try {
    work();
  } catch (const Json::exception& error) {
    throw std::runtime_error(name + ": " + error.what());
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(name + ": " + error.what());
  }
}

// --- meshoptimizer -------------------------------------------------------------------------------

#ifdef QUADRILLE_WITH_MESHOPT
void decode_view(std::string& decoded, std::string_view bytes, const Json& how, std::size_t count,
                 std::size_t stride) {
  const auto* const data = reinterpret_cast<const unsigned char*>(bytes.data());
  const std::string mode = text_of(how, "mode"), filter = text_of(how, "filter");
  int status = -1;
  if (mode == "ATTRIBUTES" && stride % 4 == 0 && stride > 0 && stride <= 256)
    status = meshopt_decodeVertexBuffer(decoded.data(), count, stride, data, bytes.size());
  else if (mode == "TRIANGLES" && count % 3 == 0 && (stride == 2 || stride == 4))
    status = meshopt_decodeIndexBuffer(decoded.data(), count, stride, data, bytes.size());
  else if (mode == "INDICES" && (stride == 2 || stride == 4))
    status = meshopt_decodeIndexSequence(decoded.data(), count, stride, data, bytes.size());
  if (status != 0)
    throw std::runtime_error("compressed bytes of mode '" + mode + "' cannot be decoded");
  if (filter == "OCTAHEDRAL" && (stride == 4 || stride == 8))
    meshopt_decodeFilterOct(decoded.data(), count, stride);
  else if (filter == "QUATERNION" && stride == 8)
    meshopt_decodeFilterQuat(decoded.data(), count, stride);
  else if (filter == "EXPONENTIAL" && stride % 4 == 0)
    meshopt_decodeFilterExp(decoded.data(), count, stride);
  else if (!filter.empty() && filter != "NONE")
    throw std::runtime_error("a filter '" + filter + "' of compressed bytes is unknown");
}
#endif

/// Puts the bytes of a compressed view where it says that they are, uncompressed.
void decode_view([[maybe_unused]] GltfDocument& document, [[maybe_unused]] Json& view,
                 [[maybe_unused]] const char* name) {
#ifdef QUADRILLE_WITH_MESHOPT
  const Json how = *extension_of(view, name);
  const std::string bytes(bytes_of_range(document, how, "a compressed buffer view"));
  const std::size_t count = count_of(how, "count"), stride = count_of(how, "byteStride");
  const std::size_t offset = count_of(view, "byteOffset", 0), buffer = count_of(view, "buffer");
  const std::size_t most = 256 * (bytes.size() + 64); // it packs no tighter
  if (stride > 256 || count > most || count * stride > most ||
      count * stride > count_of(view, "byteLength") || buffer >= document.buffers.size() ||
      offset > std::numeric_limits<std::uint32_t>::max())
    throw std::runtime_error("a compressed buffer view has inconsistent sizes");
  std::string decoded(count * stride, '\0');
  decode_view(decoded, bytes, how, count, stride);
  std::string& target = document.buffers[buffer];
  target.resize(std::max(target.size(), offset + count_of(view, "byteLength")), '\0');
  target.replace(offset, decoded.size(), decoded);
  erase_extension(view, name);
#else
  refuse("libmeshoptimizer", "gltfpack -noq -i IN -o OUT");
#endif
}

void decode_views(GltfDocument& document) {
  for (const char* const name : meshopt_names) {
    bool has_any = false;
    for (std::size_t i = 0; i < size_of(document.json, "bufferViews"); ++i)
      if (extension_of(element_of(document.json, "bufferViews", i), name)) {
        with_errors_of_extension(
            name, [&] { decode_view(document, document.json["bufferViews"][i], name); });
        has_any = true;
      }
    for (std::size_t i = 0; i < size_of(document.json, "buffers"); ++i)
      if (extension_of(element_of(document.json, "buffers", i), name))
        erase_extension(document.json["buffers"][i], name);
    if (!has_any)
      continue;
    forget_extension(document.json, name);
    document.compression = "meshopt";
  }
}

// --- draco ---------------------------------------------------------------------------------------

#ifdef QUADRILLE_WITH_DRACO
/// Decodes the primitives of a document.
class DracoDecoding {
public:
  explicit DracoDecoding(GltfDocument& document) : document_(document) {}

  void decode(Json& primitive, const Json& how) {
    const std::size_t view = count_of(how, "bufferView");
    const draco::Mesh& mesh = mesh_of(view);
    const Json* const ids = member(how, "attributes");
    if (!ids || !member(primitive, "attributes"))
      throw std::runtime_error("a compressed primitive has no 'attributes'");
    for (const auto& [name, id] : ids->items())
      if (member(primitive["attributes"], name))
        write_attribute(view, mesh, count_of(*ids, name.c_str()),
                        count_of(primitive["attributes"], name.c_str()));
    write_indices(view, mesh, primitive);
    primitive.erase("mode"); // of triangles, whatever it was
  }

private:
  const draco::Mesh& mesh_of(std::size_t view) {
    std::unique_ptr<draco::Mesh>& mesh = meshes_[view];
    if (mesh)
      return *mesh;
    const std::string_view bytes = bytes_of_view(document_, view);
    draco::DecoderBuffer buffer;
    buffer.Init(bytes.data(), bytes.size());
    draco::Decoder decoder;
    auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok())
      throw std::runtime_error(std::string("a primitive compressed by Draco cannot be ") +
                               "decoded: " + decoded.status().error_msg());
    mesh = std::move(decoded).value();
    return *mesh;
  }

  void write_attribute(std::size_t view, const draco::Mesh& mesh, std::size_t id,
                       std::size_t accessor) {
    if (!is_new(view, accessor))
      return;
    const draco::PointAttribute* const attribute =
        mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(id));
    Json& json = json_of(accessor);
    const ElementType type(json);
    if (!attribute || static_cast<std::size_t>(attribute->num_components()) != type.components)
      throw std::runtime_error("an attribute compressed by Draco has another type, or is " +
                               std::string("missing"));
    std::string bytes;
    for (draco::PointIndex point(0); point < mesh.num_points(); ++point) {
      append(*attribute, attribute->mapped_index(point), type, bytes);
      bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
    }
    const std::size_t stride = (type.size() + 3) / 4 * 4;
    put(json, view, mesh.num_points(), std::move(bytes), stride == type.size() ? 0 : stride);
  }

  static void append(const draco::PointAttribute& attribute, draco::AttributeValueIndex value,
                     const ElementType& type, std::string& bytes) {
    switch (type.component.code) {
    case 5120:
      return append_as<std::int8_t>(attribute, value, type, bytes);
    case 5121:
      return append_as<std::uint8_t>(attribute, value, type, bytes);
    case 5122:
      return append_as<std::int16_t>(attribute, value, type, bytes);
    case 5123:
      return append_as<std::uint16_t>(attribute, value, type, bytes);
    case 5125:
      return append_as<std::uint32_t>(attribute, value, type, bytes);
    default:
      return append_as<float>(attribute, value, type, bytes);
    }
  }

  template <class Number>
  static void append_as(const draco::PointAttribute& attribute, draco::AttributeValueIndex value,
                        const ElementType& type, std::string& bytes) {
    std::array<Number, 4> numbers{};
    if (!attribute.ConvertValue<Number>(value, static_cast<std::int8_t>(type.components),
                                        numbers.data()))
      throw std::runtime_error("an attribute compressed by Draco has another type");
    for (std::size_t i = 0; i < type.components; ++i)
      append_little_endian(bytes, numbers[i]);
  }

  void write_indices(std::size_t view, const draco::Mesh& mesh, Json& primitive) {
    if (!member(primitive, "indices")) {
      document_.json["accessors"].push_back({{"type", "SCALAR"}, {"count", 0}});
      primitive["indices"] = document_.json["accessors"].size() - 1;
    }
    const std::size_t accessor = count_of(primitive, "indices");
    if (!is_new(view, accessor))
      return;
    std::string bytes;
    for (draco::FaceIndex face(0); face < mesh.num_faces(); ++face)
      for (int i = 0; i < 3; ++i)
        append_little_endian(bytes, static_cast<std::uint32_t>(
                                        mesh.face(face)[static_cast<std::size_t>(i)].value()));
    Json& json = json_of(accessor);
    json["componentType"] = std::size_t{5125};
    put(json, view, 3 * std::size_t{mesh.num_faces()}, std::move(bytes), 0);
  }

  /// Primitives may share what they have.
  bool is_new(std::size_t view, std::size_t accessor) {
    const auto [place, is_new] = views_.try_emplace(accessor, view);
    if (place->second != view)
      throw std::runtime_error("two primitives compressed by Draco share an accessor");
    return is_new;
  }

  Json& json_of(std::size_t accessor) {
    element_of(document_.json, "accessors", accessor); // is it there?
    return document_.json["accessors"][accessor];
  }

  /// The first of what was compressed in a view takes its number, so that nothing is left of it.
  void put(Json& accessor, std::size_t old_view, std::size_t count, std::string bytes,
           std::size_t stride) {
    if (bytes.empty())
      throw std::runtime_error("a primitive compressed by Draco is empty");
    std::string& buffer = document_.buffers.at(0);
    buffer.resize((buffer.size() + 3) / 4 * 4, '\0');
    Json view = {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}};
    if (stride > 0)
      view["byteStride"] = stride;
    buffer += bytes;
    Json& views = document_.json["bufferViews"];
    const std::size_t number = replaced_views_.insert(old_view).second ? old_view : views.size();
    if (number == views.size())
      views.push_back(Json());
    views[number] = std::move(view);
    accessor["bufferView"] = number;
    accessor["count"] = count;
    accessor.erase("byteOffset");
  }

  GltfDocument& document_;
  std::map<std::size_t, std::unique_ptr<draco::Mesh>> meshes_; // by views
  std::map<std::size_t, std::size_t> views_;                   // of accessors
  std::set<std::size_t> replaced_views_;
};
#endif

void decode_primitives(GltfDocument& document) {
#ifdef QUADRILLE_WITH_DRACO
  DracoDecoding decoding(document);
#endif
  bool has_any = false;
  for (std::size_t mesh = 0; mesh < size_of(document.json, "meshes"); ++mesh)
    for (std::size_t i = 0; i < size_of(element_of(document.json, "meshes", mesh), "primitives");
         ++i) {
      const Json& json = element_of(element_of(document.json, "meshes", mesh), "primitives", i);
      const Json* const how = extension_of(json, draco_name);
      if (!how)
        continue;
      has_any = true;
#ifdef QUADRILLE_WITH_DRACO
      Json& primitive = document.json["meshes"][mesh]["primitives"][i];
      decoding.decode(primitive, Json(*how));
      erase_extension(primitive, draco_name);
#else
      refuse("libdraco", "gltf-pipeline -i IN -o OUT");
#endif
    }
  if (!has_any)
    return;
  forget_extension(document.json, draco_name);
  document.compression = "draco";
}

} // namespace

void decompress(GltfDocument& document) {
  decode_views(document);
  with_errors_of_extension(draco_name, [&] { decode_primitives(document); });
}

} // namespace quadrille_examples
