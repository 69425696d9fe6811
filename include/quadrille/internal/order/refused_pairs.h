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

/// Pairs that were refused, each listed at both of its ends until the neighbourhood of one changes;
/// and at the face that was in its way, if one was, until that changes. Those that came first leave
/// first.
class RefusedPairs {
public:
  explicit RefusedPairs(std::size_t vertices, Workspace* workspace = nullptr)
      : last_entry_(vertices, none, workspace) {}

  /// `is_held`: is it one of those that held() counts? `face`: what was in its way.
  void add(const QueuedPair& pair, bool is_held = false, Index face = none) {
    const Index slot = new_slot();
    slots_[slot] = {pair, {none, none, none}, 2, is_held, true};
    link(last_entry_[pair.first], lists * slot);
    link(last_entry_[pair.second], lists * slot + 1);
    ++size_;
    held_ += is_held;
    if (face != none) [[unlikely]]
      add_behind(face, slot);
  }

  bool has(Index vertex) const {
    return last_entry_[vertex] != none;
  } ///< any, perhaps one that has left

  /// Empties the list of a vertex and calls visit(pair) for each pair that was still refused; or
  /// stops after the first `most` of these. Returns whether the list is empty.
  template <class Visit>
  bool release(Index vertex, std::size_t most, Visit visit) {
    return release_list(last_entry_[vertex], most, visit);
  }

  /// Have any been refused for a face that was in their way?
  bool has_behind() const { return !last_behind_.empty(); }
  /// The same for those.
  template <class Visit>
  void release_behind(Index face, Visit visit) {
    if (face < last_behind_.size())
      release_list(last_behind_[face], ~std::size_t{0}, visit);
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
  static constexpr Index lists = 4; // room for the numbers of three

  struct Slot {
    QueuedPair pair;
    std::array<Index, 3> next; // in the lists of the ends and of a face; the first follows the last
    std::int16_t count;        // of the lists that it is in
    bool is_held;
    bool is_refused; // while it has left none
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

  // An entry is a slot and which of its lists.
  Index& next(Index entry) { return slots_[entry / lists].next[entry % lists]; }

  void link(Index& last, Index entry) {
    if (last == none) {
      next(entry) = entry;
    } else {
      next(entry) = next(last);
      next(last) = entry;
    }
    last = entry;
  }

  // The slot of the first entry of a list, which leaves it.
  Index unlink_first(Index& last) {
    const Index entry = next(last), slot = entry / lists;
    if (entry == last)
      last = none;
    else
      next(last) = next(entry);
    if (--slots_[slot].count == 0)
      free_.push_back(slot);
    return slot;
  }

  template <class Visit>
  bool release_list(Index& last, std::size_t most, Visit visit) {
    while (last != none && most > 0) {
      Slot& slot = slots_[unlink_first(last)];
      if (!slot.is_refused)
        continue;
      slot.is_refused = false; // the other lists forget it later
      --size_;
      --most;
      held_ -= slot.is_held;
      visit(slot.pair);
    }
    return last == none;
  }

  // A face may stay in the way for long: what has left in another way makes room.
  QUADRILLE_NOINLINE void add_behind(Index face, Index slot) {
    if (last_behind_.size() <= face)
      last_behind_.resize(face + std::size_t{1}, none);
    Index& last = last_behind_[face];
    while (last != none && !slots_[next(last) / lists].is_refused)
      unlink_first(last);
    ++slots_[slot].count;
    link(last, lists * slot + 2);
  }

  std::vector<Slot> slots_;
  std::vector<Index> free_;
  Array<Index> last_entry_;        // of the list of each vertex
  std::vector<Index> last_behind_; // the same of faces, once one was in the way
  std::size_t size_ = 0, held_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ORDER_REFUSED_PAIRS_H
