#ifndef QUADRILLE_INTERNAL_CORE_RECORDING_RECORD_ORDER_H
#define QUADRILLE_INTERNAL_CORE_RECORDING_RECORD_ORDER_H

#include <quadrille/internal/core/base/digit_sort.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/recording/record_scratch.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace quadrille::internal {

/// Where a contraction of a stage is recorded, and what it costs.
struct RecordPlace {
  std::size_t block;
  float cost;
  std::uint32_t thread;
  Index number;
};

/// The contractions that threads have recorded in a stage, by cost and then by block. By block
/// first, so that ties of costs, which no float of at least 0 orders otherwise than its bits do,
/// are too.
inline std::vector<RecordPlace>
places_in_order_of_cost(const std::vector<RecordScratch>& scratches) {
  std::vector<RecordPlace> places;
  for (std::uint32_t thread = 0; thread < scratches.size(); ++thread) {
    const RecordBuffer& buffer = scratches[thread].contractions;
    std::size_t i = 0;
    for (const RecordBuffer::Block& block : buffer.blocks)
      for (; i < block.end; ++i)
        places.push_back({block.number, buffer.costs[i], thread, static_cast<Index>(i)});
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const RecordPlace& a, const RecordPlace& b) { return a.block < b.block; });
  std::vector<RecordPlace> next(places.size());
  for (int shift = 0; shift < 32; shift += 8) {
    sort_by_digit<8>(places.data(), places.size(), next.data(), [shift](const RecordPlace& place) {
      return std::bit_cast<std::uint32_t>(place.cost) >> shift & 255;
    });
    places.swap(next);
  }
  return places;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_RECORDING_RECORD_ORDER_H
