#ifndef QUADRILLE_INTERNAL_CONTRACTION_WORKING_SURFACE_H
#define QUADRILLE_INTERNAL_CONTRACTION_WORKING_SURFACE_H

#include <quadrille/internal/appearance/appearance.h>
#include <quadrille/internal/base/assert.h>
#include <quadrille/internal/base/compiler.h>
#include <quadrille/internal/base/threads.h>
#include <quadrille/internal/complex/topology_count.h>
#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/contraction/checks.h>
#include <quadrille/internal/contraction/cleanup.h>
#include <quadrille/internal/contraction/contraction.h>
#include <quadrille/internal/contraction/contraction_count.h>
#include <quadrille/internal/contraction/counts.h>
#include <quadrille/internal/contraction/doubled_faces.h>
#include <quadrille/internal/contraction/finished_surface.h>
#include <quadrille/internal/contraction/guard_list.h>
#include <quadrille/internal/contraction/input_parts.h>
#include <quadrille/internal/contraction/measured_distances.h>
#include <quadrille/internal/contraction/moved_vertices.h>
#include <quadrille/internal/contraction/part_event.h>
#include <quadrille/internal/contraction/parts.h>
#include <quadrille/internal/contraction/progress.h>
#include <quadrille/internal/contraction/recession.h>
#include <quadrille/internal/contraction/recording.h>
#include <quadrille/internal/contraction/setup.h>
#include <quadrille/internal/contraction/shape_check.h>
#include <quadrille/internal/contraction/target_rules.h>
#include <quadrille/internal/cost/no_local_terms.h>
#include <quadrille/internal/cost/vertex_importance.h>
#include <quadrille/internal/cost/vertex_memories.h>
#include <quadrille/internal/evaluation/pair_evaluator.h>
#include <quadrille/internal/input/surface_input.h>
#include <quadrille/internal/pairs/pair_finder.h>
#include <quadrille/internal/pairs/pair_selection.h>
#include <quadrille/internal/policy/mesh_units.h>
#include <quadrille/internal/policy/orders.h>
#include <quadrille/internal/surface/geometry.h>
#include <quadrille/internal/surface/numbering.h>
#include <quadrille/internal/surface/scale.h>
#include <quadrille/internal/surface/shared_vertices.h>
#include <quadrille/report.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// A surface that is being simplified, and the parts that keep up with it, each with one job.
template <class Policies>
class WorkingSurface {
public:
  using Cost = typename Policies::Cost;
  static constexpr std::size_t dimension = Cost::dimension;
  using Contraction = internal::Contraction<Cost>;
  using Input = InputOf<dimension, Policies::has_channels>;

  WorkingSurface(Input input, const Box<dimension>& box, const Policies& policies)
      : policies_(policies), scale_(scale_of(input, box, policies)),
        complex_(input.positions.size(), take_triangles(policies.pairs, input),
                 !policies.order.passes, policies.threads),
        scratches_(scratches_for(policies.threads, complex_)),
        pairs_(complex_, link_condition_, evaluator_, policies.pairs.includes_edges(),
               select_pairs(policies.pairs, input, complex_, scratch().labels)),
        is_topology_kept_(keeps_topology(policies.topology, pairs_.has_others())),
        creases_(std::move(input.creases)),
        numbering_({input.positions.size(), std::move(input.input_vertices)},
                   {complex_.face_capacity(), std::move(input.input_faces)},
                   policies.order.passes.has_value()),
        geometry_(complex_, scale_.scaled(std::move(input.positions)), std::move(input.is_fixed),
                  policies.threads),
        shared_(std::move(input.is_shared), std::move(input.borders), numbering_),
        moved_(geometry_, complex_.workspace()), memories_(complex_.workspace()),
        terms_(policies.cost, geometry_, complex_, link_condition_, shared_),
        importance_(relative_importances(input.importances)),
        appearance_(policies, complex_, geometry_, memories_),
        recording_({policies, scale_, complex_, numbering_, geometry_, appearance_.channels(),
                    distances_}),
        evaluator_(policies, scale_, complex_, geometry_, memories_, terms_, appearance_.channels(),
                   importance_, numbering_),
        guards_(policies.guards, {complex_, geometry_, numbering_, scale_, is_topology_kept_}),
        checks_(policies, scale_, complex_, numbering_, geometry_, shared_, link_condition_,
                appearance_.seams(), appearance_.channels(), guards_, is_topology_kept_),
        displacement_(scale_.diagonal(), scale_.length_from_mesh(scale_.diagonal())),
        target_rules_(policies, scale_, complex_, link_condition_, labels(), is_topology_kept_),
        shape_check_(scale_, complex_, geometry_, parts_, labels()),
        costs_(policies.optional.costs, complex_),
        edges_(policies.stop.needs().edges, complex_, scratch()), progress_(policies) {
    if (!is_topology_kept_ || input.has_duplicate_faces)
      settle_doubled_faces(complex_, numbering_.faces, input, scratch().tally, policies.threads);
    if (policies.topology == Topology::parts_may_vanish) {
      measure_parts();
      parts_.measure_isolation(complex_, geometry_, scale_);
    }
    appearance_.read(input, numbering_, scale_, pairs_.are_edges());
    progress_.start({complex_.count_faces(), complex_.count_vertices()},
                    count_unselected(complex_, numbering_.faces, input.is_selected),
                    edges_.count(numbering_.faces, input.is_selected), scale_.diagonal());
    if (progress_.proceed())
      classify(box, input.tolerances);
    if (!progress_.proceed())
      return;
    remember();
    if (policies.optional.memories)
      memories_.take_given(*policies.optional.memories, numbering_.vertices);
    QUADRILLE_ASSERT(have_rows(followers(*this), complex_.vertex_capacity()));
    if (recording())
      recording()->begin();
    if (progress_.has_visitor())
      progress_.expect(ContractionCount(is_topology_kept_, complex_.backs())
                           .contractions(policies.stop, status()));
  }
  WorkingSurface(const WorkingSurface&) = delete; // its parts refer to each other
  WorkingSurface& operator=(const WorkingSurface&) = delete;

  /// The parts that follow contractions, in the order in which they are told: who compares old and
  /// new places comes before the geometry; who looks at the surface, last. From what each of them
  /// has it follows that it is told, packed, prefetched, and given memory: see ContractionEvent,
  /// tell_vanished() and columns.h.
  static auto followers(auto& self) {
    return std::tie(self.recording_, self.costs_, self.edges_, self.distances_,
                    self.appearance_.channels(), self.appearance_.seams(), self.pairs_,
                    self.numbering_, self.moved_, self.memories_, self.geometry_, self.shared_,
                    self.link_condition_, self.terms_, self.importance_, self.parts_, self.guards_);
  }

  const Policies& policies() const { return policies_; }
  TriangleComplex& complex() { return complex_; }
  const TriangleComplex& complex() const { return complex_; }
  bool is_topology_kept() const { return is_topology_kept_; }
  Recording<Policies>* recording() { return recording_.get(); } ///< nullptr if nobody is told
  /// One for each thread.
  std::vector<Scratch>& scratches() { return scratches_; }
  Scratch& scratch() { return scratches_.front(); }

  const Parts<dimension>& parts() const { return parts_; } ///< none before they are measured
  /// In linear time, the first time.
  void measure_parts() {
    if (parts_.size() == 0)
      parts_ = Parts<dimension>(complex_, geometry_, scale_, scale_.diagonal());
  }
  const Array<Index>& labels() const { return appearance_.seams().labels(); }
  bool are_seams_kept() const { return appearance_.seams().keeps_channels(); }
  PairFinder<Policies>& pairs() { return pairs_; }
  const PairEvaluator<Policies>& evaluator() const { return evaluator_; }
  GuardList<dimension>& guards() { return guards_; }
  const Checks<Policies>& checks() const { return checks_; }
  const OptionalDistances<Policies>& distances() const { return distances_; }
  TargetRules<Policies>& target_rules() { return target_rules_; }
  ShapeCheck<Cost>& shape_check() { return shape_check_; }
  Progress<Policies>& progress() { return progress_; }
  const Status& status() const { return progress_.status(); }

  /// Ask for what a contraction will read of an end, but for its faces, and of a neighbour.
  QUADRILLE_ALWAYS_INLINE void prefetch_end(Index v) const {
    complex_.prefetch(v);
    prefetch_parts(followers(*this), v);
  }
  QUADRILLE_ALWAYS_INLINE void prefetch_neighbour(Index v) const {
    evaluator_.prefetch(v);
    scratches_.front().labels.prefetch(v);
  }

  /// Contracts a pair, and returns the vertex that is left: an end that keeps its place, else the
  /// first. Observers are told before and after it. What has changed is tallied, to be counted.
  ///
  /// In a pass, contractions have no end in common, end_pass() is called after the last, and those
  /// whose stars have no vertex in common may be done at the same time. Where topology is free, no
  /// end of an earlier one may be cut off: see any_cut_off().
  template <class Mode>
  Index apply(const Contraction& contraction, const Mode& mode) {
    const auto [kept, gone] = kept_and_gone(contraction, geometry_);
    QUADRILLE_ASSERT(kept != gone && complex_.has_faces(kept) && complex_.has_faces(gone));
    using Event = ContractionEvent<Cost, Mode>;
    const Event event{contraction, mode, kept, gone, recession_of(contraction, geometry_, scale_)};
    const auto observers = observers_of<Event>(followers(*this));
    tell_all_before(observers, event);
    change_faces(event);
    tell_all_after(observers, event);
    contraction.scratch().tally.count_contraction(
        event.recession.error, displacement_of(contraction, event.recession.error));
    return kept;
  }

  /// How much a contraction would move.
  std::uint64_t displacement_of(const Contraction& contraction) const {
    return displacement_of(contraction, recession_of(contraction, geometry_, scale_).error);
  }
  /// The same of one of this error.
  std::uint64_t displacement_of(const Contraction& contraction, double error) const {
    return displacement_(error, contraction.pair().squared_reach, contraction.cost());
  }

  /// Of a vertex that is a hub or was one: see LocalTerms::sum_up().
  void sum_up_terms(Index v) { terms_.sum_up(v, scratch().labels); }

  /// Removes a part whole, of which these vertices are left. Observers are told before.
  void remove_part(Index part, std::span<const Index> vertices) {
    internal::remove_part(complex_, vertices, parts_[part], followers(*this), scratch().tally);
  }

  /// Vertices remember the surface as it is now instead of as it was, if `refresh` is true. If
  /// enough of them are gone, those that are left get new numbers, in the same order.
  void end_pass(bool refresh) {
    if (status().faces > 0 && pairs_.are_edges() &&
        4 * progress_.vertices() < 3 * complex_.vertex_capacity())
      pack();
    else
      complex_.build_lists(policies_.threads);
    if (refresh) {
      creases_.follow(numbering_);
      remember();
    } else {
      terms_.sum_up(scratch().labels);
    }
  }

  /// What has become of the surface, which is gone then; with memories, if that is asked for. Tells
  /// the report the rest, and the visitor that this is the end.
  FinishedSurface<Cost, ChannelsLeftOf<Policies>> finish(bool keeps_memories, Report& report) && {
    progress_.tell(report);
    if (policies_.stop.needs().distance)
      distances_->tell(report, progress_.has_all_points());
    if (policies_.optional.bounds)
      distances_->tell_bounds(*policies_.optional.bounds);
    count_topology(complex_, scratch().labels).tell(report);
    report.components_before =
        is_topology_kept_ ? report.components_after + report.vanished_parts : input_parts_.size();
    if (is_topology_kept_ && report.vanished_parts > 0)
      report.error = (std::max)(
          report.error,
          scale_.length_of_mesh(distance_of(parts_.gone(complex_, scale_), complex_, geometry_)));
    input_parts_.tell(complex_, geometry_, scale_, numbering_, report);
    if (!progress_.is_cancelled())
      progress_.tell_end();
    auto channels = appearance_.take_channels();
    return {scale_,
            link_condition_.is_closed(),
            std::move(complex_),
            geometry_.take_positions(),
            moved_.take(),
            keeps_memories ? memories_.take() : UninitializedArray<typename Cost::Memory>(),
            std::move(numbering_),
            std::move(channels)};
  }

private:
  void classify(const Box<dimension>& box, const std::vector<double>& tolerances) {
    if (is_topology_kept_)
      link_condition_ = LinkCondition(
          complex_,
          [this](std::size_t worker) -> VertexLabels& { return scratches_[worker].labels; },
          policies_.threads);
    else
      input_parts_ = InputParts(complex_, geometry_, scale_, numbering_.vertices);
    if (policies_.stop.needs().distance) {
      distances_.measure({policies_, scale_, complex_, numbering_, geometry_, link_condition_,
                          evaluator_, checks_, box, tolerances});
      progress_.announce_distance(0);
      if (policies_.stop.needs().distance_back)
        progress_.announce_distance_back(0);
      if (policies_.stop.needs().tolerance)
        progress_.announce_tolerance(0);
    }
  }

  void remember() {
    const auto is_interior = [this](Index v) { return link_condition_.is_interior(v); };
    VertexLabels& labels = scratch().labels;
    memories_.remember(with_engine_lengths(policies_.cost, scale_), geometry_.positions(), complex_,
                       labels, creases_.left(numbering_), shared_, is_interior, policies_.threads);
    memories_.remember_input(policies_.cost, numbering_);
    appearance_.remember();
    terms_.sum_up(labels);
  }

  // What is gone takes no more time or room in a cache. Local terms are summed up anew after it,
  // and the numbering takes the list of vertices.
  void pack() {
    Array<Index> vertices = complex_.left_vertices();
    const auto is_left = [this](Index face) { return !complex_.is_removed(face); };
    numbering_.faces.pack_if(is_left);
    pack_others(followers(*this), vertices, is_left);
    parallel_for(policies_.threads, 2, [&](std::size_t part, std::size_t) {
      if (part == 0)
        complex_.pack(vertices);
      else
        pack_columns(followers(*this), vertices);
    });
    complex_.fill_lists(policies_.threads);
    numbering_.vertices.pack(std::move(vertices));
  }

  template <class Event>
  QUADRILLE_ALWAYS_INLINE void change_faces(const Event& event) {
    Cleanup cleanup(complex_, event.contraction.scratch(), appearance_.seams().labels());
    if constexpr (Event::is_in_pass) {
      complex_.relabel(event.kept, event.gone);
      cleanup.remove_shared_faces();
    } else {
      complex_.reserve_for_merge(event.kept, event.gone);
      cleanup.remove_shared_faces();
      complex_.merge(event.kept, event.gone);
    }
    if (is_topology_kept_)
      return;
    cleanup.remove_duplicate_faces();
    cleanup.remove_isolated_vertices(event.contraction.second());
  }

  const Policies& policies_;
  Scale<dimension> scale_;
  TriangleComplex complex_;
  std::vector<Scratch> scratches_;
  PairFinder<Policies> pairs_;
  bool is_topology_kept_;
  LinkCondition link_condition_;
  NamedCreases creases_;
  Numbering numbering_;
  Geometry<dimension> geometry_;
  SharedVertices shared_;
  MovedVertices<dimension> moved_;
  Parts<dimension> parts_;
  VertexMemories<Cost> memories_;
  QUADRILLE_NO_UNIQUE_ADDRESS typename LocalTermsOf<Cost>::type terms_;
  VertexImportance importance_;
  Appearance<Policies> appearance_;
  OptionalRecording<Policies> recording_;
  PairEvaluator<Policies> evaluator_;
  GuardList<dimension> guards_;
  Checks<Policies> checks_;
  OptionalDistances<Policies> distances_;
  Displacement displacement_;
  TargetRules<Policies> target_rules_;
  ShapeCheck<Cost> shape_check_;
  CountedCosts costs_;
  CountedEdges edges_;
  Progress<Policies> progress_;
  InputParts input_parts_; // none where topology is kept
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CONTRACTION_WORKING_SURFACE_H
