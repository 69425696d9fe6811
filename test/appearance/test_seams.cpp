// Seams of a texture that are kept: charts keep their topology, their neighbours and their corners,
// whatever form the asset has.
#include "charts.h"
#include "meshes.h"
#include "soups.h"
#include "textured.h"
#include "textured_meshes.h"

#include <quadrille/channels.h>
#include <quadrille/simplify.h>
#include <quadrille/texture_deviation.h>
#include <quadrille/threshold_pairs.h>

#include <catch2/catch.hpp>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using namespace test;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;

const ChannelOptions kept{.seams = Seams::kept};

struct Result {
  Textured surface;
  Report report;
};

Soup to_soup(const std::vector<Point>& points, const std::vector<Triangle>& triangles) {
  Soup soup{{}, triangles};
  for (const Point& p : points)
    soup.points.push_back(to_position(p));
  return soup;
}

// --- The forms of an asset -----------------------------------------------------------------------

template <class... Arguments>
Result by_triples(const Textured& surface, const Arguments&... arguments) {
  PointSoup soup(surface.soup);
  auto [values, triples] = indexed(surface.texture);
  std::vector<int> labels = surface.labels;
  const Report report =
      simplify(soup.points, soup.triangles, arguments..., Texture{values, triples, kept},
               Labels{CGAL::make_property_map(labels)});
  REQUIRE(triples.size() == soup.triangles.size());
  labels.resize(soup.triangles.size());
  return {{to_soup(soup.points, soup.triangles), at_corners(values, triples), labels}, report};
}

Result as_triples(const Textured& surface, std::size_t faces) {
  return by_triples(surface, FaceCount{faces});
}

Result as_split_vertices(const Textured& surface, std::size_t faces) {
  auto [vertices, texture] = [&] {
    auto [soup, values] = split(surface.soup, surface.texture);
    return std::pair(PointSoup(soup), std::get<0>(values));
  }();
  std::vector<int> labels = surface.labels;
  const Report report = simplify(vertices.points, vertices.triangles, FaceCount{faces},
                                 SplitVertices{}, Texture{CGAL::make_property_map(texture), kept},
                                 Labels{CGAL::make_property_map(labels)});
  labels.resize(vertices.triangles.size());
  const Soup soup = to_soup(vertices.points, vertices.triangles);
  CHECK(without_isolated_points(soup).points.size() == soup.points.size());
  return {{welded(soup), at_corners(texture, soup.triangles), labels}, report};
}

template <class M>
Result on_mesh(const Textured& surface, std::size_t faces) {
  TexturedMesh<M> asset(surface);
  const Report report = simplify(asset.mesh, FaceCount{faces}, Texture{asset.texture_map(), kept},
                                 Labels{asset.label_map()});
  CHECK(is_valid_triangle_mesh(asset.mesh));
  return {asset.surface(), report};
}

// --- Models --------------------------------------------------------------------------------------

struct Model {
  std::string name;
  Textured surface;
};

// No edge is a seam at one end only, but at the poles of the earth.
std::vector<Model> models() {
  return {{"cylinder", textured_cylinder(24, 10)},
          {"torus", textured_torus(24, 16)},
          {"earth", earth(24, 12)},
          {"20 charts", sphere_of_20_charts(3)},
          {"mirrored sphere", mirrored_sphere(4)},
          {"two materials", two_materials(4, 0)},
          {"two materials with a wave", two_materials(4, 0.2)}};
}

std::vector<Model> models_for_soups_only() {
  return {{"Moebius strip", moebius_strip(30, 8, 0)},
          {"Moebius strip with its seam elsewhere", moebius_strip(30, 8, 13)},
          {"three pages", three_pages(10, 2)},
          {"three pages of one texture", three_pages(10, 0)}};
}

std::size_t part_of(const Textured& surface, double ratio) {
  return static_cast<std::size_t>(ratio * static_cast<double>(surface.labels.size()));
}

void check_pattern(const Textured& result, const Textured& before) {
  const ChartPattern pattern = pattern_of(result), expected = pattern_of(before);
  INFO(expected << "\n  " << pattern);
  const bool is_same = pattern == expected;
  CHECK(is_same);
  CHECK(is_finite(result));
  CHECK(count_jumps(result.soup, result.texture, 1) <= count_jumps(before.soup, before.texture, 1));
}

void check_charts(const Textured& result, const Textured& before) {
  check_pattern(result, before);
  const SoupTopology topology = topology_of(result.soup), expected = topology_of(before.soup);
  INFO(expected << "\n  " << topology);
  CHECK(is_same_topology(topology, expected));
  CHECK_FALSE(topology.has_collapsed_faces);
}

} // namespace

// --- Charts --------------------------------------------------------------------------------------

TEST_CASE("Charts keep their topology, their neighbours and their corners") {
  std::vector<Model> all = models();
  for (Model& model : models_for_soups_only())
    all.push_back(std::move(model));
  for (const auto& [name, surface] : all)
    for (const double ratio : {0.4, 0.1, 0.}) {
      const auto [result, report] = as_triples(surface, part_of(surface, ratio));
      CAPTURE(name, ratio, report);
      check_charts(result, surface);
      CHECK(result.labels.size() == report.faces_after);
      if (ratio > 0.2)
        CHECK(is_target_reached(report.stop));
      if (ratio == 0)
        CHECK(report.rejected(Rejection::seam) + report.rejected(Rejection::destruction) > 0);
    }
}

TEST_CASE("Corners of charts that are not told vanish") { // else the patterns say nothing
  const ChartPattern pattern = pattern_of(sphere_of_20_charts(3));
  PointSoup soup(sphere_of_20_charts(3).soup);
  simplify(soup.points, soup.triangles, FaceRatio{0.1});
  const auto is_left = [&](const ChartPattern::Place& corner) {
    return std::any_of(soup.points.begin(), soup.points.end(),
                       [&](const Point& p) { return to_position(p).coordinates == corner; });
  };
  CHECK_FALSE(std::all_of(pattern.corners.begin(), pattern.corners.end(), is_left));
}

TEST_CASE("The seam of a cylinder stays a path from border to border, along which v is linear") {
  const Textured cylinder = textured_cylinder(40, 16);
  for (const std::size_t faces : {400U, 100U, 14U}) {
    const auto [result, report] = as_triples(cylinder, faces);
    CAPTURE(faces, report);
    CHECK(report.faces_after <= faces);
    check_charts(result, cylinder);
    for (std::size_t t = 0; t < result.labels.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const Position& p = result.soup.points[result.soup.triangles[t][i]];
        CHECK(result.texture[t][i][1] == Approx(p[2] / 2).margin(1e-9));
      }
    for (const auto& [edge, sides] : sides_of_edges(result.soup))
      if (sides.size() == 2 && jumps(result.texture, sides) == 2)
        for (const EdgeSide& side : sides)
          for (const std::size_t corner : {side.lower, side.upper}) {
            const double u = result.texture[side.face][corner][0];
            CHECK(std::min(std::abs(u), std::abs(u - 1)) < 0.02);
          }
  }
}

TEST_CASE("A cube of six charts comes to twelve faces, with the texture exactly where it was") {
  const Textured cube = textured_cube(8);
  for (const bool has_two_labels : {false, true}) {
    const Textured surface = with_labels(
        cube, [&](const Position& p) { return has_two_labels && side_of_cube(p) < 3 ? 1 : 0; });
    const auto [result, report] = as_triples(surface, 12);
    CAPTURE(has_two_labels, report);
    CHECK(report.stop == StopReason::target_met);
    CHECK(result.labels.size() == 12);
    CHECK(result.soup.points.size() == 8);
    check_charts(result, surface);
    CHECK(texture_area(result) == Approx(6 / 16.).epsilon(1e-12));
    for (std::size_t t = 0; t < result.labels.size(); ++t) {
      const int side = side_of_cube(centre(result.soup, result.soup.triangles[t]));
      REQUIRE(side >= 0);
      for (std::size_t i = 0; i < 3; ++i) {
        const Position& p = result.soup.points[result.soup.triangles[t][i]];
        CHECK(squared_distance(result.texture[t][i], place_on_cube(side, p)) < 1e-24);
      }
    }
  }
}

TEST_CASE("An earth comes to its target, though each face has a place of its own at the poles") {
  const Textured surface = earth(32, 16);
  const auto [result, report] = as_triples(surface, 57);
  CAPTURE(report);
  CHECK(is_target_reached(report.stop));
  check_charts(result, surface);
  CHECK(count_turned(result) == 0);
  CHECK(texture_area(result) > 0.75);
  CHECK(texture_area(result) < 1.05);
}

TEST_CASE("A texture is mirrored where it was, and goes to few faces all the same") {
  const Textured surface = mirrored_sphere(4);
  const auto [result, report] = as_triples(surface, 40);
  CAPTURE(report);
  CHECK(is_target_reached(report.stop));
  check_charts(result, surface);
  CHECK(seam_drift(result, surface) < 0.15);
}

TEST_CASE("Borders of charts stay where they were") {
  const auto drift = [](const Textured& surface, double ratio) {
    return seam_drift(as_triples(surface, part_of(surface, ratio)).surface, surface);
  };
  CHECK(drift(two_materials(4, 0), 0.1) < 0.04);
  CHECK(drift(two_materials(4, 0.2), 0.2) < 0.06);
  CHECK(drift(sphere_of_20_charts(3), 0.2) < 0.05);
}

TEST_CASE("A seam that ends inside stays, until few faces are left") {
  for (const Textured& surface : {dart(16), double_dart(16)})
    for (const double ratio : {0.4, 0.1, 0.}) {
      const auto [result, report] = as_triples(surface, part_of(surface, ratio));
      CAPTURE(ratio, report);
      CHECK(is_finite(result));
      CHECK(count_turned(result) == 0);
      CHECK(faces_of_charts(result).size() == 1);
      CHECK(is_same_topology(topology_of(result.soup), topology_of(surface.soup)));
      if (ratio > 0) {
        CHECK(is_target_reached(report.stop));
        check_charts(result, surface);
        CHECK(texture_area(result) == Approx(texture_area(surface)).epsilon(0.02));
        CHECK(seam_drift(result, surface) < 0.03);
      }
    }
}

// --- Folds and flips -----------------------------------------------------------------------------

TEST_CASE("No face is turned over in the texture, and what would be is counted") {
  // Around the middle of a flat sheet the texture is turned, by more the nearer it is.
  const Soup sheet = with_noise(grid(24, 24), 1, 0.005);
  const Textured surface = textured(sheet, [&](std::size_t, std::uint32_t v) {
    const double x = sheet.points[v][0] - 0.5, y = sheet.points[v][1] - 0.5;
    const double turn = 4 * std::max(0., 0.5 - std::hypot(x, y));
    return TexturePlace{
        {x * std::cos(turn) - y * std::sin(turn), x * std::sin(turn) + y * std::cos(turn)}};
  });
  REQUIRE(count_turned(surface) == 0);
  const auto [result, report] = as_triples(surface, 0);
  CAPTURE(report);
  CHECK(count_turned(result) == 0);
  CHECK(report.rejected(Rejection::texture) > 0);
  CHECK(to_string(Rejection::texture) == "texture");
  check_charts(result, surface);
}

TEST_CASE("Which way the triangles of a soup turn makes no seam") {
  Textured surface = textured_cylinder(24, 10);
  for (std::size_t t = 0; t < surface.labels.size(); t += 3) {
    std::swap(surface.soup.triangles[t][1], surface.soup.triangles[t][2]);
    std::swap(surface.texture[t][1], surface.texture[t][2]);
  }
  const auto [result, report] = as_triples(surface, 100);
  CAPTURE(report);
  CHECK(is_target_reached(report.stop));
  check_charts(result, surface);
}

TEST_CASE("0 and -0 are one place") {
  Soup sheet = mapped(bumpy_sheet(12), [](const Position& p) {
    return p - Position{{0.5, 0.5, 0}};
  });
  const auto with_zero = [&](double zero) {
    return textured(sheet, [&](std::size_t t, std::uint32_t v) {
      const Position& p = sheet.points[v];
      const bool is_left = centre(sheet, sheet.triangles[t])[0] < 0;
      return TexturePlace{{p[0] == 0 && is_left ? zero : p[0], p[1]}};
    });
  };
  const Result result = as_triples(with_zero(-0.), 40), expected = as_triples(with_zero(0.), 40);
  CHECK((described(result.surface) == described(expected.surface)));
  CHECK(result.report.rejections == expected.report.rejections);
}

TEST_CASE("How large a label is in the texture does not matter") {
  const Textured surface = two_materials(4, 0.2);
  const Textured expected = as_triples(surface, 300).surface;
  for (const double factor : {16., 1. / 16}) {
    Textured scaled = surface;
    for (std::size_t t = 0; t < scaled.labels.size(); ++t)
      if (scaled.labels[t] == 1)
        for (TexturePlace& place : scaled.texture[t])
          place *= factor;
    const Textured result = as_triples(scaled, 300).surface;
    CHECK(is_same_surface(result.soup, expected.soup, 1e-6));
    CHECK(std::count(result.labels.begin(), result.labels.end(), 1) ==
          std::count(expected.labels.begin(), expected.labels.end(), 1));
  }
}

// --- Forms ---------------------------------------------------------------------------------------

TEST_CASE("Index triples, split vertices and maps over halfedges give the same, bit for bit") {
  std::vector<Model> all = models();
  all.push_back({"cube", textured_cube(6)});
  all.push_back({"dart", dart(12)});
  all.push_back({"random charts", random_charts(random_closed(1), 5)});
  for (const auto& [name, surface] : all) {
    CAPTURE(name);
    const std::size_t faces = part_of(surface, 0.2);
    const Result expected = as_triples(surface, faces);
    CHECK(expected.surface.labels.size() < surface.labels.size());
    const auto check_same = [&](const std::string& form, const Result& result) {
      CAPTURE(form, result.report, expected.report);
      CHECK((described(result.surface) == described(expected.surface)));
      CHECK(result.report.contractions == expected.report.contractions);
      CHECK(result.report.rejections == expected.report.rejections);
      CHECK(result.report.error == expected.report.error);
    };
    check_same("split vertices", as_split_vertices(surface, faces));
    check_same("Surface_mesh", on_mesh<Mesh>(surface, faces));
    check_same("Polyhedron_3", on_mesh<Polyhedron>(surface, faces));
  }
}

TEST_CASE("Values at corners are told by what they are and not by their index") {
  const Textured surface = textured_torus(24, 16);
  PointSoup soup(surface.soup);
  std::vector<TexturePlace> values; // each corner has its own
  std::vector<Triangle> triples;
  for (const auto& triangle : surface.texture) {
    const auto first = static_cast<std::uint32_t>(values.size());
    triples.push_back({first, first + 1, first + 2});
    values.insert(values.end(), triangle.begin(), triangle.end());
  }
  std::vector<int> labels = surface.labels;
  simplify(soup.points, soup.triangles, FaceCount{200}, Texture{values, triples, kept},
           Labels{CGAL::make_property_map(labels)});
  labels.resize(soup.triangles.size());
  const Textured result{to_soup(soup.points, soup.triangles), at_corners(values, triples), labels};
  CHECK((described(result) == described(as_triples(surface, 200).surface)));
}

TEST_CASE("Duplicate and degenerate triangles go, and points of none, each with its values") {
  const Textured surface = random_charts(random_closed(2), 1);
  Textured spoilt = surface;
  spoilt.soup.points.push_back({{9, 9, 9}});
  const auto add = [&](const Triangle& corners, std::size_t like) {
    const auto at = static_cast<std::ptrdiff_t>(spoilt.labels.size() / 2);
    spoilt.soup.triangles.insert(spoilt.soup.triangles.begin() + at, corners);
    spoilt.texture.insert(spoilt.texture.begin() + at, surface.texture[like]);
    spoilt.labels.insert(spoilt.labels.begin() + at, surface.labels[like]);
  };
  for (std::size_t t = 0; t < surface.labels.size() / 3; t += 3) {
    add(surface.soup.triangles[t], t);
    add({surface.soup.triangles[t][0], surface.soup.triangles[t][1], surface.soup.triangles[t][1]},
        t);
  }
  const std::size_t faces = part_of(surface, 0.5);
  const Result result = as_triples(spoilt, faces), expected = as_triples(surface, faces);
  CHECK((described(result.surface) == described(expected.surface)));
  CHECK(result.surface.soup.points.size() == expected.surface.soup.points.size());
}

TEST_CASE("Split vertices of a surface that is not manifold stay split where they were") {
  for (const auto& [name, surface] : models_for_soups_only()) {
    CAPTURE(name);
    const std::size_t faces = part_of(surface, 0.3);
    const Result expected = as_triples(surface, faces), result = as_split_vertices(surface, faces);
    CHECK((described(result.surface) == described(expected.surface)));
  }
}

TEST_CASE("Charts that are apart in space become one surface by ThresholdPairs, with their seams") {
  const Textured whole = sphere_of_20_charts(3);
  const Textured apart{split(whole.soup, whole.texture).soup, whole.texture, whole.labels};
  REQUIRE(topology_of(apart.soup).components == 20);
  auto [result, report] = by_triples(apart, FaceCount{400}, ThresholdPairs{1e-6});
  CAPTURE(report);
  CHECK(report.non_edge_contractions > 0);
  result.soup = welded(result.soup);
  CHECK(topology_of(result.soup).is_closed());
  check_pattern(result, whole);
}

// --- Random values -------------------------------------------------------------------------------

// Calls check(result, surface) for surfaces with a random texture, to half of their faces and as
// far as they go.
template <class TextureOf, class Check>
void check_random(std::uint64_t seeds, TextureOf texture_of, Check check) {
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const Soup soup =
        seed % 4 == 3 ? with_holes(random_closed(seed), seed, 12) : random_closed(seed);
    const Textured surface = texture_of(soup, seed);
    for (const double ratio : {0.5, 0.}) {
      const auto [result, report] = as_triples(surface, part_of(surface, ratio));
      CAPTURE(seed, ratio, report);
      check(result, surface);
    }
  }
}

TEST_CASE("Charts of random patches, some of one place, keep their pattern") {
  check_random(24, random_charts, check_charts);
}

TEST_CASE("Faces that get an area in the texture late, and are folded then, tear no label") {
  const auto crumpled = [](const Soup& soup, std::uint64_t seed) {
    Textured surface = random_corners(soup, seed);
    Random random(seed);
    for (auto& corners : surface.texture)
      for (TexturePlace& place : corners)
        place = {{std::round(2 * place[0]), random.below(8) == 0 ? 1. : 0.}};
    return surface;
  };
  check_random(48, crumpled, [](const Textured& result, const Textured& surface) {
    const bool is_same = pattern_of_labels(result) == pattern_of_labels(surface);
    CHECK(is_same);
  });
}

TEST_CASE("Random values at corners leave labels as they are, and finite values") {
  check_random(48, random_corners, [](const Textured& result, const Textured& surface) {
    CHECK(is_finite(result));
    CHECK(is_same_topology(topology_of(result.soup), topology_of(surface.soup)));
    const bool is_same = pattern_of_labels(result) == pattern_of_labels(surface);
    CHECK(is_same);
  });
}
