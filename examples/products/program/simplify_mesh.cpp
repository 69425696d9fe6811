#include "simplify_mesh.h"

#include <quadrille/compiled/option_setting.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille_examples {

namespace {

quadrille::SoupOptions::Cost cost(const Options& options) {
  using Cost = quadrille::SoupOptions::Cost;
  return options.cost == "length"          ? Cost::edge_length
         : options.cost == "memoryless"    ? Cost::memoryless_quadric
         : options.cost == "thin-features" ? Cost::thin_feature_quadric
                                           : Cost::quadric;
}

/// Simplifies a mesh without attributes that vary.
quadrille::Report simplify_positions(IndexedMesh& mesh, const quadrille::SoupOptions& options,
                                     std::vector<std::size_t>* vertex_map) {
  quadrille::SoupPoints points = soup_points(mesh.points);
  const quadrille::Report report =
      quadrille::simplify_soup(points, mesh.triangles, options, vertex_map);
  mesh.points = mesh_points(points);
  resize_constants(mesh);
  return report;
}

/// Of the values of each point, the one that is ahead.
std::vector<double> values_ahead(const IndexedMesh& mesh, const std::vector<double>& values,
                                 bool (*is_ahead)(double, double)) {
  std::vector<double> result(values.begin(),
                             values.begin() + static_cast<std::ptrdiff_t>(mesh.points.size()));
  for (std::size_t face = 0; face < mesh.value_triangles.size(); ++face)
    for (std::size_t i = 0; i < 3; ++i) {
      const double value = values[mesh.value_triangles[face][i]];
      double& ahead = result[mesh.triangles[face][i]];
      if (is_ahead(value, ahead))
        ahead = value;
    }
  return result;
}

} // namespace

std::string in_words_of_program(std::string message) {
  constexpr std::string_view scope = "quadrille::";
  if (message.starts_with(scope))
    if (const std::size_t end = message.find(": "); end != std::string::npos)
      message.erase(0, end + 2);
  for (std::size_t at = 0; (at = message.find(scope)) != std::string::npos;)
    message.erase(at, scope.size());
  return message;
}

std::vector<double> point_numbers(const IndexedMesh& mesh, const std::string& name,
                                  bool (*is_ahead)(double, double)) {
  std::string names;
  for (const NamedNumbers& numbers : mesh.vertex_numbers) {
    if (numbers.name == name)
      return values_ahead(mesh, numbers.values, is_ahead);
    names += (names.empty() ? "" : ", ") + in_quotes(numbers.name);
  }
  throw std::invalid_argument("the vertices of IN have no scalar " + in_quotes(name) +
                              (names.empty()
                                   ? "; they have none at all, but those of a PLY file can"
                                   : "; they have " + names));
}

quadrille::SoupOptions soup_options(const Options& options) {
  using Soup = quadrille::SoupOptions;
  Soup result;
  options.target.tell(result);
  result.cost = cost(options);
  result.boundary_weight = options.boundary_weight;
  if (options.crease_degrees)
    result.crease_degrees = *options.crease_degrees;
  result.line_weight = options.line_weight;
  result.normal_noise = std::tan(options.normal_noise * std::numbers::pi / 180);
  if (options.weighs_squared_area)
    result.weighting = quadrille::Weighting::by_squared_area;
  result.importance = options.importances;
  result.tolerance = options.tolerances;
  result.selected = options.selected;
  if (options.placement == "endpoint")
    result.placement = Soup::Placement::endpoint;
  if (options.placement == "midpoint")
    result.placement = Soup::Placement::midpoint;
  if (options.is_relaxed) {
    result.order = Soup::Order::relaxed;
    result.threads = options.threads;
  }
  if (!options.preset.empty())
    quadrille::internal::set_word(result, "preset", options.preset);
  if (options.preset.empty() || !options.topology.empty() || options.drops_components ||
      options.keeps_components || options.joins_pairs())
    result.topology = topology(options);
  result.no_self_intersection = options.forbids_intersections;
  result.keep_solid = options.keeps_solid;
  result.coordinates_are_floats = writes_floats(options);
  result.normal_deviation = options.normal_degrees;
  result.proceed = options.proceed;
  return result;
}

ChannelChoices channel_choices(const Options& options) {
  const auto importance_if_asked_by = [&](const char* cost) {
    return options.cost.empty() || options.cost == cost ? 1. : hardly;
  };
  return {.of_colors = importance_if_asked_by("color"),
          .of_textures = importance_if_asked_by("texture"),
          .of_normals = importance_if_asked_by(""),
          .of_numbers = hardly, // they may be noise
          .texture_seams = options.seams};
}

quadrille::Report simplify_mesh(IndexedMesh& mesh, const Options& options,
                                const std::optional<quadrille::SoupRecorder>& recorder,
                                std::vector<std::size_t>* vertex_map) {
  quadrille::SoupOptions soup = soup_options(options, mesh.points, mesh.triangles);
  soup.recorder = recorder;
  if (!needs_channels(mesh))
    return simplify_positions(mesh, soup, vertex_map);
  return MeshChannels(mesh).simplify(soup, channel_choices(options), vertex_map);
}

} // namespace quadrille_examples
