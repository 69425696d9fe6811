#ifndef QUADRILLE_INTERNAL_ORDER_GREEDY_LOOP_H
#define QUADRILLE_INTERNAL_ORDER_GREEDY_LOOP_H

#include <quadrille/internal/complex/star.h>
#include <quadrille/internal/contraction/pair_contraction.h>
#include <quadrille/internal/memory/array.h>
#include <quadrille/internal/order/deferred_pairs.h>
#include <quadrille/internal/order/flattened_vertices.h>
#include <quadrille/internal/order/pair_queue.h>
#include <quadrille/order.h>
#include <quadrille/report.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Contracts pairs in the order of their costs, the least first, until the stop policy is
/// satisfied. Costs are compared as floats; equal ones by the lower, then by the higher index of
/// the pair.
///
/// A contraction changes the costs of the pairs at its vertex, and of no others but for costs that
/// look at the surface as it is now: see GreedyOrder::eager and FlattenedVertices. A pair that is
/// refused waits until a vertex of a face at one of its ends has moved.
///
/// Looking at a pair takes time in proportion to the faces at its ends. So that a vertex of d faces
/// costs no more than about d² in all, a change beside it brings back only as many of its pairs as
/// `most_pairs` says, and all of them when no others are left, as long as that pays.
template <class Policies>
class GreedyLoop {
public:
  explicit GreedyLoop(PairContraction<Policies>& surface)
      : surface_(surface), scratch_(surface.scratch()),
        stamp_(surface.vertex_capacity(), 0, surface.complex().workspace()),
        queue_(expected_pairs(surface.pairs().count(surface.status().faces),
                              surface.vertex_capacity()),
               surface.complex().workspace()),
        parked_(surface.vertex_capacity(), surface.complex().workspace()),
        flattened_(looks_for_flattened() ? stamp_.size() : 0, tolerated_fall<Cost>,
                   surface.complex().workspace()) {
    for (Index v = 0; v < stamp_.size(); ++v)
      note_unevenness(v);
    const auto end = static_cast<Index>(stamp_.size());
    const Index step = surface_.has_visitor() ? vertices_between_visits : end;
    for (Index v = 0; v < end && !is_cancelled_; v += std::min(step, end - v)) {
      is_cancelled_ = !surface_.proceed();
      surface_.pairs().for_each_above(scratch_, v, v + std::min(step, end - v), 1,
                                      [&](Index a, Index b, float cost) { push(a, b, cost); });
    }
  }

  /// For how many the queue makes room, of a surface with so many pairs and vertices.
  static std::size_t expected_pairs(std::size_t pairs, std::size_t vertices) {
    return pairs + vertices / 8;
  }

  /// Why it has ended.
  StopReason run() {
    const StopReason reason = contract_pairs();
    surface_.count(scratch_.tally);
    return reason;
  }

private:
  using Cost = typename Policies::Cost;
  using Candidate = typename PairContraction<Policies>::Candidate;

  static constexpr std::uint32_t dead = ~std::uint32_t{0};
  static constexpr Index vertices_between_visits = 1 << 16;
  static constexpr std::size_t few_faces = 64; // at a vertex
  static constexpr std::size_t all = ~std::size_t{0};
  static constexpr double dearest_exact_pair = 4; // by what the next pair in the order costs

  StopReason contract_pairs() {
    if (is_cancelled_)
      return StopReason::cancelled;
    while (const std::optional<QueuedPair> next = next_pair()) {
      if (is_cancelled())
        return StopReason::cancelled;
      Candidate candidate = surface_.evaluate(next->first, next->second);
      if (has_become_dearer(candidate, *next)) {
        push(next->first, next->second, static_cast<float>(candidate.key));
        continue;
      }
      surface_.announce(candidate);
      if (is_beyond_hub(*next, candidate)) {
        park(*next, Rejection::distance);
        continue;
      }
      surface_.gather(scratch_, next->first, next->second);
      if (const auto cause = surface_.rejection(scratch_, next->first, next->second, candidate))
        park(*next, *cause);
      else if (is_too_far(*next, candidate))
        park(*next, Rejection::distance);
      else if (surface_.is_enough())
        return surface_.reason_of_target();
      else if (destroys(candidate))
        park(*next, Rejection::destruction);
      else if (!is_last_resort_ && misses_target(*next, candidate))
        overshooting_.push_back(*next);
      else
        contract(*next, candidate);
    }
    return final_reason();
  }

  bool is_outdated(const QueuedPair& pair) const {
    return pair.stamp < std::max(stamp_[pair.first], stamp_[pair.second]);
  }
  bool is_bare(const QueuedPair& pair) const {
    return !surface_.complex().has_faces(pair.first) || !surface_.complex().has_faces(pair.second);
  }
  auto outdated() const {
    return [this](const QueuedPair& pair) { return is_outdated(pair); };
  }

  QueuedPair pair_now(Index v, Index w, float cost) const {
    const auto [first, second] = std::minmax(v, w);
    return {cost, first, second, time_};
  }
  void push(Index v, Index w, float cost) { queue_.push(pair_now(v, w, cost), outdated()); }

  // A cost that looks at the surface as it is can change while a pair waits.
  bool has_become_dearer(const Candidate& candidate, const QueuedPair& pair) const {
    if constexpr (asks_for_current<Cost>)
      return static_cast<float>(candidate.key) > tolerated_rise<Cost> * pair.cost &&
             !is_last_resort_;
    else
      return false;
  }

  // The cheapest; those that would go beyond the target when there are no others.
  std::optional<QueuedPair> next_pair() {
    prefetch();
    std::optional<QueuedPair> next = queue_.pop(outdated());
    while (next ? is_bare(*next) : release_waiting())
      next = queue_.pop(outdated());
    is_last_resort_ = !next;
    return next ? next : next_overshooting();
  }

  // For nothing, since the target can't be reached? Asked when the surface has few faces left.
  bool destroys(const Candidate& candidate) {
    if (!surface_.is_destructive(candidate))
      return false;
    if (!is_target_reachable_)
      is_target_reachable_ = surface_.is_target_reachable();
    return !*is_target_reachable_;
  }

  // Would it go beyond the target, where another pair might meet it? Or is it such another one, but
  // costs too much more than the first that would have had its turn?
  bool misses_target(const QueuedPair& pair, const Candidate& candidate) {
    const bool others_wait = first_overshooting_ < overshooting_.size();
    if (others_wait && candidate.cost > highest_cost_)
      return true;
    if (!surface_.overshoots(scratch_, pair.second))
      return false;
    if (!others_wait)
      highest_cost_ = dearest_exact_pair * candidate.key;
    return true;
  }

  // They came in the order of their costs.
  std::optional<QueuedPair> next_overshooting() {
    while (first_overshooting_ < overshooting_.size()) {
      const QueuedPair& pair = overshooting_[first_overshooting_++];
      if (!is_outdated(pair) && !is_bare(pair))
        return pair;
    }
    return std::nullopt;
  }

  // Pairs lie anywhere, so most of the time would go into waiting for memory.
  [[gnu::always_inline]] void prefetch() const {
    surface_.prefetch([&](std::size_t ahead) { return queue_.peek(ahead); },
                      [&](Index w) __attribute__((always_inline)) { parked_.prefetch(w); });
  }

  // Does the stop policy stop at the distance, and at nothing else?
  bool is_too_far(const QueuedPair& pair, Candidate& candidate) {
    if constexpr (asks_for_distance<typename Policies::Stop>) {
      if (is_enough_at_no_distance())
        return false;
      const bool result = surface_.is_too_far(scratch_, pair.first, pair.second, candidate);
      surface_.announce(candidate); // may have another target
      return result;
    } else {
      return false;
    }
  }
  // The same, if it is seen at a glance.
  bool is_beyond_hub(const QueuedPair& pair, const Candidate& candidate) {
    if constexpr (asks_for_distance<typename Policies::Stop>)
      return !is_enough_at_no_distance() &&
             surface_.is_beyond_hub(scratch_, pair.first, pair.second, candidate);
    else
      return false;
  }
  bool is_enough_at_no_distance() {
    surface_.announce_distance(0);
    return surface_.is_enough();
  }

  StopReason final_reason() {
    if constexpr (asks_for_distance<typename Policies::Stop>)
      surface_.announce_distance(0);
    if (surface_.is_enough() || has_met_distance_)
      return surface_.reason_of_target();
    if (has_met_destruction_)
      return StopReason::target_unreachable;
    return parked_.size() == 0 ? StopReason::no_pair_left : StopReason::all_pairs_rejected;
  }

  void park(const QueuedPair& pair, Rejection cause) {
    ++scratch_.tally.rejections[static_cast<std::size_t>(cause)];
    has_met_distance_ |= cause == Rejection::distance;
    has_met_destruction_ |= cause == Rejection::destruction;
    parked_.park(pair);
  }

  void contract(const QueuedPair& pair, const Candidate& candidate) {
    const Index kept = surface_.contract(scratch_, pair.first, pair.second, candidate);
    surface_.count(scratch_.tally);
    ++time_;
    stamp_[pair.first] = stamp_[pair.second] = dead;
    stamp_[kept] = time_;
    for (Index end : {pair.first, pair.second})
      parked_.release(end, all, [](const QueuedPair&) {}); // outdated, all of them
    release_parked(scratch_.star.shared);                  // they may be no neighbours any more
    const bool are_edges = surface_.pairs().are_edges();   // then partners are neighbours
    if (!are_edges) {
      release_parked(scratch_.star.first);
      release_parked(scratch_.star.second);
    }
    if (!surface_.complex().has_faces(kept))
      return;
    note_unevenness(kept);
    if (surface_.complex().degree_bound(kept) > few_faces) {
      push_cheapest(kept, are_edges);
      return;
    }
    surface_.pairs().for_each(scratch_, kept, [&](Index partner, float cost) {
      push(kept, partner, cost);
      if (are_edges)
        release_parked(partner);
      if (looks_for_flattened())
        flattened_.look_at(partner, surface_.unevenness(partner));
    });
    if (is_eager())
      push_around(kept);
    else if (flattened_.are_many())
      push_flattened();
  }

  // Does a contraction change what pairs of its neighbours cost, and are these costed at once?
  bool is_eager() const {
    if constexpr (asks_for_current<Cost> && std::same_as<typename Policies::Order, GreedyOrder>)
      return surface_.policies().order.eager;
    else
      return false;
  }

  // The pairs of the neighbours of a vertex that has just been contracted, each once, but its own.
  void push_around(Index v) {
    ring_.clear();
    surface_.complex().for_each_corner(v, [&](Index face, Index i) {
      const StarFace f = PairStar::star_face(surface_.complex(), face, i);
      for (Index w : {f.second, f.third})
        if (stamp_[w] != time_ && surface_.complex().degree_bound(w) <= few_faces) {
          stamp_[w] = time_;
          ring_.push_back(w);
        }
    });
    push_pairs_of_ring([v](Index x) { return x != v; });
  }

  // Each once, with the vertices x for which is_wanted(x) holds.
  template <class IsWanted>
  void push_pairs_of_ring(IsWanted is_wanted) {
    surface_.pairs().for_each_of(
        scratch_, ring_,
        [&](Index w, Index x) { return is_wanted(x) && ((stamp_[x] != time_) | (w < x)); },
        [&](Index w, Index x, float cost) { push(w, x, cost); });
  }

  // Where a cost tells how uneven they are. Eager order costs their pairs anyway.
  bool looks_for_flattened() const { return tells_unevenness<Cost> && !is_eager(); }
  void note_unevenness(Index v) {
    if (looks_for_flattened())
      flattened_.note(v, surface_.unevenness(v));
  }

  // The pairs of the flattened vertices, each once.
  [[gnu::noinline]] void push_flattened() {
    ring_.clear();
    ++time_; // so that what was pushed before is outdated
    flattened_.take([this](Index v) {
      if (stamp_[v] == dead || !surface_.complex().has_faces(v))
        return;
      note_unevenness(v);
      if (surface_.complex().degree_bound(v) > few_faces)
        return;
      stamp_[v] = time_;
      ring_.push_back(v);
    });
    push_pairs_of_ring([](Index) { return true; });
  }

  // Of a vertex of many faces. Its other pairs wait as if they were refused.
  void push_cheapest(Index v, bool are_edges) {
    new_pairs_.clear();
    surface_.pairs().for_each(scratch_, v, [&](Index partner, float cost) {
      new_pairs_.push_back({cost, partner});
      if (are_edges)
        release_parked(partner);
    });
    std::sort(new_pairs_.begin(), new_pairs_.end());
    const std::size_t pushed = std::min(most_pairs(v), new_pairs_.size());
    for (std::size_t i = 0; i < pushed; ++i)
      push(v, new_pairs_[i].second, new_pairs_[i].first);
    for (std::size_t i = pushed; i < new_pairs_.size(); ++i)
      parked_.park(pair_now(v, new_pairs_[i].second, new_pairs_[i].first));
    waiting_.push_back(v);
  }

  void release_parked(const Room<StarFace>& faces) {
    for (const StarFace& f : faces)
      for (Index v : {f.second, f.third})
        release_parked(v);
  }

  // Its surroundings have changed, so the answer of a filter may.
  void release_parked(Index v) {
    if (parked_.has(v))
      release_some(v);
  }
  [[gnu::noinline]] void release_some(Index v) { // seldom
    if (!parked_.release(v, most_pairs(v), push_again()))
      waiting_.push_back(v);
  }

  // Those that were left behind. False if there are none, or if those of the last time brought too
  // few contractions.
  bool release_waiting() {
    if (time_ < time_to_release_)
      return false;
    std::size_t released = 0;
    for (Index v : std::exchange(waiting_, {}))
      parked_.release(v, all, [&](const QueuedPair& pair) {
        ++released;
        push_again()(pair);
      });
    time_to_release_ = time_ + static_cast<std::uint32_t>(released / few_faces);
    return released > 0;
  }

  auto push_again() {
    return [this](const QueuedPair& pair) {
      if (!is_outdated(pair))
        queue_.push(pair, outdated());
    };
  }

  // So many pairs of a vertex look at few² faces together; all of them where there are few.
  std::size_t most_pairs(Index v) const {
    const std::size_t faces = surface_.complex().degree_bound(v);
    return faces <= few_faces ? all : std::max<std::size_t>(1, few_faces * few_faces / faces);
  }

  bool is_cancelled() { return ++pairs_seen_ % 256 == 0 && !surface_.proceed(); }

  PairContraction<Policies>& surface_;
  Scratch& scratch_;
  Array<std::uint32_t> stamp_; // of each vertex: since when the costs of its pairs hold
  std::uint32_t time_ = 0;     // contractions so far
  PairQueue queue_;
  ParkedPairs parked_;
  FlattenedVertices flattened_;
  std::vector<std::pair<float, Index>> new_pairs_; // of a vertex of many faces: cost and partner
  std::vector<Index> ring_;                        // vertices whose pairs are costed anew
  std::vector<Index> waiting_;                     // vertices with pairs that were left behind
  std::uint32_t time_to_release_ = 0;              // these
  std::vector<QueuedPair> overshooting_;           // pairs that would go beyond the target
  std::size_t first_overshooting_ = 0;             // of them that has not had its turn
  double highest_cost_ = 0;                        // of a pair that is taken instead of one of them
  bool is_last_resort_ = false;                    // does one of them have it now?
  std::size_t pairs_seen_ = 0;
  std::optional<bool> is_target_reachable_; // if it has been asked
  bool has_met_distance_ = false, has_met_destruction_ = false;
  bool is_cancelled_ = false; // before it has begun
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ORDER_GREEDY_LOOP_H
