// The measure of texture deviation, on surfaces whose deviation is known.
#include "soups.h"

#include <quadrille/attribute_quadric.h>
#include <quadrille/simplify.h>
#include <quadrille/texture_deviation.h>

#include <catch2/catch.hpp>

#include <CGAL/property_map.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace {

using namespace quadrille;

// A grid in the plane z = 0, whose texture is a map of its points.
template <class Map>
TexturedSoup textured(const test::Soup& soup, Map map) {
  TexturedSoup result{{soup.points, soup.triangles}, {{}, soup.triangles}, {}};
  for (const auto& p : soup.points)
    result.texture.points.push_back(map(p));
  return result;
}

Vector<2> flat(const test::Position& p) {
  return {{p[0], p[1]}};
}

const test::Soup sheet = test::grid(16, 12);

} // namespace

TEST_CASE("A surface has no deviation from itself, whatever its triangles") {
  const TexturedSoup original = textured(sheet, flat);
  for (const auto& soup : {sheet, test::grid(3, 5)}) {
    const TextureDeviation deviation = texture_deviation(textured(soup, flat), original, 20'000);
    CHECK(deviation.greatest < 1e-7);
    CHECK(deviation.bleeding == 0);
    CHECK(deviation.flipped == 0);
  }
}

TEST_CASE("A texture that has slid deviates by its way, and bleeds where it has left its chart") {
  const TexturedSoup original = textured(sheet, flat);
  const TexturedSoup slid = textured(sheet, [](const auto& p) {
    return Vector<2>{{p[0] + 0.125, p[1]}};
  });
  const TextureDeviation deviation = texture_deviation(slid, original, 50'000);
  CHECK(deviation.rms == Approx(0.125));
  CHECK(deviation.greatest == Approx(0.125));
  CHECK(deviation.percentile_99 == Approx(0.125));
  CHECK(deviation.bleeding == Approx(0.125).epsilon(0.01));
}

TEST_CASE("A texture that is stretched deviates more the further away") {
  const TexturedSoup original = textured(sheet, flat);
  const TexturedSoup stretched = textured(sheet, [](const auto& p) {
    return Vector<2>{{0.5 * p[0], p[1]}};
  });
  const TextureDeviation deviation = texture_deviation(stretched, original, 50'000);
  CHECK(deviation.rms == Approx(0.5 / std::sqrt(3)).epsilon(0.01)); // of x / 2, x even in [0, 1]
  CHECK(deviation.greatest == Approx(0.5).epsilon(0.01));
  CHECK(deviation.percentile_99 == Approx(0.495).epsilon(0.01));
}

TEST_CASE("A surface that is turned over in its texture is seen") {
  const TexturedSoup original = textured(sheet, flat);
  const TexturedSoup mirrored = textured(sheet, [](const auto& p) {
    return Vector<2>{{1 - p[0], p[1]}};
  });
  CHECK(texture_deviation(mirrored, original, 10'000).flipped == 1);
}

TEST_CASE("Where labels differ, a place of the texture is another one") {
  TexturedSoup original = textured(sheet, flat), surface = original;
  original.labels.assign(sheet.triangles.size(), 1);
  surface.labels.assign(sheet.triangles.size(), 2);
  CHECK(texture_deviation(surface, original, 1000).bleeding == 1);
}

TEST_CASE("Of several places with the same texture the nearest counts") {
  // Two sheets, one above the other, with the same texture.
  const TexturedSoup original = textured(test::joined(sheet, sheet, {{0, 0, 5}}), flat);
  const TexturedSoup upper = textured(test::mapped(sheet,
                                                   [](const auto& p) {
                                                     return test::Position{{p[0], p[1], 4.5}};
                                                   }),
                                      flat);
  CHECK(texture_deviation(upper, original, 1000).greatest == Approx(0.5));
}

TEST_CASE("Torn edges are those of other than two faces, after welding") {
  const test::Soup sphere = test::sphere(2);
  TriangleSoup<> torn;
  for (const auto& t : sphere.triangles) { // no two faces share a vertex
    const auto first = static_cast<std::uint32_t>(torn.points.size());
    torn.triangles.push_back({first, first + 1, first + 2});
    for (std::size_t i = 0; i < 3; ++i)
      torn.points.push_back(sphere.points[t[i]]);
  }
  CHECK(count_torn_edges(torn) == 0);
  torn.points[0][0] += 1e-9;
  CHECK(count_torn_edges(torn) == 4); // two of its face, two of the other faces there

  const TriangleSoup<> book{{{{0, 0, 0}}, {{0, 0, 1}}, {{1, 0, 0}}, {{-1, 1, 0}}, {{-1, -1, 0}}},
                            {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}};
  CHECK(count_torn_edges(book) == 7); // with its spine
}

TEST_CASE("A simplified terrain keeps its texture by TextureQuadric, and not by Quadric") {
  const test::Soup terrain = test::mapped(test::grid(60, 60), [](const auto& p) {
    return test::Position{{p[0], p[1], 0.1 * std::sin(7 * p[0]) * std::cos(5 * p[1])}};
  });
  const auto wavy = [](const auto& p) {
    return Vector<2>{{p[0] + 0.05 * std::sin(9 * p[1]), p[1] + 0.05 * std::sin(8 * p[0])}};
  };
  const TexturedSoup original = textured(terrain, wavy);
  const auto rms_by = [&](bool by_texture) {
    std::vector<std::array<double, 3>> points;
    std::vector<std::array<double, 2>> coordinates;
    for (const auto& p : terrain.points) {
      points.push_back({p[0], p[1], p[2]});
      coordinates.push_back({wavy(p)[0], wavy(p)[1]});
    }
    auto triangles = terrain.triangles;
    const auto map = CGAL::make_property_map(coordinates);
    if (by_texture)
      simplify<TextureQuadric>(points, triangles, FaceRatio{0.05},
                               CGAL::parameters::vertex_texture_map(map));
    else
      simplify(points, triangles, FaceRatio{0.05}, EndpointPlacement{});
    TexturedSoup result{{{}, triangles}, {{}, triangles}, {}};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vector<3>& p = result.shape.points.emplace_back(Vector<3>{points[i]});
      result.texture.points.push_back(by_texture ? Vector<2>{coordinates[i]}
                                                 : wavy(p)); // ends keep their texture
    }
    return texture_deviation(result, original, 50'000).rms;
  };
  CHECK(rms_by(true) < 0.5 * rms_by(false));
}

TEST_CASE("Soups without coordinates for all corners are refused") {
  TexturedSoup soup = textured(sheet, flat);
  const TexturedSoup original = soup;
  soup.texture.triangles.pop_back();
  CHECK_THROWS_AS(texture_deviation(soup, original), std::invalid_argument);
  soup = original;
  soup.texture.triangles[3][1] = static_cast<std::uint32_t>(soup.texture.points.size());
  CHECK_THROWS_AS(texture_deviation(soup, original), std::invalid_argument);
}
