#ifndef QUADRILLE_INTERNAL_CORE_CONTRACTION_RECORDING_H
#define QUADRILLE_INTERNAL_CORE_CONTRACTION_RECORDING_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/contraction/measured_distances.h>
#include <quadrille/internal/core/state/component_event.h>
#include <quadrille/internal/core/state/contraction.h>
#include <quadrille/internal/core/state/scratch.h>
#include <quadrille/internal/core/state/surface_state.h>
#include <quadrille/report.h>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace quadrille::internal {

/// Reports contractions to a recorder. It is compiled only for calls that have one: see
/// RecordWriter.
template <class Policies>
class Recording {
public:
  using Contraction = internal::Contraction<typename Policies::Cost>;

  virtual ~Recording() = default;

  /// The surface as it is before the first contraction.
  virtual void begin() = 0;
  virtual void before(const Contraction& contraction) = 0;
  /// Reports a contraction, with the error that Report::error counts; contractions of a pass are
  /// reported at the end of its stage.
  virtual void after(const Contraction& contraction, Index kept, Index gone, double error,
                     bool is_in_pass) = 0;
  virtual void vanished(const ComponentEvent& event) = 0;
  /// Reports a rejected pair with these ends, or a component, which has none.
  virtual void reject(const std::array<Index, 2>& ends, Rejection cause, double error) = 0;
  virtual void reject_in_pass(const std::array<Index, 2>& ends, Rejection cause, double error,
                              Scratch& scratch) = 0;
  /// From here on, contractions and rejections of a thread belong to a block of a pass.
  virtual void begin_block(std::size_t number, Scratch& scratch) = 0;
  /// Reports the contractions of blocks in the order of their costs, as far as the order within
  /// each block allows it: ties by block.
  virtual void end_stage() = 0;
  virtual void end(StopReason reason) = 0;
};

/// The data that a recording reads.
template <class Policies>
struct RecordingNeeds {
  SurfaceState<Policies>& state;
  const OptionalDistances<Policies>& distances;
};

/// The recording of a surface as an observer of its contractions, if there is a recorder.
template <class Policies>
class OptionalRecording {
public:
  explicit OptionalRecording(const RecordingNeeds<Policies>& needs) {
    if (needs.state.policies.recorder)
      recording_ = needs.state.policies.optional.make_recording(needs);
  }

  /// nullptr if there is no recorder.
  Recording<Policies>* get() const { return recording_.get(); }

  template <class Event>
  QUADRILLE_ALWAYS_INLINE void before(const Event& event) {
    if (recording_) [[unlikely]]
      recording_->before(event.contraction);
  }
  template <class Event>
  QUADRILLE_ALWAYS_INLINE void after(const Event& event) {
    if (recording_) [[unlikely]]
      recording_->after(event.contraction, event.kept, event.gone, event.feature_loss.error,
                        Event::is_in_pass);
  }
  void vanished(const ComponentEvent& event) {
    if (recording_)
      recording_->vanished(event);
  }

private:
  std::unique_ptr<Recording<Policies>> recording_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_CONTRACTION_RECORDING_H
