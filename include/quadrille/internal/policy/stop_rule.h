#ifndef QUADRILLE_INTERNAL_POLICY_STOP_RULE_H
#define QUADRILLE_INTERNAL_POLICY_STOP_RULE_H

#include <quadrille/internal/policy/policies.h>
#include <quadrille/report.h>

#include <memory>
#include <utility>

namespace quadrille::internal {

/// A stop policy of any type, told at run time: one engine is compiled for all of them.
class StopRule {
public:
  /// Keeps the policy; copies of the rule share it.
  template <class Stop>
  static StopRule of(Stop stop) {
    StopRule rule;
    rule.is_asking_ = asks_for_distance<Stop> && internal::is_asking_for_distance(stop);
    rule.is_asking_both_ways_ =
        rule.is_asking_ && asks_both_ways<Stop> && internal::is_asking_both_ways(stop);
    rule.is_asking_for_tolerance_ = rule.is_asking_both_ways_ && asks_for_tolerance<Stop> &&
                                    internal::is_asking_for_tolerance(stop);
    rule.is_asking_for_cost_ = asks_for_cost<Stop> && internal::is_asking_for_cost(stop);
    rule.is_asking_for_edges_ = asks_for_edges<Stop> && internal::is_asking_for_edges(stop);
    rule.is_enough_ = [](const void* policy, const Status& status) -> bool {
      return (*static_cast<const Stop*>(policy))(status);
    };
    rule.is_passed_ = [](const void* policy, const Status& status) -> bool {
      return internal::is_passed(*static_cast<const Stop*>(policy), status);
    };
    rule.policy_ = std::make_shared<const Stop>(std::move(stop));
    return rule;
  }

  /// Does it stop at a surface of this status?
  bool operator()(const Status& status) const { return is_enough_(policy_.get(), status); }
  /// Is that beyond the target and not just at it?
  bool is_passed(const Status& status) const { return is_passed_(policy_.get(), status); }
  /// Does it look at Status::next_distance?
  bool is_asking_for_distance() const { return is_asking_; }
  /// And at Status::next_distance_back?
  bool is_asking_both_ways() const { return is_asking_both_ways_; }
  /// And at Status::next_tolerance?
  bool is_asking_for_tolerance() const { return is_asking_for_tolerance_; }
  /// Does it look at Status::next_cost?
  bool is_asking_for_cost() const { return is_asking_for_cost_; }
  /// Does it look at Status::edges?
  bool is_asking_for_edges() const { return is_asking_for_edges_; }

private:
  using Asked = bool (*)(const void*, const Status&);

  StopRule() = default;

  std::shared_ptr<const void> policy_;
  Asked is_enough_ = nullptr, is_passed_ = nullptr;
  bool is_asking_ = false, is_asking_both_ways_ = false, is_asking_for_tolerance_ = false;
  bool is_asking_for_cost_ = false, is_asking_for_edges_ = false;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_POLICY_STOP_RULE_H
