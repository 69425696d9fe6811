#ifndef QUADRILLE_INTERNAL_PAIR_QUEUE_H
#define QUADRILLE_INTERNAL_PAIR_QUEUE_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

namespace quadrille::internal {

/// A pair of vertices in the queue, with the cost that it had at time `stamp`.
struct QueuedPair {
  float cost; // at least 0
  std::uint32_t first, second;
  std::uint32_t stamp;

  friend bool operator<(const QueuedPair& a, const QueuedPair& b) {
    return std::tie(a.cost, a.first, a.second) < std::tie(b.cost, b.first, b.second);
  }
};

/// A priority queue of pairs that are rarely popped and mostly outdated: least cost first, ties by
/// the indices of the pair.
///
/// Pairs lie in *buckets* by the top 13 bits of their cost (for floats of at least 0, the order of
/// the bits is the order of the values), each an append-only list of blocks. Only when a bucket
/// becomes the lowest is it opened: its outdated pairs, nine of ten, are dropped unsorted, and the
/// rest is sorted. A pair that comes in at or below the open bucket goes to a small heap beside it.
/// The order is exact.
///
/// All memory is taken when the queue is built: pairs that are up to date never outnumber those
/// that it began with, so when the blocks run out, dropping outdated pairs always frees enough.
class PairQueue {
public:
  /// Makes room for `expected` pairs that are up to date at one time.
  explicit PairQueue(std::size_t expected) {
    const std::size_t pairs = expected + expected / 2;
    blocks_.reserve(pairs / Block::capacity + 2 * bucket_count);
  }

  template <class IsOutdated>
  void push(const QueuedPair& pair, IsOutdated is_outdated) {
    const std::size_t bucket = bucket_of(pair.cost);
    if (bucket < open_end_) {
      heap_.push_back(pair);
      std::push_heap(heap_.begin(), heap_.end(), later);
      return;
    }
    if (blocks_.size() == blocks_.capacity() && free_ == end_of_list)
      drop_outdated(is_outdated);
    append(bucket, pair);
  }

  /// Takes out the first pair that is not outdated; nothing when none is left.
  template <class IsOutdated>
  std::optional<QueuedPair> pop(IsOutdated is_outdated) {
    do {
      while (sorted_at_ < sorted_.size() || !heap_.empty()) {
        const QueuedPair pair = take_first();
        if (!is_outdated(pair))
          return pair;
      }
    } while (open_next_bucket(is_outdated));
    return std::nullopt;
  }

  /// The pair that may come next, for a look ahead: nothing when that is not known.
  const QueuedPair* peek(std::size_t ahead) const {
    return sorted_at_ + ahead < sorted_.size() ? &sorted_[sorted_at_ + ahead] : nullptr;
  }

private:
  static constexpr std::size_t bucket_count = std::size_t{1} << 13;
  static constexpr std::uint32_t end_of_list = ~std::uint32_t{0};

  struct Block {
    static constexpr std::size_t capacity = 31;
    std::array<QueuedPair, capacity> pairs;
    std::uint32_t size = 0;
    std::uint32_t next = end_of_list;
  };

  static bool later(const QueuedPair& a, const QueuedPair& b) { return b < a; }

  // The sign bit of a cost is 0; below it come 8 bits of exponent and 5 of the fraction.
  static std::size_t bucket_of(float cost) {
    return std::bit_cast<std::uint32_t>(cost) >> (31 - 13);
  }

  void append(std::size_t bucket, const QueuedPair& pair) {
    std::uint32_t& first = first_block_[bucket];
    if (first == end_of_list || blocks_[first].size == Block::capacity) {
      const std::uint32_t added = new_block();
      blocks_[added].next = first;
      first = added;
    }
    Block& block = blocks_[first];
    block.pairs[block.size++] = pair;
    lowest_ = std::min(lowest_, bucket);
  }

  std::uint32_t new_block() {
    if (free_ == end_of_list) {
      blocks_.emplace_back();
      return static_cast<std::uint32_t>(blocks_.size() - 1);
    }
    const std::uint32_t block = free_;
    free_ = blocks_[block].next;
    blocks_[block].size = 0;
    return block;
  }

  void free_block(std::uint32_t block) {
    blocks_[block].next = free_;
    free_ = block;
  }

  QueuedPair take_first() {
    const bool from_heap =
        sorted_at_ == sorted_.size() || (!heap_.empty() && heap_.front() < sorted_[sorted_at_]);
    if (!from_heap)
      return sorted_[sorted_at_++];
    std::pop_heap(heap_.begin(), heap_.end(), later);
    const QueuedPair pair = heap_.back();
    heap_.pop_back();
    return pair;
  }

  template <class IsOutdated>
  bool open_next_bucket(IsOutdated is_outdated) {
    while (lowest_ < bucket_count && first_block_[lowest_] == end_of_list)
      ++lowest_;
    if (lowest_ == bucket_count)
      return false;
    sorted_.clear();
    sorted_at_ = 0;
    for (std::uint32_t b = first_block_[lowest_]; b != end_of_list;) {
      const Block& block = blocks_[b];
      for (std::uint32_t i = 0; i < block.size; ++i)
        if (!is_outdated(block.pairs[i]))
          sorted_.push_back(block.pairs[i]);
      const std::uint32_t next = block.next;
      free_block(b);
      b = next;
    }
    first_block_[lowest_++] = end_of_list;
    open_end_ = lowest_;
    std::sort(sorted_.begin(), sorted_.end());
    return true;
  }

  template <class IsOutdated>
  void drop_outdated(IsOutdated is_outdated) {
    for (std::size_t bucket = lowest_; bucket < bucket_count; ++bucket) {
      std::uint32_t b = first_block_[bucket];
      first_block_[bucket] = end_of_list;
      while (b != end_of_list) {
        const Block block = blocks_[b]; // a copy: the block may be refilled at once
        free_block(b);
        for (std::uint32_t i = 0; i < block.size; ++i)
          if (!is_outdated(block.pairs[i]))
            append(bucket, block.pairs[i]);
        b = block.next;
      }
    }
  }

  std::vector<Block> blocks_;
  std::uint32_t free_ = end_of_list;
  std::vector<std::uint32_t> first_block_ = std::vector<std::uint32_t>(bucket_count, end_of_list);
  std::size_t lowest_ = bucket_count; // no block lies in a bucket below this one
  std::size_t open_end_ = 0;          // one past the bucket that was opened last
  std::vector<QueuedPair> sorted_;    // its pairs; those before sorted_at_ are gone
  std::size_t sorted_at_ = 0;
  std::vector<QueuedPair> heap_; // pairs that came in at or below the open bucket
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_PAIR_QUEUE_H
