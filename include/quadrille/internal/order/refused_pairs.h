#ifndef QUADRILLE_INTERNAL_ORDER_REFUSED_PAIRS_H
#define QUADRILLE_INTERNAL_ORDER_REFUSED_PAIRS_H

#include <quadrille/internal/base/compiler.h>
#include <quadrille/internal/base/prefetch.h>
#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/memory/array.h>
#include <quadrille/internal/order/pair_queue.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace quadrille::internal {

/// Pairs that were refused, each listed at both of its ends until the neighbourhood of one changes.
/// Those that came first leave first.
class RefusedPairs {
public:
  explicit RefusedPairs(std::size_t vertices, Workspace* workspace = nullptr)
      : last_entry_(vertices, none, workspace) {}

  /// `is_held`: is it one of those that held() counts?
  void add(const QueuedPair& pair, bool is_held = false) {
    const Index slot = new_slot();
    slots_[slot] = {pair, {none, none}, 2, is_held};
    link(pair.first, slot, 0);
    link(pair.second, slot, 1);
    ++size_;
    held_ += is_held;
  }

  bool has(Index vertex) const {
    return last_entry_[vertex] != none;
  } ///< any, perhaps one that has left

  /// Empties the list of a vertex and calls visit(pair) for each pair that was still refused; or
  /// stops after the first `most` of these. Returns whether the list is empty.
  template <class Visit>
  bool release(Index vertex, std::size_t most, Visit visit) {
    Index& last = last_entry_[vertex];
    while (last != none && most > 0) {
      const Index entry = next(last);
      if (entry == last)
        last = none;
      else
        next(last) = next(entry);
      Slot& slot = slots_[entry / 2];
      if (--slot.lists == 1) {
        --size_;
        --most;
        held_ -= slot.is_held;
        visit(slot.pair); // the other list forgets it later
      } else {
        free_.push_back(entry / 2);
      }
    }
    return last == none;
  }

  /// Empties the list of a vertex.
  QUADRILLE_ALWAYS_INLINE void forget(Index vertex) {
    if (has(vertex))
      forget_all(vertex);
  }

  std::size_t size() const { return size_; }
  std::size_t held() const { return held_; }

  QUADRILLE_ALWAYS_INLINE void prefetch(Index vertex) const {
    internal::prefetch(&last_entry_[vertex]);
  }

private:
  struct Slot {
    QueuedPair pair;
    std::array<Index, 2> next; // in the lists of the two ends; the first follows the last
    std::int16_t lists;        // how many lists it is in; refused while in both
    bool is_held;
  };

  Index new_slot() {
    if (free_.empty()) {
      slots_.emplace_back();
      return static_cast<Index>(slots_.size() - 1);
    }
    const Index slot = free_.back();
    free_.pop_back();
    return slot;
  }

  QUADRILLE_NOINLINE void forget_all(Index vertex) { // seldom
    release(vertex, ~std::size_t{0}, [](const QueuedPair&) {});
  }

  // An entry is a slot and the end whose list it is in: 2·slot + end.
  Index& next(Index entry) { return slots_[entry / 2].next[entry % 2]; }

  void link(Index vertex, Index slot, Index end) {
    const Index entry = 2 * slot + end;
    Index& last = last_entry_[vertex];
    if (last == none) {
      next(entry) = entry;
    } else {
      next(entry) = next(last);
      next(last) = entry;
    }
    last = entry;
  }

  std::vector<Slot> slots_;
  std::vector<Index> free_;
  Array<Index> last_entry_; // of the list of each vertex
  std::size_t size_ = 0, held_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ORDER_REFUSED_PAIRS_H
