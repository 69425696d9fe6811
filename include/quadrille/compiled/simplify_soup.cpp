// The other source files define the engines.
#define QUADRILLE_WITH_COMPILED

#include <quadrille/compiled.h>
#include <quadrille/compiled/joined_soup.h>
#include <quadrille/compiled/prepared_soup.h>
#include <quadrille/compiled/presets.h>
#include <quadrille/compiled/run_soup.h>
#include <quadrille/compiled/soup_channel_map.h>
#include <quadrille/compiled/soup_run.h>
#include <quadrille/edge_length.h>
#include <quadrille/memoryless_quadric.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille {

namespace {

using internal::SoupRun;

[[noreturn]] void reject(const std::string& what) {
  throw std::invalid_argument("quadrille::simplified_soup: " + what);
}

// Requires one value for each element, if there are any values.
void require_count(const char* name, std::size_t values, std::size_t count, const char* of_what) {
  if (values > 0 && values != count)
    reject(name + (" has " + std::to_string(values)) + " values for " + std::to_string(count) +
           " " + of_what);
}

// Requires that all triangles that are not vertical show the same side along an axis.
void require_height_field(const SoupView& soup, SoupOptions::Axis axis) {
  const std::size_t up = static_cast<std::size_t>(axis), u = (up + 1) % 3, v = (up + 2) % 3;
  const auto sign = [&](const std::array<std::uint32_t, 3>& t) {
    const auto& [p, q, r] = std::tie(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]);
    const double left = (q[u] - p[u]) * (r[v] - p[v]), right = (r[u] - p[u]) * (q[v] - p[v]);
    return (left > right) - (left < right);
  };
  int shown = 0;
  std::size_t first = 0;
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    const auto& t = soup.triangles[i];
    for (std::uint32_t corner : t)
      if (corner >= soup.points.size())
        return; // it is reported later
    const int side = sign(t);
    if (shown == 0 && side != 0) {
      shown = side;
      first = i;
    }
    if (side * shown < 0)
      reject(std::string("the input is no height field along ") + "xyz"[up] + ": triangle " +
             std::to_string(i) + " shows the other side than triangle " + std::to_string(first));
  }
}

void validate_call(const SoupView& soup, const SoupOptions& options) {
  require_count("fixed", options.fixed.size(), soup.points.size(), "points");
  require_count("tolerance", options.tolerance.size(), soup.points.size(), "points");
  if (!options.tolerance.empty() && (options.error || options.relative_error))
    reject("there are both an error and a tolerance of points: pass the smaller of both as "
           "tolerance");
  require_count("shared", options.shared.size(), soup.points.size(), "points");
  require_count("importance", options.importance.size(), soup.points.size(), "points");
  require_count("selected", options.selected.size(), soup.triangles.size(), "triangles");
  require_count("labels", soup.labels.size(), soup.triangles.size(), "triangles");
  for (std::size_t i = 0; i < soup.channels.size(); ++i)
    internal::SoupChannelMap(soup.channels[i])
        .validate("channel " + std::to_string(i), soup.points.size(), soup.triangles.size());
  if (options.plane_flatness && !options.keep_planes)
    reject("plane_flatness needs keep_planes, an area");
  if (options.plane_outline && !options.keep_planes)
    reject("plane_outline needs keep_planes, an area");
  if (options.height_field)
    require_height_field(soup, *options.height_field);
  if (options.crease_degrees < 180 && options.cost != SoupOptions::Cost::quadric)
    reject("crease_degrees needs the cost quadric, the only one with creases");
  if ((options.weighting != Weighting::by_area || options.line_weight != 0 ||
       options.normal_noise != 0 || options.position_noise != 0) &&
      options.cost != SoupOptions::Cost::quadric)
    reject("weighting, line_weight, normal_noise and position_noise need the cost quadric");
  if (options.threads > 1 && options.order != SoupOptions::Order::relaxed &&
      !options.simplified_topology)
    reject("more than one thread needs the relaxed order or simplified_topology");
}

Report simplify_by_cost_of_options(SoupRun& run) {
  using Cost = SoupOptions::Cost;
  switch (run.options.cost) {
  case Cost::quadric:
    return internal::simplify_by_cost(run, Quadric{});
  case Cost::memoryless_quadric:
    return internal::simplify_by_cost(run, MemorylessQuadric{});
  case Cost::thin_feature_quadric:
    return internal::simplify_by_cost(run, ThinFeatureQuadric{});
  case Cost::edge_length:
    return internal::simplify_by_cost(run, EdgeLength{});
  }
  reject("there is no such cost");
}

// Returns a channel of a soup without triangles, which is empty, or of a run that was cancelled
// before any change.
SoupChannel unchanged_channel(const SoupChannelView& channel, bool has_values) {
  if (!has_values)
    return {channel.components, {}, {}};
  return {channel.components,
          {channel.values.begin(), channel.values.end()},
          {channel.triangles.begin(), channel.triangles.end()}};
}

SoupResult run_prepared(const SoupView& soup, const SoupOptions& options,
                        const std::function<Report(SoupRun&)>& simplify) {
  if (options.split_vertices) {
    const internal::JoinedSoup joined(soup, options);
    SoupResult result = run_prepared(joined.view(), joined.options(), simplify);
    joined.restore(result);
    return result;
  }
  internal::PreparedSoup prepared(soup, options);
  SoupResult result = internal::run_soup(prepared.view(), prepared.options(), simplify);
  prepared.restore(result);
  return result;
}

} // namespace

SoupResult internal::run_soup(const SoupView& soup, const SoupOptions& options,
                              const std::function<Report(SoupRun&)>& simplify) {
  if (options.preset)
    return run_soup(soup, internal::with_preset(options, soup), simplify);
  validate_call(soup, options);
  if (internal::has_preparation(options))
    return run_prepared(soup, options, simplify);
  const bool has_values = !soup.triangles.empty();
  const SoupView bare{soup.points, soup.triangles, {}, {}};
  SoupRun run{has_values ? soup : bare,
              options,
              internal::SoupPointArray(soup.points),
              internal::SoupTriangleArray(soup.triangles),
              {},
              {}};
  if (!options.split_vertices) { // a run that is cancelled at once changes nothing
    run.vertex_map.resize(soup.points.size());
    std::iota(run.vertex_map.begin(), run.vertex_map.end(), std::size_t{0});
  }
  SoupResult result;
  result.report = simplify(run);
  result.points = std::move(run.points).take();
  std::tie(result.triangles, result.input_faces) = std::move(run.triangles).take();
  result.channels = std::move(run.channels);
  if (result.channels.empty())
    for (const SoupChannelView& channel : soup.channels)
      result.channels.push_back(unchanged_channel(channel, has_values));
  if (!soup.labels.empty())
    for (const std::uint32_t face : result.input_faces)
      result.labels.push_back(soup.labels[face]);
  result.vertex_map = std::move(run.vertex_map);
  return result;
}

SoupResult simplified_soup(const SoupView& soup, const SoupOptions& options) {
  return internal::run_soup(soup, options, simplify_by_cost_of_options);
}

Report simplify_soup(SoupPoints& points, SoupTriangles& triangles, const SoupOptions& options,
                     std::vector<std::size_t>* vertex_map) {
  SoupResult result = simplified_soup({points, triangles}, options);
  points = std::move(result.points);
  triangles = std::move(result.triangles);
  if (vertex_map)
    *vertex_map = std::move(result.vertex_map);
  return result.report;
}

} // namespace quadrille
