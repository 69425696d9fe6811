#ifndef QUADRILLE_INTERNAL_CONTRACTION_REFUSALS_H
#define QUADRILLE_INTERNAL_CONTRACTION_REFUSALS_H

#include <quadrille/internal/base/index.h>
#include <quadrille/record.h>
#include <quadrille/report.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// What a thread has refused in a stage of a pass, block by block.
class Refusals {
public:
  /// Refusals belong to that block from here on.
  void begin_block(std::size_t number) { blocks_.push_back({number, refusals_.size()}); }
  void add(const RecordedRefusal& refusal) {
    refusals_.push_back(refusal);
    blocks_.back().end = refusals_.size();
  }
  void clear() {
    refusals_.clear();
    blocks_.clear();
  }

  using OfBlock = std::pair<std::size_t, std::span<const RecordedRefusal>>;
  void append_to(std::vector<OfBlock>& by_block) const {
    std::size_t begin = 0;
    for (const Block& block : blocks_) {
      by_block.emplace_back(block.number, std::span(refusals_).subspan(begin, block.end - begin));
      begin = block.end;
    }
  }

private:
  struct Block {
    std::size_t number;
    std::size_t end; // from where those of the block before it end
  };

  std::vector<RecordedRefusal> refusals_;
  std::vector<Block> blocks_;
};

/// Tells of all that threads have refused in a stage, by block, and forgets it. Each block belongs
/// to one thread.
template <class Recorder, class Scratch>
void tell_refusals(const Recorder& recorder, std::vector<Scratch>& scratches) {
  std::vector<Refusals::OfBlock> blocks;
  for (const Scratch& scratch : scratches)
    scratch.record.refusals.append_to(blocks);
  std::sort(blocks.begin(), blocks.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [number, refusals] : blocks)
    for (const RecordedRefusal& refusal : refusals)
      recorder.refuse(refusal);
  for (Scratch& scratch : scratches)
    scratch.record.refusals.clear();
}

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
