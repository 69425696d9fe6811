#ifndef QUADRILLE_INTERNAL_FILE_CHUNK_H
#define QUADRILLE_INTERNAL_FILE_CHUNK_H

#include <quadrille/channels.h>
#include <quadrille/internal/core/call/arguments.h>
#include <quadrille/internal/core/call/run.h>
#include <quadrille/internal/core/cost/vertex_states.h>
#include <quadrille/internal/core/evaluation/cost_units.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/surface/box.h>
#include <quadrille/internal/core/surface/scale.h>
#include <quadrille/internal/file/chunk_adapter.h>
#include <quadrille/stop.h>

#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// \file
/// Simplifies a chunk of a surface by itself, and returns all that a caller needs to join the
/// chunks.

namespace quadrille::internal {

/// Converts a cost limit from the engine's unit to the mesh's units. The limit is one of the cost's
/// keys, as CostHistogram::cost_for() returns it, for surfaces that are simplified in the scale of
/// that box.
template <class Cost>
CostLimit cost_limit(const Cost& cost, const Box<Cost::dimension>& box, double key) {
  static_assert(has_cost_in_mesh_units<Cost>);
  return CostLimit(key * cost_of_key(cost, Scale<Cost::dimension>(box, is_scale_free<Cost>)));
}

template <>
inline constexpr bool is_channel<ChunkChannels> = true;

/// Returns the channels among the arguments of a call, if there are any.
inline const ChunkChannels* channels_among() {
  return nullptr;
}
template <class First, class... Rest>
const ChunkChannels* channels_among(const First& first, const Rest&... rest) {
  if constexpr (std::is_same_v<First, ChunkChannels>)
    return &first;
  else
    return channels_among(rest...);
}

/// Requests the states of vertices, if the cost has any.
template <class Cost>
struct ChunkReporter {
  static constexpr bool asks_for_states = !std::is_empty_v<typename Cost::State>;
};

/// Simplifies a chunk by itself. Its policies are all that `simplify` accepts in addition to cost
/// and placement, and ChunkChannels; of named parameters, it accepts a visitor. Everything is in
/// the scale of the chunk's box. Positions without faces are removed. If the visitor cancels before
/// the first contraction, the result is empty.
///
/// Throws std::invalid_argument for an invalid chunk, and everything that `simplify` throws.
template <class Cost, class Placement, class... Arguments>
ChunkResult<Cost> simplify_chunk(Chunk<Cost> chunk, const Cost& cost, const Placement& placement,
                                 const Arguments&... arguments) {
  using State = typename Cost::State;
  static_assert(
      std::is_empty_v<State> || requires(State m) { m -= m; },
      "quadrille: out of core, a cost with state needs a State with the operator -=");
  ChunkResult<Cost> result;
  const GivenStates<State> given{std::move(chunk.states), std::move(chunk.has_state)};
  auto policies = pick_policies<NotGiven, NotGiven>(cost, placement, arguments...);
  if (!given.states.empty())
    policies.optional.states = &given;
  policies.optional.costs = &result.costs;
  std::vector<FaceBound> bounds = std::move(chunk.bounds);
  if (!bounds.empty() && bounds.size() != chunk.triangles.size())
    throw std::invalid_argument("quadrille: a tile has " + std::to_string(bounds.size()) +
                                " bounds, not " + std::to_string(chunk.triangles.size()));
  if (policies.stop.needs().tolerance && chunk.tolerances.empty()) {
    if (bounds.empty() && !chunk.triangles.empty())
      throw std::invalid_argument("quadrille: a tile has no tolerances");
    policies.optional.greatest_tolerance = chunk.greatest_tolerance;
  }
  if (policies.stop.needs().distance) {
    bounds.resize(chunk.triangles.size());
    policies.optional.bounds = &bounds;
  }
  Arena arena(memory_needs(policies, !chunk.labels.empty(), chunk.positions.size(),
                           chunk.triangles.size()));
  ChunkAdapter<Cost, decltype(policies)::has_channels> adapter(
      chunk, given, channels_among(arguments...), result, arena);
  const auto read = [](auto& reader) { return reader.read(); };
  result.report = run(adapter, policies, read, ChunkReporter<Cost>{});
  if (policies.optional.bounds)
    for (const Index face : result.faces)
      result.bounds.push_back(bounds[face]);
  return result;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_CHUNK_H
