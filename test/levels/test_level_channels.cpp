// Levels of surfaces with attributes: each has the values that simplify leaves.
#include "meshes.h"
#include "soups.h"
#include "textured.h"

#include <quadrille/attribute_quadric.h>
#include <quadrille/channels.h>
#include <quadrille/levels.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>

#include <CGAL/property_map.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace {

using namespace quadrille;
using namespace test;

auto until(std::size_t contractions) {
  return [contractions](const Status& status) { return status.contractions >= contractions; };
}

// The values of a channel of a level at the corners of its triangles.
template <std::size_t N>
CornerValues<N> at_corners(const Level& level, const LevelChannel& channel) {
  REQUIRE(channel.components == N);
  CornerValues<N> result;
  const auto& triangles = channel.triangles.empty() ? level.triangles : channel.triangles;
  REQUIRE(triangles.size() == level.faces);
  for (const auto& triangle : triangles) {
    auto& corners = result.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      if ((triangle[i] + 1) * N > channel.values.size())
        FAIL("a corner has no value");
      std::copy_n(&channel.values[triangle[i] * N], N, corners[i].coordinates.data());
    }
  }
  return result;
}

template <std::size_t N>
void require_equal(const CornerValues<N>& a, const CornerValues<N>& b) {
  REQUIRE(a.size() == b.size());
  bool is_equal = true;
  for (std::size_t f = 0; f < a.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i)
      is_equal = is_equal && a[f][i] == b[f][i];
  REQUIRE(is_equal);
}

std::vector<Vector<3>> colors_of(const Soup& soup) {
  std::vector<Vector<3>> colors;
  for (const Position& p : soup.points)
    colors.push_back({{0.5 + 0.3 * std::sin(3 * p[0]), 0.5 + 0.2 * p[1], 0.9}});
  return colors;
}

void require_equal_points(const Level& level, const PointSoup& soup) {
  REQUIRE(level.triangles == soup.triangles);
  bool is_equal = true;
  for (std::size_t v = 0; v < level.vertices; ++v)
    is_equal = is_equal && Position{level.points[v]} == to_position(soup.points[v]);
  REQUIRE(is_equal);
}

// Of one value a point: numbers of the user's, which as_written(number) of the level's becomes.
template <class Value, class AsWritten>
void require_equal_values(const LevelChannel& channel, const std::vector<Value>& values,
                          std::size_t points, AsWritten as_written) {
  const std::size_t n = channel.components;
  REQUIRE(channel.values.size() == n * points);
  bool is_equal = true;
  for (std::size_t v = 0; v < points; ++v)
    for (std::size_t c = 0; c < n; ++c)
      is_equal = is_equal && as_written(channel.values[n * v + c]) == values[v][c];
  REQUIRE(is_equal);
}
double as_it_is(double x) {
  return x;
}

// A texture with its seams, normals with creases and a colour of each point: all levels.
void require_same_levels(const Textured& surface, Seams seams_of_texture, std::size_t step) {
  const CornerValues<3> facets = facet_normals(surface.soup);
  const auto run = [&](auto stop, auto&&... recorder) {
    PointSoup soup(surface.soup);
    auto [values, triples] = indexed(surface.texture);
    auto [normals, normal_triples] = indexed(facets);
    std::vector<Vector<3>> colors = colors_of(surface.soup);
    std::vector<std::array<double, 1>> heat;
    for (const Position& p : surface.soup.points)
      heat.push_back({p[2] * p[2]});
    const Report report = simplify(
        soup.points, soup.triangles, stop, Texture{values, triples, {.seams = seams_of_texture}},
        Colors{CGAL::make_property_map(colors)}, Normals{normals, normal_triples},
        Attributes{CGAL::make_property_map(heat), {.new_values = NewValues::existing}},
        recorder...);
    return std::tuple(soup, test::at_corners(values, triples),
                      test::at_corners(normals, normal_triples), colors, heat, report);
  };
  Levels levels;
  const auto coarsest = run(FaceRatio{0.05}, record_into(levels));
  const std::size_t contractions = std::get<5>(coarsest).contractions;
  CHECK(contractions > surface.soup.triangles.size() / 4);
  for (std::size_t i = 0; i <= contractions; i += step) {
    CAPTURE(i);
    const auto [soup, texture, normals, colors, heat, report] = run(until(i));
    const Level level = in_input_order(levels.at(AfterContractions{i}));
    require_equal_points(level, soup);
    REQUIRE(level.channels.size() == 4);
    require_equal(at_corners<2>(level, level.channels[0]), texture);
    require_equal_values(level.channels[1], colors, level.vertices, as_it_is);
    require_equal(at_corners<3>(level, level.channels[2]), normals);
    require_equal_values(level.channels[3], heat, level.vertices, as_it_is);
  }
}

TEST_CASE("channels of a level are what simplify leaves") {
  require_same_levels(textured_torus(14, 9), Seams::kept, 7);
  require_same_levels(sphere_of_20_charts(2), Seams::kept, 7);
  require_same_levels(textured_cylinder(12, 7), Seams::priced, 7);
  require_same_levels(mirrored_sphere(4), Seams::free, 7);
}

TEST_CASE("channels of a level are what simplify leaves, of a large surface in any order") {
  Textured earth = test::earth(120, 50);
  require_same_levels(earth, Seams::kept, 2100);
}

TEST_CASE("channels of the last level of passes are what these leave") {
  const Textured surface = textured_torus(100, 60);
  PointSoup soup(surface.soup);
  auto [values, triples] = indexed(surface.texture);
  std::vector<Vector<3>> colors = colors_of(surface.soup);
  Levels levels;
  simplify(soup.points, soup.triangles, FaceRatio{0.05}, Texture{values, triples},
           Colors{CGAL::make_property_map(colors)}, RelaxedOrder{}, record_into(levels));
  const Level level = in_input_order(levels.at(FaceCount{0}));
  require_equal_points(level, soup);
  require_equal(at_corners<2>(level, level.channels[0]), test::at_corners(values, triples));
  require_equal_values(level.channels[1], colors, level.vertices, as_it_is);
}

TEST_CASE("attributes of a cost are channels of a level") {
  const Soup soup = with_noise(sphere(2), 3, 0.02);
  Levels levels;
  const auto run = [&](auto stop, auto&&... recorder) {
    PointSoup points(soup);
    std::vector<std::array<float, 3>> colors;
    for (const Vector<3>& c : colors_of(soup))
      colors.push_back(
          {static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])});
    simplify<ColorQuadric, OptimalPlacement>(
        points.points, points.triangles, stop,
        CGAL::parameters::vertex_color_map(CGAL::make_property_map(colors)), recorder...);
    return std::pair(points, colors);
  };
  run(FaceCount{20}, record_into(levels));
  for (std::size_t faces = 320; faces > 20; faces -= 20) {
    const auto [points, colors] = run(FaceCount{faces});
    const Level level = in_input_order(levels.at(FaceCount{faces}));
    require_equal_points(level, points);
    REQUIRE(level.channels.size() == 1);
    require_equal_values(level.channels[0], colors, level.vertices,
                         [](double x) { return static_cast<float>(x); });
  }
}

TEST_CASE("colours in linear light and small integers are told in the user's numbers") {
  const Soup soup = sphere(2);
  Levels levels;
  const auto run = [&](auto stop, auto&&... recorder) {
    PointSoup points(soup);
    std::vector<std::array<std::uint8_t, 4>> colors;
    for (const Vector<3>& c : colors_of(soup))
      colors.push_back({static_cast<std::uint8_t>(255 * c[0]),
                        static_cast<std::uint8_t>(255 * c[1]),
                        static_cast<std::uint8_t>(255 * c[2]), 128});
    simplify(points.points, points.triangles, stop,
             Colors{CGAL::make_property_map(colors), {.linear_light = true}}, recorder...);
    return std::pair(points, colors);
  };
  run(FaceCount{20}, record_into(levels));
  for (std::size_t faces = 320; faces > 20; faces -= 20) {
    const auto [points, colors] = run(FaceCount{faces});
    const Level level = in_input_order(levels.at(FaceCount{faces}));
    require_equal_points(level, points);
    REQUIRE(level.channels[0].components == 4);
    require_equal_values(level.channels[0], colors, level.vertices,
                         [](double x) { return std::round(x); });
  }
}

} // namespace
