#ifndef QUADRILLE_COMPILED_RUN_SOUP_H
#define QUADRILLE_COMPILED_RUN_SOUP_H

#include <quadrille/channels.h>
#include <quadrille/compiled.h>
#include <quadrille/compiled/soup_channel_list.h>
#include <quadrille/compiled/soup_maps.h>
#include <quadrille/compiled/soup_pairs.h>
#include <quadrille/compiled/soup_run.h>
#include <quadrille/distance_limits.h>
#include <quadrille/guards.h>
#include <quadrille/internal/core/policy/built_in_placement.h>
#include <quadrille/keep_planes.h>
#include <quadrille/parameters.h>
#include <quadrille/placement.h>
#include <quadrille/record.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>
#include <quadrille/voxel_size.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/property_map.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

/// \file
/// Converts options to policies.

namespace quadrille::internal {

/// Returns the limits of the options as distances and as fractions of the diagonal; at most one of
/// a kind is set.
template <class Limit>
std::optional<Limit> limit_of(const SoupOptions& options, bool is_asked) {
  if (!is_asked || !options.error)
    return std::nullopt;
  return Limit(*options.error);
}
template <class Limit>
std::optional<Limit> relative_limit_of(const SoupOptions& options, bool is_asked) {
  if (!is_asked || !options.relative_error)
    return std::nullopt;
  return Limit::relative(*options.relative_error);
}

/// Returns the targets of the options. Distances that no target needs are not measured.
inline auto stop_of(const SoupOptions& options) {
  std::optional<FaceCount> faces;
  std::optional<FaceRatio> ratio;
  std::optional<VertexCount> vertices;
  std::optional<CostLimit> cost;
  std::optional<ToleranceLimit> tolerance;
  std::optional<std::reference_wrapper<const std::function<bool(const Status&)>>> own;
  if (options.faces)
    faces = FaceCount{*options.faces};
  if (options.ratio)
    ratio = FaceRatio{*options.ratio};
  if (options.vertices)
    vertices = VertexCount{*options.vertices};
  if (options.cost_limit)
    cost = CostLimit(*options.cost_limit);
  if (!options.tolerance.empty())
    tolerance.emplace();
  if (options.stop)
    own = std::cref(options.stop);
  const bool are_limits = options.error || options.relative_error;
  if (!faces && !ratio && !vertices && !cost && !tolerance && !own && !are_limits)
    ratio = FaceRatio{};
  return AnyOf{faces,
               ratio,
               vertices,
               limit_of<DistanceLimit>(options, !options.both_ways),
               relative_limit_of<DistanceLimit>(options, !options.both_ways),
               limit_of<HausdorffLimit>(options, options.both_ways),
               relative_limit_of<HausdorffLimit>(options, options.both_ways),
               tolerance,
               cost,
               own};
}

/// The filter of the options.
struct SoupFilter {
  const std::function<bool(const SoupContraction&)>& asked;

  bool allows(const auto& contraction) const {
    SoupContraction seen{.first = contraction.first(),
                         .second = contraction.second(),
                         .target = space(contraction.target()).coordinates,
                         .faces = {},
                         .removed_faces = {},
                         .highest_degree = contraction.highest_degree()};
    for (const auto& f : contraction.faces())
      seen.faces.push_back({f.index, f.before.coordinates, f.after.coordinates,
                            f.second.coordinates, f.third.coordinates});
    for (const std::size_t face : contraction.removed_faces())
      seen.removed_faces.push_back(face);
    return asked(seen);
  }
};

struct SoupVisitor {
  const std::function<bool(const Status&)>& asked;
  bool proceed(const Status& status) const { return asked(status); }
};

/// Makes a policy of the function in the options, if there is one.
template <class Policy, class Function>
std::optional<Policy> policy_of(const Function& asked) {
  if (!asked)
    return std::nullopt;
  return Policy{asked};
}
inline std::optional<SoupPairs> pairs_of(const SoupOptions& options) {
  if (!options.pairs_closer_than)
    return std::nullopt;
  return SoupPairs(*options.pairs_closer_than);
}

inline std::optional<KeepPlanes> keep_planes_of(const SoupOptions& options) {
  if (!options.keep_planes)
    return std::nullopt;
  return KeepPlanes{*options.keep_planes, options.plane_flatness,
                    options.plane_outline ? options.plane_outline : options.error};
}

inline std::optional<VoxelSize> voxel_size_of(const SoupOptions& options) {
  if (!options.voxel_size)
    return std::nullopt;
  return VoxelSize{*options.voxel_size};
}

inline std::optional<HeightField> height_field_of(const SoupOptions& options) {
  if (!options.height_field)
    return std::nullopt;
  Vector<3> up{};
  up[static_cast<std::size_t>(*options.height_field)] = 1;
  return HeightField(up);
}

inline std::optional<CGAL::Bbox_3> bounding_box_of(const SoupOptions& options) {
  if (!options.bounding_box)
    return std::nullopt;
  const auto& [low, high] = *options.bounding_box;
  return CGAL::Bbox_3(low[0], low[1], low[2], high[0], high[1], high[2]);
}

/// Returns the order of the options: one engine is compiled for both orders.
inline AnyOrder order_of(const SoupOptions& options) {
  if (options.order == SoupOptions::Order::greedy)
    return GreedyOrder{};
  return RelaxedOrder{options.share, options.refresh, options.threads};
}

// Returns the guards of the options. KeepSolid includes NoSelfIntersection.
inline std::optional<NormalDeviation> normal_deviation_of(const SoupOptions& options) {
  if (!options.normal_deviation)
    return std::nullopt;
  return NormalDeviation{*options.normal_deviation};
}
inline std::optional<NoSelfIntersection> no_self_intersection_of(const SoupOptions& options) {
  if (!options.no_self_intersection || options.keep_solid)
    return std::nullopt;
  return NoSelfIntersection{};
}
inline std::optional<KeepSolid> keep_solid_of(const SoupOptions& options) {
  if (!options.keep_solid)
    return std::nullopt;
  return KeepSolid{};
}

inline std::optional<RecordInto<SoupRecorder>>
record_into_given(std::optional<SoupRecorder>& recorder) {
  if (!recorder)
    return std::nullopt;
  return record_into(*recorder);
}

/// Returns the named parameters of the options.
inline auto named_of(const SoupOptions& options) {
  return parameters::chain<parameters::bounding_box_t>(bounding_box_of(options))
      .coordinates_are_floats(options.coordinates_are_floats)
      .boundary_edges(std::span<const std::array<std::uint32_t, 2>>(options.boundaries))
      .vertex_is_shared_map(values_if_given(options.shared))
      .vertex_importance_map(values_if_given(options.importance))
      .vertex_tolerance_map(values_if_given(options.tolerance))
      .face_is_selected_map(values_if_given(options.selected))
      .vertex_is_constrained_map(values_if_given(options.fixed))
      .visitor(policy_of<SoupVisitor>(options.proceed));
}

/// Is there an engine for soups without attributes, in addition to the one for all soups? It has
/// the same results, as much code, and takes 7/8 of the time. A library that has to be small
/// defines QUADRILLE_FEW_ENGINES, and has it for the default cost only.
#ifdef QUADRILLE_FEW_ENGINES
template <class Cost>
inline constexpr bool has_bare_engine = std::is_same_v<Cost, Quadric>;
#else
template <class Cost>
inline constexpr bool has_bare_engine = true;
#endif

/// Simplifies with the policies of the options, in an order; `more` are labels and channels, if
/// there are any.
template <class Cost, class Placement, class Order, class... More>
Report simplify_by(SoupRun& run, const Cost& cost, const Placement& placement, const Order& order,
                   const More&... more) {
  const SoupOptions& options = run.options;
  std::optional<SoupRecorder> recorder = options.recorder;
  const auto named = named_of(options);
  const auto simplify_soup = [&](const auto&... rest) {
    return simplify(run.points, run.triangles, cost, placement, pairs_of(options), stop_of(options),
                    order, NormalFlip(options.normal_flip), policy_of<SoupFilter>(options.allows),
                    options.topology, keep_planes_of(options), voxel_size_of(options),
                    height_field_of(options), normal_deviation_of(options),
                    no_self_intersection_of(options), keep_solid_of(options),
                    record_into_given(recorder), more..., rest...);
  };
  if constexpr (sizeof...(More) > 0)
    if (options.split_vertices)
      return simplify_soup(SplitVertices{}, named);
  return simplify_soup(parameters::vertex_to_vertex_map(PointMap{&run.vertex_map}, named));
}

/// Simplifies with all attributes that a soup has or may have.
template <class Cost, class Placement, class Order>
Report simplify_with_all(SoupRun& run, const Cost& cost, const Placement& placement,
                         const Order& order) {
  std::optional<Labels<SoupLabelMap>> labels;
  if (!run.soup.labels.empty())
    labels = Labels{SoupLabelMap{run.soup.labels}, run.options.region_boundary_weight};
  return simplify_by(run, cost, placement, order, labels,
                     SoupChannelList{run.soup.channels, &run.channels});
}

/// Returns the placement of the options; the default for a cost with a minimizer is the optimal
/// one.
template <class Cost>
BuiltInPlacement placement_of(const SoupOptions& options) {
  using Placement = SoupOptions::Placement;
  constexpr bool has_minimizer = PlacementPolicy<OptimalPlacement, Cost>;
  switch (options.placement.value_or(has_minimizer ? Placement::optimal : Placement::midpoint)) {
  case Placement::optimal:
    if (!has_minimizer)
      throw std::invalid_argument(
          "quadrille::simplified_soup: this cost has no optimal placement: choose endpoints or "
          "midpoints");
    return BuiltInPlacement(OptimalPlacement{});
  case Placement::endpoint:
    return BuiltInPlacement(EndpointPlacement{});
  case Placement::midpoint:
    break;
  }
  return BuiltInPlacement(MidpointPlacement{});
}

/// Returns a cost with the weights of the options.
template <class Cost>
Cost with_weights(Cost cost, const SoupOptions& options) {
  if constexpr (requires { cost.boundary_weight; })
    cost.boundary_weight = options.boundary_weight;
  if constexpr (requires { cost.crease_degrees; }) {
    cost.crease_weight = options.crease_weight;
    cost.crease_degrees = options.crease_degrees;
  }
  if constexpr (requires { cost.line_weight; }) {
    cost.weighting = options.weighting;
    cost.line_weight = options.line_weight;
    cost.normal_noise = options.normal_noise;
    cost.position_noise = options.position_noise;
  }
  return cost;
}

template <class Cost>
Report simplify_by_cost(SoupRun& run, const Cost& cost) {
  const Cost weighted = with_weights(cost, run.options);
  const BuiltInPlacement placement = placement_of<Cost>(run.options);
  const AnyOrder order = order_of(run.options);
  if constexpr (has_bare_engine<Cost>) {
    if (!run.is_carrying())
      return simplify_by(run, weighted, placement, order);
  }
  return simplify_with_all(run, weighted, placement, order);
}

} // namespace quadrille::internal

#endif // QUADRILLE_COMPILED_RUN_SOUP_H
