#ifndef QUADRILLE_INTERNAL_ORDER_STAMPED_QUEUE_H
#define QUADRILLE_INTERNAL_ORDER_STAMPED_QUEUE_H

#include <quadrille/internal/base/compiler.h>
#include <quadrille/internal/base/index.h>
#include <quadrille/internal/order/pair_queue.h>
#include <quadrille/internal/order/pair_stamps.h>

#include <cstddef>
#include <optional>

namespace quadrille::internal {

/// The queue of pairs, from which outdated ones never come.
class StampedQueue {
public:
  /// Makes room for `expected` pairs that are up to date at one time.
  StampedQueue(std::size_t vertices, std::size_t expected, Workspace* workspace)
      : stamps_(vertices, workspace), queue_(expected, workspace) {}

  PairStamps& stamps() { return stamps_; }
  const PairStamps& stamps() const { return stamps_; }

  QUADRILLE_ALWAYS_INLINE void push(Index v, Index w, float key) {
    queue_.push(stamps_.pair_now(v, w, key), stamps_.outdated());
  }
  /// Pushes a pair with the key that it had, unless it is outdated.
  void push_again(const QueuedPair& pair) {
    if (!stamps_.is_outdated(pair))
      queue_.push(pair, stamps_.outdated());
  }
  std::optional<QueuedPair> pop() { return queue_.pop(stamps_.outdated()); }
  const QueuedPair* peek(std::size_t ahead) const { return queue_.peek(ahead); }

private:
  PairStamps stamps_;
  PairQueue queue_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ORDER_STAMPED_QUEUE_H
