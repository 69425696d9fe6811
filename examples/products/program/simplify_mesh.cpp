#include "simplify_mesh.h"

#include <quadrille/compiled/option_setting.h>
#include <quadrille/compiled/prepared_soup.h>
#include <quadrille/compiled/presets.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quadrille_examples {

namespace {

/// Simplifies a mesh without attributes that vary.
quadrille::Report simplify_positions(IndexedMesh& mesh, const quadrille::SoupOptions& options,
                                     quadrille::PreparedSurface* begun) {
  const quadrille::SoupPoints points = soup_points(mesh.points);
  quadrille::SoupResult result = quadrille::simplified_soup({points, mesh.triangles}, options);
  mesh.points = mesh_points(result.points);
  mesh.triangles = std::move(result.triangles);
  resize_constants(mesh);
  if (begun)
    *begun = begun_surface(result);
  return result.report;
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
  quadrille::SoupOptions result = options.soup;
  options.target.tell(result);
  if (options.is_relaxed() || options.cuts_handles() || options.soup.preset)
    result.threads = options.threads;
  const bool is_asked = options.soup.topology || options.drops_components ||
                        options.keeps_components || options.joins_pairs();
  if (!options.soup.preset || is_asked)
    result.topology = topology(options);
  result.coordinates_are_floats = writes_floats(options);
  return result;
}

void set_lengths(const Options& options, double diagonal, quadrille::SoupOptions& result) {
  for (const auto& [option, amount] : options.lengths)
    if (amount.value > 0)
      quadrille::internal::set_number(result, option, length_of(amount, diagonal));
}

ChannelChoices channel_choices(const Options& options) {
  const auto importance_if_asked_by = [&](const char* cost) {
    return options.cost.empty() || options.cost == cost ? 1. : hardly;
  };
  return {.of_colors = importance_if_asked_by("color"),
          .of_textures = importance_if_asked_by("texture"),
          .of_normals = importance_if_asked_by(""),
          .of_numbers = hardly, // they may be noise
          .texture_seams = options.textures.seams};
}

quadrille::Report simplify_mesh(IndexedMesh& mesh, const Options& options,
                                const std::optional<quadrille::SoupRecorder>& recorder,
                                quadrille::PreparedSurface* begun) {
  quadrille::SoupOptions soup = soup_options(options, mesh.points, mesh.triangles);
  soup.recorder = recorder;
  if (!needs_channels(mesh))
    return simplify_positions(mesh, soup, begun);
  return MeshChannels(mesh).simplify(soup, channel_choices(options), begun);
}

IndexedMesh bare_mesh(const quadrille::SoupPoints& points,
                      const quadrille::SoupTriangles& triangles) {
  IndexedMesh mesh;
  mesh.points = mesh_points(points);
  mesh.triangles = triangles;
  return mesh;
}

IndexedMesh mesh_that_runs_begin_with(const quadrille::SoupPoints& points,
                                      const quadrille::SoupTriangles& triangles,
                                      quadrille::SoupOptions options) {
  const quadrille::SoupView soup{points, triangles};
  if (options.preset)
    options = quadrille::internal::with_preset(options, soup);
  if (!quadrille::internal::has_preparation(options))
    return bare_mesh(points, triangles);
  const quadrille::internal::PreparedSoup prepared(soup, options);
  const quadrille::SoupView view = prepared.view();
  return bare_mesh({view.points.begin(), view.points.end()},
                   {view.triangles.begin(), view.triangles.end()});
}

} // namespace quadrille_examples
