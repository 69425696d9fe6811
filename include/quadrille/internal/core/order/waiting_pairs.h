#ifndef QUADRILLE_INTERNAL_CORE_ORDER_WAITING_PAIRS_H
#define QUADRILLE_INTERNAL_CORE_ORDER_WAITING_PAIRS_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/prefetch.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/order/pair_queue.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Rejected pairs, each listed at both of its ends until the neighbourhood of one changes; and at
/// the face that obstructed it, if any, until that changes. They leave in the order in which they
/// came.
class RejectedPairs {
public:
  explicit RejectedPairs(std::size_t vertices, Arena* arena = nullptr)
      : last_entry_(vertices, none, arena) {}

  /// `is_blocked`: is it one of those that blocked() counts? `face`: the face that obstructed it.
  void add(const QueuedPair& pair, bool is_blocked = false, Index face = none) {
    const Index slot = new_slot();
    slots_[slot] = {pair, {none, none, none}, 2, is_blocked, true};
    link(last_entry_[pair.first], lists * slot);
    link(last_entry_[pair.second], lists * slot + 1);
    ++size_;
    blocked_ += is_blocked;
    if (face != none) [[unlikely]]
      append_after(face, slot);
  }

  bool has(Index vertex) const {
    return last_entry_[vertex] != none;
  } ///< any, perhaps one that has left

  /// Empties the list of a vertex and calls visit(pair) for each pair that was still rejected; or
  /// stops after the first `most` of these. Returns whether the list is empty.
  template <class Visit>
  bool release(Index vertex, std::size_t most, Visit visit) {
    return release_list(last_entry_[vertex], most, visit);
  }

  /// Have any been rejected because a face obstructed them?
  bool has_obstructed() const { return !last_obstructed_.empty(); }
  /// Visits those pairs.
  template <class Visit>
  void release_obstructed(Index face, Visit visit) {
    if (face < last_obstructed_.size())
      release_list(last_obstructed_[face], ~std::size_t{0}, visit);
  }

  /// Empties the list of a vertex.
  QUADRILLE_ALWAYS_INLINE void forget(Index vertex) {
    if (has(vertex))
      forget_all(vertex);
  }

  std::size_t size() const { return size_; }
  std::size_t blocked() const { return blocked_; }

  QUADRILLE_ALWAYS_INLINE void prefetch(Index vertex) const {
    internal::prefetch(&last_entry_[vertex]);
  }

private:
  static constexpr Index lists = 4; // room for the numbers of three

  struct Slot {
    QueuedPair pair;
    std::array<Index, 3> next; // in the lists of the ends and of a face; the first follows the last
    std::int16_t count;        // of the lists that it is in
    bool is_blocked;
    bool is_rejected; // while it has left none
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
      if (!slot.is_rejected)
        continue;
      slot.is_rejected = false; // the other lists forget it later
      --size_;
      --most;
      blocked_ -= slot.is_blocked;
      visit(slot.pair);
    }
    return last == none;
  }

  // A face may obstruct pairs for long: pairs that have left in another way make room.
  QUADRILLE_NOINLINE void append_after(Index face, Index slot) {
    if (last_obstructed_.size() <= face)
      last_obstructed_.resize(face + std::size_t{1}, none);
    Index& last = last_obstructed_[face];
    while (last != none && !slots_[next(last) / lists].is_rejected)
      unlink_first(last);
    ++slots_[slot].count;
    link(last, lists * slot + 2);
  }

  std::vector<Slot> slots_;
  std::vector<Index> free_;
  Array<Index> last_entry_;        // of the list of each vertex
  std::vector<Index> last_obstructed_; // the same for faces, once one obstructed a pair
  std::size_t size_ = 0, blocked_ = 0;
};

/// Rejected pairs wait here until a change next to them, or of the face that obstructed them.
///
/// Evaluating a pair takes time in proportion to the faces at its ends, except for those of
/// high-valence vertices. So that no vertex takes more time at each change than one of few faces, a
/// change next to it brings back only as many of its pairs as `most_pairs` says, and all of them
/// when no others are left, as long as that pays.
class WaitingPairs {
public:
  static constexpr std::size_t few_faces = 64; // at a vertex
  static constexpr std::size_t all = ~std::size_t{0};

  explicit WaitingPairs(const TriangleComplex& complex)
      : complex_(complex), rejected_(complex.vertex_capacity(), complex.arena()) {}

  /// `is_blocked`: see blocked(). `face`: the face that obstructed it.
  void add(const QueuedPair& pair, bool is_blocked = false, Index face = none) {
    rejected_.add(pair, is_blocked, face);
  }
  /// Counts the waiting pairs that were rejected for the sake of constraints.
  std::size_t blocked() const { return rejected_.blocked(); }
  /// Some pairs of a vertex of many faces have been added, and others are in the queue.
  void note_left_waiting(Index v) { left_waiting_.push_back(v); }
  bool empty() const { return rejected_.size() == 0; }

  /// Returns the number of pairs of a vertex that visit few² faces together; all of them if there
  /// are few.
  std::size_t most_pairs(Index v) const {
    const std::size_t faces = complex_.degree_bound(v);
    return faces <= few_faces ? all : (std::max<std::size_t>)(1, few_faces * few_faces / faces);
  }

  /// All pairs of a vertex are outdated.
  void forget(Index v) { rejected_.forget(v); }

  /// The surroundings of a vertex have changed, so the answer of a filter may. Calls push(pair) for
  /// pairs that are to be looked at once more.
  template <class Push>
  void release(Index v, Push push) {
    if (rejected_.has(v))
      release_some(v, push);
  }

  /// Do pairs wait for faces?
  bool has_obstructed() const { return rejected_.has_obstructed(); }
  /// A face has changed, or is gone, so it may no longer obstruct pairs. Calls push(pair) as
  /// release() does.
  template <class Push>
  void release_obstructed(Index face, Push push) {
    rejected_.release_obstructed(face, push);
  }

  /// Calls push(pair) for all of them.
  template <class Push>
  void release_all(Push push) {
    left_waiting_.clear();
    for (Index v = 0; v < complex_.vertex_capacity(); ++v)
      rejected_.release(v, all, push);
  }

  /// Releases the remaining pairs, some at a time. Returns false if there are none, or if the last
  /// release brought too few contractions: time counts these.
  template <class Push>
  bool release_rest(std::uint32_t time, Push push) {
    if (time < time_to_release_)
      return false;
    std::size_t released = 0;
    for (Index v : std::exchange(left_waiting_, {}))
      rejected_.release(v, all, [&](const QueuedPair& pair) {
        ++released;
        push(pair);
      });
    time_to_release_ = time + static_cast<std::uint32_t>(released / few_faces);
    return released > 0;
  }

  QUADRILLE_ALWAYS_INLINE void prefetch(Index v) const { rejected_.prefetch(v); }

private:
  template <class Push>
  QUADRILLE_NOINLINE void release_some(Index v, Push push) { // seldom
    if (!rejected_.release(v, most_pairs(v), push))
      left_waiting_.push_back(v);
  }

  const TriangleComplex& complex_;
  RejectedPairs rejected_;
  std::vector<Index> left_waiting_; // vertices of some of them
  std::uint32_t time_to_release_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ORDER_WAITING_PAIRS_H
