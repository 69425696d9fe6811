#ifndef QUADRILLE_INTERNAL_CORE_POLICY_ENGINE_POLICIES_H
#define QUADRILLE_INTERNAL_CORE_POLICY_ENGINE_POLICIES_H

#include <quadrille/filters.h>
#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/optional.h>
#include <quadrille/internal/core/base/threads.h>
#include <quadrille/internal/core/policy/contraction_view.h>
#include <quadrille/internal/core/policy/guard_set.h>
#include <quadrille/internal/core/policy/mesh_units.h>
#include <quadrille/internal/core/policy/orders.h>
#include <quadrille/internal/core/policy/pair_source.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/policy/stop_rule.h>
#include <quadrille/internal/core/surface/numbering.h>
#include <quadrille/internal/core/surface/scale.h>
#include <quadrille/pairs.h>
#include <quadrille/recorded.h>
#include <quadrille/report.h>

#include <concepts>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The type-erased filters of a call: a NormalFlip, which is always present and compiled into the
/// engine, and others, in the order of the call.
template <std::size_t N>
class FilterList {
public:
  /// The default of a call: NormalFlip, unless one is among the filters. Each may be a
  /// std::optional.
  template <class... Filters>
  static FilterList of(const Filters&... filters) {
    FilterList list;
    (if_given(filters, [&](const auto& filter) { list.add(filter); }), ...);
    return list;
  }

  /// Returns the cause with which the first filter rejects the contraction, of which this is a
  /// view.
  template <class Contraction>
  std::optional<Rejection> rejection(const ContractionView<N>& view, const Contraction& contraction,
                                     const Numbering& numbering, const Scale<N>& scale) const {
    if (!normal_flip_.allows(view))
      return NormalFlip::cause;
    if (others_.empty())
      return std::nullopt;
    return rejection_by_others(view, contraction, numbering, scale);
  }

private:
  struct Other {
    std::shared_ptr<const void> filter;
    bool (*allows)(const void*, const IndexedContraction<N>&, const Scale<N>&);
    Rejection cause;
  };

  template <class Contraction>
  QUADRILLE_NOINLINE std::optional<Rejection>
  rejection_by_others(const ContractionView<N>& view, const Contraction& contraction,
                      const Numbering& numbering, const Scale<N>& scale) const {
    const IndexedContraction<N> indexed(view, contraction.star(), contraction.first(),
                                        contraction.second(), numbering);
    for (const Other& other : others_)
      if (!other.allows(other.filter.get(), indexed, scale))
        return other.cause;
    return std::nullopt;
  }

  template <class Filter>
  void add(const Filter& filter) {
    validate(filter);
    if constexpr (std::same_as<Filter, NormalFlip>)
      if (!std::exchange(is_normal_flip_given_, true)) {
        normal_flip_ = filter;
        return;
      }
    others_.push_back({std::make_shared<const Filter>(filter), &allows<Filter>, cause_of<Filter>});
  }

  template <class Filter>
  static bool allows(const void* filter, const IndexedContraction<N>& contraction,
                     [[maybe_unused]] const Scale<N>& scale) {
    const Filter& by_type = *static_cast<const Filter*>(filter);
    if constexpr (is_scale_free<Filter>)
      return by_type.allows(contraction);
    else
      return by_type.allows(ContractionInMeshUnits<N>(contraction, scale));
  }

  NormalFlip normal_flip_;
  bool is_normal_flip_given_ = false;
  std::vector<Other> others_;
};

/// A type-erased recorder, which the user keeps.
class RecorderHandle {
public:
  template <class R>
  explicit RecorderHandle(R& recorder) : recorder_(&recorder) {
    begin_ = [](void* r, RecordedSurface&& surface) {
      static_cast<R*>(r)->begin(std::move(surface));
    };
    record_ = [](void* r, const RecordedContraction& contraction) {
      static_cast<R*>(r)->record(contraction);
    };
    if constexpr (requires(const RecordedRejection& rejection) { recorder.reject(rejection); })
      reject_ = [](void* r, const RecordedRejection& rejection) {
        static_cast<R*>(r)->reject(rejection);
      };
    end_ = [](void* r, StopReason reason) {
      if constexpr (requires { static_cast<R*>(r)->stop(reason); })
        static_cast<R*>(r)->stop(reason);
      static_cast<R*>(r)->end();
    };
  }

  bool asks_for_rejections() const { return reject_ != nullptr; }

  void begin(RecordedSurface surface) const { begin_(recorder_, std::move(surface)); }
  void record(const RecordedContraction& contraction) const { record_(recorder_, contraction); }
  void reject(const RecordedRejection& rejection) const { reject_(recorder_, rejection); }
  void end(StopReason reason) const { end_(recorder_, reason); }

private:
  void* recorder_;
  void (*begin_)(void*, RecordedSurface&&) = nullptr;
  void (*record_)(void*, const RecordedContraction&) = nullptr;
  void (*reject_)(void*, const RecordedRejection&) = nullptr;
  void (*end_)(void*, StopReason) = nullptr;
};

template <std::size_t N>
struct SurfaceInput;
/// Functions that change an input before it is simplified, in this order: see KeepPlanes and
/// VoxelSize.
template <std::size_t N>
using Preparations = std::vector<std::function<void(SurfaceInput<N>&)>>;
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
template <class State>
struct GivenStates;
struct FaceBound;
class CostHistogram;

/// Contracts pairs in passes; false if the visitor cancels. RelaxedOrder brings it.
template <class Policies>
bool run_passes(WorkingSurface<Policies>& surface, const PassSettings& settings);

/// The functions that only some calls need: a call that cannot need one does not compile it.
template <class Policies>
struct OptionalModules {
  /// Contracts pairs in passes; false if the visitor cancels.
  bool (*run_passes)(WorkingSurface<Policies>&, const PassSettings&) = nullptr;
  /// Makes the object that writes to the recorder.
  std::unique_ptr<Recording<Policies>> (*make_recording)(const RecordingNeeds<Policies>&) = nullptr;
  /// Makes the object that measures distances for a stop policy that asks for them.
  std::unique_ptr<MeasuredDistances<Policies>> (*make_distances)(const DistanceNeeds<Policies>&) =
      nullptr;
  /// The initial states of vertices, used instead of those that their faces would give, if present.
  const GivenStates<typename Policies::Cost::State>* states = nullptr;
  /// The distance of each input face from the input of all chunks, at the beginning and then at the
  /// end; used if a stop policy asks for distances.
  std::vector<FaceBound>* bounds = nullptr;
  /// The greatest tolerance of the input of all chunks, in the mesh's units, if bounds have
  /// tolerances at the beginning.
  std::optional<double> greatest_tolerance = {};
  /// Counts what contractions cost.
  CostHistogram* costs = nullptr;
};

/// All arguments of `simplify`, each with its default if it was omitted. The engine is compiled for
/// a cost and a placement, with channels or without; all else is chosen at run time.
template <class Cost_, class Placement_, bool has_channels_>
struct Policies {
  using Cost = Cost_;
  using Placement = Placement_;
  /// Channels carry attributes in addition to the shape.
  static constexpr bool has_channels = has_channels_;

  Cost cost;
  Placement placement;
  double region_boundary_weight; // see Labels
  PairSource pairs;
  StopRule stop;
  CallOrder order;
  std::function<bool(const Status&)> visitor; // of no target where there is none
  Threads threads;                            // as many as the order asks for
  std::optional<RecorderHandle> recorder;     // receives contractions
  std::optional<Topology> topology;           // nothing: as the mesh and the pairs suggest
  Preparations<Cost_::dimension> preparations;
  FilterList<Cost::dimension> filters;
  GuardSet<Cost::dimension> guards;
  OptionalModules<Policies> optional;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_POLICY_ENGINE_POLICIES_H
