#ifndef QUADRILLE_INTERNAL_CORE_ORDER_DEFERRED_PAIRS_H
#define QUADRILLE_INTERNAL_CORE_ORDER_DEFERRED_PAIRS_H

#include <quadrille/internal/core/order/pair_queue.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace quadrille::internal {

/// Pairs that would go beyond the target of the stop policy, put aside while others may meet it
/// exactly. They come back in the order in which they were put aside, which is that of their costs.
class DeferredPairs {
public:
  /// How many times what comes first in the order meeting a target exactly is worth: a little
  /// error, and no more.
  static constexpr double costliest_exact = 4;

  bool empty() const { return next_ == pairs_.size(); }

  /// Puts a pair with this key aside.
  void defer(const QueuedPair& pair, double key) {
    if (empty())
      highest_cost_ = costliest_exact * key;
    pairs_.push_back(pair);
  }
  /// Is that more than meeting the target exactly is worth, by what the first of the pairs here
  /// costs?
  bool is_too_costly(double cost) const { return !empty() && cost > highest_cost_; }

  /// Takes out the first pair that satisfies is_left(pair).
  template <class IsLeft>
  std::optional<QueuedPair> take(IsLeft is_left) {
    while (!empty())
      if (const QueuedPair& pair = pairs_[next_++]; is_left(pair))
        return pair;
    return std::nullopt;
  }

private:
  std::vector<QueuedPair> pairs_;
  std::size_t next_ = 0;
  double highest_cost_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ORDER_DEFERRED_PAIRS_H
