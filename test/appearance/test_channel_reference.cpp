// Channels are simplified as by brute force, which keeps attributes in the quadric and solves for
// position and attributes together.

#include "channel_reference.h"
#include "meshes.h"
#include "same_contractions.h"
#include "soups.h"

#include <quadrille/channels.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using test::ChannelReference;
using test::CornerValues;
using test::Mesh;
using test::Position;
using test::Soup;
using test::Value;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;
using Channels = std::vector<ChannelReference::Channel>;

/// Values by a function of the triangle's number, the vertex and its position.
template <class F>
CornerValues values_of(const Soup& soup, F f) {
  CornerValues values;
  for (std::uint32_t t = 0; t < soup.triangles.size(); ++t) {
    values.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = soup.triangles[t][i];
      values.back()[i] = f(t, v, soup.points[v]);
    }
  }
  return values;
}

// --- Channels of a mesh --------------------------------------------------------------------------

template <std::size_t M>
std::array<double, M> as_array(const Value& value) {
  std::array<double, M> result{};
  std::copy_n(value.begin(), M, result.begin());
  return result;
}

std::string name_of(std::size_t channel) {
  return "channel " + std::to_string(channel);
}

/// What has the value of a corner, by the halfedge that points to it.
Halfedge key_of(const Mesh&, Halfedge h, Halfedge) {
  return h;
}
Vertex key_of(const Mesh& mesh, Halfedge h, Vertex) {
  return mesh.target(h);
}

/// A channel as a map over the vertices or halfedges of a mesh, of its name.
template <class Key, std::size_t M>
auto make_map(Mesh& mesh, const Soup& soup, const Channels& channels, std::size_t channel) {
  const auto map = mesh.add_property_map<Key, std::array<double, M>>(name_of(channel)).first;
  for (const auto f : mesh.faces())
    for (const auto h : mesh.halfedges_around_face(mesh.halfedge(f)))
      for (std::size_t i = 0; i < 3; ++i)
        if (mesh.target(h) == Mesh::Vertex_index(soup.triangles[f][i]))
          map[key_of(mesh, h, Key())] = as_array<M>(channels[channel].values[f][i]);
  return map;
}

ChannelOptions options_of(const ChannelReference::Channel& channel) {
  return {.weights = channel.weights,
          .seams = channel.is_kept_texture ? Seams::kept : Seams::priced,
          .chart_boundary_weight = channel.chart_boundary_weight};
}

/// A channel of a mesh as an argument; textures alone have two components here.
template <class Key, std::size_t M>
auto argument(Mesh& mesh, const Soup& soup, const Channels& channels, std::size_t channel) {
  const auto map = make_map<Key, M>(mesh, soup, channels, channel);
  if constexpr (M == 2)
    return Texture{map, options_of(channels[channel])};
  else
    return Attributes{map, options_of(channels[channel])};
}

/// A component of a value as it is written: texture coordinates stay in the range of the input.
double as_written(const ChannelReference::Channel& channel, std::size_t c, double x) {
  double low = x, high = x;
  if (channel.weights.size() == 2) {
    low = std::numeric_limits<double>::infinity();
    high = -low;
    for (const auto& corners : channel.values)
      for (const auto& value : corners) {
        low = std::min(low, static_cast<double>(value[c]));
        high = std::max(high, static_cast<double>(value[c]));
      }
  }
  return std::clamp(x, low, high);
}

/// Where the values of a mesh and the reference differ by more than a distance, or nothing.
template <class Key, std::size_t M>
std::string difference(const Mesh& mesh, const ChannelReference& reference,
                       const Channels& channels, std::size_t channel, double tolerance) {
  const auto map = mesh.property_map<Key, std::array<double, M>>(name_of(channel)).first;
  for (const auto f : mesh.faces())
    for (const auto h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      const test::Triangle& t = reference.faces().at(f);
      const std::uint32_t v = mesh.target(h);
      const auto i = static_cast<std::size_t>(std::find(t.begin(), t.end(), v) - t.begin());
      const Value& expected = reference.value(channel, f, i);
      const auto& value = map[key_of(mesh, h, Key())];
      for (std::size_t c = 0; c < M; ++c)
        if (!(std::abs(value[c] -
                       as_written(channels[channel], c, static_cast<double>(expected[c]))) *
                  channels[channel].weights[c] <=
              tolerance))
          return "channel " + std::to_string(channel) + " has another value in face " +
                 std::to_string(f) + " at vertex " + std::to_string(v);
    }
  return {};
}

/// With channels of M components each, over the vertices or halfedges.
template <class Key, std::size_t... M>
void require_same_channels(const Soup& soup, const Channels& channels) {
  const auto require = [&]<std::size_t... I>(std::index_sequence<I...>) {
    ChannelReference reference(soup, channels);
    const double tolerance = 1e-7 * test::diagonal(soup);
    test::require_same_contractions(
        soup, reference,
        [&](Mesh& mesh, const auto& stop) {
          return simplify(mesh, stop, argument<Key, M>(mesh, soup, channels, I)...);
        },
        [&](const Mesh& mesh) {
          return (difference<Key, M>(mesh, reference, channels, I, tolerance) + ...);
        });
  };
  require(std::make_index_sequence<sizeof...(M)>{});
}

// --- Surfaces of 20 to 60 vertices ---------------------------------------------------------------

Soup bumpy_sphere(std::uint64_t seed) {
  return test::with_noise(test::uv_sphere(8, 6), seed, 0.05);
}

Soup small_surface(std::uint64_t seed) {
  switch (seed % 3) {
  case 0:
    return bumpy_sphere(seed);
  case 1:
    return test::with_noise(test::torus(8, 6), seed, 0.05);
  default:
    return test::with_noise(test::with_flipped_edges(test::grid(6, 6), seed, 20), seed, 0.03);
  }
}

double middle(const Soup& soup, std::uint32_t t, std::size_t axis) {
  double sum = 0;
  for (std::uint32_t v : soup.triangles[t])
    sum += soup.points[v][axis];
  return sum / 3;
}

Value smooth_color(const Position& p) {
  return {0.5 + 0.3 * std::sin(2 * p[0] + p[1]), 0.5 + 0.2 * std::cos(3 * p[1]), 0.4 * p[2]};
}

// A number of a set and a seed, in [0, 1).
double noise(std::uint64_t seed, std::uint64_t number) {
  return test::Random(1000 * seed + number)(0, 1);
}

} // namespace

TEST_CASE("Surfaces with one value a vertex are simplified as by brute force") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 3));
  const double weight = GENERATE(0.02, 0.3, 3.0);
  CAPTURE(seed, weight);
  const Soup soup = small_surface(seed);
  const CornerValues colors = values_of(soup, [&](auto, std::uint32_t v, const Position& p) {
    Value color = smooth_color(p);
    for (std::size_t c = 0; c < 3; ++c)
      color[c] += 0.1 * noise(seed, 3 * v + c);
    return color;
  });
  require_same_channels<Vertex, 3>(soup, {{colors, {weight, weight, 0.5 * weight}}});
}

// Where the middle of a small surface is.
double half_of(std::uint64_t seed) {
  return seed % 3 == 2 ? 0.5 : 0;
}

// A texture of two charts, one on each side of the middle.
CornerValues two_charts(const Soup& soup, std::uint64_t seed) {
  return values_of(soup, [&](std::uint32_t t, std::uint32_t v, const Position& p) {
    const double chart = middle(soup, t, 0) < half_of(seed) ? 0 : 3;
    return Value{p[1] + 0.2 * p[0] + chart, p[2] + 0.1 * noise(seed, v)};
  });
}

TEST_CASE("Channels with seams of their own are simplified as by brute force") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 3));
  CAPTURE(seed);
  const Soup soup = small_surface(seed);
  const CornerValues texture = two_charts(soup, seed);
  const CornerValues colors =
      values_of(soup, [&](std::uint32_t t, std::uint32_t, const Position& p) {
        Value color = smooth_color(p);
        color[1] += middle(soup, t, 1) < half_of(seed) ? 0 : 0.25;
        return color;
      });
  require_same_channels<Halfedge, 2, 3>(soup, {{texture, {0.5, 0.5}}, {colors, {0.2, 0.3, 0.1}}});
}

TEST_CASE("Surfaces full of seams are simplified as by brute force") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 3));
  CAPTURE(seed);
  const Soup soup = small_surface(seed);
  const CornerValues values = values_of(soup, [&](std::uint32_t t, std::uint32_t v, auto) {
    return Value{noise(seed, v), noise(seed, 100 + t) < 0.7 ? 0.0 : 0.3};
  });
  require_same_channels<Halfedge, 2>(soup, {{values, {0.1, 0.2}}});
}

TEST_CASE("Charts of a texture are simplified as by brute force") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 5));
  const double chart_boundary_weight = GENERATE(10.0, 0.0);
  CAPTURE(seed, chart_boundary_weight);
  const Soup soup = small_surface(seed);
  const CornerValues texture = two_charts(soup, seed);
  require_same_channels<Halfedge, 2>(soup, {{texture, {0.5, 0.5}, true, chart_boundary_weight}});
}

TEST_CASE("Folds of a texture are kept as by brute force") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 3));
  CAPTURE(seed);
  const Soup soup = small_surface(seed);
  const double half = seed % 3 == 2 ? 0.5 : 0;
  const CornerValues texture = values_of(soup, [&](auto, auto, const Position& p) {
    return Value{std::abs(p[0] - half), p[2] + 0.3 * p[1]};
  });
  require_same_channels<Halfedge, 2>(soup, {{texture, {0.5, 0.5}, true}});
}

TEST_CASE("A globe whose texture has one seam and half seams at its poles, as by brute force") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 2));
  const bool are_seams_kept = GENERATE(true, false);
  CAPTURE(seed, are_seams_kept);
  constexpr std::uint32_t meridians = 8, parallels = 6, top = 1 + meridians * (parallels - 1);
  const Soup soup = test::with_noise(test::uv_sphere(meridians, parallels), seed, 0.05);
  const auto is_pole = [&](std::uint32_t v) { return v == 0 || v == top; };
  const auto meridian = [&](std::uint32_t v) { return (v - 1) % meridians; };
  const CornerValues texture = values_of(soup, [&](std::uint32_t t, std::uint32_t v,
                                                   const Position& p) {
    std::vector<double> around; // the meridians of the face, of which the first is also the last
    const test::Triangle& face = soup.triangles[t];
    const bool is_last = std::any_of(face.begin(), face.end(), [&](std::uint32_t w) {
      return !is_pole(w) && meridian(w) == meridians - 1;
    });
    const auto place = [&](std::uint32_t w) {
      return is_last && meridian(w) == 0 ? meridians : meridian(w);
    };
    for (std::uint32_t w : face)
      if (!is_pole(w))
        around.push_back(place(w));
    const double u = is_pole(v) ? (around[0] + around[1]) / 2 : place(v);
    return Value{u / meridians, std::atan2(p[2], std::hypot(p[0], p[1])) / 3};
  });
  require_same_channels<Halfedge, 2>(soup, {{texture, {1.5, 1.5}, are_seams_kept}});
}
