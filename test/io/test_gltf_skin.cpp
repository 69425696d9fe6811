// A mesh that joints move, in examples/products/mesh_io/gltf.h: what is left of it follows them in
// every pose.

#if __has_include(<nlohmann/json.hpp>)

#include "../examples/products/mesh_io/gltf.h"
#include "folder.h"
#include "gltf_assets.h"

#include <catch2/catch.hpp>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

using namespace quadrille_examples;
using namespace gltf_assets;
using test::Folder;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Place = Kernel::Point_3;

// --- A tube along z of radius 1/2 and length 8, closed at both ends, with a joint in its middle --

constexpr std::uint32_t rings = 40, sides = 24;
constexpr double length = 8, elbow = length / 2;

Side tube() {
  Side side;
  for (std::uint32_t i = 0; i <= rings; ++i)
    for (std::uint32_t k = 0; k < sides; ++k) {
      const double angle = 2 * std::numbers::pi * k / sides;
      side.positions.push_back({std::cos(angle) / 2, std::sin(angle) / 2, length * i / rings});
    }
  for (std::uint32_t i = 0; i < rings; ++i)
    for (std::uint32_t k = 0; k < sides; ++k) {
      const std::uint32_t v = i * sides + k, w = i * sides + (k + 1) % sides;
      side.corners.insert(side.corners.end(), {v, w, w + sides, v, w + sides, v + sides});
    }
  for (std::uint32_t k = 1; k + 1 < sides; ++k) {
    const std::uint32_t top = rings * sides;
    side.corners.insert(side.corners.end(), {0, k + 1, k, top, top + k, top + k + 1});
  }
  return side;
}

/// What the second joint says about a place: it bends over a length of two.
double share_of_second(double z) {
  return std::clamp((z - elbow + 1) / 2, 0., 1.);
}

/// The second joint has its bind matrix; weights are stored in a type.
Asset skinned_tube(std::size_t type) {
  Asset asset;
  const Side side = tube();
  Json primitive;
  Json& attributes = primitive["attributes"];
  attributes["POSITION"] = asset.add(side.positions, 3);
  attributes["JOINTS_0"] = asset.add(elements_of(side.positions,
                                                 [](const Element&) {
                                                   return Element{0, 1, 0, 0};
                                                 }),
                                     4, unsigned_byte);
  attributes["WEIGHTS_0"] = asset.add(elements_of(side.positions,
                                                  [](const Element& p) {
                                                    const double second = share_of_second(p[2]);
                                                    return Element{1 - second, second, 0, 0};
                                                  }),
                                      4, type, type != single);
  primitive["indices"] = asset.add_indices(side.corners);
  asset.json()["meshes"][0]["primitives"].push_back(primitive);
  std::string binds(2 * 16 * sizeof(float), '\0');
  for (std::size_t joint = 0; joint < 2; ++joint) {
    std::array<float, 16> matrix{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    matrix[14] = joint == 1 ? static_cast<float>(-elbow) : 0;
    std::copy_n(reinterpret_cast<const char*>(matrix.data()), sizeof matrix,
                binds.begin() + static_cast<std::ptrdiff_t>(joint * sizeof matrix));
  }
  const std::size_t view = asset.add_view(binds);
  asset.json()["accessors"].push_back(
      {{"componentType", single}, {"type", "MAT4"}, {"count", 2}, {"bufferView", view}});
  asset.json()["skins"] = {
      {{"joints", {1, 2}}, {"inverseBindMatrices", asset.json()["accessors"].size() - 1}}};
  asset.json()["nodes"] = {
      {{"mesh", 0}, {"skin", 0}}, {{"children", {2}}}, {{"translation", {0, 0, elbow}}}};
  return asset;
}

// --- How it moves --------------------------------------------------------------------------------

/// Turned about an axis through the elbow, by a right angle.
Place turned(const Element& p, std::size_t axis) {
  const double x = p[0], y = p[1], z = p[2] - elbow;
  if (axis == 0)
    return {x, -z, y + elbow};
  if (axis == 1)
    return {z, y, -x + elbow};
  return {-y, x, z + elbow};
}

struct Posed {
  std::vector<Place> places;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

const Elements& values(const GltfPrimitive& primitive, const std::string& name) {
  return std::find_if(primitive.attributes.begin(), primitive.attributes.end(),
                      [&](const GltfAttribute& a) { return a.name == name; })
      ->elements;
}

/// As a renderer does it: each vertex between the places that its joints have it at.
Posed posed(const GltfPrimitive& primitive, std::size_t axis) {
  Posed result{{}, primitive.triangles};
  const Elements &positions = values(primitive, "POSITION"),
                 &joints = values(primitive, "JOINTS_0"), &weights = values(primitive, "WEIGHTS_0");
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const Element p = positions[v];
    double second = 0;
    for (std::size_t i = 0; i < 4; ++i)
      second += joints[v][i] == 1 ? weights[v][i] : 0;
    const Place moved = turned(p, axis);
    result.places.emplace_back(p[0] + second * (moved.x() - p[0]),
                               p[1] + second * (moved.y() - p[1]),
                               p[2] + second * (moved.z() - p[2]));
  }
  return result;
}

/// How far the farthest vertex of one is from the other's surface.
double greatest_distance(const Posed& from, const Posed& to) {
  double greatest = 0;
  for (const Place& p : from.places) {
    double nearest = 1e9;
    for (const auto& [a, b, c] : to.triangles)
      nearest = std::min(
          nearest,
          CGAL::squared_distance(p, Kernel::Triangle_3(to.places[a], to.places[b], to.places[c])));
    greatest = std::max(greatest, nearest);
  }
  return std::sqrt(greatest);
}

GltfPrimitive primitive_of(const std::string& content) {
  const Source source{"document", content};
  return PrimitiveReader::read(GltfReader(source).read(), 0, 0).value();
}

/// Simplifies a tube whose weights are stored in a type to a part of the faces.
void check_tube(std::size_t type) {
  const std::string content = skinned_tube(type).glb();
  const Folder folder;
  GltfMeshes meshes = GltfMeshes::read(folder.file("in", content));
  GltfSceneSurface(meshes.surfaces(), meshes.placements()).simplify({.ratio = 0.15}, {});
  write_gltf(folder.path("out"), meshes.take(), ".glb");
  const GltfPrimitive before = primitive_of(content);
  const GltfPrimitive after = primitive_of(read_content(folder.path("out")));
  REQUIRE(after.triangles.size() <= before.triangles.size() * 15 / 100);

  const Elements& weights = values(after, "WEIGHTS_0");
  for (std::size_t v = 0; v < weights.size(); ++v) {
    const Element w = weights[v];
    CHECK(std::abs(w[0] + w[1] + w[2] + w[3] - 1) < 1e-6);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    CAPTURE(axis);
    const Posed was = posed(before, axis), is = posed(after, axis);
    CHECK(greatest_distance(was, is) < 0.04);
    CHECK(greatest_distance(is, was) < 0.02);
  }
}

} // namespace

TEST_CASE("a tube of two joints keeps its elbow: it follows in every pose") {
  SECTION("with weights of single precision") {
    check_tube(single);
  }
  SECTION("with weights of bytes") {
    check_tube(unsigned_byte);
  }
}

#endif
