// The measures of charts.h, on textured surfaces whose charts are known, and on spoilt ones.
#include "charts.h"
#include "soups.h"
#include "textured.h"

#include <catch2/catch.hpp>

#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

namespace {

using namespace test;

struct Model {
  std::string name;
  Textured surface;
  std::size_t charts;
  long euler; // of each chart, cut along its seams
  std::size_t corners, arcs, loops;
  std::size_t half_seams = 0; // edges that are discontinuous at one end
};

std::vector<Model> models() {
  return {{"cylinder", textured_cylinder(12, 5), 1, 1, 2, 3, 0},
          {"cylinder with its seam elsewhere", textured_cylinder(12, 5, 7), 1, 1, 2, 3, 0},
          {"torus", textured_torus(9, 7), 1, 1, 1, 2, 0},
          {"earth", earth(8, 6), 1, 1, 2, 1, 0, 14},
          {"cube", textured_cube(3), 6, 1, 8, 12, 0},
          {"20 charts", sphere_of_20_charts(2), 20, 1, 12, 30, 0},
          {"mirrored sphere", mirrored_sphere(3), 2, 1, 0, 0, 1},
          {"two materials", two_materials(3, 0), 2, 1, 0, 0, 1},
          {"two materials with a wave", two_materials(4, 0.2), 2, 1, 0, 0, 1},
          {"dart", dart(8), 1, 1, 2, 2, 0, 1},
          {"double dart", double_dart(8), 1, 0, 2, 1, 1, 2},
          {"Moebius strip", moebius_strip(12, 4, 0), 1, 1, 2, 3, 0},
          {"Moebius strip with its seam elsewhere", moebius_strip(12, 4, 5), 1, 1, 2, 3, 0},
          {"three pages", three_pages(4, 2), 3, 1, 2, 4, 0},
          {"three pages of one texture", three_pages(4, 0), 3, 1, 2, 4, 0}};
}

bool is_same_pattern(const Textured& a, const Textured& b) {
  return pattern_of(a) == pattern_of(b);
}

} // namespace

TEST_CASE("The charts of the models are known") {
  for (const Model& model : models()) {
    const ChartPattern pattern = pattern_of(model.surface);
    INFO(model.name << ": " << pattern);
    CHECK(pattern.charts.size() == model.charts);
    for (const auto& chart : pattern.charts)
      CHECK(chart.euler == model.euler);
    CHECK(pattern.corners.size() == model.corners);
    CHECK(pattern.arcs.size() == model.arcs);
    CHECK(pattern.loops == model.loops);
    CHECK(count_jumps(model.surface.soup, model.surface.texture, 1) == model.half_seams);
    CHECK(is_finite(model.surface));
    CHECK(topology_of(model.surface.soup).components == 1);
  }
}

TEST_CASE("The charts of the models have an area, and are turned over where they are mirrored") {
  for (const Model& model : models()) {
    CAPTURE(model.name);
    for (const auto& triangle : model.surface.texture)
      CHECK(std::abs(texture_area(triangle)) > 1e-6);
    const bool is_mirrored =
        model.name == "mirrored sphere" || model.name == "Moebius strip with its seam elsewhere";
    CHECK((count_turned(model.surface) > 0) == is_mirrored);
  }
  CHECK(texture_area(textured_cylinder(12, 5)) == Approx(1));
  CHECK(texture_area(textured_cube(4)) == Approx(6 / 16.));
  CHECK(pattern_of(mirrored_sphere(2)).charts.front().turned == -1);
  CHECK(pattern_of(mirrored_sphere(2)).charts.back().turned == 1);
}

TEST_CASE("A place of the texture that is spoilt shows in the pattern") {
  for (const Model& model : models()) {
    CAPTURE(model.name);
    Textured spoilt = model.surface;
    const std::size_t at = spoilt.texture.size() - 1;
    for (TexturePlace& place : spoilt.texture[at])
      place += {{100, 100}};
    CHECK_FALSE(is_same_pattern(spoilt, model.surface)); // the triangle is a chart of its own
    spoilt = model.surface;
    std::swap(spoilt.texture[at][0], spoilt.texture[at][1]);
    CHECK_FALSE(is_same_pattern(spoilt, model.surface));
    spoilt = model.surface;
    ++spoilt.labels[at];
    CHECK_FALSE(is_same_pattern(spoilt, model.surface));
  }
}

TEST_CASE("A corner that moves shows in the pattern, and a line does not") {
  const Textured cube = textured_cube(2);
  const ChartPattern pattern = pattern_of(cube);
  for (std::size_t v = 0; v < cube.soup.points.size(); ++v) {
    Textured moved = cube;
    moved.soup.points[v] += {{1e-15, 1e-15, 1e-15}};
    const auto& corners = pattern.corners;
    const bool is_corner =
        std::find(corners.begin(), corners.end(), cube.soup.points[v].coordinates) != corners.end();
    CHECK(is_same_pattern(moved, cube) == !is_corner);
  }
}

TEST_CASE("Which way the triangles of a soup turn is no fold") {
  Textured cylinder = textured_cylinder(8, 4);
  const ChartPattern pattern = pattern_of(cylinder);
  for (std::size_t f = 0; f < cylinder.labels.size(); f += 3) {
    std::swap(cylinder.soup.triangles[f][1], cylinder.soup.triangles[f][2]);
    std::swap(cylinder.texture[f][1], cylinder.texture[f][2]);
  }
  const ChartPattern of_mixed = pattern_of(cylinder);
  CHECK((of_mixed.arcs == pattern.arcs));
  CHECK(of_mixed.charts.size() == 1);
  CHECK(of_mixed.charts[0].turned == 0);
}

TEST_CASE("Charts with the same numbers that meet in a vertex only are two") {
  const Soup sheet = grid(2, 2);
  const Textured checkered = textured(sheet, [&](std::size_t t, std::uint32_t v) {
    const Position &p = sheet.points[v], c = centre(sheet, sheet.triangles[t]);
    return TexturePlace{{p[0] + ((c[0] > 0.5) != (c[1] > 0.5) ? 7 : 0), p[1]}};
  });
  const ChartPattern pattern = pattern_of(checkered);
  CHECK(pattern.charts.size() == 4);
  CHECK(pattern.corners.size() == 5); // with four in the middles of the border's sides
  CHECK(pattern.arcs.size() == 8);
}

TEST_CASE("The pattern of labels does not look at the texture") {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Textured surface = random_charts(sphere(3), seed);
    const ChartPattern pattern = pattern_of_labels(surface);
    CHECK(pattern.charts.size() < pattern_of(surface).charts.size());
    surface.texture = random_corners(surface.soup, seed).texture;
    CHECK((pattern_of_labels(surface) == pattern));
  }
}

TEST_CASE("Random charts have no edge that is a seam at one end only, random corners have many") {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Textured charts = random_charts(torus(20, 10), seed);
    CHECK(count_jumps(charts.soup, charts.texture, 1) == 0);
    CHECK(count_jumps(charts.soup, charts.texture, 2) > 20);
    const Textured corners = random_corners(torus(20, 10), seed);
    CHECK(count_jumps(corners.soup, corners.texture, 1) > 20);
  }
}

TEST_CASE("The drift of seams is that of their points, and of the middles of their edges") {
  const Textured cylinder = textured_cylinder(8, 4);
  CHECK(seam_drift(cylinder, cylinder) < 1e-12);
  Textured moved = cylinder;
  for (Position& p : moved.soup.points)
    p *= 1.25;
  CHECK(seam_drift(moved, cylinder) == Approx(std::hypot(0.25, 0.5)));
}

TEST_CASE("Index triples and split vertices say the same as the corners") {
  for (const Model& model : models()) {
    CAPTURE(model.name);
    const Textured& surface = model.surface;
    const auto [values, triples] = indexed(surface.texture);
    CHECK((at_corners(values, triples) == surface.texture));
    const SplitSoup<2> vertices = split(surface.soup, surface.texture);
    const std::vector<TexturePlace>& of_points = std::get<0>(vertices.values);
    CHECK((at_corners(of_points, vertices.soup.triangles) == surface.texture));
    CHECK(is_identical(welded(vertices.soup), surface.soup));
    CHECK((vertices.soup.points.size() > surface.soup.points.size()) ==
          (model.name != "mirrored sphere" && model.name != "three pages of one texture"));
  }
  const Soup soup = cube(2);
  const auto normals = facet_normals(soup);
  const auto both = split(soup, textured_cube(2).texture, normals);
  CHECK(both.soup.points.size() == 6 * 9);
  CHECK((at_corners(std::get<1>(both.values), both.soup.triangles) == normals));
}

TEST_CASE("The list of faces does not depend on numbers, but on all else") {
  const Textured cube = textured_cube(2);
  Textured other = cube;
  std::rotate(other.soup.triangles[3].begin(), other.soup.triangles[3].begin() + 1,
              other.soup.triangles[3].end());
  std::rotate(other.texture[3].begin(), other.texture[3].begin() + 1, other.texture[3].end());
  std::swap(other.soup.triangles[0], other.soup.triangles[5]);
  std::swap(other.texture[0], other.texture[5]);
  CHECK((described(other) == described(cube)));
  other.texture[7][1][0] += 1e-15;
  CHECK_FALSE((described(other) == described(cube)));
  other = cube;
  other.labels[4] = 9;
  CHECK_FALSE((described(other) == described(cube)));
}
