#ifndef QUADRILLE_TEST_GLTF_ASSETS_H
#define QUADRILLE_TEST_GLTF_ASSETS_H

/// \file
/// Small glTF documents, made here.

#include "../examples/products/mesh_io/gltf/accessor.h"
#include "../examples/products/mesh_io/gltf/document.h"
#include "../examples/products/mesh_io/gltf/json.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace gltf_assets {

using quadrille_examples::Element;
using quadrille_examples::ElementType;
using quadrille_examples::GltfDocument;
using quadrille_examples::Json;

enum Type : std::size_t { signed_short = 5122, unsigned_byte = 5121, unsigned_short = 5123 };
inline constexpr std::size_t unsigned_int = 5125, single = 5126;

/// A document with one mesh, in one buffer, to which accessors and primitives are added.
class Asset {
public:
  Asset() {
    json_ = Json::parse(R"({
      "asset": {"version": "2.0", "copyright": "nobody", "extras": {"large": 12345678901234567}},
      "extensionsUsed": ["VENDOR_unknown"],
      "extensions": {"VENDOR_unknown": {"empty": {}, "list": [null, 0.1, -3, true]}},
      "scene": 0, "scenes": [{"nodes": [0, 1]}],
      "nodes": [{"mesh": 0, "extras": "kept"}, {"mesh": 0, "translation": [3, 0, 0]}],
      "cameras": [{"type": "perspective", "perspective": {"yfov": 0.8, "znear": 0.1}}],
      "materials": [{"name": "red", "extensions": {"KHR_materials_unlit": {}}}, {"name": "blue"}],
      "images": [{"uri": "a%20picture.png"}, {"mimeType": "image/png"}],
      "meshes": [{"name": "ball", "extras": 7, "primitives": []}],
      "accessors": [], "bufferViews": [], "buffers": [{"name": "all", "byteLength": 0}]})");
    json_["images"][1]["bufferView"] = add_view(picture);
  }

  Json& json() { return json_; }
  Json& primitive(std::size_t i) { return json_["meshes"][0]["primitives"][i]; }

  std::size_t add_view(const std::string& content) {
    bytes_.resize((bytes_.size() + 3) / 4 * 4);
    json_["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", content.size()}});
    bytes_ += content;
    return json_["bufferViews"].size() - 1;
  }

  /// An accessor of vectors of `components` numbers, which are stored in a type. Those of integers
  /// for which `is_normalized` mean fractions.
  std::size_t add(const std::vector<Element>& elements, std::size_t components,
                  std::size_t type = single, bool is_normalized = false) {
    Json accessor = {{"componentType", type},
                     {"type", std::array{"SCALAR", "VEC2", "VEC3", "VEC4"}[components - 1]},
                     {"count", elements.size()}};
    if (is_normalized)
      accessor["normalized"] = true;
    const ElementType stored(accessor);
    const std::size_t stride = (stored.size() + 3) / 4 * 4;
    std::string content;
    for (const Element& element : elements) {
      const std::size_t end = content.size() + (elements.size() > 1 ? stride : stored.size());
      for (std::size_t c = 0; c < components; ++c)
        stored.append(stored.stored(element[c]), content);
      content.resize(end, '\0');
    }
    accessor["bufferView"] = add_view(content);
    if (stride != stored.size())
      json_["bufferViews"].back()["byteStride"] = stride;
    json_["accessors"].push_back(accessor);
    return json_["accessors"].size() - 1;
  }

  std::size_t add_indices(const std::vector<std::uint32_t>& indices,
                          std::size_t type = unsigned_int) {
    Json accessor = {{"componentType", type}, {"type", "SCALAR"}, {"count", indices.size()}};
    std::string content;
    for (const std::uint32_t index : indices)
      ElementType(accessor).append(index, content);
    accessor["bufferView"] = add_view(content);
    json_["accessors"].push_back(accessor);
    return json_["accessors"].size() - 1;
  }

  GltfDocument document() const {
    GltfDocument document{json_, {bytes_}};
    document.json["buffers"][0]["byteLength"] = bytes_.size();
    return document;
  }
  std::string glb() const { return encode_glb(document()); }
  std::string gltf() const { return encode_gltf(document()); }
  const std::string& bytes() const { return bytes_; }

  static constexpr const char* picture = "not really a picture";

private:
  Json json_;
  std::string bytes_;
};

/// Vertices of a side of a ball, split from those of the other sides, and its triangles.
struct Side {
  std::vector<Element> positions, textures;
  std::vector<std::uint32_t> corners;
};

/// A side of a cube of n × n quadrilaterals, blown up to a ball of radius 1.
inline Side side_of_ball(std::size_t number, std::uint32_t n) {
  const auto at = [&](std::uint32_t i) { return 2. * i / n - 1; };
  const double sign = number % 2 == 0 ? 1 : -1;
  Side side;
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= n; ++j) {
      Element p{};
      p[number / 2] = sign;
      p[(number / 2 + 1) % 3] = sign * at(i);
      p[(number / 2 + 2) % 3] = at(j);
      // Sums of squares in one order, so that sides meet exactly.
      const double length = std::sqrt(1 + (p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - 1));
      for (double& x : p)
        x = static_cast<float>(x / length) + 0.F;
      side.positions.push_back(p);
      const double chart = static_cast<double>(number);
      side.textures.push_back({(chart + 0.1 + 0.8 * i / n) / 6, 0.1 + 0.8 * j / n});
    }
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t v = i * (n + 1) + j;
      for (const std::uint32_t corner : {v, v + n + 1, v + n + 2, v, v + n + 2, v + 1})
        side.corners.push_back(corner);
    }
  return side;
}

/// Three sides each as the vertices of one primitive.
inline Side half_of_ball(std::size_t half, std::uint32_t n) {
  Side sum;
  for (std::size_t number = 3 * half; number < 3 * half + 3; ++number) {
    const Side side = side_of_ball(number, n);
    for (const std::uint32_t corner : side.corners)
      sum.corners.push_back(corner + static_cast<std::uint32_t>(sum.positions.size()));
    sum.positions.insert(sum.positions.end(), side.positions.begin(), side.positions.end());
    sum.textures.insert(sum.textures.end(), side.textures.begin(), side.textures.end());
  }
  return sum;
}

/// The same with a vertex for each corner.
inline Side unindexed(const Side& side) {
  Side result;
  for (const std::uint32_t corner : side.corners) {
    result.corners.push_back(static_cast<std::uint32_t>(result.corners.size()));
    result.positions.push_back(side.positions[corner]);
    result.textures.push_back(side.textures[corner]);
  }
  return result;
}

template <class Value>
std::vector<Element> elements_of(const std::vector<Element>& positions, Value value) {
  std::vector<Element> result;
  for (const Element& p : positions)
    result.push_back(value(p));
  return result;
}

/// A ball of two materials that is textured and has normals; one half has tangents, colours and an
/// attribute of its own as well.
inline Asset ball(std::uint32_t n = 8, bool is_indexed = true) {
  Asset asset;
  for (std::size_t half = 0; half < 2; ++half) {
    const Side side = is_indexed ? half_of_ball(half, n) : unindexed(half_of_ball(half, n));
    Json primitive = {{"material", half}};
    Json& attributes = primitive["attributes"];
    attributes["POSITION"] = asset.add(side.positions, 3);
    attributes["NORMAL"] = asset.add(side.positions, 3);
    attributes["TEXCOORD_0"] = asset.add(side.textures, 2);
    if (half == 0) {
      attributes["TANGENT"] = asset.add(
          elements_of(
              side.positions,
              [](const Element& p) {
                const double l = std::hypot(p[0], p[1]);
                const double sign = p[2] > 0.3 ? 1 : -1;
                return l > 0 ? Element{-p[1] / l, p[0] / l, 0, sign} : Element{1, 0, 0, sign};
              }),
          4);
      attributes["COLOR_0"] =
          asset.add(elements_of(side.positions,
                                [](const Element& p) {
                                  return Element{(1 + p[0]) / 2, (1 + p[1]) / 2, 0, 1};
                                }),
                    4, unsigned_byte, true);
      attributes["_HEAT"] =
          asset.add(elements_of(side.positions, [](const Element& p) { return Element{p[2]}; }), 1);
      attributes["_PART"] = asset.add(
          elements_of(side.positions, [](const Element& p) { return Element{p[2] > 0 ? 3. : 5.}; }),
          1, unsigned_short);
    }
    if (is_indexed)
      primitive["indices"] = asset.add_indices(side.corners);
    asset.json()["meshes"][0]["primitives"].push_back(primitive);
  }
  return asset;
}

/// A wavy sheet as one strip, of integers in 16 bits.
inline Asset strip(std::uint32_t n = 12) {
  Asset asset;
  std::vector<Element> positions, textures;
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= n; ++j) {
      positions.push_back({100. * i, 100. * j, std::round(40 * std::sin(i * j / 9.))});
      textures.push_back({double(i) / n, double(j) / n});
    }
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < n; ++i) {
    if (!corners.empty())
      corners.insert(corners.end(), {corners.back(), i * (n + 1)});
    for (std::uint32_t j = 0; j <= n; ++j)
      corners.insert(corners.end(), {i * (n + 1) + j, (i + 1) * (n + 1) + j});
  }
  Json primitive = {{"mode", 5}};
  primitive["attributes"]["POSITION"] = asset.add(positions, 3, signed_short);
  primitive["attributes"]["TEXCOORD_0"] = asset.add(textures, 2, unsigned_short, true);
  primitive["indices"] = asset.add_indices(corners, unsigned_short);
  asset.json()["extensionsRequired"] = {"KHR_mesh_quantization"};
  asset.json()["meshes"][0]["primitives"].push_back(primitive);
  return asset;
}

} // namespace gltf_assets

#endif
