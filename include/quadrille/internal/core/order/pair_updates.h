#ifndef QUADRILLE_INTERNAL_CORE_ORDER_PAIR_UPDATES_H
#define QUADRILLE_INTERNAL_CORE_ORDER_PAIR_UPDATES_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/contraction/working_surface.h>
#include <quadrille/internal/core/memory/append_buffer.h>
#include <quadrille/internal/core/order/cost_refresh.h>
#include <quadrille/internal/core/order/versioned_queue.h>
#include <quadrille/internal/core/order/waiting_pairs.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/state/contraction.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Updates the pairs, in the queue and among those that wait, after a contraction.
///
/// It outdates the pairs of the two ends: their costs are computed again, and old entries of the
/// queue are dropped when their turn comes. Pairs next to it may have become cheaper (CostRefresh)
/// or may no longer be rejected (WaitingPairs). At a high-valence vertex to which a vertex has
/// moved, only the pairs next to that vertex are visited.
template <class Policies>
class PairUpdates {
public:
  using Contraction = internal::Contraction<typename Policies::Cost>;

  PairUpdates(WorkingSurface<Policies>& surface, VersionedQueue& queue, WaitingPairs& waiting)
      : surface_(surface), scratch_(surface.scratch()), queue_(queue), waiting_(waiting),
        refresh_(surface, queue.versions()) {}

  /// A contraction has been done that has left the vertex `kept`.
  void follow(const Contraction& contraction, Index kept) {
    queue_.versions().advance();
    if (waiting_.has_obstructed()) [[unlikely]]
      release_obstructed(contraction.star());
    if (contraction.star().high_valence != none && surface_.pairs().are_edges())
      update_at_high_valence(contraction);
    else
      update_around(contraction, kept);
    if (surface_.complex().high_valence_vertices().any())
      review_high_valence();
  }

  /// All pairs of a vertex are outdated, for good.
  QUADRILLE_ALWAYS_INLINE void forget(Index v) {
    queue_.versions().retire(v);
    waiting_.forget(v);
  }

private:
  auto push_pair() {
    return [this](Index v, Index w, float key) { queue_.push(v, w, key); };
  }
  auto push_again() {
    return [this](const QueuedPair& pair) { queue_.push_again(pair); };
  }

  QUADRILLE_ALWAYS_INLINE void update_around(const Contraction& contraction, Index kept) {
    for (Index end : {contraction.first(), contraction.second()})
      forget(end);
    queue_.versions().renew(kept);
    release_around(contraction.star());
    if (!surface_.complex().has_faces(kept))
      return;
    refresh_.note(kept);
    push_pairs(kept);
  }

  void push_pairs(Index v) {
    if (surface_.complex().degree_bound(v) > WaitingPairs::few_faces)
      push_cheapest(v);
    else
      push_all(v);
  }

  // The pairs that a high-valence vertex had stay as they are: where they have become more costly,
  // they go back when their turn comes. It gets further ones with neighbours of the vertex that has
  // come to it.
  QUADRILLE_NOINLINE void update_at_high_valence(const Contraction& contraction) {
    const PairStar& star = contraction.star();
    const bool is_first = star.high_valence == contraction.first();
    forget(is_first ? contraction.second() : contraction.first());
    release_around(star);
    neighbours_.clear();
    for (const StarFace& f : is_first ? star.second : star.first)
      for (Index w : {f.second, f.third})
        if (surface_.complex().has_faces(w))
          neighbours_.push_back(w);
    std::sort(neighbours_.begin(), neighbours_.end());
    neighbours_.erase(std::unique(neighbours_.begin(), neighbours_.end()), neighbours_.end());
    const auto is_at = [](Index w) { return [w](const StarFace& f) { return f.has(w); }; };
    const auto& others = is_first ? star.first : star.second;
    for (Index w : neighbours_) {
      waiting_.release(w, push_again());
      refresh_.look_at(w);
      if (std::none_of(star.shared.begin(), star.shared.end(), is_at(w)) &&
          std::none_of(others.begin(), others.end(), is_at(w)))
        queue_.push(star.high_valence, w, surface_.evaluator().key_of({star.high_valence, w}));
    }
    refresh_.note(star.high_valence);
    refresh_.run(push_pair());
  }

  // A vertex that is no longer a high-valence vertex may move. The boundary terms of the others
  // have been computed again.
  QUADRILLE_NOINLINE void review_high_valence() {
    surface_.complex().review_high_valence([this](Index v) {
      surface_.sum_up_terms(v);
      const TriangleComplex& complex = surface_.complex();
      if (complex.high_valence_vertices().has(v) || queue_.versions().is_retired(v) ||
          !complex.has_faces(v))
        return;
      queue_.versions().advance();
      queue_.versions().renew(v);
      waiting_.forget(v);
      push_pairs(v);
    });
  }

  // Vertices of faces that are gone may be no neighbours any more. The others are partners, if all
  // pairs are edges, and met as such.
  QUADRILLE_ALWAYS_INLINE void release_around(const PairStar& star) {
    release(star.shared);
    if (surface_.pairs().are_edges())
      return;
    release(star.first);
    release(star.second);
  }
  QUADRILLE_ALWAYS_INLINE void release(const AppendBuffer<StarFace>& faces) {
    for (const StarFace& f : faces)
      for (Index v : {f.second, f.third})
        waiting_.release(v, push_again());
  }

  // Faces that have changed or are gone may have obstructed pairs anywhere.
  QUADRILLE_NOINLINE void release_obstructed(const PairStar& star) {
    for (const auto* faces : {&star.first, &star.second, &star.shared})
      for (const StarFace& f : *faces)
        waiting_.release_obstructed(f.face, push_again());
  }

  void push_all(Index v) {
    const bool are_edges = surface_.pairs().are_edges();
    surface_.pairs().for_each(scratch_, v, [&](Index partner, float key) {
      queue_.push(v, partner, key);
      if (are_edges)
        waiting_.release(partner, push_again());
      refresh_.look_at(partner);
    });
    refresh_.run(push_pair());
  }

  // Pushes the cheapest pair of a vertex with many faces. Its other pairs wait as if they had been
  // rejected.
  void push_cheapest(Index v) {
    const bool are_edges = surface_.pairs().are_edges();
    new_pairs_.clear();
    surface_.pairs().for_each(scratch_, v, [&](Index partner, float key) {
      new_pairs_.push_back({key, partner});
      if (are_edges)
        waiting_.release(partner, push_again());
    });
    std::sort(new_pairs_.begin(), new_pairs_.end());
    const std::size_t pushed = (std::min)(waiting_.most_pairs(v), new_pairs_.size());
    for (std::size_t i = 0; i < pushed; ++i)
      queue_.push(v, new_pairs_[i].second, new_pairs_[i].first);
    for (std::size_t i = pushed; i < new_pairs_.size(); ++i)
      waiting_.add(queue_.versions().pair_now(v, new_pairs_[i].second, new_pairs_[i].first));
    waiting_.note_left_waiting(v);
  }

  WorkingSurface<Policies>& surface_;
  Scratch& scratch_;
  VersionedQueue& queue_;
  WaitingPairs& waiting_;
  CostRefresh<Policies> refresh_;
  std::vector<Index> neighbours_; // of a vertex that has come to a high-valence vertex
  std::vector<std::pair<float, Index>> new_pairs_; // of a vertex of many faces: key and partner
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ORDER_PAIR_UPDATES_H
