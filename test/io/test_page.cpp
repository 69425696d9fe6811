// What a page holds of a recording: every level of it, and what its vertices and corners have.
#include "../examples/products/mesh_io/attributes/mesh_channels.h"
#include "../examples/products/page/attribute_recorder.h"
#include "../examples/products/page/file.h"
#include "../examples/products/page/level_arrays.h"
#include "../examples/products/page/track.h"
#include "replay.h"
#include "soups.h"

#include <quadrille/attribute_quadric.h>
#include <quadrille/record.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace quadrille_examples {
const std::array<std::string_view, 4> page_parts = {"<title>", "</title>", "|", "</html>"};
}

namespace {

using namespace quadrille;
using namespace quadrille_examples;
using test::Soup;

/// The numbers of three corners, one after the other, the least corner first.
using Corners = std::vector<float>;

Corners turned(std::array<Corners, 3> corners) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  Corners all;
  for (const Corners& corner : corners)
    all.insert(all.end(), corner.begin(), corner.end());
  return all;
}

/// What levels.js does, by the words of track.h: the numbers that items have after so many
/// contractions, at the corners of the first faces.
std::vector<std::array<Corners, 3>> corners_at(const Track& track, std::size_t contractions,
                                               std::size_t faces) {
  std::vector<float> values = track.values;
  const std::size_t end = contractions == 0 ? 0 : track.change_ends[contractions - 1];
  for (std::size_t change = 0; change < end; ++change)
    std::copy_n(&track.changed_values[change * track.width], track.width,
                &values[track.changed[change] * track.width]);
  std::vector<std::array<Corners, 3>> result(faces);
  for (std::size_t face = 0; face < faces; ++face)
    for (std::size_t i = 0; i < 3; ++i) {
      std::uint32_t item = track.corners[face][i];
      while (track.ends[item] <= contractions)
        item = track.parents[item];
      result[face][i].assign(&values[item * track.width],
                             &values[item * track.width] + track.width);
    }
  return result;
}

std::multiset<Corners> positions_at(const LevelArrays& arrays, std::size_t contractions) {
  const std::size_t faces = contractions == 0 ? arrays.faces : arrays.faces_after[contractions - 1];
  std::multiset<Corners> result;
  for (auto corners : corners_at(arrays.vertices, contractions, faces)) {
    for (Corners& corner : corners)
      corner.resize(3);
    result.insert(turned(corners));
  }
  return result;
}

std::multiset<Corners> positions_of(const Level& level, const PageFrame& frame) {
  std::multiset<Corners> result;
  for (const auto& triangle : level.triangles) {
    std::array<Corners, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
      for (const double x : frame(level.points[triangle[i]]).coordinates)
        corners[i].push_back(static_cast<float>(x));
    result.insert(turned(corners));
  }
  return result;
}

/// Every level, or every tenth one of many, is that of the recording, whichever the first one is.
void require_levels(const Levels& levels, std::size_t most_faces) {
  const RecordedAttributes none;
  LevelArraysBuilder builder(levels, none);
  const LevelArrays arrays = builder.build(most_faces);
  const std::size_t all = levels.coarsest().contractions, left = arrays.faces_after.size();
  REQUIRE(arrays.faces <= std::max(most_faces, levels.coarsest().faces));
  REQUIRE(arrays.errors.size() == left + 1);
  for (std::size_t c = 0; c <= left; c += left < 50 ? 1 : 10) {
    INFO(c << " of " << left << " contractions");
    const Level level = levels.at(AfterContractions{all - left + c});
    REQUIRE(positions_at(arrays, c) == positions_of(level, builder.frame()));
    REQUIRE(static_cast<std::size_t>(
                std::count_if(arrays.vertices.ends.begin(), arrays.vertices.ends.end(),
                              [&](std::uint32_t end) { return end > c; })) == level.vertices);
    REQUIRE(arrays.errors[c] == static_cast<float>(builder.frame().part(level.error)));
  }
}

template <class... Policies>
Levels levels_of(Soup soup, std::size_t faces, const Policies&... policies) {
  Levels levels;
  simplify(soup.points, soup.triangles, FaceCount{faces}, record_into(levels), policies...);
  return levels;
}

/// Three sheets that have an edge in common, and a triangle across one of them.
Soup book() {
  Soup soup = test::joined(test::grid(8, 8), test::tilted(test::grid(6, 6)), {{0, 0, 9}});
  const auto points = static_cast<std::uint32_t>(soup.points.size());
  soup.points.push_back({{4, 4, 5}});
  soup.triangles.push_back({40, 41, points});
  soup.triangles.push_back({41, 40, points});
  soup.triangles.push_back({40, 60, points});
  return soup;
}

TEST_CASE("a page holds each level of a recording") {
  require_levels(levels_of(test::sphere(2), 4), 1000);
  require_levels(levels_of(test::with_noise(test::sphere(3), 5, 0.02), 4), 5000);
  require_levels(levels_of(test::grid(9, 7), 2), 1000);
  require_levels(levels_of(test::triangle(), 1), 1000);
  require_levels(levels_of(book(), 2, Topology::free), 1000);
  require_levels(levels_of(book(), 2, ThresholdPairs(2.5)), 1000);
}

TEST_CASE("a page holds each level of parts that vanish whole") {
  Soup soup = test::sphere(2);
  for (int i = 1; i < 9; ++i)
    soup = test::joined(soup, test::tetrahedron(), {{3. * i, 0.5 * i * i, 0}});
  const Levels levels = levels_of(soup, 20, Topology::components_may_vanish);
  REQUIRE(levels.coarsest().faces <= 20);
  require_levels(levels, 1000);
  require_levels(levels, 100);
}

TEST_CASE("a page that begins at a coarser level holds each level from there on") {
  const Levels levels = levels_of(test::with_noise(test::sphere(3), 5, 0.02), 4);
  for (const std::size_t most : {1279U, 900U, 333U, 7U, 3U})
    require_levels(levels, most);
}

TEST_CASE("the error of a vertex is the root mean square distance to its planes") {
  const Levels levels = levels_of(test::with_noise(test::sphere(3), 5, 0.02), 4, Quadric{});
  const RecordedAttributes none;
  const LevelArrays arrays = LevelArraysBuilder(levels, none).build(5000);
  float greatest = 0; // of a closed surface that is what the run tells
  for (std::size_t c = 0; c < arrays.faces_after.size(); ++c) {
    greatest = std::max(greatest, arrays.vertices.changed_values[4 * c + 3]);
    REQUIRE(greatest <= arrays.errors[c + 1] * 1.00001f); // which counts more of coarse faces
  }
}

IndexedMesh mesh_of(const Soup& soup) {
  IndexedMesh mesh;
  for (const auto& p : soup.points)
    mesh.points.emplace_back(p[0], p[1], p[2]);
  mesh.triangles = soup.triangles;
  return mesh;
}

/// A torus with colours, and texture coordinates that have a seam.
ShownMesh painted_torus() {
  ShownMesh shown;
  shown.mesh = mesh_of(test::torus(24, 16));
  for (const Point& p : shown.mesh.points)
    shown.mesh.colors.push_back(
        {std::round(60 * (p.x() + 2)), std::round(60 * (p.y() + 2)), 9, 255});
  return shown;
}

float byte_as_light(double byte) {
  return static_cast<float>(linear_light(byte / 255));
}

TEST_CASE("a page has the colours that a run leaves, as channels") {
  ShownMesh shown = painted_torus();
  Levels levels;
  AttributeRecorder recorder(shown, levels);
  MeshChannels(shown.mesh).simplify({.faces = 100, .recorder = record_into(recorder)}, {});

  const RecordedAttributes recorded = recorder.take();
  LevelArraysBuilder builder(levels, recorded);
  const LevelArrays arrays = builder.build(10000);
  REQUIRE(arrays.vertices.width == 7);
  REQUIRE(arrays.vertices.values[6] == byte_as_light(9));
  const Level coarsest = in_input_order(levels.at(FaceCount{100}));
  REQUIRE(coarsest.triangles == shown.mesh.triangles);
  const auto corners = corners_at(arrays.vertices, arrays.faces_after.size(), 100);
  const Level unsorted = levels.at(FaceCount{100});
  for (std::size_t face = 0; face < 100; ++face) {
    const auto place = std::lower_bound(coarsest.input_faces.begin(), coarsest.input_faces.end(),
                                        unsorted.input_faces[face]);
    const auto& triangle =
        shown.mesh.triangles[static_cast<std::size_t>(place - coarsest.input_faces.begin())];
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) // the mesh has them rounded to bytes
        REQUIRE(corners[face][i][4 + k] ==
                Approx(byte_as_light(shown.mesh.colors[triangle[i]][k])).margin(0.0045));
  }
}

TEST_CASE("a page has the textures and colours that a run leaves, as channels with seams") {
  ShownMesh shown = painted_torus();
  shown.looks.materials.front().image = 0;
  CornerValues<2>& textures = shown.mesh.corner_textures;
  for (const auto& triangle : shown.mesh.triangles) {
    textures.triples.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const Point& p = shown.mesh.points[triangle[i]];
      const bool is_left = shown.mesh.points[triangle[0]].x() + shown.mesh.points[triangle[1]].x() +
                               shown.mesh.points[triangle[2]].x() <
                           0;
      textures.triples.back()[i] = static_cast<std::uint32_t>(textures.values.size());
      textures.values.push_back({p.y() + (is_left ? 10 : 0), p.z()});
    }
  }
  Levels levels;
  AttributeRecorder recorder(shown, levels);
  MeshChannels(shown.mesh).simplify({.faces = 200, .recorder = record_into(recorder)}, {});
  const RecordedAttributes recorded = recorder.take();
  REQUIRE(recorded.has_colors);
  REQUIRE_FALSE(recorded.has_textures);
  for (const std::size_t most : {10000U, 500U}) {
    LevelArraysBuilder builder(levels, recorded);
    const LevelArrays arrays = builder.build(most);
    const std::size_t faces = shown.mesh.triangles.size();
    const auto at_vertices = corners_at(arrays.vertices, arrays.faces_after.size(), faces);
    const auto at_corners = corners_at(arrays.textures, arrays.faces_after.size(), faces);
    std::multiset<Corners> shown_by_page, left_by_run;
    for (std::size_t face = 0; face < faces; ++face) {
      std::array<Corners, 3> of_page, of_run;
      for (std::size_t i = 0; i < 3; ++i) {
        of_page[i] = {at_vertices[face][i][4], at_corners[face][i][0], at_corners[face][i][1]};
        const auto& color = shown.mesh.colors[shown.mesh.triangles[face][i]];
        const auto& texture = textures.values[textures.triples[face][i]];
        of_run[i] = {byte_as_light(std::clamp(color[0], 0., 255.)), static_cast<float>(texture[0]),
                     static_cast<float>(1 - texture[1])};
      }
      shown_by_page.insert(turned(of_page));
      left_by_run.insert(turned(of_run));
    }
    REQUIRE(shown_by_page == left_by_run);
  }
}

TEST_CASE("no name of a file ends an element of a page") {
  PageSource source;
  source.name = "a\"b</script><img src=x onerror=alert(1)>&\\.off";
  source.levels = levels_of(test::tetrahedron(), 4);
  const std::string page = encode_page(source).content;
  REQUIRE(page.find("<title>a\"b&lt;/script&gt;&lt;img src=x onerror=alert(1)&gt;&amp;\\.off"
                    "</title>{") == 0);
  REQUIRE(page.find("\"name\":\"a\\u0022b\\u003c/script\\u003e\\u003cimg src=x "
                    "onerror=alert(1)\\u003e\\u0026\\u005c.off\"") != std::string::npos);
  REQUIRE(page.find("<script") == std::string::npos);
  REQUIRE(page == encode_page(source).content);
}

} // namespace
