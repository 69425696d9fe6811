// Pairs that a pass leaves out because their states alone cost more than its limit, before it looks
// at what channels add.

#include "contractions.h"
#include "soups.h"
#include "textured.h"

#include <quadrille/channels.h>
#include <quadrille/internal/core/contraction/working_surface.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using internal::Index;
using test::Textured;

template <std::size_t N>
internal::ChannelInput channel_of(const test::CornerValues<N>& corners, Attribute attribute,
                                  double weight) {
  internal::ChannelInput channel;
  channel.components = N;
  channel.attribute = attribute;
  channel.seams = channel.is_texture() ? Seams::soft : Seams::priced;
  channel.weights.assign(N, weight);
  const auto indexed = test::indexed(corners);
  for (const Vector<N>& value : indexed.values)
    channel.values.insert(channel.values.end(), value.coordinates.begin(), value.coordinates.end());
  for (const auto& triple : indexed.triples)
    channel.corners.push_back({triple[0], triple[1], triple[2]});
  return channel;
}

// Noise of each corner's point.
test::CornerValues<3> noisy_colors(const test::Soup& soup) {
  test::CornerValues<3> values;
  for (const auto& triangle : soup.triangles) {
    values.emplace_back();
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t c = 0; c < 3; ++c)
        values.back()[i][c] = std::sin(100.0 * (triangle[i] + 1) * static_cast<double>(c + 1));
  }
  return values;
}

struct Keyed {
  Index first, second;
  float key;

  friend bool operator==(const Keyed&, const Keyed&) = default;
};

template <class Surface>
std::vector<Keyed> pairs_of(Surface& surface, float limit) {
  std::vector<Keyed> pairs;
  const auto end = static_cast<Index>(surface.complex().vertex_capacity());
  surface.pairs().for_each_above(
      surface.scratch(), 0, end, 1,
      [&](Index v, Index w, float key) {
        pairs.push_back({v, w, key});
      },
      limit);
  return pairs;
}

} // namespace

TEST_CASE("Only pairs that cost more than a limit are left out without a look at channels") {
  const double weight = GENERATE(0.01, 1.0, 30.0); // of colours
  CAPTURE(weight);
  const Textured sphere = test::with_points(
      test::sphere_of_20_charts(2), test::with_noise(test::sphere_of_20_charts(2).soup, 1, 0.02));
  const test::CornerValues<3> colors = noisy_colors(sphere.soup);
  internal::InputWithChannels input(test::input_of(sphere.soup));
  input.channels.push_back(channel_of(sphere.texture, Attribute::texture, 1));
  input.channels.push_back(channel_of(colors, Attribute::color, weight));
  const std::vector<std::array<double, 3>> values; // which a call would have
  const std::vector<std::array<Index, 3>> triples;
  const auto policies =
      internal::pick_policies<Quadric, OptimalPlacement>(Topology::kept, Colors{values, triples});
  const auto box = input.box();
  internal::WorkingSurface<std::remove_const_t<decltype(policies)>> surface(std::move(input), box,
                                                                            policies);

  const std::vector<Keyed> all = pairs_of(surface, std::numeric_limits<float>::infinity());
  std::vector<float> keys;
  for (const Keyed& pair : all)
    keys.push_back(pair.key);
  std::sort(keys.begin(), keys.end());
  for (std::size_t percent : {1u, 30u, 50u, 90u, 100u}) {
    CAPTURE(percent);
    const float limit = keys[(keys.size() - 1) * percent / 100];
    const auto is_above = [&](const Keyed& pair) { return pair.key > limit; };
    std::vector<Keyed> expected = all, found = pairs_of(surface, limit);
    CHECK(found.size() <= all.size());
    if (percent <= 30 && weight < 1)
      CHECK(found.size() < all.size() / 2);
    std::erase_if(expected, is_above);
    std::erase_if(found, is_above);
    CHECK(found == expected);
  }
}
