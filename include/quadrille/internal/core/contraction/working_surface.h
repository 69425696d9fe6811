#ifndef QUADRILLE_INTERNAL_CORE_CONTRACTION_WORKING_SURFACE_H
#define QUADRILLE_INTERNAL_CORE_CONTRACTION_WORKING_SURFACE_H

#include <quadrille/internal/core/base/assert.h>
#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/threads.h>
#include <quadrille/internal/core/complex/topology_count.h>
#include <quadrille/internal/core/contraction/checks.h>
#include <quadrille/internal/core/contraction/contraction_count.h>
#include <quadrille/internal/core/contraction/finished_surface.h>
#include <quadrille/internal/core/contraction/guard_list.h>
#include <quadrille/internal/core/contraction/measured_distances.h>
#include <quadrille/internal/core/contraction/run.h>
#include <quadrille/internal/core/contraction/shape_check.h>
#include <quadrille/internal/core/evaluation/pair_evaluator.h>
#include <quadrille/internal/core/evaluation/pair_finder.h>
#include <quadrille/internal/core/memory/vertex_arrays.h>
#include <quadrille/internal/core/policy/orders.h>
#include <quadrille/internal/core/state/component_event.h>
#include <quadrille/internal/core/state/contraction.h>
#include <quadrille/internal/core/state/feature_loss.h>
#include <quadrille/internal/core/state/surface_state.h>
#include <quadrille/report.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// A surface that is being simplified: its state, who evaluates, checks and guards contractions,
/// and the run. An order of contractions works on this.
template <class Policies>
class WorkingSurface {
public:
  using Cost = typename Policies::Cost;
  static constexpr std::size_t dimension = Cost::dimension;
  using Contraction = internal::Contraction<Cost>;
  using State = SurfaceState<Policies>;

  WorkingSurface(typename State::Input input, const Box<dimension>& box, const Policies& policies)
      : state_(input, box, policies), evaluator_(state_), pairs_(state_, evaluator_),
        guards_(policies.guards, {state_.complex, state_.geometry, state_.numbering, state_.scale,
                                  state_.is_topology_kept}),
        checks_(state_, guards_), shape_check_(state_), run_(state_, distances_) {
    run_.start(state_, input.is_selected);
    if (progress().proceed())
      classify(box, input.tolerances);
    if (!progress().proceed())
      return;
    accumulate();
    if (policies.optional.states)
      state_.states.take_given(*policies.optional.states, state_.numbering.vertices);
    QUADRILLE_ASSERT(have_rows(array_owners(*this), complex().vertex_capacity()));
    if (run_.recording())
      run_.recording()->begin();
    if (progress().has_visitor())
      progress().expect(ContractionCount(state_.is_topology_kept, complex().reverse_faces())
                            .contractions(policies.stop, status()));
  }
  WorkingSurface(const WorkingSurface&) = delete; // its members refer to each other
  WorkingSurface& operator=(const WorkingSurface&) = delete;

  /// Returns the observers of contractions, before and after, and of components that vanish: see
  /// ContractionEvent and ComponentEvent. Their order has no meaning: before a contraction they
  /// read the old surface, after it the new one, and each of them writes to itself only.
  static auto observers(auto& self) {
    return std::tie(self.evaluator_, self.distances_, self.guards_, self.run_);
  }
  /// All that is packed, prefetched and counted with vertices and faces: see vertex_arrays.h.
  static auto array_owners(auto& self) {
    return std::tuple_cat(State::array_owners(self.state_), observers(self));
  }

  const Policies& policies() const { return state_.policies; }
  State& state() { return state_; }
  const State& state() const { return state_; }
  TriangleComplex& complex() { return state_.complex; }
  const TriangleComplex& complex() const { return state_.complex; }
  Scratch& scratch() { return state_.scratch(); }

  const PairEvaluator<Policies>& evaluator() const { return evaluator_; }
  PairFinder<Policies>& pairs() { return pairs_; }
  GuardList<dimension>& guards() { return guards_; }
  const Checks<Policies>& checks() const { return checks_; }
  const OptionalDistances<Policies>& distances() const { return distances_; }
  ShapeCheck<Policies>& shape_check() { return shape_check_; }

  Run<Policies>& run() { return run_; }
  Progress<Policies>& progress() { return run_.progress(); }
  const Status& status() const { return run_.progress().status(); }

  /// Ask for what a contraction will read of an end, but for its faces, and of a neighbour.
  QUADRILLE_ALWAYS_INLINE void prefetch_end(Index v) const {
    complex().prefetch(v);
    prefetch_owners(array_owners(*this), v);
  }
  QUADRILLE_ALWAYS_INLINE void prefetch_neighbour(Index v) const {
    evaluator_.prefetch_pair(v);
    state_.scratches.front().labels.prefetch(v);
  }

  /// Contracts a pair, and returns the vertex that is left: an end that keeps its place, else the
  /// first.
  ///
  /// In a pass, contractions have no end in common, end_pass() is called after the last, and those
  /// whose stars have no vertex in common may be done at the same time. With free topology, no end
  /// of an earlier one may be cut off: see any_cut_off().
  template <class Mode>
  Index apply(const Contraction& contraction, const Mode& mode) {
    const auto [kept, gone] = kept_and_gone(contraction, state_.geometry);
    QUADRILLE_ASSERT(kept != gone && complex().has_faces(kept) && complex().has_faces(gone));
    const ContractionEvent<Cost, Mode> event{
        contraction, mode, kept, gone, feature_loss_of(contraction, state_.geometry, state_.scale)};
    notify_all_before(observers(*this), event);
    state_.contract(event);
    notify_all_after(observers(*this), event);
    return kept;
  }

  /// How much a contraction would move.
  std::uint64_t displacement_of(const Contraction& contraction) const {
    return run_.displacement_of(contraction,
                                feature_loss_of(contraction, state_.geometry, state_.scale).error);
  }

  /// Sums up the terms of a vertex that is or was a high-valence vertex: see LocalTerms::sum_up().
  void sum_up_terms(Index v) { evaluator_.sum_up(v, scratch().labels); }

  /// Removes a whole component, of which these vertices are left. Observers are notified before.
  void remove_component(Index component, std::span<const Index> vertices) {
    internal::remove_component(complex(), vertices, state_.components[component], observers(*this),
                               scratch().counters);
  }

  /// Accumulates the current surface in the states of vertices instead of the earlier one, if
  /// `refresh` is true. If enough vertices are gone, the remaining ones get new numbers, in the
  /// same order.
  void end_pass(bool refresh) {
    if (status().faces > 0 && pairs_.are_edges() &&
        4 * progress().vertices() < 3 * complex().vertex_capacity())
      pack();
    else
      complex().build_lists(policies().threads);
    if (refresh) {
      state_.creases.follow(state_.numbering);
      accumulate();
    } else {
      evaluator_.sum_up(scratch().labels);
    }
  }

  /// Returns the final surface and gives up its data; with states, if requested. Completes the
  /// report, and notifies the visitor of the end.
  FinishedSurface<Cost, ChannelsLeftOf<Policies>> finish(bool keeps_states, Report& report) && {
    progress().write_to(report);
    if (policies().stop.needs().distance)
      distances_->write_to(report, progress().has_all_points());
    if (policies().optional.bounds)
      distances_->write_bounds(*policies().optional.bounds);
    state_.write_to(report);
    if (!progress().is_cancelled())
      progress().report_end();
    auto channels = state_.appearance.take_channels();
    return {state_.scale,
            state_.link_condition.is_closed(),
            std::move(state_.complex),
            state_.geometry.take_positions(),
            state_.moved.take(),
            keeps_states ? state_.states.take() : UninitializedArray<typename Cost::State>(),
            std::move(state_.numbering),
            std::move(channels)};
  }

private:
  void classify(const Box<dimension>& box, const std::vector<double>& tolerances) {
    state_.classify();
    if (!policies().stop.needs().distance)
      return;
    distances_.measure({state_, evaluator_, checks_, box, tolerances});
    progress().announce_distance(0);
    if (policies().stop.needs().reverse_distance)
      progress().announce_reverse_distance(0);
    if (policies().stop.needs().tolerance)
      progress().announce_tolerance(0);
  }

  void accumulate() {
    state_.accumulate();
    evaluator_.sum_up(scratch().labels);
  }

  // Removed vertices and faces take no more time or room in a cache. Local terms are summed up
  // again after it, and the numbering takes the list of vertices.
  void pack() {
    Array<Index> vertices = complex().left_vertices();
    const auto is_left = [this](Index face) { return !complex().is_removed(face); };
    state_.numbering.faces.pack_if(is_left);
    pack_others(array_owners(*this), vertices, is_left);
    parallel_for(policies().threads, 2, [&](std::size_t task, std::size_t) {
      if (task == 0)
        complex().pack(vertices);
      else
        pack_vertex_arrays(array_owners(*this), vertices);
    });
    complex().fill_lists(policies().threads);
    state_.numbering.vertices.pack(std::move(vertices));
  }

  State state_;
  PairEvaluator<Policies> evaluator_;
  PairFinder<Policies> pairs_;
  GuardList<dimension> guards_;
  Checks<Policies> checks_;
  OptionalDistances<Policies> distances_;
  ShapeCheck<Policies> shape_check_;
  Run<Policies> run_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_CONTRACTION_WORKING_SURFACE_H
