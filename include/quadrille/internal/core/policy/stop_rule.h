#ifndef QUADRILLE_INTERNAL_CORE_POLICY_STOP_RULE_H
#define QUADRILLE_INTERNAL_CORE_POLICY_STOP_RULE_H

#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/report.h>

#include <memory>
#include <utility>

namespace quadrille::internal {

/// A type-erased stop policy: one engine is compiled for all of them.
class StopRule {
public:
  /// Keeps the policy; copies of the rule share it.
  template <class Stop>
  static StopRule of(Stop stop) {
    StopRule rule;
    rule.needs_ = internal::needs_now(stop);
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
  /// Which numbers of the status it looks at that have to be found out.
  const Needs& needs() const { return needs_; }

private:
  using Asked = bool (*)(const void*, const Status&);

  StopRule() = default;

  std::shared_ptr<const void> policy_;
  Asked is_enough_ = nullptr, is_passed_ = nullptr;
  Needs needs_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_POLICY_STOP_RULE_H
