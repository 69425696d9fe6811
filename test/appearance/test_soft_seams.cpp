// Seams of a texture that are held, as they are by default: targets are met, the shape stays near
// that of priced seams, and few faces show what lies beside their chart.
#include "charts.h"
#include "meshes.h"
#include "soups.h"
#include "textured.h"

#include <quadrille/channels.h>
#include <quadrille/distance.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>
#include <quadrille/texture_deviation.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using namespace test;

/// A bumpy sphere in an atlas of many charts with jagged borders, each in a cell of its own.
Textured sphere_of_patches(std::size_t count) {
  Soup soup = sphere(4);
  for (Position& p : soup.points)
    p = (1 + 0.05 * std::sin(5 * p[0]) * std::sin(4 * p[1] + 1) * std::sin(6 * p[2] + 2)) * p;
  const auto patches = random_patches(soup, 5, count);
  const auto side = static_cast<std::uint32_t>(std::ceil(std::sqrt(count)));
  std::vector<Position> normals(count);
  for (std::size_t t = 0; t < patches.size(); ++t)
    normals[patches[t]] += centre(soup, soup.triangles[t]);
  return textured(soup, [&](std::size_t t, std::uint32_t v) {
    const std::uint32_t patch = patches[t];
    const Position normal = (1 / std::sqrt(squared_length(normals[patch]))) * normals[patch];
    const Position up = std::abs(normal[2]) < 0.9 ? Position{{0, 0, 1}} : Position{{1, 0, 0}};
    Position along = cross(normal, up);
    along *= 1 / std::sqrt(squared_length(along));
    const Position across = cross(normal, along), &p = soup.points[v];
    const auto column = patch % side, row = patch / side;
    return TexturePlace{
        {(column + 0.5 + 0.4 * dot(p, along)) / side, (row + 0.5 + 0.4 * dot(p, across)) / side}};
  });
}

TexturedSoup measured(const Textured& surface) {
  const auto [values, triples] = indexed(surface.texture);
  return {{surface.soup.points, surface.soup.triangles}, {values, triples}, {}};
}

/// Of the edges of a closed surface, in which part the faces differ at both ends.
double part_of_seams(const Textured& surface) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::array<TexturePlace, 2>> met;
  std::size_t seams = 0;
  for (std::size_t t = 0; t < surface.soup.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto v = surface.soup.triangles[t][i], w = surface.soup.triangles[t][(i + 1) % 3];
      const TexturePlace at_v = surface.texture[t][i], at_w = surface.texture[t][(i + 1) % 3];
      const auto other = met.find({w, v});
      if (other == met.end())
        met.insert({{v, w}, {at_v, at_w}});
      else
        seams += other->second[0] != at_w && other->second[1] != at_v;
    }
  return static_cast<double>(seams) / (1.5 * static_cast<double>(surface.soup.triangles.size()));
}

struct Result {
  Textured surface;
  Report report;
  double rms = 0, bleeding = 0;
};

template <class Cost = Quadric, class Order = GreedyOrder>
Result simplified(const Textured& input, std::size_t faces, const ChannelOptions& options,
                  const Order& order = {}) {
  PointSoup soup(input.soup);
  auto [values, triples] = indexed(input.texture);
  const Report report = simplify(soup.points, soup.triangles, Cost{}, order, FaceCount{faces},
                                 Texture{values, triples, options});
  Result result{{to_soup(soup), at_corners(values, triples), {}}, report};
  result.surface.labels.resize(soup.triangles.size());
  result.rms = surface_distance(input.soup.points, input.soup.triangles, soup.points,
                                soup.triangles, {.samples = 10000})
                   .rms;
  result.bleeding = texture_deviation(measured(input), measured(result.surface)).bleeding;
  return result;
}

} // namespace

TEMPLATE_TEST_CASE("Held seams meet a target near the shape of priced ones, and bleed less", "",
                   Quadric, MemorylessQuadric) {
  const Textured input = sphere_of_patches(60);
  const std::size_t all = input.labels.size();
  for (const double ratio : {0.2, 0.1}) {
    const auto faces = static_cast<std::size_t>(ratio * static_cast<double>(all));
    const auto check = [&](const auto& order) {
      const Result held = simplified<TestType>(input, faces, {}, order);
      const Result priced = simplified<TestType>(input, faces, {.seams = Seams::priced}, order);
      CAPTURE(ratio, held.rms, priced.rms, held.bleeding, priced.bleeding);
      CHECK(is_target_reached(held.report.stop));
      CHECK(held.report.rejected(Rejection::seam) == 0);
      CHECK(held.rms < 2.5 * priced.rms);
      CHECK(held.bleeding < 0.75 * priced.bleeding);
      CHECK(count_turned(held.surface) == count_turned(input));
    };
    check(GreedyOrder{});
    check(RelaxedOrder{});
  }
}

TEST_CASE("Seams that are kept end before they destroy the shape") {
  const Textured input = sphere_of_patches(60);
  std::optional<std::size_t> least;
  for (const double ratio : {0.1, 0.05, 0.02}) {
    const auto faces = static_cast<std::size_t>(ratio * static_cast<double>(input.labels.size()));
    const Result kept = simplified(input, faces, {.seams = Seams::kept});
    INFO(kept.report);
    CHECK(kept.rms < 0.03); // of a radius of 1
    if (!is_target_reached(kept.report.stop)) {
      CHECK(least.value_or(kept.surface.labels.size()) == kept.surface.labels.size());
      least = kept.surface.labels.size();
    }
  }
  CHECK(least.has_value());
}

TEST_CASE("The weight of borders leads from priced seams to firmly held ones") {
  const Textured input = sphere_of_patches(30);
  const auto faces = input.labels.size() / 6;
  double last = std::numeric_limits<double>::infinity();
  for (const double weight : {0.0, 0.01, 0.1, 1.0}) {
    const Result held = simplified(input, faces, {.chart_boundary_weight = weight});
    CAPTURE(weight);
    CHECK(held.bleeding < last);
    last = held.bleeding;
  }
}

TEST_CASE("By default borders hold the more firmly, the fewer of the edges are seams") {
  for (const std::size_t patches : {4u, 20u, 200u}) {
    const Textured input = sphere_of_patches(patches);
    const auto faces = input.labels.size() / 6;
    const double part = part_of_seams(input);
    const double weight = std::clamp(0.0036 / (part * part), 0.1, 1.0);
    CAPTURE(patches, part, weight);
    const Result by_default = simplified(input, faces, {});
    const Result named =
        simplified(input, faces, {.seams = Seams::soft, .chart_boundary_weight = weight});
    CHECK(by_default.surface.texture == named.surface.texture);
  }
}

TEST_CASE("Where there is no seam, held and priced seams give the same surface") {
  Textured sheet = textured(bumpy_sheet(20), [&](std::size_t, std::uint32_t v) {
    return TexturePlace{{(v % 21) / 20.0, (v / 21) / 20.0}};
  });
  const Result held = simplified(sheet, 100, {});
  const Result priced = simplified(sheet, 100, {.seams = Seams::priced});
  CHECK(held.surface.soup.points == priced.surface.soup.points);
  CHECK(held.surface.texture == priced.surface.texture);
}

TEST_CASE("Texture coordinates stay in the range of those that there were") {
  for (const Seams seams : {Seams::kept, Seams::soft, Seams::priced}) {
    const Textured input = sphere_of_patches(12);
    TexturePlace low = input.texture[0][0], high = low;
    for (const auto& corners : input.texture)
      for (const TexturePlace& q : corners)
        for (std::size_t i = 0; i < 2; ++i) {
          low[i] = std::min(low[i], q[i]);
          high[i] = std::max(high[i], q[i]);
        }
    const Result result = simplified(input, input.labels.size() / 40, {.seams = seams});
    for (const auto& corners : result.surface.texture)
      for (const TexturePlace& q : corners)
        for (std::size_t i = 0; i < 2; ++i) {
          CHECK(q[i] >= low[i]);
          CHECK(q[i] <= high[i]);
        }
  }
}
