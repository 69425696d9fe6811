#ifndef QUADRILLE_INTERNAL_CORE_RECORDING_RECORD_SCRATCH_H
#define QUADRILLE_INTERNAL_CORE_RECORDING_RECORD_SCRATCH_H

#include <quadrille/internal/core/recording/record_buffer.h>
#include <quadrille/recorded.h>

#include <algorithm>
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

/// What a thread has done in a pass and a recorder is not told of yet.
struct RecordScratch {
  RecordBuffer contractions;
  Refusals refusals; // where a recorder wants to know
};

/// Tells of all that threads have refused in a stage, by block, and forgets it. Each block belongs
/// to one thread.
template <class Recorder>
void tell_refusals(const Recorder& recorder, std::vector<RecordScratch>& scratches) {
  std::vector<Refusals::OfBlock> blocks;
  for (const RecordScratch& scratch : scratches)
    scratch.refusals.append_to(blocks);
  std::sort(blocks.begin(), blocks.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [number, refusals] : blocks)
    for (const RecordedRefusal& refusal : refusals)
      recorder.refuse(refusal);
  for (RecordScratch& scratch : scratches)
    scratch.refusals.clear();
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_RECORDING_RECORD_SCRATCH_H
