#ifndef QUADRILLE_EXAMPLES_PROGRAM_SIMPLIFY_MESH_H
#define QUADRILLE_EXAMPLES_PROGRAM_SIMPLIFY_MESH_H

/// \file
/// From options and a mesh to the call that simplifies it.

#include "../carrying_cost.h"
#include "../local_cost.h"
#include "../mesh_attributes.h"
#include "../mesh_channels.h"
#include "../mesh_io.h"
#include "options.h"
#include "policies.h"

#include <quadrille/compiled.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iostream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace quadrille_examples {

template <class Cost>
Cost with_boundary_weight(Cost cost, const Options& options) {
  cost.boundary_weight = options.boundary_weight;
  return cost;
}

// In all that follows, `into` is nothing, or the quadrille::record_into of a run that is recorded.

quadrille::Report simplify(auto& mesh, const Options& options, const auto& cost,
                           const auto&... named) {
  const auto until = [&](const auto& stop) {
    return quadrille::simplify(mesh.points, mesh.triangles, cost, placement(options),
                               quadrille::ThresholdPairs(options.pairs_closer_than), stop,
                               topology(options), named...);
  };
  // It asks for distances that other targets need not pay for.
  if (const auto* limit = std::get_if<quadrille::ErrorLimit>(&options.target.chosen))
    return until(*limit);
  return until(options.target);
}

/// With attributes, which the engine places together with the positions.
template <std::size_t N>
quadrille::Report simplify_with(const MeshAttributes& attributes, IndexedMesh& mesh,
                                const Options& options, const auto& cost, const auto&... into) {
  std::vector<CarriedAttributes<N>> carried = attributes.carried<N>();
  const quadrille::Report report =
      simplify(mesh, options, cost, into...,
               quadrille::parameters::vertex_attribute_map(CGAL::make_property_map(carried)));
  attributes.restore(mesh, carried);
  return report;
}

/// N attributes as further dimensions. They are lengths already.
template <std::size_t N>
quadrille::AttributeQuadric<N> attribute_quadric(const Options& options) {
  auto cost = with_boundary_weight(quadrille::AttributeQuadric<N>{}, options);
  cost.weights.emplace().coordinates.fill(1);
  return cost;
}

/// The quadric in as many dimensions as vary, rounded up, since each takes time to compile.
quadrille::Report simplify_by_attributes(const MeshAttributes& attributes, IndexedMesh& mesh,
                                         const Options& options, const auto&... into) {
  if (attributes.size() <= 2)
    return simplify_with<2>(attributes, mesh, options, attribute_quadric<2>(options), into...);
  if (attributes.size() == 3)
    return simplify_with<3>(attributes, mesh, options, attribute_quadric<3>(options), into...);
  return simplify_with<6>(attributes, mesh, options, attribute_quadric<6>(options), into...);
}

/// With a cost that looks at positions only, along which attributes are carried.
quadrille::Report simplify_carrying(const MeshAttributes& attributes, IndexedMesh& mesh,
                                    const Options& options, const auto& cost, const auto&... into) {
  return simplify_with<6>(attributes, mesh, options,
                          CarryingCost<std::remove_cvref_t<decltype(cost)>, 6>(cost), into...);
}

inline quadrille::SoupOptions soup_options(const Options& options) {
  using Cost = quadrille::SoupOptions::Cost;
  quadrille::SoupOptions result;
  options.target.tell(result);
  result.cost = options.cost == "length"          ? Cost::edge_length
                : options.cost == "memoryless"    ? Cost::memoryless_quadric
                : options.cost == "thin-features" ? Cost::thin_feature_quadric
                                                  : Cost::quadric;
  result.boundary_weight = options.boundary_weight;
  if (options.placement == "endpoint")
    result.placement = quadrille::SoupOptions::Placement::endpoint;
  if (options.placement == "midpoint")
    result.placement = quadrille::SoupOptions::Placement::midpoint;
  result.pairs_closer_than = options.pairs_closer_than;
  result.topology = topology(options);
  return result;
}

/// Without attributes that vary.
inline quadrille::Report simplify_positions(const MeshAttributes& attributes, IndexedMesh& mesh,
                                            const Options& options) {
  quadrille::SoupPoints points(mesh.points.size());
  std::transform(mesh.points.begin(), mesh.points.end(), points.begin(), [](const Point& p) {
    return std::array{p.x(), p.y(), p.z()};
  });
  const quadrille::Report report =
      quadrille::simplify_soup(points, mesh.triangles, soup_options(options));
  mesh.points.resize(points.size());
  std::transform(points.begin(), points.end(), mesh.points.begin(),
                 [](const auto& p) { return Point(p[0], p[1], p[2]); });
  attributes.restore(mesh);
  return report;
}

/// By how much less counts what shall hardly count.
inline constexpr double hardly = 1. / 64;

/// As AttributeQuadric has it for each kind. If one is asked for by name, the other hardly counts.
inline Importance importance(const Options& options) {
  Importance importance{quadrille::ColorQuadric{}.importance,
                        quadrille::TextureQuadric{}.importance};
  if (options.cost == "color")
    importance.of_textures *= hardly;
  if (options.cost == "texture")
    importance.of_colors *= hardly;
  return importance;
}

/// All count by default; else only those that the cost is asked for by name. Numbers may be noise,
/// so they hardly count.
inline ChannelImportance channel_importance(const Options& options) {
  const auto importance_if_asked_by = [&](const char* cost) {
    return options.cost.empty() || options.cost == cost ? 1. : hardly;
  };
  return {.of_colors = importance_if_asked_by("color"),
          .of_textures = importance_if_asked_by("texture"),
          .of_normals = importance_if_asked_by(""),
          .of_numbers = hardly};
}

/// Calls simplify_by(cost) with the one that looks at positions: two types serve for all of them.
quadrille::Report with_cost_of_positions(const Options& options, const auto& simplify_by) {
  LocalCost local;
  local.boundary_weight = options.boundary_weight;
  if (options.cost == "memoryless")
    local.kind = LocalCost::memoryless;
  else if (options.cost == "thin-features")
    local.kind = LocalCost::thin_features;
  else if (options.cost == "length")
    local.kind = LocalCost::length;
  else
    return simplify_by(with_boundary_weight(quadrille::Quadric{}, options));
  return simplify_by(local);
}

/// With values at corners, named numbers and parts of faces, which `taken` takes through.
quadrille::Report simplify_by_channels(auto& mesh, auto&& taken, const Options& options,
                                       const auto&... into) {
  return with_cost_of_positions(options, [&](const auto& cost) {
    return taken.take_through(
        [&](const auto&... channels) {
          return simplify(mesh, options, cost, into..., channels...);
        },
        channel_importance(options));
  });
}

inline quadrille::Report simplify_by_cost(IndexedMesh& mesh, const Options& options) {
  if (needs_channels(mesh))
    return simplify_by_channels(mesh, MeshChannels(mesh), options);
  const MeshAttributes attributes(mesh, importance(options));
  if (attributes.size() == 0)
    return simplify_positions(attributes, mesh, options);
  const auto carrying = [&](const auto& cost) {
    return simplify_carrying(attributes, mesh, options, cost);
  };
  if (options.cost == "length")
    return carrying(quadrille::EdgeLength{});
  if (options.cost == "memoryless")
    return carrying(with_boundary_weight(quadrille::MemorylessQuadric{}, options));
  if (options.cost == "thin-features")
    return carrying(with_boundary_weight(quadrille::ThinFeatureQuadric{}, options));
  if (options.cost != "quadric")
    return simplify_by_attributes(attributes, mesh, options);
  return carrying(with_boundary_weight(quadrille::Quadric{}, options));
}

/// As simplify_positions, which records nothing.
quadrille::Report simplify_recorded_positions(IndexedMesh& mesh, const Options& options,
                                              const auto& into) {
  if (options.cost == "memoryless") // LocalCost rounds differently
    return simplify(mesh, options, with_boundary_weight(quadrille::MemorylessQuadric{}, options),
                    into);
  IndexedMesh bare;
  bare.points = std::move(mesh.points);
  bare.triangles = std::move(mesh.triangles);
  const quadrille::Report report = simplify_by_channels(bare, MeshChannels(bare), options, into);
  mesh.points = std::move(bare.points);
  mesh.triangles = std::move(bare.triangles);
  return report;
}

/// As simplify_by_cost, to the same bits, by fewer types of costs, since each of them is compiled
/// once more for recordings.
quadrille::Report simplify_recorded(IndexedMesh& mesh, const Options& options, const auto& into) {
  if (needs_channels(mesh))
    return simplify_by_channels(mesh, MeshChannels(mesh), options, into);
  const MeshAttributes attributes(mesh, importance(options));
  if (attributes.size() == 0) {
    const quadrille::Report report = simplify_recorded_positions(mesh, options, into);
    attributes.restore(mesh);
    return report;
  }
  const auto carrying = [&](const auto& cost) {
    return simplify_carrying(attributes, mesh, options, cost, into);
  };
  if (options.cost.empty() || options.cost == "color" || options.cost == "texture")
    return simplify_by_attributes(attributes, mesh, options, into);
  if (options.cost == "memoryless") // as above
    return carrying(with_boundary_weight(quadrille::MemorylessQuadric{}, options));
  return with_cost_of_positions(options, carrying);
}

/// What is wrong with attributes that no weight makes comparable with positions is told of the
/// file.
quadrille::Report with_errors_of_file(const Options& options, const auto& simplify) {
  try {
    return simplify();
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(options.input + ": " + error.what());
  }
}

/// Whatever of the file the result will not have, and what a user may not expect.
inline void print_remarks(const Options& options, IndexedMesh& mesh) {
  if (!mesh.losses.empty())
    mesh.remarks.push_back("not kept: " + mesh.losses.text());
  const std::size_t open = options.pairs_closer_than > 0 ? 0 : OpenSeams::count(mesh);
  if (open > 0)
    mesh.remarks.push_back(
        "boundary edges at the place of another one, along which cracks may open, since the two do "
        "not share their vertices (--weld makes them one): " +
        std::to_string(open));
  for (const std::string& remark : mesh.remarks)
    std::cerr << options.input << ": " << remark << '\n';
}

} // namespace quadrille_examples

#endif
