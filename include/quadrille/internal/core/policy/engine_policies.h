#ifndef QUADRILLE_INTERNAL_CORE_POLICY_ENGINE_POLICIES_H
#define QUADRILLE_INTERNAL_CORE_POLICY_ENGINE_POLICIES_H

#include <quadrille/internal/core/base/threads.h>
#include <quadrille/internal/core/policy/filter_list.h>
#include <quadrille/internal/core/policy/guard_set.h>
#include <quadrille/internal/core/policy/orders.h>
#include <quadrille/internal/core/policy/pair_source.h>
#include <quadrille/internal/core/policy/recorder_handle.h>
#include <quadrille/internal/core/policy/stop_rule.h>
#include <quadrille/report.h>
#include <quadrille/topology.h>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace quadrille::internal {

template <class Policies>
class WorkingSurface;
template <class Policies>
class Recording;
template <class Policies>
struct RecordingNeeds;
template <class Policies>
std::unique_ptr<Recording<Policies>> make_recording(const RecordingNeeds<Policies>& needs);
template <class Policies>
class MeasuredDistances;
template <class Policies>
struct DistanceNeeds;
template <class Policies, bool both_ways>
std::unique_ptr<MeasuredDistances<Policies>> make_distances(const DistanceNeeds<Policies>& needs);
template <class Memory>
struct GivenMemories;
struct FaceBound;
class CostHistogram;

/// Contracts pairs in passes; false if the visitor cancels. RelaxedOrder brings it.
template <class Policies>
bool run_passes(WorkingSurface<Policies>& surface, const PassSettings& settings);

/// What only some calls need, as functions: a call that cannot need it does not compile it.
template <class Policies>
struct OptionalParts {
  /// Contracts pairs in passes; false if the visitor cancels.
  bool (*run_passes)(WorkingSurface<Policies>&, const PassSettings&) = nullptr;
  /// What tells the recorder.
  std::unique_ptr<Recording<Policies>> (*make_recording)(const RecordingNeeds<Policies>&) = nullptr;
  /// What measures distances for a stop policy that asks for them.
  std::unique_ptr<MeasuredDistances<Policies>> (*make_distances)(const DistanceNeeds<Policies>&) =
      nullptr;
  /// What vertices remember at the beginning instead of what their faces leave, if that is given.
  const GivenMemories<typename Policies::Cost::Memory>* memories = nullptr;
  /// How far each input face is from the input of all pieces, at the beginning and then at the end;
  /// where a stop policy asks for distances.
  std::vector<FaceBound>* bounds = nullptr;
  /// The greatest tolerance of the input of all pieces, in the mesh's units, where bounds have
  /// tolerances at the beginning.
  std::optional<double> greatest_tolerance = {};
  /// Counts what contractions cost.
  CostHistogram* costs = nullptr;
};

/// Everything that `simplify` was asked for, each with its default where it was not named. The
/// engine is compiled for a cost and a placement, with channels or without; all else is told at run
/// time.
template <class Cost_, class Placement_, bool has_channels_>
struct Policies {
  using Cost = Cost_;
  using Placement = Placement_;
  static constexpr bool has_channels = has_channels_; ///< of attributes beside the shape

  Cost cost;
  Placement placement;
  double label_border_weight; // see Labels
  PairSource pairs;
  StopRule stop;
  CallOrder order;
  std::function<bool(const Status&)> visitor; // of no target where there is none
  Threads threads;                            // as many as the order asks for
  std::optional<RecorderHandle> recorder;     // who is told of contractions
  std::optional<Topology> topology;           // nothing: as the mesh and the pairs suggest
  FilterList<Cost::dimension> filters;
  GuardSet<Cost::dimension> guards;
  OptionalParts<Policies> optional;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_POLICY_ENGINE_POLICIES_H
