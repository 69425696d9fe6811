#ifndef QUADRILLE_EXAMPLES_POLICIES_OF_CHUNKS_H
#define QUADRILLE_EXAMPLES_POLICIES_OF_CHUNKS_H

/// \file
/// The policies of a run by parts (quadrille/file.h) that the options of compiled soups name.

#include <quadrille/compiled.h>
#include <quadrille/edge_length.h>
#include <quadrille/file.h>
#include <quadrille/memoryless_quadric.h>

#include <optional>
#include <string>

namespace quadrille_examples {

/// The best that the cost has, unless another one is asked for.
template <class Cost>
quadrille::internal::BuiltInPlacement placement_of_chunks(const quadrille::SoupOptions& options) {
  using quadrille::internal::BuiltInPlacement;
  using Asked = quadrille::SoupOptions::Placement;
  using Kind = BuiltInPlacement::Kind;
  constexpr bool has_minimizer = quadrille::PlacementPolicy<quadrille::OptimalPlacement, Cost>;
  if (options.placement == Asked::endpoint)
    return BuiltInPlacement(Kind::endpoint);
  if (options.placement == Asked::midpoint || !has_minimizer)
    return BuiltInPlacement(Kind::midpoint);
  return BuiltInPlacement(Kind::optimal);
}

/// `tolerance` is the name of those of vertices, if they are the limit.
inline std::optional<quadrille::internal::DistanceChoice>
limit_of_chunks(const quadrille::SoupOptions& options, const std::string& tolerance) {
  using quadrille::internal::DistanceChoice;
  using Kind = DistanceChoice::Kind;
  if (!tolerance.empty())
    return DistanceChoice(Kind::tolerances);
  if (!options.error && !options.relative_error)
    return std::nullopt;
  return DistanceChoice(options.both_ways ? Kind::both_ways : Kind::one_way,
                        options.error ? *options.error : *options.relative_error, !options.error);
}

/// Returns run(cost, stop) with these policies; half of the faces without a target and a limit of
/// distances.
template <class Cost, class Run>
auto with_stop_of_chunks(const quadrille::SoupOptions& options, bool is_limited, const Run& run) {
  Cost cost;
  if constexpr (requires { cost.boundary_weight; })
    cost.boundary_weight = options.boundary_weight;
  if (options.faces)
    return run(cost, quadrille::FaceCount{*options.faces});
  if (is_limited && !options.ratio)
    return run(cost, quadrille::FaceCount{0});
  return run(cost, quadrille::FaceRatio{options.ratio.value_or(0.5)});
}

/// The same with the cost that is asked for: one of those of positions alone.
template <class Run>
auto with_policies_of_chunks(const quadrille::SoupOptions& options, bool is_limited,
                             const Run& run) {
  switch (options.cost) {
  case quadrille::SoupOptions::Cost::memoryless_quadric:
    return with_stop_of_chunks<quadrille::MemorylessQuadric>(options, is_limited, run);
  case quadrille::SoupOptions::Cost::thin_feature_quadric:
    return with_stop_of_chunks<quadrille::ThinFeatureQuadric>(options, is_limited, run);
  case quadrille::SoupOptions::Cost::edge_length:
    return with_stop_of_chunks<quadrille::EdgeLength>(options, is_limited, run);
  default:
    return with_stop_of_chunks<quadrille::Quadric>(options, is_limited, run);
  }
}

} // namespace quadrille_examples

#endif
