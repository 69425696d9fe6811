#ifndef QUADRILLE_INTERNAL_CORE_CALL_ENGINE_H
#define QUADRILLE_INTERNAL_CORE_CALL_ENGINE_H

#include <quadrille/internal/core/contraction/enclosed_volume.h>
#include <quadrille/internal/core/contraction/result.h>
#include <quadrille/internal/core/contraction/working_surface.h>
#include <quadrille/internal/core/input/spatial_order.h>
#include <quadrille/internal/core/input/surface_input.h>
#include <quadrille/internal/core/order/greedy_loop.h>
#include <quadrille/internal/core/policy/orders.h>
#include <quadrille/internal/core/policy/stop_rule.h>
#include <quadrille/report.h>

#include <chrono>
#include <optional>
#include <stdexcept>
#include <utility>

namespace quadrille::internal {

/// Seconds since it was last asked.
class StopWatch {
public:
  double lap() {
    const auto now = Clock::now();
    return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
};

/// Contracts pairs in the order that was asked for. Returns why that has ended.
template <class Policies>
StopReason contract(WorkingSurface<Policies>& surface, Report& report, StopWatch& watch) {
  if (surface.progress().is_cancelled())
    return StopReason::cancelled;
  const std::optional<PassSettings>& passes = surface.policies().order.passes;
  if (passes) {
    report.seconds.prepare = watch.lap();
    if (!surface.progress().begin_contracting() ||
        !surface.policies().optional.run_passes(surface, *passes))
      return StopReason::cancelled;
    if (surface.progress().is_enough())
      return surface.run().target_rules().reason_of_stop(surface.status());
  }
  GreedyLoop<Policies> loop(surface);
  if (!passes)
    report.seconds.prepare = watch.lap();
  return loop.run();
}

/// Throws if there are tolerances and no policy enforces them, or the other way round. Are
/// tolerances of faces given?
template <class Input>
void check_tolerances(const Input& input, const StopRule& stop, bool have_faces) {
  if (stop.needs().tolerance && !have_faces && input.tolerances.size() < input.positions.size())
    throw std::invalid_argument(
        "quadrille::simplify: ToleranceLimit needs tolerances: pass vertex_tolerance_map");
  if (!stop.needs().tolerance && !input.tolerances.empty())
    throw std::invalid_argument("quadrille::simplify: nothing enforces the tolerances of "
                                "vertex_tolerance_map: pass ToleranceLimit as stop policy");
}

/// Prepares an input. Throws if the placement would leave the planes in which vertices have to
/// stay, or has to contain a surface that is no longer there.
template <class Policies>
void prepare(SurfaceInput<Policies::Cost::dimension>& input, const Policies& policies,
             Report& report) {
  using Placement = typename Policies::Placement;
  for (const auto& preparation : policies.preparations)
    preparation(input);
  report.kept_planes = input.planes.regions;
  if constexpr (looks_at_star<Placement>)
    if (input.planes.regions > 0)
      throw std::invalid_argument("quadrille::simplify: KeepPlanes does not go with a placement "
                                  "that looks at the faces around a pair: a hull, VolumeKeeping");
  if constexpr (needs_closed_surface<Placement>)
    if (!input.moved.empty())
      throw std::invalid_argument("quadrille::simplify: VoxelSize does not go with a hull, which "
                                  "has to contain the input");
}

/// The surface once pairs have been contracted; nothing if the visitor cancels before the first.
template <class Policies>
std::optional<typename ResultOf<Policies>::Finished>
contract_input(InputOf<Policies::Cost::dimension, Policies::has_channels> input,
               const Policies& policies, bool keeps_states, Report& report, StopWatch& watch) {
  check_tolerances(input, policies.stop, policies.optional.greatest_tolerance.has_value());
  const auto own_box = input.box();
  const auto box = box_of_units(input, own_box);
  if (policies.pairs.ignores_indices())
    SpatialOrder::apply(input, own_box, policies.threads);
  prepare(input, policies, report);
  WorkingSurface<Policies> surface(std::move(input), box, policies);
  const EnclosedVolume volume(surface, box);
  report.volume_before = volume(surface);
  surface.guards().begin(report);
  report.stop = contract(surface, report, watch);
  report.volume_after = volume(surface);
  surface.guards().end(report);
  if (surface.progress().is_cancelled() && !surface.progress().has_begun())
    return std::nullopt;
  if (surface.run().recording())
    surface.run().recording()->end(report.stop);
  return std::move(surface).finish(keeps_states, report);
}

/// The engine: what is left of a surface; nothing if the visitor cancels before the first
/// contraction. It does not know the mesh: where it has been instantiated for a cost and a
/// placement, calls with these compile no more than adapters (see
/// <quadrille/internal/core/call/compiled_engines.h>).
template <class Policies>
std::optional<ResultOf<Policies>>
simplify_input(InputOf<Policies::Cost::dimension, Policies::has_channels> input,
               const Policies& policies, bool keeps_states, Report& report, StopWatch& watch) {
  auto finished = contract_input(std::move(input), policies, keeps_states, report, watch);
  report.seconds.contract = watch.lap();
  if (!finished)
    return std::nullopt;
  return std::optional<ResultOf<Policies>>(std::in_place, *std::move(finished));
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_CALL_ENGINE_H
