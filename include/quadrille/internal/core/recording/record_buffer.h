#ifndef QUADRILLE_INTERNAL_CORE_RECORDING_RECORD_BUFFER_H
#define QUADRILLE_INTERNAL_CORE_RECORDING_RECORD_BUFFER_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/recording/record_list.h>
#include <quadrille/recorded.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace quadrille::internal {

/// The buffers of a thread for reporting contractions to a recorder: memory for the current one,
/// and in a pass a list of those that it has done, block by block.
struct RecordBuffer {
  /// The result for a wedge: `joined` and `values` begin where those of the one before end.
  struct Wedge {
    std::size_t channel;
    Index wedge;
    std::size_t joined_end, values_end;
  };
  /// A corner at an end of the pair: a channel, the identity of its wedge, the face.
  struct Corner {
    std::size_t channel;
    Index identity, face;
  };
  /// The contractions of a block: from where those of the block before it end.
  struct Block {
    std::size_t number;
    std::size_t end;
  };

  std::vector<double> values;
  std::vector<Index> faces;
  std::vector<Corner> corners;
  std::vector<Wedge> wedges;
  std::vector<Index> joined;
  std::vector<double> wedge_values;
  std::vector<RecordedWedge> views;

  RecordList list;
  std::vector<float> costs; // of those in the list: the greatest until then, of the block
  std::vector<Block> blocks;

  /// Makes the views of the wedges, once all of these are there.
  void view_wedges() {
    views.clear();
    std::size_t joined_begin = 0, values_begin = 0;
    for (const Wedge& w : wedges) {
      views.push_back({w.channel, w.wedge,
                       std::span(joined).subspan(joined_begin, w.joined_end - joined_begin),
                       std::span(wedge_values).subspan(values_begin, w.values_end - values_begin)});
      joined_begin = w.joined_end;
      values_begin = w.values_end;
    }
  }

  /// Contractions belong to that block from here on.
  void begin_block(std::size_t number) { blocks.push_back({number, list.size()}); }

  void add(const RecordedContraction& contraction, double cost) {
    const bool is_first = list.size() == first_of_block();
    const auto rounded = static_cast<float>((std::max)(cost, 0.0));
    list.add(contraction);
    costs.push_back(is_first ? rounded : (std::max)(rounded, costs.back()));
    blocks.back().end = list.size();
  }

private:
  std::size_t first_of_block() const {
    return blocks.size() < 2 ? 0 : blocks[blocks.size() - 2].end;
  }
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_RECORDING_RECORD_BUFFER_H
