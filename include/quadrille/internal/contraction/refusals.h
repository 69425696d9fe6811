#ifndef QUADRILLE_INTERNAL_CONTRACTION_REFUSALS_H
#define QUADRILLE_INTERNAL_CONTRACTION_REFUSALS_H

#include <quadrille/internal/base/index.h>
#include <quadrille/report.h>

#include <array>
#include <cstddef>

namespace quadrille::internal {

/// Counts a pair that is refused, or a part, which has no ends, and tells a recorder that wants to
/// know.
template <class Surface>
void refuse(Surface& surface, const std::array<Index, 2>& ends, Rejection cause) {
  surface.scratch().tally.reject(cause);
  if (auto* const recording = surface.recording()) [[unlikely]]
    recording->refuse(ends, cause, surface.status().next_error);
}

/// Refuses a pair in a pass, by any thread; recorders are told when the stage has ended.
template <class Surface, class Scratch>
void refuse_in_pass(Surface& surface, const std::array<Index, 2>& ends, Rejection cause,
                    double error, Scratch& scratch) {
  scratch.tally.reject(cause);
  if (auto* const recording = surface.recording()) [[unlikely]]
    recording->refuse_in_pass(ends, cause, error, scratch);
}

/// What a thread does and refuses belongs to a block of a pass from here on.
template <class Surface, class Scratch>
void begin_block(Surface& surface, std::size_t number, Scratch& scratch) {
  if (auto* const recording = surface.recording())
    recording->begin_block(number, scratch);
}
/// Tells the recorder of what the blocks have done.
template <class Surface>
void end_stage(Surface& surface) {
  if (auto* const recording = surface.recording())
    recording->end_stage();
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CONTRACTION_REFUSALS_H
