// Levels of detail in glTF documents (MSFT_lod): which meshes and nodes are added, and that the
// document is sound, by a look at it that shares nothing with what wrote it.

#if __has_include(<nlohmann/json.hpp>)

#include "../examples/products/mesh_io/gltf.h"
#include "folder.h"
#include "gltf_assets.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace quadrille_examples;
using namespace gltf_assets;
using test::Folder;

namespace {

using Surfaces = std::vector<GltfSurface>;
using Ids = std::vector<std::size_t>;

void simplify_to(Surfaces& surfaces, const GltfMeshes& meshes, double ratio) {
  GltfSceneSurface(surfaces, meshes.placements()).simplify({.ratio = ratio}, {});
}

GltfDocument read(const std::string& content) {
  const Source source{"document", content};
  return GltfReader(source).read();
}

/// The document with levels of such parts of its faces, written and read again.
GltfDocument with_levels(const Asset& asset, const std::vector<double>& ratios,
                         const std::string& extension = ".glb") {
  const Folder folder;
  GltfMeshes meshes = GltfMeshes::read(folder.file("in", asset.glb()));
  meshes.require_fit_for_levels();
  std::vector<Surfaces> levels;
  for (const double ratio : ratios) {
    levels.push_back(meshes.surfaces());
    simplify_to(levels.back(), meshes, ratio);
  }
  write_gltf(folder.path("out"), meshes.take_with(std::move(levels)), extension);
  return read(read_content(folder.path("out")));
}

/// The same document, simplified as a whole.
GltfDocument simplified(const Asset& asset, double ratio) {
  const Folder folder;
  GltfMeshes meshes = GltfMeshes::read(folder.file("in", asset.glb()));
  simplify_to(meshes.surfaces(), meshes, ratio);
  return meshes.take();
}

/// The corners of all primitives of a mesh, by the bytes of all of their attributes.
std::vector<std::vector<Element>> corners_of(const GltfDocument& document, std::size_t mesh) {
  std::vector<std::vector<Element>> corners;
  for (std::size_t i = 0; i < document.json["meshes"][mesh]["primitives"].size(); ++i) {
    const GltfPrimitive primitive = PrimitiveReader::read(document, mesh, i).value();
    for (const auto& triangle : primitive.triangles)
      for (const std::uint32_t v : triangle) {
        std::vector<Element>& corner = corners.emplace_back();
        for (const GltfAttribute& attribute : primitive.attributes)
          corner.push_back(attribute.elements[v]);
      }
  }
  return corners;
}
std::size_t face_count(const GltfDocument& document, std::size_t mesh) {
  return corners_of(document, mesh).size() / 3;
}

Ids ids_of(const Json& node) {
  return node.at("extensions").at("MSFT_lod").at("ids").get<Ids>();
}
bool has_levels(const Json& node) {
  return node.contains("extensions") && node["extensions"].contains("MSFT_lod");
}

// --- Is a document sound?
// --------------------------------------------------------------------------

std::size_t size_of_element(const Json& accessor) {
  static const std::map<std::size_t, std::size_t> bytes{{5120, 1}, {5121, 1}, {5122, 2},
                                                        {5123, 2}, {5125, 4}, {5126, 4}};
  static const std::map<std::string, std::size_t> components{
      {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
  return bytes.at(accessor["componentType"]) * components.at(accessor["type"]);
}

void require_bytes(const GltfDocument& document) {
  const Json& json = document.json;
  REQUIRE(json["buffers"].size() == document.buffers.size());
  for (std::size_t b = 0; b < document.buffers.size(); ++b)
    CHECK(json["buffers"][b]["byteLength"] == document.buffers[b].size());
  for (const Json& view : json["bufferViews"]) {
    REQUIRE(view["buffer"].get<std::size_t>() < document.buffers.size());
    REQUIRE(view["byteLength"].get<std::size_t>() >= 1);
    REQUIRE(view.value("byteOffset", std::size_t{0}) + view["byteLength"].get<std::size_t>() <=
            document.buffers[view["buffer"].get<std::size_t>()].size());
  }
  for (const Json& accessor : json["accessors"]) {
    REQUIRE(accessor["count"].get<std::size_t>() >= 1);
    const Json& view = json["bufferViews"].at(accessor["bufferView"].get<std::size_t>());
    const std::size_t size = size_of_element(accessor);
    const std::size_t stride = view.value("byteStride", size);
    const std::size_t offset = accessor.value("byteOffset", std::size_t{0});
    CHECK((view.value("byteOffset", std::size_t{0}) + offset) % 4 == 0);
    REQUIRE(offset + stride * (accessor["count"].get<std::size_t>() - 1) + size <=
            view["byteLength"].get<std::size_t>());
  }
}

/// Of those from a number on, which are new, positions have limits.
void require_meshes(const GltfDocument& document, std::size_t first_new) {
  const Json& json = document.json;
  for (std::size_t mesh = 0; mesh < json["meshes"].size(); ++mesh) {
    for (const Json& primitive : json["meshes"][mesh]["primitives"]) {
      const Json& attributes = primitive["attributes"];
      const Json& positions = json["accessors"].at(attributes["POSITION"].get<std::size_t>());
      CHECK((mesh < first_new || (positions.contains("min") && positions.contains("max"))));
      for (const auto& [name, index] : attributes.items())
        CHECK(json["accessors"].at(index.get<std::size_t>())["count"] == positions["count"]);
      CHECK(primitive.value("material", std::size_t{0}) < json["materials"].size());
    }
    CHECK(face_count(document, mesh) > 0); // which reads all indices, and checks them
  }
}

/// A node has one parent at most, and one that stands for another none.
void require_nodes(const Json& json) {
  std::map<std::size_t, int> parents;
  std::set<std::size_t> levels;
  const std::size_t count = json["nodes"].size();
  for (const Json& node : json["nodes"]) {
    if (node.contains("children"))
      for (const Json& child : node["children"])
        ++parents[child.get<std::size_t>()];
    if (node.contains("mesh"))
      CHECK(node["mesh"].get<std::size_t>() < json["meshes"].size());
    if (node.contains("skin"))
      CHECK((node.contains("mesh") && node["skin"].get<std::size_t>() < json["skins"].size()));
    if (has_levels(node))
      for (const std::size_t level : ids_of(node))
        CHECK(levels.insert(level).second);
  }
  for (const Json& scene : json["scenes"])
    for (const Json& root : scene["nodes"])
      ++parents[root.get<std::size_t>()];
  for (const auto& [node, number] : parents) {
    CHECK(node < count);
    CHECK(number == 1);
    CHECK(!levels.contains(node));
  }
  for (const std::size_t level : levels) {
    REQUIRE(level < count);
    CHECK(json["nodes"][level].contains("mesh"));
    CHECK(!json["nodes"][level].contains("children"));
  }
}

void require_animations(const Json& json) {
  if (!json.contains("animations"))
    return;
  for (const Json& animation : json["animations"]) {
    std::set<std::string> targets;
    for (const Json& channel : animation["channels"]) {
      CHECK(channel["sampler"].get<std::size_t>() < animation["samplers"].size());
      CHECK(targets.insert(channel["target"].dump()).second);
      if (channel["target"].value("path", "") != "weights")
        continue;
      CHECK(json["nodes"].at(channel["target"]["node"].get<std::size_t>()).contains("mesh"));
    }
  }
}

void require_sound(const GltfDocument& document) {
  require_bytes(document);
  require_meshes(document, 1);
  require_nodes(document.json);
  require_animations(document.json);
}

/// Joints and weights for both halves of a ball of one skin, and two displacements.
Asset rigged_ball() {
  Asset asset = ball(6);
  for (std::size_t half = 0; half < 2; ++half) {
    const std::vector<Element> positions = half_of_ball(half, 6).positions;
    Json& attributes = asset.primitive(half)["attributes"];
    attributes["JOINTS_0"] = asset.add(elements_of(positions,
                                                   [](const Element&) {
                                                     return Element{0, 1, 0, 0};
                                                   }),
                                       4, unsigned_byte);
    attributes["WEIGHTS_0"] = asset.add(elements_of(positions,
                                                    [](const Element&) {
                                                      return Element{0.5, 0.5, 0, 0};
                                                    }),
                                        4);
    asset.primitive(half)["targets"].push_back({{"POSITION", asset.add(positions, 3)}});
  }
  asset.json()["nodes"] = Json::parse(R"([
      {"name": "hero", "mesh": 0, "skin": 0, "weights": [0.25]}, {"name": "hip"}, {"children": [1]}])");
  asset.json()["skins"] = Json::parse(R"([{"joints": [1, 2]}])");
  asset.json()["scenes"][0]["nodes"] = {0, 2};
  return asset;
}

void animate(Asset& asset, std::size_t node, const char* path, std::size_t components) {
  const std::size_t times = asset.add({{0}, {1}}, 1), values = asset.add({{0}, {1}}, components);
  asset.json()["animations"].push_back(
      {{"samplers", {{{"input", times}, {"output", values}}}},
       {"channels", {{{"sampler", 0}, {"target", {{"node", node}, {"path", path}}}}}}});
}

} // namespace

TEST_CASE("meshes stay, and each node names coarser ones") {
  const Asset asset = ball(8);
  for (const char* const extension : {".glb", ".gltf"}) {
    const GltfDocument before = asset.document();
    const GltfDocument after = with_levels(asset, {0.5, 0.2}, extension);
    require_sound(after);
    const Json& json = after.json;
    CHECK(corners_of(after, 0) == corners_of(before, 0));
    CHECK(json["extensionsUsed"] == Json{"VENDOR_unknown", "MSFT_lod"});
    REQUIRE(json["nodes"].size() == 6);
    REQUIRE(json["meshes"].size() == 3); // nodes that share a mesh share its levels
    CHECK(ids_of(json["nodes"][0]) == Ids{2, 3});
    CHECK(ids_of(json["nodes"][1]) == Ids{4, 5});
    CHECK(json["nodes"][2] == Json{{"mesh", 1}});
    CHECK(json["nodes"][5] == Json{{"translation", {3, 0, 0}}, {"mesh", 2}});
    CHECK(json["nodes"][0]["extras"] == "kept");
    CHECK(json["meshes"][2]["name"] == "ball_LOD2");
    CHECK(json["meshes"][2]["primitives"][1]["material"] == 1);
    CHECK(json["meshes"][2]["extras"] == 7);
    for (const char* const key : {"materials", "cameras", "scenes", "asset"})
      CHECK(json[key] == before.json[key]);
    CHECK(json["images"].size() == 2);
    CHECK(bytes_of_view(after, count_of(json["images"][1], "bufferView")) == Asset::picture);
  }
}

TEST_CASE("a level is what a run of its own makes") {
  const Asset asset = ball(8);
  const GltfDocument levels = with_levels(asset, {0.6, 0.4, 0.2});
  REQUIRE(levels.json["meshes"].size() == 4);
  std::size_t mesh = 1;
  for (const double ratio : {0.6, 0.4, 0.2})
    CHECK(corners_of(levels, mesh++) == corners_of(simplified(asset, ratio), 0));
}

TEST_CASE("a level is shown from where it has as many faces for each part of the screen") {
  const GltfDocument levels = with_levels(ball(8), {0.5, 0.2});
  const auto coverage =
      levels.json["nodes"][1]["extras"]["MSFT_screencoverage"].get<std::vector<double>>();
  REQUIRE(coverage.size() == 3);
  CHECK(coverage[0] == Approx(double(face_count(levels, 1)) / double(face_count(levels, 0))));
  CHECK(coverage[1] == Approx(double(face_count(levels, 2)) / double(face_count(levels, 0))));
  CHECK(coverage[2] == 0);
}

TEST_CASE("skins, weights and what moves these go with all levels") {
  Asset asset = rigged_ball();
  animate(asset, 0, "weights", 1);
  const GltfDocument levels = with_levels(asset, {0.5, 0.3});
  require_sound(levels);
  const Json& json = levels.json;
  CHECK(ids_of(json["nodes"][0]) == Ids{3, 4});
  CHECK(json["nodes"][4] ==
        Json{{"name", "hero_LOD2"}, {"skin", 0}, {"weights", {0.25}}, {"mesh", 2}});
  const Json& channels = json["animations"][0]["channels"];
  REQUIRE(channels.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(channels[i]["target"]["node"] == std::array<std::size_t, 3>{0, 3, 4}[i]);
    CHECK(channels[i]["sampler"] == 0);
  }
  for (const Json& primitive : json["meshes"][2]["primitives"]) {
    CHECK(primitive["attributes"].contains("JOINTS_0"));
    CHECK(primitive["targets"].size() == 1);
  }
}

TEST_CASE("a node that has more than its mesh, or is moved, gives it to a child") {
  const auto nodes_of = [](const char* with, bool is_animated, bool is_joint) {
    Asset asset = rigged_ball();
    asset.json()["nodes"][0].update(Json::parse(with));
    asset.json()["nodes"].push_back(Json::object());
    if (is_joint)
      asset.json()["skins"][0]["joints"] = {0, 1};
    if (is_animated)
      animate(asset, 0, "rotation", 4);
    animate(asset, 0, "weights", 1);
    const GltfDocument levels = with_levels(asset, {0.5});
    require_sound(levels);
    for (const Json& channel : levels.json["animations"].back()["channels"])
      CHECK(channel["target"]["node"] >= 4);
    return levels.json["nodes"];
  };
  const Json child = {{"name", "hero"}, {"mesh", 0}, {"skin", 0}, {"weights", {0.25}}};
  const auto check = [&](const Json& nodes, const Json& children) {
    CHECK(nodes[0]["children"] == children);
    CHECK(!nodes[0].contains("mesh"));
    CHECK(!nodes[0].contains("skin"));
    CHECK(!has_levels(nodes[0]));
    for (const auto& [key, value] : child.items())
      CHECK(nodes[4][key] == value);
    CHECK(!nodes[4].contains("translation"));
    CHECK(ids_of(nodes[4]) == Ids{5});
    CHECK(nodes[5]["mesh"] == 1);
  };
  check(nodes_of(R"({"children": [3], "translation": [1, 2, 3]})", false, false), {3, 4});
  check(nodes_of(R"({"camera": 0})", false, false), {4});
  check(nodes_of(R"({"extensions": {"KHR_lights_punctual": {"light": 0}}})", false, false), {4});
  check(nodes_of("{}", true, false), {4});
  check(nodes_of("{}", false, true), {4});
}

TEST_CASE("instances go with their mesh") {
  Asset asset = ball(6);
  const Json instances = {{"attributes", {{"TRANSLATION", asset.add({{1}, {2}}, 3)}}}};
  asset.json()["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"] = instances;
  asset.json()["nodes"][1]["extensions"]["EXT_mesh_gpu_instancing"] = instances;
  asset.json()["nodes"][1]["camera"] = 0;
  const GltfDocument levels = with_levels(asset, {0.5});
  require_sound(levels);
  const Json& nodes = levels.json["nodes"];
  for (const std::size_t node : {0U, 2U, 3U, 4U})
    CHECK(nodes[node]["extensions"]["EXT_mesh_gpu_instancing"] == instances);
  CHECK(!nodes[1].contains("extensions"));
  CHECK(ids_of(nodes[3]) == Ids{4});
}

TEST_CASE("what moves nodes by pointers is told of the node that has the mesh") {
  Asset asset = rigged_ball();
  animate(asset, 0, "weights", 1);
  for (const char* const path : {"weights", "scale"}) {
    Json channel = asset.json()["animations"][0]["channels"][0];
    channel["target"] = {{"path", "pointer"}};
    channel["target"]["extensions"]["KHR_animation_pointer"]["pointer"] =
        std::string("/nodes/0/") + path;
    asset.json()["animations"][0]["channels"].push_back(channel);
  }
  asset.json()["animations"][0]["channels"].erase(0);
  const GltfDocument levels = with_levels(asset, {0.5});
  require_sound(levels);
  std::vector<std::string> pointers;
  for (const Json& channel : levels.json["animations"][0]["channels"])
    pointers.push_back(channel["target"]["extensions"]["KHR_animation_pointer"]["pointer"]);
  CHECK(pointers ==
        std::vector<std::string>{"/nodes/3/weights", "/nodes/0/scale", "/nodes/4/weights"});
}

TEST_CASE("a mesh that gets no coarser, and one that nobody shows, have no levels") {
  Asset asset = ball(6);
  Json tetrahedron = {{"indices", asset.add_indices({0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3})}};
  tetrahedron["attributes"]["POSITION"] =
      asset.add({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 3);
  Json points = {{"mode", 0}};
  points["attributes"]["POSITION"] = asset.add({{0, 0, 0}}, 3);
  Json& json = asset.json();
  json["meshes"].push_back({{"primitives", {tetrahedron}}});
  json["meshes"].push_back({{"primitives", {points}}});
  json["meshes"].push_back(json["meshes"][0]);
  json["nodes"][1] = {{"mesh", 1}};
  json["nodes"].push_back({{"mesh", 2}});
  json["scenes"][0]["nodes"].push_back(2);
  const GltfDocument levels = with_levels(asset, {0.5, 0.5, 0.2});
  CHECK(levels.json["meshes"].size() == 6);
  CHECK(ids_of(levels.json["nodes"][0]) == Ids{3, 4}); // the second is as coarse as the first
  for (const std::size_t node : {1U, 2U})
    CHECK(levels.json["nodes"][node] == json["nodes"][node]);
  require_bytes(levels);
  require_nodes(levels.json);
  CHECK(corners_of(levels, 1) == corners_of(asset.document(), 1));
}

TEST_CASE("documents that cannot take levels are refused with a line") {
  const auto complaint = [](const char* nodes) {
    Asset asset = ball(2);
    asset.json()["nodes"] = Json::parse(nodes);
    const Folder folder;
    const GltfMeshes meshes = GltfMeshes::read(folder.file("a.glb", asset.glb()));
    try {
      meshes.require_fit_for_levels();
      return std::string("accepted");
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
  };
  CHECK(complaint(R"([{"mesh": 0}])") == "accepted");
  CHECK_THAT(complaint(R"([{"mesh": 0, "extensions": {"MSFT_lod": {"ids": [1]}}}, {"mesh": 0}])"),
             Catch::Contains("a.glb: its nodes already have levels of detail"));
  CHECK_THAT(complaint("[{}]"), Catch::Contains("a.glb: it has no node with a triangle mesh"));
}

#endif
