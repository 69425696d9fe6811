#ifndef QUADRILLE_COMPILED_PRESETS_H
#define QUADRILLE_COMPILED_PRESETS_H

#include <quadrille/compiled.h>
#include <quadrille/compiled/voxel_lattice.h>
#include <quadrille/quadric_form.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string_view>

/// \file
/// The presets of presets.def: which options each stands for.

namespace quadrille::internal {

/// An option that a preset stands for. Its value is as presets.def has it, without the scope of a
/// word: "true", "components_may_vanish", "3 * edge".
struct PresetOption {
  SoupOptions::Preset preset;
  std::string_view option, value;
};

/// Returns the text of an expression without the scope of a word.
constexpr std::string_view without_scope(std::string_view expression) {
  const std::size_t scope = expression.rfind("::");
  return scope == std::string_view::npos ? expression : expression.substr(scope + 2);
}

/// The options of all presets.
inline constexpr PresetOption preset_options[] = {
#define QUADRILLE_PRESET(preset, option, value)                                                    \
  {SoupOptions::Preset::preset, #option, without_scope(#value)},
#include <quadrille/compiled/presets.def>
};

/// Returns the mean length of the edges of the triangles of a soup; 0 if it has none, or if they
/// are not finite.
inline double mean_edge_length(const SoupView& soup) {
  double sum = 0;
  for (const auto& triangle : soup.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t a = triangle[i], b = triangle[(i + 1) % 3];
      if (a < soup.points.size() && b < soup.points.size())
        sum += std::sqrt(squared_distance(Vector<3>{soup.points[a]}, Vector<3>{soup.points[b]}));
    }
  const double mean = sum / (3 * static_cast<double>(soup.triangles.size()));
  return std::isfinite(mean) ? mean : 0;
}

/// Does the call have anything that does not go with the preparations of a preset?
inline bool excludes_preparations(const SoupOptions& options) {
  return options.pairs_closer_than || options.topology == Topology::free;
}

/// Returns options with those of their preset in the place of defaults. What does not go with an
/// option of the caller is left out.
inline SoupOptions with_preset(const SoupOptions& given, const SoupView& soup) {
  const SoupOptions fallback;
  SoupOptions options = given;
  const double edge = mean_edge_length(soup);
  double voxel = 0.9 * edge;
  if (given.preset == SoupOptions::Preset::voxels)
    voxel = lattice_voxel_size(soup).value_or(voxel);
#define QUADRILLE_PRESET(preset_, option, value)                                                   \
  if (given.preset == SoupOptions::Preset::preset_ && given.option == fallback.option)             \
    options.option = value;
#include <quadrille/compiled/presets.def>
  if (excludes_preparations(given)) {
    options.manifold = given.manifold;
    options.simplified_topology = given.simplified_topology;
  }
  if (options.cost != SoupOptions::Cost::quadric) {
    options.crease_degrees = given.crease_degrees;
    options.line_weight = given.line_weight;
    options.position_noise = given.position_noise;
  }
  if (given.keep_solid) {
    options.simplified_topology = given.simplified_topology;
    options.topology = given.topology;
  }
  if (edge == 0)
    options.voxel_size = given.voxel_size;
  if (options.order != SoupOptions::Order::relaxed && !options.simplified_topology)
    options.threads = 1;
  options.preset.reset();
  return options;
}

/// Returns the options of a call whose levels are to have the indices of the input: a preset then
/// adds no points. Throws std::invalid_argument for preparations, which do.
inline SoupOptions options_of_levels(const SoupOptions& given, const SoupView& soup) {
  if (given.manifold || given.join_gaps || given.simplified_topology)
    throw std::invalid_argument("manifold, join_gaps and simplified_topology add points and "
                                "triangles: they do not go with levels or "
                                "maps, which have the indices of the input");
  SoupOptions options = given.preset ? with_preset(given, soup) : given;
  options.manifold = false;
  options.simplified_topology.reset();
  return options;
}

} // namespace quadrille::internal

#endif // QUADRILLE_COMPILED_PRESETS_H
