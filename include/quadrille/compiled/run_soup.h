#ifndef QUADRILLE_COMPILED_RUN_SOUP_H
#define QUADRILLE_COMPILED_RUN_SOUP_H

#include <quadrille/compiled.h>
#include <quadrille/compiled/soup_channel_list.h>
#include <quadrille/compiled/soup_maps.h>
#include <quadrille/compiled/soup_run.h>
#include <quadrille/internal/policy/built_in_placement.h>
#include <quadrille/normal_deviation.h>
#include <quadrille/order.h>
#include <quadrille/parameters.h>
#include <quadrille/placement.h>
#include <quadrille/self_intersection.h>
#include <quadrille/simplify.h>
#include <quadrille/solid.h>
#include <quadrille/threshold_pairs.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/property_map.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

/// \file
/// From options to policies.

namespace quadrille::internal {

/// The targets of the options; distances are needed only if one of them is a distance.
class SoupStop {
public:
  static constexpr Needs needs = {.tolerance = true, .cost = true};
  Needs needs_now() const {
    return {.distance = error_ || relative_error_,
            .distance_back = hausdorff_ || relative_hausdorff_,
            .tolerance = tolerance_.has_value(),
            .cost = cost_.has_value()};
  }

  explicit SoupStop(const SoupOptions& options) {
    if (options.faces)
      faces_ = FaceCount{*options.faces};
    if (options.ratio)
      ratio_ = FaceRatio{*options.ratio};
    if (options.cost_limit)
      cost_ = CostLimit(*options.cost_limit);
    if (options.vertices)
      vertices_ = VertexCount{*options.vertices};
    if (!options.tolerance.empty())
      tolerance_.emplace();
    if (options.both_ways)
      take_limits(options, hausdorff_, relative_hausdorff_);
    else
      take_limits(options, error_, relative_error_);
    if (options.stop)
      stop_ = {&options.stop};
    else if (!faces_ && !ratio_ && !vertices_ && needs_now() == Needs{})
      ratio_ = FaceRatio{};
  }

  bool operator()(const Status& status) const {
    return any([&](const auto& stop) { return stop(status); });
  }
  bool is_passed(const Status& status) const {
    return any([&](const auto& stop) { return internal::is_passed(stop, status); });
  }
  void validate() const {
    any([](const auto& stop) {
      internal::validate(stop);
      return false;
    });
  }

private:
  struct Asked {
    const std::function<bool(const Status&)>* is_enough;
    bool operator()(const Status& status) const { return (*is_enough)(status); }
  };

  template <class Limit>
  static void take_limits(const SoupOptions& options, std::optional<Limit>& absolute,
                          std::optional<Limit>& relative) {
    if (options.error)
      absolute = Limit(*options.error);
    if (options.relative_error)
      relative = Limit::relative(*options.relative_error);
  }

  template <class Is>
  bool any(Is is) const {
    const auto holds = [&](const auto& stop) { return stop && is(*stop); };
    return holds(faces_) || holds(ratio_) || holds(vertices_) || holds(error_) ||
           holds(relative_error_) || holds(hausdorff_) || holds(relative_hausdorff_) ||
           holds(tolerance_) || holds(cost_) || holds(stop_);
  }

  std::optional<FaceCount> faces_;
  std::optional<FaceRatio> ratio_;
  std::optional<VertexCount> vertices_;
  std::optional<ErrorLimit> error_, relative_error_;
  std::optional<HausdorffLimit> hausdorff_, relative_hausdorff_;
  std::optional<ToleranceLimit> tolerance_;
  std::optional<CostLimit> cost_;
  std::optional<Asked> stop_;
};

/// The filter of the options, which may have none.
struct SoupFilter {
  const std::function<bool(const SoupContraction&)>& asked;

  bool is_absent() const { return !asked; }
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
  bool proceed(const Status& status) const { return !asked || asked(status); }
};

inline std::optional<CGAL::Bbox_3> bounding_box_of(const SoupOptions& options) {
  if (!options.bounding_box)
    return std::nullopt;
  const auto& [low, high] = *options.bounding_box;
  return CGAL::Bbox_3(low[0], low[1], low[2], high[0], high[1], high[2]);
}

/// The order of the options, so that one engine is compiled for both.
inline AnyOrder order_of(const SoupOptions& options) {
  if (options.order == SoupOptions::Order::greedy)
    return GreedyOrder{options.eager};
  return RelaxedOrder{options.share, options.refresh, options.threads};
}

// The guards that the options ask for. A solid keeps faces apart by itself.
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

/// The named parameters that the options say.
inline auto named_of(const SoupOptions& options, const SoupVisitor& visitor) {
  return parameters::chain<parameters::bounding_box_t>(bounding_box_of(options))
      .coordinates_are_floats(options.coordinates_are_floats)
      .border_edges(std::span<const std::array<std::uint32_t, 2>>(options.borders))
      .vertex_is_shared_map(SoupValues{&options.shared})
      .vertex_importance_map(SoupValues{&options.importance})
      .vertex_tolerance_map(SoupValues{&options.tolerance})
      .face_is_selected_map(SoupValues{&options.selected})
      .vertex_is_constrained_map(SoupValues{&options.fixed})
      .visitor(std::cref(visitor));
}

/// By policies that the options say, in an order; `more` are labels and channels, if there are any.
template <class Cost, class Placement, class Order, class... More>
Report simplify_by(SoupRun& run, const Cost& cost, const Placement& placement, const Order& order,
                   const More&... more) {
  const SoupOptions& options = run.options;
  const SoupVisitor visitor{options.proceed};
  SoupRecorder recorder = options.recorder;
  const auto named = named_of(options, visitor);
  const auto simplify_soup = [&](const auto&... rest) {
    const auto run_with = [&](const auto&... topology) {
      return simplify(run.points, run.triangles, cost, placement,
                      ThresholdPairs(options.pairs_closer_than), SoupStop(options), order,
                      NormalFlip(options.normal_flip), SoupFilter{options.allows},
                      normal_deviation_of(options), no_self_intersection_of(options),
                      keep_solid_of(options), record_into(recorder), more..., topology..., rest...);
    };
    return options.topology ? run_with(*options.topology) : run_with();
  };
  if constexpr (sizeof...(More) > 0)
    if (options.split_vertices)
      return simplify_soup(SplitVertices{}, named);
  return simplify_soup(parameters::vertex_image_map(PointImages{&run.image}, named));
}

/// The same with whatever a soup carries, or may carry.
template <class Cost, class Placement, class Order>
Report simplify_with_all(SoupRun& run, const Cost& cost, const Placement& placement,
                         const Order& order) {
  return simplify_by(run, cost, placement, order,
                     Labels{SoupLabelMap{run.soup.labels}, run.options.label_border_weight},
                     SoupChannelList{run.soup.channels, &run.channels});
}

/// The placement of the options; by default, for a cost that has a minimizer, the optimal one.
template <class Cost>
BuiltInPlacement placement_of(const SoupOptions& options) {
  using Placement = SoupOptions::Placement;
  constexpr bool has_minimizer = PlacementPolicy<OptimalPlacement, Cost>;
  switch (options.placement.value_or(has_minimizer ? Placement::optimal : Placement::midpoint)) {
  case Placement::optimal:
    if (!has_minimizer)
      throw std::invalid_argument("quadrille::simplified_soup: this cost has no optimal placement: "
                                  "choose end points or midpoints");
    return BuiltInPlacement(OptimalPlacement{});
  case Placement::endpoint:
    return BuiltInPlacement(EndpointPlacement{});
  case Placement::midpoint:
    break;
  }
  return BuiltInPlacement(MidpointPlacement{});
}

/// A cost with the weights of the options.
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
  if (run.is_carrying()) // there is an engine for either
    return simplify_with_all(run, weighted, placement, order);
  return simplify_by(run, weighted, placement, order);
}

} // namespace quadrille::internal

#endif // QUADRILLE_COMPILED_RUN_SOUP_H
