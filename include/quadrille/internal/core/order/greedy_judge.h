#ifndef QUADRILLE_INTERNAL_CORE_ORDER_GREEDY_JUDGE_H
#define QUADRILLE_INTERNAL_CORE_ORDER_GREEDY_JUDGE_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/contraction/shape_check.h>
#include <quadrille/internal/core/contraction/working_surface.h>
#include <quadrille/internal/core/order/attempt.h>
#include <quadrille/internal/core/order/cost_stop.h>
#include <quadrille/internal/core/order/distance_stop.h>
#include <quadrille/internal/core/order/end_of_run.h>
#include <quadrille/internal/core/order/pair_queue.h>
#include <quadrille/internal/core/order/pair_supply.h>
#include <quadrille/internal/core/order/vanishing_components.h>
#include <quadrille/internal/core/pairs/candidate.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/state/contraction.h>
#include <quadrille/report.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace quadrille::internal {

/// Are both ends of a pair free to come to the other?
template <class Evaluator, class Contraction>
bool may_move_to_end(const Evaluator& evaluator, const Contraction& contraction) {
  const auto& geometry = evaluator.state().geometry;
  return contraction.star().high_valence == none && !geometry.is_fixed(contraction.first()) &&
         !geometry.is_fixed(contraction.second());
}

/// Moves a contraction to the cheaper end of the pair that rejects(contraction) does not reject, if
/// there is any.
template <class Evaluator, class Contraction, class Rejects>
QUADRILLE_NOINLINE bool moves_to_end(const Evaluator& evaluator, Contraction& contraction,
                                     Rejects rejects) {
  if (!may_move_to_end(evaluator, contraction))
    return false;
  const typename Contraction::Candidate wanted = contraction.candidate();
  for (const auto& end : evaluator.at_ends(wanted)) {
    contraction.replace(end);
    if (!rejects(contraction))
      return true;
  }
  contraction.replace(wanted);
  return false;
}

/// Decides attempts in the greedy order.
///
/// A cost that looks at the current surface can make a pair more costly while it waits, and so can
/// a high-valence vertex; such a pair goes back, and so does one that would spoil the shape of the
/// rest. One that would go beyond the target is deferred.
template <class Policies>
class GreedyJudge : public Judge<Policies> {
public:
  using typename Judge<Policies>::Candidate;
  using typename Judge<Policies>::Contraction;

  GreedyJudge(WorkingSurface<Policies>& surface, const PairSupply<Policies>& supply,
              const VanishingComponents<Policies>& components)
      : Judge<Policies>(surface), supply_(supply), components_(components), distance_stop_(surface),
        cost_stop_(surface), end_of_run_(surface),
        least_spoiling_(end_of_run_.has_count() && surface.state().is_topology_kept
                            ? surface.shape_check().least_error()
                            : no_limit) {}

  CostStop<Policies>& cost_stop() { return cost_stop_; }
  DistanceStop<Policies>& distance_stop() { return distance_stop_; }
  EndOfRun<Policies>& end_of_run() { return end_of_run_; }

  /// The pair at hand.
  void begin(const QueuedPair& pair) { queued_cost_ = pair.cost; }

  // By more than a little at a high-valence vertex, where each contraction makes all pairs more
  // costly.
  std::optional<float> costlier(const Candidate& candidate, bool has_moved = false) {
    this->surface().progress().announce(candidate.error);
    constexpr bool may_rise = has_local_terms<Cost> || looks_at_star<Placement>;
    const bool is_at_high_valence = this->surface().complex().high_valence_vertices().of_pair(
                                        candidate.first, candidate.second) != none;
    if (!may_rise && !is_at_high_valence && !supply_.tries_ends() && !has_moved)
      return std::nullopt;
    const auto key = static_cast<float>(candidate.key);
    const float tolerated = is_at_high_valence
                                ? (std::max)(tolerated_rise_at_high_valence, tolerated_rise<Cost>)
                                : tolerated_rise<Cost>;
    if (!(key > tolerated * queued_cost_) || supply_.is_last_resort())
      return std::nullopt;
    return key;
  }

  bool is_beyond_high_valence(const Candidate& candidate) {
    return distance_stop_.is_beyond_high_valence(candidate);
  }

  std::optional<Rejection> rejection(Contraction& contraction) {
    if (const auto cause = this->surface().checks().rejection(contraction))
      return cause;
    if (distance_stop_.is_too_far(contraction))
      return Rejection::distance;
    return std::nullopt;
  }

  // To an end: now, or when what that costs has its turn.
  std::optional<Attempt> elsewhere(Contraction& contraction, Rejection cause) {
    if (const auto key = cost_at_end(contraction, cause))
      return Attempt::put_back(*key);
    if (!moves_to_end(contraction, cause))
      return Attempt::rejected(cause);
    if (const auto key = costlier(contraction.candidate(), true))
      return Attempt::put_back(*key);
    return std::nullopt;
  }

  Attempt verdict(Contraction& contraction) {
    if (cost_stop_.is_enough_at(contraction.key()))
      return Attempt::stopped(contraction.key());
    if (end_of_run_.is_destroyed_by(contraction, supply_.waiting().blocked()))
      return Attempt::rejected(Rejection::destruction);
    if (supply_.is_last_resort())
      return {};
    if (const auto key = key_after_others(contraction))
      return Attempt::put_back(*key);
    if (const auto key = measured_key(contraction))
      return Attempt::put_back(*key);
    return misses_target(contraction) ? Attempt::deferred(contraction.key()) : Attempt();
  }

private:
  using Cost = typename Policies::Cost;
  using Placement = typename Policies::Placement;

  static constexpr float tolerated_rise_at_high_valence = 1.25f;
  static constexpr double no_limit = std::numeric_limits<double>::infinity();

  // Has a guard rejected a pair because of faces that may change?
  bool is_for_obstacle(Rejection cause) const {
    return this->surface().guards().with_obstacles(cause) != nullptr;
  }

  // Moves to an end if faces obstruct the position of least cost, which rarely happens at ends:
  // shells and walls close together would otherwise soon obstruct each other. It does so as well if
  // ends are tried: see PairSupply.
  bool moves_to_end(Contraction& contraction, Rejection cause) {
    return ((!looks_at_star<Placement> && is_for_obstacle(cause)) || supply_.tries_ends()) &&
           internal::moves_to_end(this->surface().evaluator(), contraction,
                                  [this](Contraction& c) { return rejection(c); });
  }

  // Returns the cost of the first end that the pair might move to, if that is more than others
  // cost. Whether faces obstruct it there is checked when its turn comes: most pairs are outdated
  // before that.
  std::optional<float> cost_at_end(const Contraction& contraction, Rejection cause) {
    const auto& evaluator = this->surface().evaluator();
    if (looks_at_star<Placement> || !is_for_obstacle(cause) || supply_.is_last_resort() ||
        !may_move_to_end(evaluator, contraction))
      return std::nullopt;
    const auto key = static_cast<float>(evaluator.at_ends(contraction.candidate())[0].key);
    return key > tolerated_rise<Cost> * queued_cost_ ? std::optional(key) : std::nullopt;
  }

  // Would it spoil the shape of a large component or region, while others may meet the target? Then
  // it comes after these.
  std::optional<float> key_after_others(const Contraction& contraction) {
    if (contraction.error() <= least_spoiling_) [[likely]]
      return std::nullopt;
    return strained_key(contraction);
  }
  QUADRILLE_NOINLINE std::optional<float> strained_key(const Contraction& contraction) {
    WorkingSurface<Policies>& surface = this->surface();
    surface.state().measure_components();
    if (!surface.shape_check().has_any())
      least_spoiling_ = no_limit;
    const double strain = surface.shape_check().strain(contraction);
    const float key = ShapeCheck<Policies>::costlier(contraction, strain);
    return strain > 1 && key > queued_cost_ ? std::optional(key) : std::nullopt;
  }

  // Does it move the surface further than its error says? Then it comes after those that cost less
  // than the measured value.
  std::optional<float> measured_key(Contraction& contraction) {
    if (!end_of_run_.is_near(supply_.waiting().blocked()))
      return std::nullopt;
    double excess = this->surface().shape_check().excess(contraction);
    if (!(excess > 1)) [[likely]]
      return std::nullopt;
    excess = move_where_measured(contraction, excess);
    const auto key = static_cast<float>((std::min)(excess * excess * contraction.key(), 1e37));
    return excess > 1 && key > queued_cost_ ? std::optional(key) : std::nullopt;
  }

  // To an end, if that moves the surface less. Takes the excess where it is, and returns that of
  // where it goes: see ShapeCheck.
  QUADRILLE_NOINLINE double move_where_measured(Contraction& contraction, double excess) {
    Candidate best = contraction.candidate();
    double least = contraction.error() * excess;
    if constexpr (!looks_at_star<Placement>)
      internal::moves_to_end(this->surface().evaluator(), contraction, [&](Contraction& c) {
        if (!rejection(c)) {
          const double excess_there = this->surface().shape_check().excess(c);
          if (const double loss = c.error() * excess_there; loss < least) {
            least = loss;
            excess = excess_there;
            best = c.candidate();
          }
        }
        return true; // the other end is looked at as well
      });
    contraction.replace(best);
    return excess;
  }

  // Would it go beyond the target, where another pair might meet it? Or is it such another one, but
  // costs too much more than the first that would have had its turn?
  bool misses_target(const Contraction& contraction) {
    return supply_.deferred().is_too_costly(contraction.cost()) ||
           components_.is_too_costly(contraction.key()) ||
           this->surface().run().target_rules().overshoots(contraction, this->surface().status());
  }

  const PairSupply<Policies>& supply_;
  const VanishingComponents<Policies>& components_;
  DistanceStop<Policies> distance_stop_;
  CostStop<Policies> cost_stop_;
  EndOfRun<Policies> end_of_run_;
  // Errors up to this one spoil no component. Nothing does if the stop policy stops at no count, or
  // if components may join.
  double least_spoiling_;
  float queued_cost_ = 0; // of the pair at hand
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ORDER_GREEDY_JUDGE_H
