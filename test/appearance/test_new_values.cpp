// What corners have whose values change: those of least cost, weights of a skin, values that there
// were, normals of the result; and colours in linear light.
#include "meshes.h"
#include "soups.h"
#include "textured.h"

#include <quadrille/channels.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

namespace {

using namespace quadrille;
using namespace test;

using Color = std::array<std::uint8_t, 4>;

struct Options {
  ChannelOptions normals = {}, colors = {}, weights = {}, classes = {};
};

// A surface with normals at its corners, and with a colour, three weights and a class at its
// points.
struct Asset {
  explicit Asset(const Soup& surface) : soup(surface) {
    const std::size_t n = soup.points.size();
    colors.resize(n, Color{0, 0, 0, 255});
    weights.resize(n, {1, 0, 0});
    classes.resize(n, 0);
  }

  Report run(std::size_t faces, const Options& options = {}) {
    return simplify(soup.points, soup.triangles, FaceCount{faces},
                    Normals{normals.values, normals.triples, options.normals},
                    Colors{CGAL::make_property_map(colors), options.colors},
                    Attributes{CGAL::make_property_map(weights), options.weights},
                    Attributes{CGAL::make_property_map(classes), options.classes});
  }

  PointSoup soup;
  IndexedCorners<3> normals;
  std::vector<Color> colors;
  std::vector<std::array<double, 3>> weights;
  std::vector<int> classes;
};

Vector<3> unit(const Vector<3>& v) {
  return (1 / std::sqrt(squared_length(v))) * v;
}

// Of each point, the unit normals of its triangles, weighted by their angles there.
std::vector<Vector<3>> angle_weighted_normals(const PointSoup& soup) {
  std::vector<Vector<3>> normals(soup.points.size());
  for (const Triangle& t : soup.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Position p = to_position(soup.points[t[i]]);
      const Vector<3> one = unit(to_position(soup.points[t[(i + 1) % 3]]) - p);
      const Vector<3> other = unit(to_position(soup.points[t[(i + 2) % 3]]) - p);
      normals[t[i]] += std::acos(dot(one, other)) * unit(cross(one, other));
    }
  for (Vector<3>& normal : normals)
    normal = unit(normal);
  return normals;
}

// A sphere, each point of which is black or white.
Asset black_and_white() {
  Asset asset(with_noise(sphere(4), 1, 0.01));
  Random random(7);
  for (Color& color : asset.colors) {
    const std::uint8_t grey = random.below(2) == 0 ? 0 : 255;
    color = {grey, grey, grey, grey};
  }
  return asset;
}

// Over the points that are left.
double mean(const Asset& asset, std::size_t channel) {
  double sum = 0;
  for (std::size_t v = 0; v < asset.soup.points.size(); ++v)
    sum += asset.colors[v][channel];
  return sum / static_cast<double>(asset.soup.points.size());
}

} // namespace

TEST_CASE("Classes stay classes, and where they were") {
  Asset asset(sphere(4));
  const auto class_at = [](double z) { return z < -0.3 ? 3 : z < 0.4 ? 70 : 8; };
  for (std::size_t v = 0; v < asset.classes.size(); ++v)
    asset.classes[v] = class_at(to_position(asset.soup.points[v])[2]);
  Asset averaged = asset;
  asset.run(200, {.classes = {.importance = 0.01, .new_values = NewValues::existing}});
  averaged.run(200, {.classes = {.importance = 0.01}});

  const std::set<int> classes{3, 8, 70};
  const auto is_class = [&](int c) { return classes.contains(c); };
  CHECK_FALSE(std::all_of(averaged.classes.begin(),
                          averaged.classes.begin() + std::ptrdiff_t(averaged.soup.points.size()),
                          is_class)); // else this says nothing
  std::size_t elsewhere = 0;
  for (std::size_t v = 0; v < asset.soup.points.size(); ++v) {
    CHECK(is_class(asset.classes[v]));
    if (asset.classes[v] != class_at(to_position(asset.soup.points[v])[2]))
      ++elsewhere;
  }
  CAPTURE(elsewhere);
  CHECK(elsewhere < 6);
}

TEST_CASE("Of values with index triples, those that there were are left") {
  for (const Seams seams : {Seams::priced, Seams::free}) {
    const Soup surface = with_noise(sphere(3), 2, 0.02);
    Asset asset(surface);
    asset.normals = indexed(facet_normals(surface));
    const std::vector<Vector<3>> before = asset.normals.values;
    asset.run(200, {.normals = {.seams = seams, .new_values = NewValues::existing}});
    REQUIRE_FALSE(asset.normals.values.empty());
    for (const Vector<3>& normal : asset.normals.values)
      CHECK(std::find(before.begin(), before.end(), normal) != before.end());
  }
}

TEST_CASE("Weights of a skin are at least 0 and have the sum 1") {
  for (const bool are_weights : {true, false}) {
    Asset asset(with_noise(sphere(3), 3, 0.05));
    for (std::size_t v = 0; v < asset.weights.size(); ++v) {
      const Position p = to_position(asset.soup.points[v]);
      const double one = std::max(0., p[0]), other = std::max(0., p[1]);
      asset.weights[v] = {one / 2, other / 2, 1 - one / 2 - other / 2};
    }
    asset.run(150,
              {.weights = {.new_values = are_weights ? NewValues::weights : NewValues::optimal}});
    double least = 1, furthest = 0;
    for (std::size_t v = 0; v < asset.soup.points.size(); ++v) {
      const auto& w = asset.weights[v];
      least = std::min({least, w[0], w[1], w[2]});
      furthest = std::max(furthest, std::abs(w[0] + w[1] + w[2] - 1));
    }
    if (are_weights)
      CHECK(least >= 0);
    else
      CHECK(least < 0); // else this says nothing
    CHECK(furthest < (are_weights ? 1e-12 : 1e-7)); // gradients are floats
  }
}

TEST_CASE("In linear light, black and white average to a lighter grey") {
  Asset linear = black_and_white(), plain = black_and_white();
  const double before = mean(plain, 0);
  linear.run(100, {.colors = {.importance = 1e-3, .linear_light = true}});
  plain.run(100, {.colors = {.importance = 1e-3}});
  CHECK(mean(plain, 0) == Approx(before).margin(20));
  CHECK(mean(linear, 0) == Approx(188).margin(25));           // half of the light of white
  CHECK(mean(linear, 3) == Approx(mean(plain, 3)).margin(1)); // alpha is no light
}

TEST_CASE("Colours that nothing averages are the same in linear light, bit for bit") {
  Asset asset(sphere(3));
  for (std::size_t v = 0; v < asset.colors.size(); ++v)
    asset.colors[v] = {std::uint8_t(v % 256), 1, 254, 77};
  const auto before = asset.colors;
  asset.run(asset.soup.triangles.size(), {.colors = {.linear_light = true}});
  CHECK(asset.colors == before);
  asset.run(300, {.colors = {.linear_light = true}});
  for (std::size_t v = 0; v < asset.soup.points.size(); ++v) {
    CHECK(int{asset.colors[v][1]} == 1);
    CHECK(int{asset.colors[v][2]} == 254);
    CHECK(int{asset.colors[v][3]} == 77);
  }
}

TEST_CASE("Normals may be those of the result") {
  Asset asset(mapped(sphere(3), [](const Position& p) { return Position{p[0], 2 * p[1], p[2]}; }));
  asset.normals.values.assign(1, Vector<3>{0, 0, 1}); // whatever they were
  asset.normals.triples.assign(asset.soup.triangles.size(), Triangle{0, 0, 0});
  asset.run(150, {.normals = {.new_values = NewValues::recomputed}});
  const std::vector<Vector<3>> expected = angle_weighted_normals(asset.soup);
  for (std::size_t face = 0; face < asset.soup.triangles.size(); ++face)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector<3>& normal = asset.normals.values[asset.normals.triples[face][i]];
      const Vector<3>& wanted = expected[asset.soup.triangles[face][i]];
      CHECK(squared_length(normal - wanted) < 1e-24);
    }
}

TEST_CASE("Normals of the result keep the edges at which normals differed") {
  const Soup surface = cube(4);
  Asset asset(surface);
  asset.normals = indexed(facet_normals(surface));
  for (Vector<3>& normal : asset.normals.values)
    normal = unit(normal + Vector<3>{0.3, 0.2, 0.1}); // not quite
  asset.run(12, {.normals = {.new_values = NewValues::recomputed}});
  REQUIRE(asset.soup.triangles.size() == 12);
  for (std::size_t face = 0; face < 12; ++face)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto at = [&](std::size_t k) {
        return to_position(asset.soup.points[asset.soup.triangles[face][k]]);
      };
      const Vector<3> normal = unit(cross(at(1) - at(0), at(2) - at(0)));
      CHECK(squared_length(asset.normals.values[asset.normals.triples[face][i]] - normal) < 1e-24);
    }
}
