#ifndef QUADRILLE_INTERNAL_CORE_ORDER_GREEDY_LOOP_H
#define QUADRILLE_INTERNAL_CORE_ORDER_GREEDY_LOOP_H

#include <quadrille/internal/core/contraction/working_surface.h>
#include <quadrille/internal/core/order/attempt.h>
#include <quadrille/internal/core/order/blockage.h>
#include <quadrille/internal/core/order/greedy_judge.h>
#include <quadrille/internal/core/order/pair_queue.h>
#include <quadrille/internal/core/order/pair_supply.h>
#include <quadrille/internal/core/order/pair_updates.h>
#include <quadrille/internal/core/order/vanishing_components.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/state/contraction.h>
#include <quadrille/report.h>

#include <cstddef>
#include <limits>
#include <optional>

namespace quadrille::internal {

/// Contracts the cheapest pair until the stop policy is satisfied or no pair can be contracted.
///
/// Which pair is next is up to PairSupply, whether it is contracted to attempt() and GreedyJudge,
/// and what that changes about other pairs to PairUpdates. A pair that is rejected waits until a
/// vertex of a face at one of its ends has moved (WaitingPairs), or the face that was in its way.
template <class Policies>
class GreedyLoop {
public:
  /// Selects all pairs, and computes what each costs.
  explicit GreedyLoop(WorkingSurface<Policies>& surface)
      : surface_(surface), supply_(surface), components_(surface),
        judge_(surface, supply_, components_),
        updates_(surface, supply_.queue(), supply_.waiting()) {
    supply_.fill();
  }

  /// Why it has ended.
  StopReason run() {
    const StopReason reason = contract_pairs();
    surface_.progress().count(surface_.scratch().counters);
    return reason;
  }

private:
  using Contraction = internal::Contraction<typename Policies::Cost>;

  StopReason contract_pairs() {
    if (!surface_.progress().begin_contracting())
      return StopReason::cancelled;
    while (const std::optional<QueuedPair> pair = cheapest_pair()) {
      if (is_cancelled())
        return StopReason::cancelled;
      const Attempt attempt = try_to_contract(*pair);
      switch (attempt.outcome) {
      case Outcome::contracted:
        break; // costs of the pairs around it have been updated
      case Outcome::put_back:
        supply_.queue().push(pair->first, pair->second, static_cast<float>(attempt.key));
        break;
      case Outcome::deferred:
        supply_.deferred().defer(*pair, attempt.key);
        break;
      case Outcome::rejected:
        let_wait(*pair, attempt.cause);
        break;
      case Outcome::stopped:
        if (!others_may_cost_less(*pair, static_cast<float>(attempt.key)))
          return surface_.run().target_rules().reason_of_stop(surface_.status());
      }
    }
    return reason_of_end();
  }

  QUADRILLE_ALWAYS_INLINE Attempt try_to_contract(const QueuedPair& pair) {
    judge_.begin(pair);
    return attempt(surface_, pair.first, pair.second, surface_.scratch(), judge_,
                   [this](const Contraction& contraction) {
                     const Index kept = surface_.apply(contraction, AtOnce{});
                     surface_.progress().count(surface_.scratch().counters);
                     updates_.follow(contraction, kept);
                   });
  }

  // Returns the cheapest pair once all cheaper components have vanished; none if the stop policy is
  // satisfied by that.
  std::optional<QueuedPair> cheapest_pair() {
    std::optional<QueuedPair> next = supply_.take();
    while (components_.has_below(next ? static_cast<double>(next->cost) : no_limit,
                                 supply_.is_last_resort())) {
      if (next)
        supply_.queue().push_again(*next);
      const auto is_end = [this] {
        return judge_.end_of_run().is_here(supply_.waiting().blocked());
      };
      if (is_cancelled() ||
          !components_.vanish_next([this](Index v) { updates_.forget(v); }, is_end))
        return std::nullopt;
      next = supply_.take();
    }
    return next;
  }

  void let_wait(const QueuedPair& pair, Rejection cause) {
    surface_.run().reject({pair.first, pair.second}, cause);
    has_met_distance_ |= cause == Rejection::distance;
    has_met_destruction_ |= cause == Rejection::destruction;
    const auto* const guard = surface_.guards().with_obstacles(cause);
    if (guard)
      supply_.note_obstacle();
    supply_.waiting().add(pair, Blockage<Policies>::is_by(cause), guard ? guard->obstacle() : none);
  }

  // The pair costs more than the stop policy allows: has it become more costly while it was in the
  // queue? Or are there rejected pairs that may have another turn once no pair is left?
  bool others_may_cost_less(const QueuedPair& pair, float key) {
    if (supply_.is_last_resort() || !judge_.cost_stop().is_stop_by_cost())
      return false;
    judge_.cost_stop().announce_none();
    if (key > pair.cost)
      supply_.queue().push(pair.first, pair.second, key);
    else if (supply_.have_another_turn())
      supply_.queue().push_again(pair);
    else
      return false;
    return true;
  }

  StopReason reason_of_end() {
    if (surface_.progress().is_cancelled())
      return StopReason::cancelled;
    judge_.cost_stop().announce_end();
    if (judge_.distance_stop().is_enough_without() || has_met_distance_ ||
        components_.has_met_distance())
      return surface_.run().target_rules().reason_of_stop(surface_.status());
    if (has_met_destruction_ || components_.has_met_destruction())
      return StopReason::target_unreachable;
    return supply_.waiting().empty() ? StopReason::no_pair_left : StopReason::all_pairs_rejected;
  }

  bool is_cancelled() {
    return ++pairs_seen_ % pairs_between_visits == 0 && !surface_.progress().proceed();
  }

  static constexpr std::size_t pairs_between_visits = 256;
  static constexpr double no_limit = std::numeric_limits<double>::infinity();

  WorkingSurface<Policies>& surface_;
  PairSupply<Policies> supply_;
  VanishingComponents<Policies> components_;
  GreedyJudge<Policies> judge_;
  PairUpdates<Policies> updates_;
  std::size_t pairs_seen_ = 0;
  bool has_met_distance_ = false, has_met_destruction_ = false;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ORDER_GREEDY_LOOP_H
