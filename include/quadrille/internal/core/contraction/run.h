#ifndef QUADRILLE_INTERNAL_CORE_CONTRACTION_RUN_H
#define QUADRILLE_INTERNAL_CORE_CONTRACTION_RUN_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/contraction/counts.h>
#include <quadrille/internal/core/contraction/measured_distances.h>
#include <quadrille/internal/core/contraction/progress.h>
#include <quadrille/internal/core/contraction/recording.h>
#include <quadrille/internal/core/contraction/target_rules.h>
#include <quadrille/internal/core/state/part_event.h>
#include <quadrille/internal/core/state/recession.h>
#include <quadrille/internal/core/state/scratch.h>
#include <quadrille/internal/core/state/surface_state.h>
#include <quadrille/report.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace quadrille::internal {

/// A run over a surface: how far it has come, when it stops, and who is told of what it does and of
/// what it refuses. It observes contractions.
template <class Policies>
class Run {
public:
  using Contraction = internal::Contraction<typename Policies::Cost>;

  Run(SurfaceState<Policies>& state, const OptionalDistances<Policies>& distances)
      : scratch_(state.scratch()), recording_({state, distances}),
        costs_(state.policies.optional.costs, state.complex),
        edges_(state.policies.stop.needs().edges, state.complex, scratch_),
        displacement_(state.scale.diagonal(), state.scale.length_from_mesh(state.scale.diagonal())),
        target_rules_(state), progress_(state.policies) {}

  /// Counts the surface, of which the faces that are selected may be changed.
  void start(const SurfaceState<Policies>& state, const std::vector<bool>& is_selected) {
    const TriangleComplex& complex = state.complex;
    const InputIndices& input_faces = state.numbering.faces;
    progress_.start({complex.count_faces(), complex.count_vertices()},
                    count_unselected(complex, input_faces, is_selected),
                    edges_.count(input_faces, is_selected), state.scale.diagonal());
  }

  Progress<Policies>& progress() { return progress_; }
  const Progress<Policies>& progress() const { return progress_; }
  TargetRules<Policies>& target_rules() { return target_rules_; }
  Recording<Policies>* recording() { return recording_.get(); } ///< nullptr if nobody is told

  /// Counts a pair that is refused, or a part, which has no ends, and tells a recorder that wants
  /// to know.
  void refuse(const std::array<Index, 2>& ends, Rejection cause) {
    scratch_.tally.reject(cause);
    if (recording()) [[unlikely]]
      recording()->refuse(ends, cause, progress_.status().next_error);
  }
  /// Refuses a pair in a pass, by any thread; recorders are told when the stage has ended.
  void refuse_in_pass(const std::array<Index, 2>& ends, Rejection cause, double error,
                      Scratch& scratch) {
    scratch.tally.reject(cause);
    if (recording()) [[unlikely]]
      recording()->refuse_in_pass(ends, cause, error, scratch);
  }
  /// What a thread does and refuses belongs to a block of a pass from here on.
  void begin_block(std::size_t number, Scratch& scratch) {
    if (recording())
      recording()->begin_block(number, scratch);
  }
  /// Tells the recorder of what the blocks have done.
  void end_stage() {
    if (recording())
      recording()->end_stage();
  }

  /// How much a contraction of this error would move.
  std::uint64_t displacement_of(const Contraction& contraction, double error) const {
    return displacement_(error, contraction.pair().squared_reach, contraction.cost());
  }

  template <class Event>
  QUADRILLE_ALWAYS_INLINE void before(const Event& event) {
    recording_.before(event);
    costs_.before(event);
    edges_.before(event);
  }
  /// What has changed is tallied, to be counted by Progress.
  template <class Event>
  QUADRILLE_ALWAYS_INLINE void after(const Event& event) {
    recording_.after(event);
    const double error = event.recession.error;
    event.contraction.scratch().tally.count_contraction(error,
                                                        displacement_of(event.contraction, error));
  }
  void vanished(const PartEvent& event) {
    recording_.vanished(event);
    edges_.vanished(event);
  }

private:
  Scratch& scratch_; // of the thread that does what is not done in parallel
  OptionalRecording<Policies> recording_;
  CountedCosts costs_;
  CountedEdges edges_;
  Displacement displacement_;
  TargetRules<Policies> target_rules_;
  Progress<Policies> progress_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_CONTRACTION_RUN_H
