#ifndef QUADRILLE_COMPILED_RUN_SOUP_H
#define QUADRILLE_COMPILED_RUN_SOUP_H

#include <quadrille/compiled.h>
#include <quadrille/compiled/costs.h>
#include <quadrille/parameters.h>
#include <quadrille/placement.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <CGAL/property_map.h>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

/// \file
/// From options to policies.

namespace quadrille::internal {

/// The targets of the options; distances are asked for only if one of them is a distance.
template <bool has_distance>
class SoupStop {
public:
  static constexpr bool asks_for_distance = has_distance;

  explicit SoupStop(const SoupOptions& options) {
    if (options.faces)
      faces_.emplace(*options.faces);
    if (options.ratio)
      ratio_.emplace(*options.ratio);
    if (options.vertices)
      vertices_.emplace(*options.vertices);
    if (options.error)
      error_.emplace(*options.error);
    if (options.relative_error)
      relative_error_.emplace(ErrorLimit::relative(*options.relative_error));
    if (!faces_ && !ratio_ && !vertices_ && !error_ && !relative_error_)
      ratio_.emplace();
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
  template <class Is>
  bool any(Is is) const {
    const auto holds = [&](const auto& stop) { return stop && is(*stop); };
    return holds(faces_) || holds(ratio_) || holds(vertices_) || holds(error_) ||
           holds(relative_error_);
  }

  std::optional<FaceCount> faces_;
  std::optional<FaceRatio> ratio_;
  std::optional<VertexCount> vertices_;
  std::optional<ErrorLimit> error_, relative_error_;
};

/// An end or the midpoint.
struct SoupPlacement {
  using ScaleFree = SoupPlacement; ///< as both of them are
  bool is_midpoint;

  template <class Cost, class Pair>
  auto operator()(const Cost& cost, const Pair& pair) const
      -> std::remove_cvref_t<decltype(pair.first)> {
    return is_midpoint ? MidpointPlacement{}(cost, pair) : EndpointPlacement{}(cost, pair);
  }
};

struct SoupVisitor {
  const std::function<bool(const Status&)>& asked;
  bool proceed(const Status& status) const { return !asked || asked(status); }
};

/// Which points are fixed.
struct FixedPoints {
  using key_type = std::size_t;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;
  const std::vector<bool>* is_fixed;

  friend bool get(const FixedPoints& map, std::size_t i) {
    return !map.is_fixed->empty() && (*map.is_fixed)[i];
  }
};

/// What became of each point, if anybody asks.
struct PointImages {
  using key_type = std::size_t;
  using value_type = std::size_t;
  using reference = std::size_t;
  using category = boost::writable_property_map_tag;
  std::vector<std::size_t>* image;

  friend void put(const PointImages& map, std::size_t i, std::size_t of_it) {
    if (map.image)
      (*map.image)[i] = of_it;
  }
};

template <class Cost, class Placement>
Report simplify_by(SoupPoints& points, SoupTriangles& triangles, const SoupOptions& options,
                   std::vector<std::size_t>* image, const Cost& cost, const Placement& placement) {
  const auto run = [&](const auto& stop, const auto& order) {
    const SoupVisitor visitor{options.proceed};
    const auto named = CGAL::parameters::vertex_is_constrained_map(FixedPoints{&options.fixed})
                           .visitor(std::cref(visitor));
    const auto all = parameters::vertex_image_map(PointImages{image}, named);
    const ThresholdPairs pairs(options.pairs_closer_than);
    const NormalFlip filter(options.normal_flip);
    if (options.topology)
      return simplify(points, triangles, cost, placement, pairs, stop, order, filter,
                      *options.topology, all);
    return simplify(points, triangles, cost, placement, pairs, stop, order, filter, all);
  };
  const auto in_order = [&](const auto& stop) {
    return options.order == SoupOptions::Order::relaxed ? run(stop, RelaxedOrder{})
                                                        : run(stop, GreedyOrder{});
  };
  return options.error || options.relative_error ? in_order(SoupStop<true>(options))
                                                 : in_order(SoupStop<false>(options));
}

/// With the placement of the options; by default, for a cost that has a minimizer, the optimal one.
template <class Cost>
Report simplify_by(SoupPoints& points, SoupTriangles& triangles, const SoupOptions& options,
                   std::vector<std::size_t>* image, Cost cost) {
  using Placement = SoupOptions::Placement;
  if constexpr (requires { cost.boundary_weight; })
    cost.boundary_weight = options.boundary_weight;
  constexpr bool has_minimizer = PlacementPolicy<OptimalPlacement, Cost>;
  const Placement placement =
      options.placement.value_or(has_minimizer ? Placement::optimal : Placement::midpoint);
  if constexpr (has_minimizer)
    if (placement == Placement::optimal)
      return simplify_by(points, triangles, options, image, cost, OptimalPlacement{});
  if (placement == Placement::optimal)
    throw std::invalid_argument("quadrille::simplify_soup: this cost has no optimal placement: "
                                "choose end points or midpoints");
  return simplify_by(points, triangles, options, image, cost,
                     SoupPlacement{placement == Placement::midpoint});
}

} // namespace quadrille::internal

#endif // QUADRILLE_COMPILED_RUN_SOUP_H
