// glTF documents in examples/products/mesh_io/gltf.h: what goes through a simplification, how, and
// what is refused.

#if __has_include(<nlohmann/json.hpp>)

#include "../examples/products/mesh_io/gltf.h"
#include "../examples/products/mesh_io/gltf/compression.h"
#include "folder.h"
#include "gltf_assets.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace fs = std::filesystem;
using namespace quadrille_examples;
using namespace gltf_assets;
using test::Folder;

namespace {

GltfDocument read(const std::string& content) {
  const Source source{"document", content};
  return GltfReader(source).read();
}

/// The document, simplified to a part of its faces, written in a format and read again.
GltfDocument simplified(const std::string& content, double ratio, const std::string& extension,
                        const quadrille_examples::ChannelChoices& choices = {},
                        const std::set<std::string>& labels = {}) {
  const Folder folder;
  GltfMeshes meshes = GltfMeshes::read(folder.file("in", content), labels);
  GltfSceneSurface(meshes.surfaces(), meshes.placements()).simplify({.ratio = ratio}, choices);
  write_gltf(folder.path("out"), meshes.take(), extension);
  return read(read_content(folder.path("out")));
}
GltfDocument simplified(const Asset& asset, double ratio) {
  return simplified(asset.glb(), ratio, ".glb");
}

std::vector<GltfPrimitive> primitives_of(const GltfDocument& document) {
  std::vector<GltfPrimitive> primitives;
  for (std::size_t i = 0; i < document.json["meshes"][0]["primitives"].size(); ++i)
    primitives.push_back(PrimitiveReader::read(document, 0, i).value());
  return primitives;
}

const GltfAttribute& attribute(const GltfPrimitive& primitive, const std::string& name) {
  for (const GltfAttribute& a : primitive.attributes)
    if (a.name == name)
      return a;
  throw std::logic_error("no " + name);
}

std::size_t face_count(const GltfDocument& document) {
  std::size_t count = 0;
  for (const GltfPrimitive& primitive : primitives_of(document))
    count += primitive.triangles.size();
  return count;
}

/// All that a vertex has, by the names of attributes.
using Vertex = std::vector<std::pair<std::string, Element>>;
Vertex vertex(const GltfPrimitive& primitive, std::size_t v) {
  Vertex result;
  for (const GltfAttribute& a : primitive.attributes)
    result.emplace_back(a.name, a.elements[v]);
  return result;
}

/// The faces of a primitive by all that their corners have, wherever they begin.
std::multiset<std::array<Vertex, 3>> faces_of(const GltfPrimitive& primitive) {
  std::multiset<std::array<Vertex, 3>> faces;
  for (const auto& [a, b, c] : primitive.triangles) {
    std::array<Vertex, 3> face{vertex(primitive, a), vertex(primitive, b), vertex(primitive, c)};
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    faces.insert(face);
  }
  return faces;
}

/// Edges without a second face, where vertices at one place are one.
std::size_t open_edges(const GltfDocument& document) {
  std::map<std::pair<Element, Element>, int> edges;
  for (const GltfPrimitive& primitive : primitives_of(document))
    for (const auto& triangle : primitive.triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const Elements& p = primitive.attributes[0].elements;
        const Element a = p[triangle[i]], b = p[triangle[(i + 1) % 3]];
        edges[a < b ? std::pair(a, b) : std::pair(b, a)] += a < b ? 1 : -1;
      }
  return static_cast<std::size_t>(
      std::count_if(edges.begin(), edges.end(), [](const auto& edge) { return edge.second != 0; }));
}

/// Every vertex is used, and the limits of positions are right.
void require_tidy(const GltfDocument& document) {
  for (const GltfPrimitive& primitive : primitives_of(document)) {
    const Elements& positions = primitive.attributes[0].elements;
    std::set<std::uint32_t> used;
    for (const auto& triangle : primitive.triangles)
      used.insert(triangle.begin(), triangle.end());
    CHECK(used.size() == positions.size());
    const Json& accessor = document.json["accessors"][positions.index()];
    for (std::size_t c = 0; c < 3; ++c) {
      std::set<double> values;
      for (std::size_t v = 0; v < positions.size(); ++v)
        values.insert(positions.stored(v, c));
      CHECK(accessor["min"][c].get<double>() == *values.begin());
      CHECK(accessor["max"][c].get<double>() == *values.rbegin());
    }
  }
}

/// What of a document has nothing to do with its geometry.
Json other_than_geometry(Json json) {
  for (const char* const key : {"accessors", "bufferViews", "buffers"})
    json.erase(key);
  for (Json& primitive : json["meshes"][0]["primitives"])
    for (const char* const key : {"attributes", "indices", "mode", "targets"})
      primitive.erase(key);
  for (Json& image : json["images"])
    image.erase("bufferView");
  return json;
}

std::string bytes_of_picture(const GltfDocument& document) {
  return std::string(bytes_of_view(document, count_of(document.json["images"][1], "bufferView")));
}

/// What is wrong with a document; "accepted" if nothing is.
std::string complaint(const std::string& content) {
  const Folder folder;
  const fs::path path = folder.file("a.glb", content);
  try {
    GltfMeshes::read(path);
    return "accepted";
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    CHECK(message.find('\n') == std::string::npos);
    REQUIRE(message.starts_with(path.string() + ": "));
    return message.substr(path.string().size() + 2);
  }
}

/// The same of a ball of which something is changed.
std::string complaint_about(const std::function<void(Asset&)>& change) {
  Asset asset = ball(2);
  change(asset);
  return complaint(asset.glb());
}

} // namespace

TEST_CASE("bodies of a primitive that touch stay apart, and what is one surface is joined") {
  Asset asset;
  std::vector<Element> places;
  std::vector<std::uint32_t> corners;
  for (const double x : {0., 1.}) // two cubes with a side at the same place, each of loose corners
    for (std::size_t k = 0; k < 3; ++k)
      for (const double side : {0., 1.}) {
        const auto first = static_cast<std::uint32_t>(places.size());
        for (const auto& [u, v] : {std::pair(0., 0.), {1., 0.}, {1., 1.}, {0., 1.}}) {
          Element p{};
          p[k] = side;
          p[(k + 1) % 3] = side == 1 ? u : v;
          p[(k + 2) % 3] = side == 1 ? v : u;
          p[0] += x;
          places.push_back(p);
        }
        for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U})
          corners.push_back(first + corner);
      }
  const std::size_t positions = asset.add(places, 3), indices = asset.add_indices(corners);
  asset.json()["meshes"][0]["primitives"].push_back(
      {{"attributes", {{"POSITION", positions}}}, {"indices", indices}});
  const Folder folder;
  GltfMeshes meshes = GltfMeshes::read(folder.file("a.glb", asset.glb()));
  CHECK(meshes.surfaces()[0].points.size() == 16); // and not 12, or 48
  CHECK(meshes.surfaces()[0].triangles.size() == 24);
}

TEST_CASE("the border of two colours stays where it is") {
  const std::uint32_t n = 16;
  const auto is_red = [](std::uint32_t i, std::uint32_t j) {
    return i < 8 && !(i >= 4 && j >= 4 && j < 10);
  };
  Asset asset;
  std::vector<Element> places, colors;
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> numbers; // of places with a colour
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j)
      for (const auto& [u, v] :
           {std::pair(0U, 0U), {1U, 0U}, {1U, 1U}, {0U, 0U}, {1U, 1U}, {0U, 1U}}) {
        const std::uint32_t red = is_red(i, j);
        const auto next = static_cast<std::uint32_t>(places.size());
        const auto [number, is_new] = numbers.try_emplace({i + u, j + v, red}, next);
        if (is_new) {
          places.push_back({double(i + u), double(j + v), 0, 0});
          colors.push_back({double(red), 0, 1. - red, 1});
        }
        corners.push_back(number->second);
      }
  const std::size_t positions = asset.add(places, 3), color = asset.add(colors, 4);
  const std::size_t indices = asset.add_indices(corners);
  asset.json()["meshes"][0]["primitives"].push_back(
      {{"attributes", {{"POSITION", positions}, {"COLOR_0", color}}}, {"indices", indices}});
  asset.json()["nodes"][1]["translation"][0] = 100; // where it meets nothing
  const GltfDocument result = simplified(asset, 0.06);
  const GltfPrimitive primitive = primitives_of(result).front();
  CHECK(primitive.triangles.size() <= 31);
  double red = 0;
  for (const auto& [a, b, c] : primitive.triangles) {
    const Elements& p = primitive.attributes[0].elements;
    const Elements& of = attribute(primitive, "COLOR_0").elements;
    CHECK((of[a] == of[b] && of[b] == of[c]));
    red += of[a][0] / 2 *
           ((p[b][0] - p[a][0]) * (p[c][1] - p[a][1]) - (p[b][1] - p[a][1]) * (p[c][0] - p[a][0]));
  }
  CHECK(red == Approx(8 * 16 - 4 * 6).margin(0.01));
}

TEST_CASE("what is compressed comes back, and what is exact has its bits") {
  const Asset asset = ball(12);
  for (const bool is_exact : {true, false})
    for (const char* const how : {"meshopt", "draco"}) {
      CAPTURE(how, is_exact);
      try {
        compression_of(how);
      } catch (const std::runtime_error& error) {
        CHECK_THAT(error.what(), Catch::Contains("this program was built without lib"));
        continue;
      }
      GltfDocument packed = asset.document();
      compress(packed, compression_of(how), is_exact);
      CHECK(packed.json["extensionsRequired"].size() == 1);
      CHECK(packed.buffers[0].size() < asset.bytes().size() * 2 / 3);
      for (const std::string& content : {encode_glb(packed), encode_gltf(packed)}) {
        const GltfDocument result = read(content);
        CHECK(result.compression == how);
        CHECK(open_edges(result) == 0); // parts that are rounded go on meeting
        CHECK(other_than_geometry(result.json) == other_than_geometry(asset.document().json));
        CHECK(bytes_of_picture(result) == Asset::picture);
        const auto before = primitives_of(asset.document()), after = primitives_of(result);
        for (std::size_t i = 0; i < 2; ++i) {
          CHECK(after[i].triangles.size() == before[i].triangles.size());
          const bool is_same = faces_of(after[i]) == faces_of(before[i]);
          CHECK(is_same == (is_exact || how == std::string("meshopt")));
        }
      }
    }
}

TEST_CASE("nothing is lost where nothing is simplified") {
  for (const bool is_indexed : {true, false}) {
    const Asset asset = ball(4, is_indexed);
    for (const char* const extension : {".glb", ".gltf"}) {
      const GltfDocument result = simplified(asset.glb(), 1, extension);
      require_tidy(result);
      const auto before = primitives_of(asset.document()), after = primitives_of(result);
      for (std::size_t i = 0; i < 2; ++i)
        CHECK(faces_of(after[i]) == faces_of(before[i]));
      CHECK(other_than_geometry(result.json) == other_than_geometry(asset.document().json));
      CHECK(bytes_of_picture(result) == Asset::picture);
    }
  }
}

TEST_CASE("primitives stay together, and each keeps its faces") {
  for (const bool is_indexed : {true, false}) {
    const Asset asset = ball(8, is_indexed);
    REQUIRE(open_edges(asset.document()) == 0);
    const GltfDocument result = simplified(asset, 0.3);
    require_tidy(result);
    CHECK(face_count(result) <= 231);
    CHECK(face_count(result) >= 225);
    CHECK(open_edges(result) == 0);
    for (const GltfPrimitive& primitive : primitives_of(result))
      CHECK(primitive.triangles.size() > 40);
    CHECK(other_than_geometry(result.json) == other_than_geometry(asset.document().json));
    CHECK(result.buffers[0].size() < asset.bytes().size() / 2);
  }
}

TEST_CASE("attributes go along with the surface") {
  const Asset asset = ball(10);
  const std::vector<GltfPrimitive> before = primitives_of(asset.document());
  // Where seams are kept, no chart gets a new vertex at an old place.
  const std::vector<GltfPrimitive> after = primitives_of(
      simplified(asset.glb(), 0.3, ".glb", {.texture_seams = quadrille::Seams::kept}));
  for (std::size_t i = 0; i < 2; ++i) {
    std::map<Element, std::set<Vertex>> old;
    for (std::size_t v = 0; v < before[i].attributes[0].elements.size(); ++v)
      old[before[i].attributes[0].elements[v]].insert(vertex(before[i], v));
    std::size_t unmoved = 0;
    for (std::size_t v = 0; v < after[i].attributes[0].elements.size(); ++v) {
      const Element p = after[i].attributes[0].elements[v];
      const Element normal = attribute(after[i], "NORMAL").elements[v];
      CHECK(std::hypot(normal[0], normal[1], normal[2]) == Approx(1).margin(1e-6));
      CHECK(std::hypot(p[0] - normal[0], p[1] - normal[1], p[2] - normal[2]) < 0.15);
      const auto same = old.find(p);
      if (same == old.end())
        continue;
      ++unmoved;
      CHECK(same->second.contains(vertex(after[i], v)));
    }
    CHECK(unmoved > 5);
  }
  for (std::size_t v = 0; v < after[0].attributes[0].elements.size(); ++v) {
    const Element p = after[0].attributes[0].elements[v];
    CHECK(attribute(after[0], "_HEAT").elements[v][0] == Approx(p[2]).margin(0.1));
    const Element color = attribute(after[0], "COLOR_0").elements[v];
    CHECK(color[0] == Approx((1 + p[0]) / 2).margin(0.1));
    CHECK(color[3] == 1);
    const double sign = attribute(after[0], "TANGENT").elements[v][3];
    CHECK((sign == 1 || sign == -1));
    const double part = attribute(after[0], "_PART").elements[v][0];
    CHECK((part == 3 || part == 5));
  }
}

TEST_CASE("signs of tangents hold nothing, and are those of the surface nearby") {
  const std::uint32_t n = 24;
  const auto is_sure = [](const Element& p) { return std::abs(p[0] * p[1]) > 0.03; };
  std::size_t vertices = 0;
  const auto tangent = [&](const Element& p) { // four patches, with ragged borders
    const double l = std::hypot(p[0], p[1]);
    const bool is_turned = is_sure(p) ? p[0] * p[1] < 0 : ++vertices * 7919 % 13 < 6;
    const double sign = is_turned ? -1 : 1;
    return l > 0 ? Element{-p[1] / l, p[0] / l, 0, sign} : Element{1, 0, 0, sign};
  };
  Asset asset = ball(n);
  asset.primitive(0)["attributes"]["TANGENT"] =
      asset.add(elements_of(half_of_ball(0, n).positions, tangent), 4);
  for (const double ratio : {0.2, 0.03}) {
    const GltfDocument result = simplified(asset, ratio);
    CHECK(static_cast<double>(face_count(result)) <= ratio * 12 * n * n);
    const GltfPrimitive half = primitives_of(result)[0];
    std::size_t sure = 0, wrong = 0;
    for (std::size_t v = 0; v < half.attributes[0].elements.size(); ++v) {
      const Element p = half.attributes[0].elements[v];
      const double sign = attribute(half, "TANGENT").elements[v][3];
      CHECK((sign == 1 || sign == -1));
      sure += std::abs(p[0] * p[1]) > 0.1;
      wrong += std::abs(p[0] * p[1]) > 0.1 && sign != (p[0] * p[1] < 0 ? -1 : 1);
    }
    CHECK(sure >= 12);
    CHECK(wrong == 0);
  }
}

TEST_CASE("integers of vertices hold nothing, unless they are called labels") {
  Asset asset = ball(10);
  std::size_t count = 0;
  const auto number = [&](const Element&) { return Element{static_cast<double>(++count % 3)}; };
  asset.primitive(0)["attributes"]["_NUMBER"] =
      asset.add(elements_of(half_of_ball(0, 10).positions, number), 1, unsigned_short);
  const GltfDocument free = simplified(asset, 0.05);
  CHECK(face_count(free) <= 60);
  const GltfPrimitive half = primitives_of(free)[0];
  const Elements& left = attribute(half, "_NUMBER").elements;
  for (std::size_t v = 0; v < left.size(); ++v)
    CHECK(left[v][0] <= 2);
  CHECK(face_count(simplified(asset.glb(), 0.05, ".glb", {}, {"_NUMBER"})) > 500);
  for (const char* const name : {"_HEAT", "TANGENT", "_OTHER"})
    CHECK_THROWS_WITH(
        simplified(asset.glb(), 0.05, ".glb", {}, {"_PART", name}),
        Catch::Contains("there is no integer attribute named '" + std::string(name) + "'"));
}

TEST_CASE("a face keeps its labels") {
  const GltfPrimitive half =
      primitives_of(simplified(ball(10).glb(), 0.3, ".glb", {}, {"_PART"}))[0];
  const Elements& parts = attribute(half, "_PART").elements;
  std::set<double> seen;
  for (const auto& [a, b, c] : half.triangles) {
    const double height = (half.attributes[0].elements[a][2] + half.attributes[0].elements[b][2] +
                           half.attributes[0].elements[c][2]) /
                          3;
    seen.insert(parts[a][0]);
    if (height > 0.25)
      CHECK((parts[a][0] == 3 && parts[b][0] == 3 && parts[c][0] == 3));
    if (height < -0.25)
      CHECK((parts[a][0] == 5 && parts[b][0] == 5 && parts[c][0] == 5));
  }
  CHECK(seen == std::set<double>{3, 5});
}

TEST_CASE("strips and fans become triangles; integers stay integers") {
  const GltfDocument same = simplified(strip(), 1);
  CHECK(face_count(same) == 288);
  const GltfDocument result = simplified(strip(), 0.4);
  require_tidy(result);
  CHECK(result.json["meshes"][0]["primitives"][0]["mode"] == 4);
  const GltfPrimitive sheet = primitives_of(result)[0];
  CHECK(sheet.triangles.size() <= 115);
  for (const GltfAttribute& a : sheet.attributes)
    CHECK(a.elements.type().component.size == 2);
  const Elements& p = sheet.attributes[0].elements;
  for (const auto& [a, b, c] : sheet.triangles) // all face upwards, seen from above
    CHECK((p[b][0] - p[a][0]) * (p[c][1] - p[a][1]) - (p[b][1] - p[a][1]) * (p[c][0] - p[a][0]) >
          0);

  Asset fan;
  Json primitive = {{"mode", 6}};
  primitive["attributes"]["POSITION"] =
      fan.add({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 1, 0}}, 3);
  fan.json()["meshes"][0]["primitives"].push_back(primitive);
  CHECK(faces_of(primitives_of(simplified(fan, 1))[0]) ==
        faces_of(primitives_of(fan.document())[0]));
  CHECK(face_count(fan.document()) == 3);
}

TEST_CASE("displacements of morph targets go along") {
  Asset asset = ball();
  for (std::size_t i = 0; i < 2; ++i) {
    const GltfPrimitive half = primitives_of(asset.document())[i];
    std::vector<Element> moves;
    for (std::size_t v = 0; v < half.attributes[0].elements.size(); ++v)
      moves.push_back({0, 0, half.attributes[0].elements[v][0] / 2});
    asset.primitive(i)["targets"].push_back({{"POSITION", asset.add(moves, 3)}});
  }
  const GltfDocument result = simplified(asset, 0.4);
  for (const GltfPrimitive& half : primitives_of(result)) {
    REQUIRE(half.attributes.back().target == 0U);
    for (std::size_t v = 0; v < half.attributes[0].elements.size(); ++v)
      CHECK(half.attributes.back().elements[v][2] ==
            Approx(half.attributes[0].elements[v][0] / 2).margin(0.03));
  }
}

TEST_CASE("a new vertex has blended joints and weights, an old one has its own") {
  for (const std::size_t type : {single, std::size_t{unsigned_byte}}) {
    const auto joints_at = [](const Element& p) {
      return p[0] > 0 ? Element{7, 1, 0, 0} : Element{1, 300, 0, 0};
    };
    const auto weights_at = [](const Element& p) {
      const double one = p[0] > 0 ? std::abs(p[2]) : 1 - std::abs(p[2]) / 2;
      return Element{one, 1 - one, 0, 0};
    };
    Asset asset = ball(12);
    std::map<Element, std::pair<Element, Element>> old;
    for (const std::size_t half : {0U, 1U}) {
      const std::vector<Element> positions = half_of_ball(half, 12).positions;
      Json& attributes = asset.primitive(half)["attributes"];
      attributes["JOINTS_0"] = asset.add(elements_of(positions, joints_at), 4, unsigned_short);
      attributes["WEIGHTS_0"] = asset.add(elements_of(positions, weights_at), 4, type, true);
    }
    for (const GltfPrimitive& half : primitives_of(asset.document()))
      for (std::size_t v = 0; v < half.attributes[0].elements.size(); ++v)
        old.try_emplace(half.attributes[0].elements[v], attribute(half, "JOINTS_0").elements[v],
                        attribute(half, "WEIGHTS_0").elements[v]);
    const GltfDocument result = simplified(asset, 0.25);
    CHECK(open_edges(result) == 0);
    std::size_t mixed = 0;
    for (const GltfPrimitive& primitive : primitives_of(result))
      for (std::size_t v = 0; v < primitive.attributes[0].elements.size(); ++v) {
        const Element p = primitive.attributes[0].elements[v];
        const Element joints = attribute(primitive, "JOINTS_0").elements[v];
        const Element weights = attribute(primitive, "WEIGHTS_0").elements[v];
        CHECK(std::abs(weights[0] + weights[1] + weights[2] + weights[3] - 1) < 1e-6);
        if (const auto same = old.find(p); same != old.end())
          CHECK(same->second == std::pair(joints, weights));
        double of_one = 0; // what joint 1 has, which all vertices know
        for (std::size_t i = 0; i < 4; ++i)
          of_one += joints[i] == 1 ? weights[i] : 0;
        if (std::abs(p[0]) > 0.3)
          CHECK(of_one ==
                Approx(p[0] > 0 ? 1 - std::abs(p[2]) : 1 - std::abs(p[2]) / 2).margin(0.1));
        mixed += weights[2] > 0;
      }
    CHECK(mixed > 0); // of three joints: no vertex of the input had these
  }
}

TEST_CASE("what others refer to stays: animations, points, unknown extensions, shared accessors") {
  Asset asset = ball();
  const std::size_t times = asset.add({{0}, {1}}, 1), moves = asset.add({{1, 2, 3}, {4, 5, 6}}, 3);
  asset.json()["animations"].push_back(
      {{"samplers", {{{"input", times}, {"output", moves}}}},
       {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}});
  const Json shared = asset.primitive(0)["attributes"]["POSITION"];
  Json points = {{"mode", 0}};
  points["attributes"]["POSITION"] = shared;
  asset.json()["meshes"].push_back({{"primitives", {points}}});
  asset.json()["extensions"]["VENDOR_unknown"]["bufferView"] = asset.add_view("payload");
  const GltfDocument before = asset.document(), after = simplified(asset, 0.3);
  CHECK(after.json["animations"] == before.json["animations"]);
  CHECK(after.json["meshes"][1] == before.json["meshes"][1]);
  for (const std::size_t kept : {times, moves, shared.get<std::size_t>()}) {
    const Elements old(before, kept), now(after, kept);
    REQUIRE(old.size() == now.size());
    for (std::size_t i = 0; i < old.size(); ++i)
      CHECK(old[i] == now[i]);
  }
  CHECK(bytes_of_view(after, count_of(after.json["extensions"]["VENDOR_unknown"], "bufferView")) ==
        "payload");
  CHECK(bytes_of_picture(after) == Asset::picture);
}

TEST_CASE("attributes may be sparse, or lie in between each other") {
  Asset asset = ball(4);
  const Json old = asset.json()["accessors"][0];
  const std::size_t place = asset.add_indices({5}), value = asset.add({{9, 9, 9}}, 3);
  asset.json()["accessors"][0]["sparse"] = {
      {"count", 1},
      {"indices",
       {{"bufferView", asset.json()["accessors"][place]["bufferView"]}, {"componentType", 5125}}},
      {"values", {{"bufferView", asset.json()["accessors"][value]["bufferView"]}}}};
  CHECK(primitives_of(asset.document())[0].attributes[0].elements[5] == Element{9, 9, 9, 0});
  CHECK(faces_of(primitives_of(simplified(asset, 1))[0]) ==
        faces_of(primitives_of(asset.document())[0]));
}

TEST_CASE("buffers are in the text, in the file, or in files beside it") {
  const Asset asset = ball(2);
  const Folder folder;
  GltfDocument document = asset.document();
  document.json["buffers"][0]["uri"] = "the%20bytes.bin";
  const fs::path path = folder.file("a.gltf", document.json.dump());
  CHECK_THROWS_WITH(GltfMeshes::read(path), Catch::Contains("the bytes.bin: no such file"));
  folder.file("the bytes.bin", asset.bytes());
  CHECK(GltfMeshes::read(path).surfaces()[0].triangles.size() == 48);
  CHECK(GltfMeshes::read(path).image_files() == std::vector<std::string>{"a%20picture.png"});
  CHECK(complaint(asset.gltf()) == "accepted");
  CHECK(read(asset.gltf()).buffers == document.buffers);
  for (std::size_t size = 0; size < 7; ++size) {
    const std::string bytes = std::string("\0\xFF\x80 abc", 7).substr(0, size);
    CHECK(decode_base64(encode_base64(bytes)) == bytes);
  }
}

TEST_CASE("a binary file has one buffer, whatever the document had") {
  Asset asset = ball(2);
  GltfDocument document = asset.document();
  document.json["buffers"].push_back(
      {{"byteLength", 5}, {"uri", "data:application/octet-stream;base64,aGVsbG8="}});
  document.json["bufferViews"].push_back({{"buffer", 1}, {"byteOffset", 1}, {"byteLength", 4}});
  document.buffers.push_back("hello");
  for (const std::string& content : {encode_gltf(document), encode_glb(document)}) {
    const GltfDocument result = simplified(content, 1, ".glb");
    REQUIRE(result.buffers.size() == 1);
    CHECK(!result.json["buffers"][0].contains("uri"));
    CHECK(bytes_of_view(result, size_of(document.json, "bufferViews") - 1) == "ello");
    CHECK(bytes_of_picture(result) == Asset::picture);
  }
}

TEST_CASE("tangents are perpendicular to normals") {
  for (const double ratio : {0.5, 0.2, 0.1})
    for (const GltfPrimitive& primitive : primitives_of(simplified(ball(10), ratio)))
      for (const GltfAttribute& tangents : primitive.attributes)
        for (std::size_t v = 0; tangents.name == "TANGENT" && v < tangents.elements.size(); ++v) {
          const Element t = tangents.elements[v], n = attribute(primitive, "NORMAL").elements[v];
          CHECK(std::abs(t[0] * n[0] + t[1] * n[1] + t[2] * n[2]) < 1e-5);
          CHECK(std::hypot(t[0], t[1], t[2]) == Approx(1));
        }
}

TEST_CASE("a primitive without faces has one without area") {
  Asset asset = ball(2);
  asset.primitive(0)["indices"] = asset.add_indices({0, 0, 1});
  const GltfDocument result = simplified(asset, 1);
  CHECK(primitives_of(result)[0].triangles == std::vector{std::array<std::uint32_t, 3>{0, 0, 0}});
  CHECK(primitives_of(result)[1].triangles.size() == 24);
}

TEST_CASE("triangles that are left out are counted") {
  Asset asset = ball(2);
  // One without area, and one twice the same way round; the other way round it is a back.
  asset.primitive(0)["indices"] = asset.add_indices({0, 0, 1, 0, 1, 4, 4, 1, 0, 1, 4, 0, 0, 3, 4});
  const Folder folder;
  GltfMeshes meshes = GltfMeshes::read(folder.file("a.glb", asset.glb()));
  CHECK(meshes.surfaces()[0].count_left_out() == 2);
}

TEST_CASE("what cannot be carried is refused") {
  const auto with_attribute = [](const char* name) {
    return complaint_about([&](Asset& asset) {
      asset.primitive(1)["attributes"][name] = asset.add(std::vector<Element>(27), 4);
    });
  };
  CHECK(with_attribute("_ANY") == "accepted");
  CHECK_THAT(with_attribute("JOINTS_0"), Catch::StartsWith("the primitives of a mesh differ"));
  CHECK_THAT(complaint_about([](Asset& asset) {
               asset.primitive(0)["extensions"]["KHR_draco_mesh_compression"] = Json::object();
             }),
             Catch::Contains("KHR_draco_mesh_compression"));
  CHECK_THAT(complaint_about([](Asset& asset) {
               asset.json()["bufferViews"][1]["extensions"]["EXT_meshopt_compression"] = 1;
             }),
             Catch::Contains("EXT_meshopt_compression"));
}

TEST_CASE("a mesh of degenerate triangles only is no hindrance") {
  Asset asset = ball();
  Json degenerate = asset.primitive(0);
  degenerate["indices"] = asset.add_indices({0, 0, 1, 2, 1, 2});
  asset.json()["meshes"].push_back({{"primitives", Json::array({degenerate})}});
  const std::vector<GltfPrimitive> primitives = primitives_of(simplified(asset, 0.3));
  const auto faces = [&](std::size_t mesh) {
    std::size_t count = 0;
    for (const GltfPrimitive& primitive : primitives)
      count += primitive.mesh == mesh ? primitive.triangles.size() : 0;
    return count;
  };
  CHECK(faces(0) == 230); // of 768
  CHECK(faces(1) == 0);
}

TEST_CASE("any number of sets of texture coordinates go along") {
  Asset asset = ball(6);
  for (std::size_t p = 0; p < 2; ++p)
    for (int i = 1; i < 12; ++i)
      asset.primitive(p)["attributes"]["TEXCOORD_" + std::to_string(i)] =
          asset.primitive(p)["attributes"]["TEXCOORD_0"];
  const GltfPrimitive primitive = primitives_of(simplified(asset, 0.5)).at(0);
  const Elements* first = nullptr;
  std::size_t sets = 0;
  for (const GltfAttribute& attribute : primitive.attributes) {
    if (attribute.kind != AttributeKind::texture)
      continue;
    ++sets;
    first = first ? first : &attribute.elements;
    for (std::size_t v = 0; v < first->size(); ++v)
      for (std::size_t k = 0; k < 2; ++k)
        CHECK(std::abs(attribute.elements[v][k] - (*first)[v][k]) < 1e-6);
  }
  CHECK(sets == 12);
}

TEST_CASE("broken documents are refused with a line") {
  const std::string sound = ball(2).glb();
  REQUIRE(complaint(sound) == "accepted");
  for (std::size_t size = 1; size < sound.size(); size += 97)
    CHECK(complaint(sound.substr(0, size)) != "accepted");
  const auto broken = [](const char* pointer, const Json& value) {
    return complaint_about(
        [&](Asset& asset) { asset.json()[Json::json_pointer(pointer)] = value; });
  };
  for (const Json& count : {Json(0), Json(-1), Json(1.5), Json("9"), Json(28),
                            Json(std::uint64_t{0xFFFFFFFFFFFFFFFF}), Json(std::uint64_t{1} << 62)})
    CHECK(broken("/accessors/0/count", count) != "accepted");
  CHECK_THAT(broken("/accessors/0/componentType", 1), Catch::Contains("component type 1"));
  CHECK_THAT(broken("/accessors/0/type", "MAT3"), Catch::Contains("MAT3"));
  CHECK_THAT(broken("/accessors/0/type", "VEC2"), Catch::Contains("POSITION"));
  CHECK_THAT(broken("/accessors/0/byteOffset", 4), Catch::Contains("not within buffer view"));
  CHECK_THAT(broken("/accessors/0/byteOffset", std::uint64_t{1} << 62),
             Catch::Contains("not within buffer view"));
  CHECK_THAT(broken("/accessors/0/bufferView", 999), Catch::Contains("out of range"));
  CHECK_THAT(broken("/bufferViews/1/byteLength", 1 << 30), Catch::Contains("within its buffer"));
  CHECK_THAT(broken("/bufferViews/1/byteOffset", std::uint64_t{1} << 62),
             Catch::Contains("within its buffer"));
  CHECK_THAT(broken("/bufferViews/1/byteStride", 4), Catch::Contains("stride"));
  CHECK_THAT(broken("/bufferViews/1/buffer", 1), Catch::Contains("within its buffer"));
  CHECK_THAT(broken("/meshes/0/primitives/0/attributes/POSITION", 99),
             Catch::Contains("out of range"));
  CHECK_THAT(broken("/meshes/0/primitives/0/attributes/NORMAL", 2), Catch::Contains("NORMAL"));
  CHECK_THAT(broken("/meshes/0/primitives/0/attributes", Json::object()),
             Catch::Contains("POSITION"));
  CHECK_THAT(broken("/meshes/0/primitives/0/mode", 7), Catch::Contains("mode 7"));
  CHECK_THAT(broken("/meshes/0/primitives/0/indices", 0), Catch::Contains("indices"));
  CHECK_THAT(broken("/meshes/0/primitives", 3), Catch::Contains("is not an array"));
  CHECK_THAT(broken("/asset/version", "1.0"), Catch::Contains("version"));
}

TEST_CASE("indices, positions and texts that are broken are refused with a line") {
  CHECK_THAT(complaint_about([](Asset& asset) {
               asset.primitive(1)["indices"] = asset.add_indices({0, 1, 27});
             }),
             Catch::Contains("vertex index 27 is out of range: there are 27"));
  CHECK_THAT(complaint_about([](Asset& asset) {
               std::vector<Element> positions(27);
               positions[3][1] = std::numeric_limits<double>::quiet_NaN();
               asset.primitive(1)["attributes"]["POSITION"] = asset.add(positions, 3);
             }),
             Catch::Contains("is not finite"));
  CHECK_THAT(complaint(std::string(1000, '[')), Catch::Contains("nested too deeply"));
  CHECK_THAT(complaint("{\"asset\": {\"version\": \"2.0\"}, \"a\": 1e999}"),
             Catch::Contains("not valid JSON"));
  CHECK(complaint("[]") == "not a glTF document: it has no 'asset'");
  CHECK_THAT(complaint("{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":4,\"uri\":"
                       "\"data:;base64,AAA*\"}]}"),
             Catch::Contains("base64"));
}

TEST_CASE("documents with wrong digits are refused or written again") {
  const std::string sound = ball(2).glb();
  std::mt19937 random(1);
  std::size_t accepted = 0;
  for (int run = 0; run < 400; ++run) {
    std::string content = sound;
    for (int digits = 0; digits < 2;) {
      char& c = content[random() % content.size()];
      if (c < '0' || c > '9')
        continue;
      c = static_cast<char>('0' + random() % 10);
      ++digits;
    }
    try {
      GltfMeshes meshes = [&] {
        const Folder folder;
        return GltfMeshes::read(folder.file("a.glb", content));
      }();
      encode_glb(meshes.take());
      ++accepted;
    } catch (const std::runtime_error& error) {
      CHECK(std::string(error.what()).find('\n') == std::string::npos);
    }
  }
  CHECK(accepted > 20);
}

#endif
