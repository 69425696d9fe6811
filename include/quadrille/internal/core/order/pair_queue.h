#ifndef QUADRILLE_INTERNAL_CORE_ORDER_PAIR_QUEUE_H
#define QUADRILLE_INTERNAL_CORE_ORDER_PAIR_QUEUE_H

#include <quadrille/internal/core/base/assert.h>
#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/prefetch.h>
#include <quadrille/internal/core/memory/array.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>

namespace quadrille::internal {

/// A pair of vertices in the queue, with the cost that it had at the time `version`.
struct QueuedPair {
  float cost; // at least 0
  std::uint32_t first, second;
  std::uint32_t version;

  friend bool operator<(const QueuedPair& a, const QueuedPair& b) {
    return std::tie(a.cost, a.first, a.second) < std::tie(b.cost, b.first, b.second);
  }
};

/// A priority queue of pairs that are rarely popped and mostly outdated: least cost first, ties by
/// the indices of the pair.
///
/// Pairs are in *buckets* by the top 13 bits of their cost (for floats of at least 0, the order of
/// the bits is the order of the values), each an append-only list of blocks. Only when a bucket
/// becomes the lowest is it opened: its outdated pairs, nine of ten, are dropped unsorted, and the
/// rest is sorted. A pair that is added at or below the open bucket goes to a small additional
/// heap. The order is exact.
///
/// All memory is reserved when the queue is built: pairs that are up to date never outnumber those
/// that it began with, and when half as many outdated ones have been added, these are dropped.
class PairQueue {
public:
  /// Makes room for `expected` pairs that are up to date at one time.
  explicit PairQueue(std::size_t expected, Arena* arena = nullptr) : blocks_(arena) {
    blocks_.reserve(most_blocks(expected) + bucket_count);
    take_pages(blocks_.data(), (expected + expected / 8) / Block::capacity * sizeof(Block));
    size_to_drop_at_ = most_blocks(expected) + bucket_count / 8;
  }

  /// For how many the queue makes room, of a surface with that many pairs and vertices.
  static std::size_t expected_pairs(std::size_t pairs, std::size_t vertices) {
    return pairs + vertices / 8;
  }
  /// How much will be written to, as a rule.
  static std::size_t bytes_for(std::size_t expected) {
    return most_blocks(expected) * sizeof(Block);
  }

  template <class IsOutdated>
  QUADRILLE_ALWAYS_INLINE void push(QueuedPair pair, IsOutdated is_outdated) {
    QUADRILLE_ASSERT(pair.cost >= 0); // nor is it a NaN
    const std::size_t bucket = bucket_of(pair.cost);
    if (bucket < open_end_) {
      push_to_heap(pair);
      return;
    }
    if (blocks_.size() == size_to_drop_at_ && free_ == end_of_list)
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
  static constexpr std::size_t blocks_a_step = 64; // of which the pages are taken at once
  static constexpr std::uint32_t end_of_list = ~std::uint32_t{0};

  struct Block {
    static constexpr std::size_t capacity = 31;
    std::array<QueuedPair, capacity> pairs;
    std::uint32_t next;

    Block() {} // a new block is not written to before it is used
  };

  // The first block of a bucket is the one that is being filled. Its size is stored here, so that
  // an append touches one place in the block.
  struct Bucket {
    std::uint32_t first = end_of_list;
    std::uint32_t size = Block::capacity; // of the first block: as good as full where there is none
  };

  // With those that are outdated; full ones.
  static constexpr std::size_t most_blocks(std::size_t expected) {
    return (expected + expected / 2) / Block::capacity;
  }

  static bool later(const QueuedPair& a, const QueuedPair& b) { return b < a; }

  // The sign bit of a cost is 0; below it come 8 bits of exponent and 5 of the fraction.
  static std::size_t bucket_of(float cost) {
    return std::bit_cast<std::uint32_t>(cost) >> (31 - 13);
  }

  QUADRILLE_NOINLINE void push_to_heap(const QueuedPair& pair) {
    heap_.push_back(pair);
    std::push_heap(heap_.begin(), heap_.end(), later);
  }

  // Copies member by member: a copy of the whole would wait until the members, just computed, have
  // been written.
  QUADRILLE_ALWAYS_INLINE void append(std::size_t index, QueuedPair pair) {
    Bucket& bucket = buckets_[index];
    if (bucket.size == Block::capacity)
      begin_block(index);
    QueuedPair& place = blocks_[bucket.first].pairs[bucket.size++];
    place.cost = pair.cost;
    place.first = pair.first;
    place.second = pair.second;
    place.version = pair.version;
  }

  QUADRILLE_NOINLINE void begin_block(std::size_t index) {
    Bucket& bucket = buckets_[index];
    const std::uint32_t added = new_block();
    blocks_[added].next = bucket.first;
    bucket = {added, 0};
    lowest_ = (std::min)(lowest_, index);
  }

  std::uint32_t new_block() {
    if (free_ == end_of_list) {
      if (blocks_.size() % blocks_a_step == 0 &&
          blocks_.size() + blocks_a_step <= blocks_.capacity())
        take_pages(blocks_.data() + blocks_.size(), blocks_a_step * sizeof(Block));
      blocks_.emplace_back();
      return static_cast<std::uint32_t>(blocks_.size() - 1);
    }
    return std::exchange(free_, blocks_[free_].next);
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

  // Empties a bucket and calls visit(pair) for each pair that is not outdated. The blocks are free
  // as soon as they have been read.
  template <class IsOutdated, class Visit>
  void empty(Bucket& bucket, IsOutdated is_outdated, Visit visit) {
    auto [b, size] = std::exchange(bucket, {});
    while (b != end_of_list) {
      if (blocks_[b].next != end_of_list)
        prefetch(&blocks_[blocks_[b].next]);
      const Block block = blocks_[b];
      free_block(b);
      std::array<std::uint8_t, Block::capacity> left; // of the pairs
      std::uint32_t count = 0;
      for (std::uint32_t i = 0; i < size; ++i) { // without a branch: it would wait for memory
        left[count] = static_cast<std::uint8_t>(i);
        count += !is_outdated(block.pairs[i]);
      }
      for (std::uint32_t i = 0; i < count; ++i)
        visit(block.pairs[left[i]]);
      b = block.next;
      size = Block::capacity;
    }
  }

  template <class IsOutdated>
  bool open_next_bucket(IsOutdated is_outdated) {
    while (lowest_ < bucket_count && buckets_[lowest_].first == end_of_list)
      ++lowest_;
    if (lowest_ == bucket_count)
      return false;
    sorted_.clear();
    sorted_at_ = 0;
    empty(buckets_[lowest_], is_outdated, [&](const QueuedPair& pair) { sorted_.push_back(pair); });
    open_end_ = ++lowest_;
    std::sort(sorted_.begin(), sorted_.end());
    return true;
  }

  template <class IsOutdated>
  void drop_outdated(IsOutdated is_outdated) {
    for (std::size_t i = lowest_; i < bucket_count; ++i)
      empty(buckets_[i], is_outdated, [&](const QueuedPair& pair) { append(i, pair); });
    if (free_ == end_of_list) // many buckets with few pairs each
      size_to_drop_at_ += size_to_drop_at_ / 4 + 1;
  }

  SparseArray<Block> blocks_;
  std::size_t size_to_drop_at_;
  std::uint32_t free_ = end_of_list;
  Array<Bucket> buckets_ = Array<Bucket>(bucket_count);
  std::size_t lowest_ = bucket_count; // no block lies in a bucket below this one
  std::size_t open_end_ = 0;          // one past the bucket that was opened last
  std::vector<QueuedPair> sorted_;    // its pairs; those before sorted_at_ are gone
  std::size_t sorted_at_ = 0;
  std::vector<QueuedPair> heap_; // pairs that came in at or below the open bucket
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ORDER_PAIR_QUEUE_H
