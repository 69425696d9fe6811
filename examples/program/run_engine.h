#ifndef QUADRILLE_EXAMPLES_PROGRAM_RUN_ENGINE_H
#define QUADRILLE_EXAMPLES_PROGRAM_RUN_ENGINE_H

/// \file
/// From options to calls of `quadrille::simplify`. Each call compiles an engine of its own, so what
/// includes this is split into sources that compile side by side: see simplify_mesh.h.

#include "../bounding_box.h"
#include "../carrying_cost.h"
#include "../local_cost.h"
#include "../mesh_attributes.h"
#include "../mesh_channels.h"
#include "../mesh_io.h"
#include "options.h"

#include <quadrille/compiled.h>
#include <quadrille/compiled/run_soup.h>
#include <quadrille/order.h>
#include <quadrille/placement.h>
#include <quadrille/quadric.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <CGAL/Named_function_parameters.h>

#include <functional>
#include <type_traits>
#include <utility>

namespace quadrille_examples {

// In all that follows, `into` is nothing, or the quadrille::record_into of a run that is recorded.

/// Placements chosen at run time: one engine for each cost is enough then.
struct Placement {
  enum { optimal, endpoint, midpoint } chosen;
  using ScaleFree = Placement; // as each of them is

  // The return type is spelt out so that asking whether this is a policy of another kind is no
  // error.
  auto operator()(const auto& cost, const auto& pair) const
      -> std::remove_cvref_t<decltype(pair.first)> {
    if constexpr (requires { cost.minimizer(pair); })
      if (chosen == optimal)
        return quadrille::OptimalPlacement{}(cost, pair);
    if (chosen == endpoint)
      return quadrille::EndpointPlacement{}(cost, pair);
    return quadrille::MidpointPlacement{}(cost, pair);
  }
};

inline Placement placement(const Options& options) {
  if (options.placement == "endpoint")
    return {Placement::endpoint};
  if (options.placement == "midpoint" || options.cost == "length")
    return {Placement::midpoint};
  return {Placement::optimal};
}

/// The options of a soup of these points, as quadrille::simplify_soup takes them.
quadrille::SoupOptions soup_options(const Options& options, const auto& points,
                                    const auto& triangles) {
  using Soup = quadrille::SoupOptions;
  Soup result;
  options.target.tell(result);
  result.cost = options.cost == "length"          ? Soup::Cost::edge_length
                : options.cost == "memoryless"    ? Soup::Cost::memoryless_quadric
                : options.cost == "thin-features" ? Soup::Cost::thin_feature_quadric
                                                  : Soup::Cost::quadric;
  result.boundary_weight = options.boundary_weight;
  if (options.placement == "endpoint")
    result.placement = Soup::Placement::endpoint;
  if (options.placement == "midpoint")
    result.placement = Soup::Placement::midpoint;
  if (options.joins_pairs())
    result.pairs_closer_than = length_of(options.pairs, diagonal(points, triangles));
  result.topology = topology(options);
  if (options.locks_boundaries)
    result.fixed = boundary_points(points.size(), triangles);
  result.proceed = options.proceed;
  return result;
}

inline quadrille::RelaxedOrder relaxed_order(const Options& options) {
  return {.threads = options.threads};
}

/// Named parameters of a call, and those of each call.
template <class Value, class Tag, class Before>
auto with_named_of_all(const CGAL::Named_function_parameters<Value, Tag, Before>& named,
                       const quadrille::SoupOptions& options, const auto& visitor) {
  using quadrille::internal::FixedPoints;
  return named.vertex_is_constrained_map(FixedPoints{&options.fixed}).visitor(std::cref(visitor));
}
/// All other arguments stay as they are.
template <class Argument>
const Argument& with_named_of_all(const Argument& argument, const quadrille::SoupOptions&,
                                  const auto&) {
  return argument;
}

/// The arguments are channels and the like, one of them the named parameters.
quadrille::Report simplify_in_order(const auto& order, auto& mesh, const Options& options,
                                    const auto& cost, const auto&... arguments) {
  const quadrille::SoupOptions soup = soup_options(options, mesh.points, mesh.triangles);
  const quadrille::internal::SoupVisitor visitor{soup.proceed};
  return quadrille::simplify(mesh.points, mesh.triangles, cost, placement(options), order,
                             quadrille::ThresholdPairs(soup.pairs_closer_than),
                             quadrille::internal::SoupStop(soup), *soup.topology,
                             with_named_of_all(arguments, soup, visitor)...);
}

template <class Cost>
Cost with_weights(Cost cost, const Options& options) {
  cost.boundary_weight = options.boundary_weight;
  if constexpr (requires { cost.crease_degrees; })
    cost.crease_degrees = options.crease_degrees.value_or(cost.crease_degrees);
  return cost;
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
    return simplify_by(with_weights(quadrille::Quadric{}, options));
  return simplify_by(local);
}

/// By how much less counts what shall hardly count.
inline constexpr double hardly = 1. / 64;

/// All count by default; else only those that the cost is asked for by name. Numbers may be noise,
/// so they hardly count.
inline ChannelChoices channel_choices(const Options& options) {
  const auto importance_if_asked_by = [&](const char* cost) {
    return options.cost.empty() || options.cost == cost ? 1. : hardly;
  };
  return {.of_colors = importance_if_asked_by("color"),
          .of_textures = importance_if_asked_by("texture"),
          .of_normals = importance_if_asked_by(""),
          .of_numbers = hardly,
          .texture_seams = options.seams};
}

/// With values at corners, named numbers and parts of faces, which `taken` takes through.
quadrille::Report simplify_channels(auto& mesh, auto&& taken, const Options& options,
                                    const auto&... into) {
  return with_cost_of_positions(options, [&](const auto& cost) {
    return taken.take_through(
        [&](const auto&... channels) {
          if (options.is_relaxed)
            return simplify_in_order(relaxed_order(options), mesh, options, cost, into...,
                                     channels...);
          return simplify_in_order(quadrille::GreedyOrder{}, mesh, options, cost, into...,
                                   channels...);
        },
        channel_choices(options));
  });
}

/// Does a mesh take the way on which all of its attributes are channels? Attributes as further
/// dimensions know neither passes nor creases, and what has no attributes goes the same way then.
inline bool goes_by_channels(const IndexedMesh& mesh, const Options& options) {
  return options.is_relaxed || options.crease_degrees || needs_channels(mesh);
}

/// With N attributes, which the engine places together with the positions.
template <std::size_t N>
quadrille::Report simplify_with(const MeshAttributes& attributes, IndexedMesh& mesh,
                                const Options& options, const auto& cost, const auto&... into) {
  std::vector<CarriedAttributes<N>> carried = attributes.carried<N>();
  const quadrille::Report report = simplify_in_order(
      quadrille::GreedyOrder{}, mesh, options, cost, into...,
      quadrille::parameters::vertex_attribute_map(CGAL::make_property_map(carried)));
  attributes.restore(mesh, carried);
  return report;
}

/// N attributes as further dimensions. They are lengths already.
template <std::size_t N>
quadrille::AttributeQuadric<N> attribute_quadric(const Options& options) {
  auto cost = with_weights(quadrille::AttributeQuadric<N>{}, options);
  cost.weights.emplace().coordinates.fill(1);
  return cost;
}

/// The quadric in as many dimensions as vary, rounded up, since each takes time to compile.
quadrille::Report simplify_dimensions(const MeshAttributes& attributes, IndexedMesh& mesh,
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

} // namespace quadrille_examples

#endif
