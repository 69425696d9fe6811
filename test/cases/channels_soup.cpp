#include "../support/charts.h"
#include "../support/textured.h"
#include "engine.h"

#include <quadrille/channel_options.h>
#include <quadrille/channels.h>

#include <cmath>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace test {

namespace {

using namespace quadrille;

// What a soup carries: labels of its triangles, a texture and normals at their corners.
struct Carried {
  std::vector<int> labels;
  IndexedCorners<2> texture;
  IndexedCorners<3> normals;
};

// Regions and charts that two planes tell apart, but for a few triangles and corners. Indices of no
// point are at home nowhere.
Carried carried(const Soup& soup, Random& random) {
  const auto plane = [&] { return Position{random(-1, 1), random(-1, 1), random(-1, 1)}; };
  const Position of_labels = plane(), of_charts = plane();
  Carried result;
  CornerValues<2> texture;
  CornerValues<3> normals;
  for (const Triangle& t : soup.triangles) {
    std::array<Position, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i)
      if (t[i] < soup.points.size())
        corners[i] = soup.points[t[i]];
    const Position middle = 1. / 3 * (corners[0] + corners[1] + corners[2]);
    result.labels.push_back(random.below(16) == 0 ? 2 : dot(middle, of_labels) > 0);
    const double chart = dot(middle, of_charts) > 0 ? 0 : 1;
    texture.emplace_back();
    normals.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const double jump = random.below(16) == 0 ? 0.5 : 0;
      const Position& p = corners[i];
      texture.back()[i] = {std::remainder(p[0], 8) + chart + jump, std::remainder(p[1], 8)};
      normals.back()[i] = {chart, jump, 1 - chart};
    }
  }
  result.texture = indexed(texture);
  result.normals = indexed(normals);
  return result;
}

Seams any_seams(Random& random) {
  constexpr std::array all{Seams::kept, Seams::soft, Seams::priced, Seams::free};
  return all[random.below(4)];
}

ChannelOptions any_options(Random& random) {
  constexpr std::array all{NewValues::optimal, NewValues::existing, NewValues::recomputed};
  return {.seams = any_seams(random), .new_values = all[random.below(3)]};
}

template <std::size_t N>
void require_sound(const IndexedCorners<N>& corners, std::size_t triangles) {
  if (corners.triples.size() != triangles)
    throw std::logic_error("index triples that are not one for each triangle");
  for (const Triangle& triple : corners.triples)
    for (const std::uint32_t i : triple)
      if (i >= corners.values.size())
        throw std::logic_error("an index of no value");
  for (const auto& value : corners.values)
    for (const double x : value.coordinates)
      if (!std::isfinite(x))
        throw std::logic_error("a value that is not finite");
}

// Must the regions of labels stay? Doubled triangles may have several, and of what is no manifold
// the topology is not promised.
bool keeps_regions(const Case& input) {
  if (input.call.topology != Topology::kept || input.call.threshold > 0)
    return false;
  const SoupTopology topology = topology_of(input.soup);
  return topology.is_manifold && !topology.has_duplicate_faces && !topology.has_collapsed_faces;
}

ChartPattern regions(const Soup& soup, const std::vector<int>& labels) {
  return pattern_of_labels({soup, CornerValues<2>(soup.triangles.size()), labels});
}

} // namespace

void simplify_soup_with_channels(const Case& input, Outcome& outcome) {
  Random random(input.seed);
  Carried all = carried(input.soup, random);
  const std::vector<int> labels = all.labels;
  const ChannelOptions of_texture{.seams = any_seams(random)};
  const ChannelOptions of_normals = any_options(random);
  const ChannelOptions of_colors{.linear_light = random.below(2) == 0};
  const auto is_fixed = boost::make_function_property_map<std::size_t>(
      [&](std::size_t v) -> bool { return input.is_fixed[v]; });
  const detail::CancelAt visitor(input.call.cancel_at);
  const ThresholdPairs pairs(input.call.threshold);
  outcome.report = detail::with_policies<Quadric>(input.call, pairs, [&](const auto&... policy) {
    return quadrille::simplify(
        outcome.points, outcome.triangles, Quadric{.boundary_weight = input.call.boundary_weight},
        policy..., Labels{CGAL::make_property_map(all.labels)},
        Texture{all.texture.values, all.texture.triples, of_texture},
        Normals{all.normals.values, all.normals.triples, of_normals},
        Colors{CGAL::make_property_map(outcome.colors), of_colors},
        CGAL::parameters::vertex_is_constrained_map(is_fixed).visitor(visitor));
  });
  require_sound(all.texture, outcome.triangles.size());
  require_sound(all.normals, outcome.triangles.size());
  if (outcome.report.contractions == 0 || !keeps_regions(input))
    return;
  Soup after{{}, outcome.triangles};
  for (const Point& p : outcome.points)
    after.points.push_back(to_position(p));
  all.labels.resize(outcome.triangles.size());
  const ChartPattern before = regions(input.soup, labels);
  const ChartPattern now = regions(after, all.labels);
  if (before == now)
    return;
  std::ostringstream what;
  what << "the regions of labels changed: " << before << " -> " << now;
  throw std::logic_error(what.str());
}

} // namespace test
