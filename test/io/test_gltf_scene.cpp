// Scenes of several meshes in examples/products/mesh_io/gltf.h: one price over all of them, and no
// cracks between.

#if __has_include(<nlohmann/json.hpp>)

#include "../examples/products/mesh_io/gltf.h"
#include "folder.h"
#include "gltf_assets.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace quadrille_examples;
using namespace gltf_assets;
using test::Folder;

namespace {

using Surfaces = std::vector<GltfSurface>;

/// A document of meshes without attributes, each of which is shown by a node at least.
class SceneAsset {
public:
  SceneAsset() {
    asset_.json()["meshes"] = Json::array();
    asset_.json()["nodes"] = Json::array();
  }
  std::size_t add_mesh(const std::vector<Element>& positions,
                       const std::vector<std::uint32_t>& corners) {
    Json primitive;
    primitive["attributes"]["POSITION"] = asset_.add(positions, 3);
    primitive["indices"] = asset_.add_indices(corners);
    Json mesh;
    mesh["primitives"].push_back(primitive);
    asset_.json()["meshes"].push_back(mesh);
    return asset_.json()["meshes"].size() - 1;
  }
  void show(std::size_t mesh, Json node = Json::object()) {
    node["mesh"] = mesh;
    asset_.json()["nodes"].push_back(node);
  }
  /// All surfaces after a simplification to a part of the faces.
  Surfaces simplified(double ratio) const {
    const Folder folder;
    GltfMeshes meshes = GltfMeshes::read(folder.file("in", asset_.glb()));
    GltfSceneSurface(meshes.surfaces(), meshes.placements()).simplify({.ratio = ratio}, {});
    return meshes.surfaces();
  }

private:
  Asset asset_;
};

/// A wavy sheet over [first, last] × [0, n] of unit squares, mapped.
template <class Map>
void add_sheet(SceneAsset& scene, int first, int last, int n, Map map, const Json& node) {
  std::vector<Element> positions;
  std::vector<std::uint32_t> corners;
  const auto rows = static_cast<std::uint32_t>(n + 1);
  for (int i = first; i <= last; ++i)
    for (int j = 0; j <= n; ++j)
      positions.push_back(
          map(Element{double(i), double(j), std::sin(i * 0.7) * std::cos(j * 0.5)}));
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(last - first); ++i)
    for (std::uint32_t j = 0; j + 1 < rows; ++j) {
      const std::uint32_t v = i * rows + j;
      corners.insert(corners.end(), {v, v + rows, v + rows + 1, v, v + rows + 1, v + 1});
    }
  scene.show(scene.add_mesh(positions, corners), node);
}

std::set<std::uint32_t> boundary_of(const GltfSurface& surface) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& triangle : surface.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      ++edges[std::minmax(triangle[i], triangle[(i + 1) % 3])];
  std::set<std::uint32_t> points;
  for (const auto& [edge, count] : edges)
    if (count == 1)
      points.insert({edge.first, edge.second});
  return points;
}

/// Where a mesh has its border at a place x of the scene, the other coordinates.
template <class ToScene>
std::set<std::array<long, 2>> boundary_at(const GltfSurface& surface, double x, ToScene to_scene) {
  std::set<std::array<long, 2>> places;
  for (const std::uint32_t v : boundary_of(surface)) {
    const Vector place = to_scene(surface.place(v));
    if (std::abs(place[0] - x) < 1e-3)
      places.insert({std::lround(place[1] * 1e3), std::lround(place[2] * 1e3)});
  }
  return places;
}

const auto as_it_is = [](const Vector& place) { return place; };

} // namespace

TEST_CASE("meshes that meet stay together") {
  for (const double ratio : {0.5, 0.1, 0.03}) {
    SceneAsset scene;
    for (int k = 0; k < 3; ++k)
      add_sheet(
          scene, 8 * k, 8 * k + 8, 24, [](const Element& p) { return p; }, Json::object());
    const Surfaces left = scene.simplified(ratio);
    for (std::size_t k = 0; k < 2; ++k) {
      // Their common border may bend, but not for one of them alone.
      std::set<Vector> ends;
      std::size_t common = 0;
      for (const std::uint32_t v : boundary_of(left[k]))
        ends.insert(left[k].place(v));
      for (const std::uint32_t v : boundary_of(left[k + 1]))
        common += ends.contains(left[k + 1].place(v));
      CHECK(common >= 2);
      std::size_t lone = 0; // off the outer border
      for (const std::uint32_t v : boundary_of(left[k + 1])) {
        const Vector p = left[k + 1].place(v);
        lone += std::abs(p[0] - 8. * static_cast<double>(k + 1)) < 2 && p[1] > 1 && p[1] < 23 &&
                !ends.contains(p);
      }
      CHECK(lone == 0);
    }
  }
}

TEST_CASE("meshes meet where their nodes bring them, mirrored or scaled") {
  SceneAsset scene;
  add_sheet(
      scene, 0, 8, 24, [](const Element& p) { return p; }, Json::object());
  add_sheet(scene, 8, 16, 24,
            [](const Element& p) {
              return Element{(8 - p[0]) / 2, p[1] / 2, p[2] / 2};
            },
            {{"scale", {-2, 2, 2}}, {"translation", {8, 0, 0}}});
  const Surfaces left = scene.simplified(0.2);
  const auto back = [](const Vector& p) { return Vector{8 - 2 * p[0], 2 * p[1], 2 * p[2]}; };
  std::set<std::array<long, 3>> ends;
  const auto rounded = [](const Vector& p) {
    return std::array{std::lround(p[0] * 1e3), std::lround(p[1] * 1e3), std::lround(p[2] * 1e3)};
  };
  for (const std::uint32_t v : boundary_of(left[0]))
    ends.insert(rounded(left[0].place(v)));
  for (const std::uint32_t v : boundary_of(left[1]))
    if (const Vector p = back(left[1].place(v)); p[0] < 9.5 && p[1] > 1 && p[1] < 23)
      CHECK(ends.contains(rounded(p)));
}

TEST_CASE("an instance that meets others is held there") {
  // Waves that are the same at both ends of a sheet, and not straight anywhere.
  const auto wave = [](const Element& p) {
    return Element{p[0], p[1], std::sin(p[1]) + std::sin(p[0] * std::numbers::pi / 4)};
  };
  const auto boundary_of_input = [&](double x) {
    std::set<std::array<long, 2>> places;
    for (int j = 0; j <= 24; ++j)
      places.insert({1000 * j, std::lround(1e3 * wave({x, double(j)})[2])});
    return places;
  };
  SceneAsset scene;
  add_sheet(scene, 0, 8, 24, wave, Json::object());
  SECTION("by each other, at two borders") {
    scene.show(0, {{"translation", {8, 0, 0}}});
    const Surfaces left = scene.simplified(0.2);
    CHECK(boundary_at(left[0], 0, as_it_is) == boundary_of_input(0));
    CHECK(boundary_at(left[0], 8, as_it_is) == boundary_of_input(8));
  }
  SECTION("by their mirror images, at one border") {
    scene.show(0, {{"scale", {-1, 1, 1}}, {"translation", {16, 0, 0}}});
    const Surfaces left = scene.simplified(0.2);
    CHECK(boundary_at(left[0], 8, as_it_is) == boundary_of_input(8));
    CHECK(boundary_at(left[0], 0, as_it_is).size() < 20);
  }
  SECTION("by a mesh that is shown once, which is held too") {
    scene.show(0, {{"translation", {0, 100, 0}}});
    add_sheet(scene, 8, 16, 24, wave, Json::object());
    const Surfaces left = scene.simplified(0.2);
    for (const GltfSurface& surface : left)
      CHECK(boundary_at(surface, 8, as_it_is) == boundary_of_input(8));
    CHECK(boundary_at(left[0], 0, as_it_is).size() < 20);
    CHECK(boundary_at(left[1], 16, as_it_is).size() < 20);
  }
}

TEST_CASE("there is one price in the units of the scene") {
  // The same ball at 1 and at 1/50 of its size, and one that is large in one of two instances.
  const Side side = half_of_ball(0, 12);
  SceneAsset scene;
  for (int i = 0; i < 3; ++i)
    scene.add_mesh(side.positions, side.corners);
  scene.show(0);
  scene.show(1, {{"scale", {0.02, 0.02, 0.02}}, {"translation", {5, 0, 0}}});
  scene.show(2, {{"scale", {0.02, 0.02, 0.02}}, {"translation", {10, 0, 0}}});
  scene.show(2, {{"translation", {15, 0, 0}}});
  const Surfaces left = scene.simplified(0.4);
  CHECK(left[1].triangles.size() * 5 < left[0].triangles.size());
  CHECK(left[2].triangles.size() ==
        Approx(static_cast<double>(left[0].triangles.size())).epsilon(0.2));
}

TEST_CASE("meshes at one place, flat ones and those that no node shows are no hindrance") {
  SceneAsset scene;
  const auto same = [](const Element& p) { return p; };
  for (int i = 0; i < 2; ++i) // of one border, so their corner triangles would be the same
    add_sheet(scene, 0, 4, 4, same, Json::object());
  add_sheet(scene, 0, 4, 4, same, {{"scale", {1, 1, 0}}});
  scene.add_mesh(side_of_ball(0, 4).positions, side_of_ball(0, 4).corners);
  const Surfaces left = scene.simplified(1);
  for (const GltfSurface& surface : left)
    CHECK(surface.triangles.size() == 32);
}

#endif
