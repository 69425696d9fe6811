#ifndef QUADRILLE_INTERNAL_CORE_ORDER_PAIR_SUPPLY_H
#define QUADRILLE_INTERNAL_CORE_ORDER_PAIR_SUPPLY_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/contraction/working_surface.h>
#include <quadrille/internal/core/order/deferred_pairs.h>
#include <quadrille/internal/core/order/end_of_run.h>
#include <quadrille/internal/core/order/pair_queue.h>
#include <quadrille/internal/core/order/versioned_queue.h>
#include <quadrille/internal/core/order/waiting_pairs.h>
#include <quadrille/internal/core/policy/policies.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>

namespace quadrille::internal {

/// Prefetches the data that contracting the next pairs will read, step by step: the data of their
/// ends in all components, the corners of these, the faces, and the data of their neighbours. Pairs
/// are anywhere in memory, so most of the time would otherwise be spent waiting for it. peek(n)
/// points to the pair that comes n pairs later, or to none; also(w) prefetches what the caller will
/// read of a neighbour.
template <class Surface, class Peek, class Also>
QUADRILLE_ALWAYS_INLINE inline void look_ahead(const Surface& surface, Peek peek, Also also) {
  const auto& complex = surface.complex();
  if (const auto* last = peek(12))
    for (Index v : {last->first, last->second})
      surface.prefetch_end(v);
  if (const auto* later = peek(8))
    for (Index v : {later->first, later->second})
      complex.prefetch_corners(v);
  if (const auto* soon = peek(4))
    for (Index v : {soon->first, soon->second})
      complex.prefetch_faces(v);
  if (const auto* next = peek(2))
    for (Index v : {next->first, next->second})
      complex.for_each_next(v, [&](Index w) QUADRILLE_ALWAYS_INLINE_LAMBDA {
        surface.prefetch_neighbour(w);
        also(w);
      });
}

/// Which pair is next: the cheapest in the queue; once there is none, rejected pairs that may have
/// another turn; and when these are done, the deferred ones, which would go beyond the target.
template <class Policies>
class PairSupply {
public:
  /// Has none before fill().
  explicit PairSupply(WorkingSurface<Policies>& surface)
      : surface_(surface),
        queue_(surface.complex().vertex_capacity(),
               PairQueue::expected_pairs(
                   surface.pairs().count(surface.status().faces, surface.status().vertices),
                   surface.complex().vertex_capacity()),
               surface.complex().arena()),
        waiting_(surface.complex()) {}

  VersionedQueue& queue() { return queue_; }
  WaitingPairs& waiting() { return waiting_; }
  const WaitingPairs& waiting() const { return waiting_; }
  DeferredPairs& deferred() { return deferred_; }
  const DeferredPairs& deferred() const { return deferred_; }

  /// Has one of the deferred pairs its turn?
  bool is_last_resort() const { return is_last_resort_; }
  /// Do rejected pairs have another turn, in which vertices may go to ends of their pairs?
  bool tries_ends() const { return tries_ends_; }

  /// With all pairs of the surface, unless the visitor cancels.
  void fill() {
    const auto end = static_cast<Index>(surface_.complex().vertex_capacity());
    const Index step = surface_.progress().has_visitor() ? vertices_between_visits : end;
    for (Index v = 0; v < end && surface_.progress().proceed(); v += (std::min)(step, end - v))
      surface_.pairs().for_each_above(
          surface_.scratch(), v, v + (std::min)(step, end - v), 1,
          [this](Index a, Index b, float key) { queue_.push(a, b, key); });
  }

  /// The next pair; none if there is none that could be contracted.
  std::optional<QueuedPair> take() {
    look_ahead(
        surface_, [&](std::size_t ahead) { return queue_.peek(ahead); },
        [&](Index w) QUADRILLE_ALWAYS_INLINE_LAMBDA { waiting_.prefetch(w); });
    std::optional<QueuedPair> next = queue_.pop();
    while (next ? has_isolated_end(*next) : have_another_turn())
      next = queue_.pop();
    is_last_resort_ = !next;
    return next ? next : deferred_.take([this](const QueuedPair& pair) {
      return !queue_.versions().is_outdated(pair) && !has_isolated_end(pair);
    });
  }

  /// Have rejected pairs another turn, once no others are left? Then they are in the queue.
  bool have_another_turn() {
    return waiting_.release_rest(queue_.versions().time(), push_again()) || may_try_ends() ||
           may_proceed();
  }

  /// A guard has rejected a pair because of other faces.
  void note_obstacle() { has_met_obstacle_ = true; }

private:
  static constexpr Index vertices_between_visits = 1 << 16;
  static constexpr double fraction_that_pays =
      0.95; // of the faces left since the last look for a way
  static constexpr double no_limit = std::numeric_limits<double>::infinity();

  auto push_again() {
    return [this](const QueuedPair& pair) { queue_.push_again(pair); };
  }

  bool has_isolated_end(const QueuedPair& pair) const {
    const TriangleComplex& complex = surface_.complex();
    return !complex.has_faces(pair.first) || !complex.has_faces(pair.second);
  }

  // Once no pair is left where vertices may go to the places of least cost: around a high-valence
  // vertex these are ill-determined by narrow faces that look all in about the same direction, and
  // so they are on flat walls between holes. Then those that were rejected have another turn.
  QUADRILLE_NOINLINE bool may_try_ends() {
    if (tries_ends_ || waiting_.empty() ||
        !(surface_.complex().high_valence_vertices().any() || guards_shapes()))
      return false;
    tries_ends_ = true;
    waiting_.release_all(push_again());
    return true;
  }

  // Are there large components or regions in addition to others, which nothing may spoil?
  bool guards_shapes() {
    if (!stops_at_a_count(surface_) || !surface_.state().is_topology_kept)
      return false;
    surface_.state().measure_components();
    return surface_.shape_check().has_any();
  }

  // Once no pair is left, faces may have gone from where others were rejected for meeting them:
  // that need not be near the pairs. As long as looking at all of them again pays.
  QUADRILLE_NOINLINE bool may_proceed() {
    const auto faces = static_cast<double>(surface_.status().faces);
    if (!has_met_obstacle_ || faces > fraction_that_pays * faces_before_search_)
      return false;
    faces_before_search_ = faces;
    waiting_.release_all(push_again());
    return true;
  }

  WorkingSurface<Policies>& surface_;
  VersionedQueue queue_;
  WaitingPairs waiting_;
  DeferredPairs deferred_;
  bool is_last_resort_ = false;
  bool tries_ends_ = false;
  bool has_met_obstacle_ = false;
  double faces_before_search_ = no_limit; // see may_proceed()
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ORDER_PAIR_SUPPLY_H
