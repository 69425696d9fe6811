#ifndef QUADRILLE_INTERNAL_ORDER_GREEDY_LOOP_H
#define QUADRILLE_INTERNAL_ORDER_GREEDY_LOOP_H

#include <quadrille/internal/base/compiler.h>
#include <quadrille/internal/complex/star.h>
#include <quadrille/internal/contraction/contraction.h>
#include <quadrille/internal/contraction/refusals.h>
#include <quadrille/internal/contraction/working_surface.h>
#include <quadrille/internal/order/cost_stop.h>
#include <quadrille/internal/order/deferred_pairs.h>
#include <quadrille/internal/order/distance_stop.h>
#include <quadrille/internal/order/end_of_run.h>
#include <quadrille/internal/order/hold.h>
#include <quadrille/internal/order/look_ahead.h>
#include <quadrille/internal/order/pair_queue.h>
#include <quadrille/internal/order/pair_updates.h>
#include <quadrille/internal/order/place_at_end.h>
#include <quadrille/internal/order/stamped_queue.h>
#include <quadrille/internal/order/vanishing_parts.h>
#include <quadrille/internal/order/waiting_pairs.h>
#include <quadrille/internal/policy/policies.h>
#include <quadrille/report.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace quadrille::internal {

/// Contracts the cheapest pair until the stop policy is satisfied or no pair can be contracted.
///
/// What a contraction changes about other pairs is up to PairUpdates. A cost that looks at the
/// surface as it is can make a pair more costly while it waits, and so can a hub; such a pair goes
/// back. A pair that is refused waits until a vertex of a face at one of its ends has moved
/// (WaitingPairs), or the face that was in its way; one that would go beyond the target, until
/// there are no others (DeferredPairs).
template <class Policies>
class GreedyLoop {
public:
  explicit GreedyLoop(WorkingSurface<Policies>& surface)
      : surface_(surface), scratch_(surface.scratch()),
        queue_(surface.complex().vertex_capacity(),
               PairQueue::expected_pairs(
                   surface.pairs().count(surface.status().faces, surface.status().vertices),
                   surface.complex().vertex_capacity()),
               surface.complex().workspace()),
        waiting_(surface.complex()), distance_stop_(surface), cost_stop_(surface), parts_(surface),
        end_of_run_(surface), updates_(surface, queue_, waiting_) {
    fill_queue();
  }

  /// Why it has ended.
  StopReason run() {
    const StopReason reason = contract_pairs();
    surface_.progress().count(scratch_.tally);
    return reason;
  }

private:
  using Cost = typename Policies::Cost;
  using Candidate = internal::Candidate<Cost>;
  using Contraction = internal::Contraction<Cost>;

  static constexpr Index vertices_between_visits = 1 << 16;
  static constexpr std::size_t pairs_between_visits = 256;
  static constexpr float tolerated_rise_at_hub = 1.25f;
  static constexpr double part_that_pays = 0.95; // of the faces left since the last look for a way
  static constexpr double no_limit = std::numeric_limits<double>::infinity();

  StopReason contract_pairs() {
    if (!surface_.progress().begin_contracting())
      return StopReason::cancelled;
    while (const std::optional<QueuedPair> next = next_pair()) {
      if (is_cancelled())
        return StopReason::cancelled;
      Candidate candidate = surface_.evaluator().evaluate(next->first, next->second);
      if (goes_back(candidate, *next))
        continue;
      if (distance_stop_.is_beyond_hub(candidate)) {
        refuse(*next, Rejection::distance);
        continue;
      }
      Contraction contraction(
          candidate, GatheredStar(surface_.complex(), next->first, next->second, scratch_));
      if (is_put_off(candidate, contraction.star(), *next))
        continue;
      std::optional<Rejection> cause = refusal(contraction);
      if (cause && goes_back_for_end(contraction, cause, *next))
        continue;
      if (cause)
        refuse(*next, *cause);
      else if (cost_stop_.is_enough_at(contraction.key())) {
        if (!others_may_cost_less(contraction, *next))
          return surface_.target_rules().reason_of_stop(surface_.status());
      } else if (end_of_run_.is_destroyed_by(contraction, waiting_.held()))
        refuse(*next, Rejection::destruction);
      else if (!is_last_resort_ &&
               (spoils_shape(contraction, *next) || costs_too_little(contraction, *next)))
        continue;
      else if (!is_last_resort_ && misses_target(contraction))
        deferred_.defer(*next, contraction.key());
      else
        contract(contraction);
    }
    return final_reason();
  }

  std::optional<Rejection> refusal(Contraction& contraction) {
    if (const auto cause = surface_.checks().rejection(contraction))
      return cause;
    if (distance_stop_.is_too_far(contraction))
      return Rejection::distance;
    return std::nullopt;
  }

  // Where a pair costs more than the stop policy allows: has it become more costly while it was in
  // the queue? Or are there refused pairs that may have another turn once no pair is left?
  bool others_may_cost_less(const Contraction& contraction, const QueuedPair& pair) {
    if (is_last_resort_ || !cost_stop_.is_stop_by_cost())
      return false;
    cost_stop_.announce_none();
    if (const auto key = static_cast<float>(contraction.key()); key > pair.cost)
      queue_.push(pair.first, pair.second, key);
    else if (have_another_turn())
      queue_.push_again(pair);
    else
      return false;
    return true;
  }

  // Refused pairs, once no others are left.
  bool have_another_turn() {
    return waiting_.release_rest(queue_.stamps().time(), push_again()) || may_try_ends() ||
           may_have_way();
  }

  // To an end, where faces are in the way of the place of least cost, which ends seldom are: shells
  // and walls close together would soon hold each other. And around a hub: see may_try_ends().
  bool moves_to_end(Contraction& contraction, Rejection cause) {
    return ((!looks_at_star<typename Policies::Placement> && is_for_obstacle(cause)) ||
            tries_ends_) &&
           internal::moves_to_end(surface_.evaluator(), contraction,
                                  [this](Contraction& c) { return refusal(c); });
  }

  // A pair that is refused may go to an end: now, and then there is no cause any more, or when what
  // that costs has its turn.
  bool goes_back_for_end(Contraction& contraction, std::optional<Rejection>& cause,
                         const QueuedPair& pair) {
    if (waits_for_end(contraction, *cause, pair))
      return true;
    if (!moves_to_end(contraction, *cause))
      return false;
    if (goes_back(contraction.candidate(), pair, true))
      return true;
    cause.reset();
    return false;
  }

  // Does the first end that it might go to cost more than others? Whether faces are in the way
  // there is looked at when its turn comes: most pairs are outdated before that.
  bool waits_for_end(const Contraction& contraction, Rejection cause, const QueuedPair& pair) {
    if (looks_at_star<typename Policies::Placement> || !is_for_obstacle(cause) || is_last_resort_ ||
        !may_move_to_end(surface_.evaluator(), contraction))
      return false;
    const auto key =
        static_cast<float>(surface_.evaluator().at_ends(contraction.candidate())[0].key);
    if (!(key > tolerated_rise<Cost> * pair.cost))
      return false;
    queue_.push(pair.first, pair.second, key);
    return true;
  }

  // Once no pair is left where vertices may go to the places of least cost: around a hub these are
  // ill-determined by narrow faces that look all in about the same direction, and so they are on
  // flat walls between holes. Then those that were refused have another turn.
  QUADRILLE_NOINLINE bool may_try_ends() {
    if (tries_ends_ || waiting_.empty() || !(surface_.complex().hubs().any() || guards_shapes()))
      return false;
    tries_ends_ = true;
    waiting_.release_all(push_again());
    return true;
  }

  // Are there large parts or regions beside others, which nothing may spoil?
  bool guards_shapes() {
    if (!end_of_run_.has_count() || !surface_.is_topology_kept())
      return false;
    surface_.measure_parts();
    return surface_.shape_check().has_any();
  }

  // Once no pair is left, faces may have gone from where others were refused for meeting them: that
  // need not be near the pairs. As long as looking at all of them again pays.
  QUADRILLE_NOINLINE bool may_have_way() {
    const auto faces = static_cast<double>(surface_.status().faces);
    if (!has_met_obstacle_ || faces > part_that_pays * faces_before_way_)
      return false;
    faces_before_way_ = faces;
    waiting_.release_all(push_again());
    return true;
  }

  void fill_queue() {
    const auto end = static_cast<Index>(surface_.complex().vertex_capacity());
    const Index step = surface_.progress().has_visitor() ? vertices_between_visits : end;
    for (Index v = 0; v < end && surface_.progress().proceed(); v += (std::min)(step, end - v))
      surface_.pairs().for_each_above(scratch_, v, v + (std::min)(step, end - v), 1, push_pair());
  }

  auto push_pair() {
    return [this](Index v, Index w, float key) { queue_.push(v, w, key); };
  }
  auto push_again() {
    return [this](const QueuedPair& pair) { queue_.push_again(pair); };
  }

  bool has_isolated_end(const QueuedPair& pair) const {
    const TriangleComplex& complex = surface_.complex();
    return !complex.has_faces(pair.first) || !complex.has_faces(pair.second);
  }

  // The cheapest pair, once all parts have vanished that are cheaper; none if the stop policy is
  // satisfied by that.
  std::optional<QueuedPair> next_pair() {
    std::optional<QueuedPair> next = next_queued();
    while (parts_.has_below(next ? static_cast<double>(next->cost) : no_limit, is_last_resort_)) {
      if (next)
        queue_.push_again(*next);
      if (is_cancelled() ||
          !parts_.vanish_next([this](Index v) { updates_.forget(v); },
                              [this] { return end_of_run_.is_here(waiting_.held()); }))
        return std::nullopt;
      next = next_queued();
    }
    return next;
  }

  // Those that would go beyond the target when there are no others.
  std::optional<QueuedPair> next_queued() {
    look_ahead(
        surface_, [&](std::size_t ahead) { return queue_.peek(ahead); },
        [&](Index w) QUADRILLE_ALWAYS_INLINE_LAMBDA { waiting_.prefetch(w); });
    std::optional<QueuedPair> next = queue_.pop();
    while (next ? has_isolated_end(*next) : have_another_turn())
      next = queue_.pop();
    is_last_resort_ = !next;
    return next ? next : deferred_.take([this](const QueuedPair& pair) {
      return !queue_.stamps().is_outdated(pair) && !has_isolated_end(pair);
    });
  }

  // Into the queue, if it has become more costly, or been moved to where it is; by more than a
  // little at a hub, where each contraction makes all pairs so.
  bool goes_back(const Candidate& candidate, const QueuedPair& pair, bool has_moved = false) {
    surface_.progress().announce(candidate.error);
    constexpr bool may_rise = has_local_terms<Cost> || looks_at_star<typename Policies::Placement>;
    const bool is_at_hub = surface_.complex().hubs().of_pair(pair.first, pair.second) != none;
    if (!may_rise && !is_at_hub && !tries_ends_ && !has_moved)
      return false;
    const auto key = static_cast<float>(candidate.key);
    const float tolerated =
        is_at_hub ? (std::max)(tolerated_rise_at_hub, tolerated_rise<Cost>) : tolerated_rise<Cost>;
    if (!(key > tolerated * pair.cost) || is_last_resort_)
      return false;
    queue_.push(pair.first, pair.second, key);
    return true;
  }

  // Has it no place, or one that is more costly, now that its placement has looked at the star?
  bool is_put_off(Candidate& candidate, const PairStar& star, const QueuedPair& pair) {
    if constexpr (looks_at_star<typename Policies::Placement>) {
      if (surface_.evaluator().settle(candidate, star))
        return goes_back(candidate, pair);
      refuse(pair, Policies::Placement::cause);
      return true;
    }
    return false;
  }

  // Would it spoil the shape of a large part or region, while others may meet the target? It goes
  // behind these.
  bool spoils_shape(const Contraction& contraction, const QueuedPair& pair) {
    if (contraction.error() <= least_spoiling_) [[likely]]
      return false;
    return goes_behind_others(contraction, pair);
  }
  QUADRILLE_NOINLINE bool goes_behind_others(const Contraction& contraction,
                                             const QueuedPair& pair) {
    surface_.measure_parts();
    if (!surface_.shape_check().has_any())
      least_spoiling_ = no_limit;
    const double strain = surface_.shape_check().strain(contraction);
    const float key = ShapeCheck<Cost>::dearer(contraction, strain);
    if (!(strain > 1) || !(key > pair.cost))
      return false;
    queue_.push(pair.first, pair.second, key);
    return true;
  }

  // To an end, if that moves the surface less. Takes the excess where it is, and returns that of
  // where it goes: see ShapeCheck.
  QUADRILLE_NOINLINE double move_where_measured(Contraction& contraction, double excess) {
    Candidate best = contraction.candidate();
    double least = contraction.error() * excess;
    if constexpr (!looks_at_star<typename Policies::Placement>)
      internal::moves_to_end(surface_.evaluator(), contraction, [&](Contraction& c) {
        if (!refusal(c)) {
          const double excess_there = surface_.shape_check().excess(c);
          if (const double way = c.error() * excess_there; way < least) {
            least = way;
            excess = excess_there;
            best = c.candidate();
          }
        }
        return true; // the other end is looked at as well
      });
    contraction.replace(best);
    return excess;
  }

  // Does it move the surface further than its error says? It goes behind those that cost less than
  // what is measured.
  bool costs_too_little(Contraction& contraction, const QueuedPair& pair) {
    if (!end_of_run_.is_near(waiting_.held()))
      return false;
    double excess = surface_.shape_check().excess(contraction);
    if (!(excess > 1)) [[likely]]
      return false;
    excess = move_where_measured(contraction, excess);
    const auto key = static_cast<float>((std::min)(excess * excess * contraction.key(), 1e37));
    if (!(excess > 1 && key > pair.cost))
      return false;
    queue_.push(pair.first, pair.second, key);
    return true;
  }

  // Would it go beyond the target, where another pair might meet it? Or is it such another one, but
  // costs too much more than the first that would have had its turn?
  bool misses_target(const Contraction& contraction) {
    return deferred_.is_too_dear(contraction.cost()) || parts_.is_too_dear(contraction.key()) ||
           surface_.target_rules().overshoots(contraction, surface_.status());
  }

  StopReason final_reason() {
    if (surface_.progress().is_cancelled())
      return StopReason::cancelled;
    cost_stop_.announce_end();
    if (distance_stop_.is_enough_without() || has_met_distance_ || parts_.has_met_distance())
      return surface_.target_rules().reason_of_stop(surface_.status());
    if (has_met_destruction_ || parts_.has_met_destruction())
      return StopReason::target_unreachable;
    return waiting_.empty() ? StopReason::no_pair_left : StopReason::all_pairs_rejected;
  }

  void refuse(const QueuedPair& pair, Rejection cause) {
    internal::refuse(surface_, {pair.first, pair.second}, cause);
    has_met_distance_ |= cause == Rejection::distance;
    has_met_destruction_ |= cause == Rejection::destruction;
    const auto* const guard = surface_.guards().with_obstacles(cause);
    has_met_obstacle_ |= guard != nullptr;
    waiting_.add(pair, Hold<Policies>::is_by(cause), guard ? guard->obstacle() : none);
  }

  // Has a guard refused a pair because of faces that may change?
  bool is_for_obstacle(Rejection cause) const {
    return surface_.guards().with_obstacles(cause) != nullptr;
  }

  void contract(const Contraction& contraction) {
    const Index kept = surface_.apply(contraction, AtOnce{});
    surface_.progress().count(scratch_.tally);
    updates_.follow(contraction, kept);
  }

  bool is_cancelled() {
    return ++pairs_seen_ % pairs_between_visits == 0 && !surface_.progress().proceed();
  }

  WorkingSurface<Policies>& surface_;
  Scratch& scratch_;
  StampedQueue queue_;
  WaitingPairs waiting_;
  DeferredPairs deferred_;
  DistanceStop<Policies> distance_stop_;
  CostStop<Policies> cost_stop_;
  VanishingParts<Policies> parts_;
  EndOfRun<Policies> end_of_run_;
  PairUpdates<Policies> updates_;
  // Errors up to this one spoil no part. Nothing does where the stop policy stops at no count, or
  // where parts may join.
  double least_spoiling_ = end_of_run_.has_count() && surface_.is_topology_kept()
                               ? surface_.shape_check().least_error()
                               : no_limit;
  bool is_last_resort_ = false; // has one of the deferred pairs its turn?
  bool tries_ends_ = false;     // see may_try_ends()
  std::size_t pairs_seen_ = 0;
  bool has_met_distance_ = false, has_met_destruction_ = false, has_met_obstacle_ = false;
  double faces_before_way_ = no_limit; // see may_have_way()
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ORDER_GREEDY_LOOP_H
