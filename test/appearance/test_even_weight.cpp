// What colours and normals count by default: by how hard they are to tell from what is beside,
// which is found here face by face.
#include "meshes.h"
#include "soups.h"
#include "textured.h"

#include <quadrille/channels.h>
#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace {

using namespace quadrille;
using namespace test;

using Values = std::vector<std::array<double, 3>>; // one for each point

double range_of(const Values& values) {
  double range = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto [low, high] = std::minmax_element(
        values.begin(), values.end(), [c](const auto& a, const auto& b) { return a[c] < b[c]; });
    range = std::max(range, (*high)[c] - (*low)[c]);
  }
  return range;
}

/// The far corner of a face as seen from another: its distance from the plane beside how far its
/// values are off, by the height over each edge.
double ratio(const Soup& soup, const Values& values, const Triangle& face, std::uint32_t far,
             double edge, double range) {
  const Position &a = soup.points[face[0]], &b = soup.points[face[1]], &c = soup.points[face[2]];
  const Position normal = cross(b - a, c - a), &p = soup.points[far];
  const double area = std::sqrt(squared_length(normal));
  const auto part = [&](const Position& q, const Position& r) {
    return dot(cross(q - p, r - p), normal) / (area * area);
  };
  const std::array parts{part(b, c), part(c, a), part(a, b)};
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double extended = parts[0] * values[face[0]][k] + parts[1] * values[face[1]][k] +
                            parts[2] * values[face[2]][k];
    sum += std::pow(values[far][k] - extended, 2);
  }
  return (std::abs(dot(p - a, normal)) / area + edge / 50) / (std::sqrt(sum / 3) + range / 200);
}

double median_ratio(const Soup& soup, const Values& values) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> faces; // left of each edge
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      faces[{soup.triangles[t][i], soup.triangles[t][(i + 1) % 3]}] = t;
  std::vector<double> ratios;
  for (const auto& [edge, face] : faces) {
    const auto [v, w] = edge;
    const auto other = faces.find({w, v});
    if (other == faces.end())
      continue;
    const Triangle& across = soup.triangles[other->second];
    const std::uint32_t far = across[0] + across[1] + across[2] - v - w;
    const double length = std::sqrt(squared_length(soup.points[w] - soup.points[v]));
    ratios.push_back(ratio(soup, values, soup.triangles[face], far, length, range_of(values)));
  }
  std::sort(ratios.begin(), ratios.end());
  return ratios[ratios.size() / 2];
}

/// A torus of fewer vertices than are sampled, and values on it that are `noise` to that part.
Values waves(const Soup& soup, double noise) {
  std::mt19937 random(7);
  Values values;
  for (const Position& p : soup.points) {
    const auto wave = [&](double x) {
      return 0.5 + 0.3 * std::sin(2 * x) +
             noise * (static_cast<double>(random()) / 4294967296 - 0.5);
    };
    values.push_back({wave(p[0]), wave(p[1]), wave(p[2] + p[0])});
  }
  return values;
}

template <class Channel>
std::vector<Position> points_left(const Soup& soup, const Channel& channel) {
  PointSoup input(soup);
  simplify(input.points, input.triangles, FaceCount{120}, channel);
  return to_soup(input).points;
}

template <template <class> class Channel>
std::vector<Position> points_left(const Soup& soup, Values values, const ChannelOptions& options) {
  std::vector<std::array<std::size_t, 3>> triples;
  for (const Triangle& t : soup.triangles)
    triples.push_back({t[0], t[1], t[2]});
  return points_left(soup, Channel(values, triples, options));
}

bool are_close(const std::vector<Position>& a, const std::vector<Position>& b) {
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(),
      [](const Position& p, const Position& q) { return squared_length(p - q) < 1e-16; });
}

template <template <class> class Channel>
void check(const Soup& soup, const Values& values, double weight) {
  CAPTURE(weight);
  const auto by_default = points_left<Channel>(soup, values, {});
  CHECK(are_close(by_default,
                  points_left<Channel>(soup, values, {.weights = {weight, weight, weight}})));
  CHECK_FALSE(are_close(by_default, points_left<Channel>(soup, values, {.importance = 1.5})));
}

} // namespace

TEST_CASE(
    "Colours and normals count by default by how smooth they are, and others by their range") {
  const Soup soup = with_noise(torus(24, 12), 1, 0.01);
  bool is_between = false;
  for (const double noise : {0.0, 0.1, 1.0, 30.0}) {
    const Values values = waves(soup, noise);
    const double even = median_ratio(soup, values);
    const double usual = 0.02 * diagonal(soup) / range_of(values);
    CAPTURE(noise, even / usual);
    check<Colors>(soup, values, std::clamp(0.5 * even, 0.05 * usual, usual));
    check<Attributes>(soup, values, usual);
    check<Normals>(soup, values, std::clamp(1.1 * even, 0.1 * usual, 2 * usual));
    is_between = is_between || (0.5 * even > 0.05 * usual && 1.1 * even < 2 * usual);
  }
  CHECK(is_between);
}
