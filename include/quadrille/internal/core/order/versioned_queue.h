#ifndef QUADRILLE_INTERNAL_CORE_ORDER_VERSIONED_QUEUE_H
#define QUADRILLE_INTERNAL_CORE_ORDER_VERSIONED_QUEUE_H

#include <quadrille/internal/core/base/assert.h>
#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/order/pair_queue.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace quadrille::internal {

/// The time since which the costs of the pairs of each vertex are valid. A pair that was put into
/// the queue before that is outdated: so a change of a vertex takes its pairs out of the queue
/// without a search.
class PairVersions {
public:
  PairVersions(std::size_t vertices, Arena* arena) : versions_(vertices, 0, arena) {}

  std::size_t size() const { return versions_.size(); }
  std::uint32_t time() const { return time_; }
  /// From here on, what is put into the queue is later.
  void advance() { ++time_; }

  /// The pairs of a vertex that were put into the queue before now are outdated.
  void renew(Index v) { versions_[v] = time_; }
  bool is_new(Index v) const { return versions_[v] == time_; }
  /// All pairs of a vertex are outdated, for good.
  void retire(Index v) { versions_[v] = never; }
  bool is_retired(Index v) const { return versions_[v] == never; }

  bool is_outdated(const QueuedPair& pair) const {
    return pair.version < (std::max)(versions_[pair.first], versions_[pair.second]);
  }
  auto outdated() const {
    return [this](const QueuedPair& pair) { return is_outdated(pair); };
  }

  QueuedPair pair_now(Index v, Index w, float key) const {
    QUADRILLE_ASSERT(v != w && !is_retired(v) && !is_retired(w));
    const auto [first, second] = std::minmax(v, w);
    return {key, first, second, time_};
  }

private:
  static constexpr std::uint32_t never = ~std::uint32_t{0};

  Array<std::uint32_t> versions_;
  std::uint32_t time_ = 0;
};

/// The queue of pairs, from which outdated ones never come.
class VersionedQueue {
public:
  /// Makes room for `expected` pairs that are up to date at one time.
  VersionedQueue(std::size_t vertices, std::size_t expected, Arena* arena)
      : versions_(vertices, arena), queue_(expected, arena) {}

  PairVersions& versions() { return versions_; }
  const PairVersions& versions() const { return versions_; }

  QUADRILLE_ALWAYS_INLINE void push(Index v, Index w, float key) {
    queue_.push(versions_.pair_now(v, w, key), versions_.outdated());
  }
  /// Pushes a pair with the key that it had, unless it is outdated.
  void push_again(const QueuedPair& pair) {
    if (!versions_.is_outdated(pair))
      queue_.push(pair, versions_.outdated());
  }
  std::optional<QueuedPair> pop() { return queue_.pop(versions_.outdated()); }
  const QueuedPair* peek(std::size_t ahead) const { return queue_.peek(ahead); }

private:
  PairVersions versions_;
  PairQueue queue_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ORDER_VERSIONED_QUEUE_H
