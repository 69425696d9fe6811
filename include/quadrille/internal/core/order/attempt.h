#ifndef QUADRILLE_INTERNAL_CORE_ORDER_ATTEMPT_H
#define QUADRILLE_INTERNAL_CORE_ORDER_ATTEMPT_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/contraction/working_surface.h>
#include <quadrille/internal/core/pairs/candidate.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/state/contraction.h>
#include <quadrille/internal/core/state/scratch.h>
#include <quadrille/report.h>

#include <optional>

namespace quadrille::internal {

/// The result of an attempt to contract a pair.
enum class Outcome {
  contracted,
  put_back, ///< it waits for its turn, with the cost that it has now
  deferred, ///< others come first, whatever it costs
  rejected, ///< for a cause that may go
  stopped   ///< the stop policy stops here
};

/// An outcome, with its data.
struct Attempt {
  Outcome outcome = Outcome::contracted;
  Rejection cause = {}; ///< the cause, if it was rejected
  double key = 0;       ///< the cost by which pairs are ordered
  double error = 0;     ///< the error of the contraction, if it was rejected

  static Attempt put_back(float key) { return {Outcome::put_back, {}, static_cast<double>(key)}; }
  static Attempt deferred(double key) { return {Outcome::deferred, {}, key}; }
  static Attempt rejected(Rejection cause) { return {Outcome::rejected, cause}; }
  static Attempt stopped(double key) { return {Outcome::stopped, {}, key}; }
};

/// Decides each step of an attempt; each order of contractions overrides some of the decisions.
template <class Policies>
class Judge {
public:
  using Candidate = internal::Candidate<typename Policies::Cost>;
  using Contraction = internal::Contraction<typename Policies::Cost>;

  explicit Judge(WorkingSurface<Policies>& surface) : surface_(surface) {}

  /// With which cost does the pair go back, if it now costs more than it may?
  std::optional<float> costlier(const Candidate&) { return std::nullopt; }
  /// Is it certain to be too far from the input, before its star is known?
  bool is_beyond_high_valence(const Candidate&) { return false; }
  /// Would it take more than there is left for it? Then it goes back as it is.
  bool is_too_large(const PairStar&) { return false; }
  /// Why it must not be done, if so. It may get another place.
  std::optional<Rejection> rejection(Contraction& contraction) {
    return surface_.checks().rejection(contraction);
  }
  /// Returns the outcome of a rejected contraction: empty if it got another position, where it may
  /// be done.
  std::optional<Attempt> elsewhere(Contraction&, Rejection cause) {
    return Attempt::rejected(cause);
  }
  /// Should an allowed contraction be done?
  Attempt verdict(Contraction&) { return {}; }

protected:
  WorkingSurface<Policies>& surface() const { return surface_; }

private:
  WorkingSurface<Policies>& surface_;
};

/// Contracts a pair, unless something speaks against it: contract(contraction) does it. This is the
/// one way in which contractions come about, whatever the order.
template <class Policies, class Judge, class Contract>
QUADRILLE_ALWAYS_INLINE inline Attempt attempt(WorkingSurface<Policies>& surface, Index first,
                                               Index second, Scratch& scratch, Judge& judge,
                                               Contract contract) {
  using Placement = typename Policies::Placement;
  using Cost = typename Policies::Cost;
  Candidate<Cost> candidate = surface.evaluator().evaluate(first, second); // the target, its cost
  if (const auto key = judge.costlier(candidate))
    return Attempt::put_back(*key);
  if (judge.is_beyond_high_valence(candidate))
    return Attempt::rejected(Rejection::distance);

  Contraction<Cost> contraction(candidate, GatheredStar(surface.complex(), first, second, scratch));
  if (judge.is_too_large(contraction.star()))
    return Attempt::put_back(static_cast<float>(candidate.key));
  if constexpr (looks_at_star<Placement>) { // which determines the target
    if (!surface.evaluator().resolve(candidate, contraction.star()))
      return {Outcome::rejected, Placement::cause, 0, candidate.error};
    if (const auto key = judge.costlier(candidate))
      return Attempt::put_back(*key);
  }

  if (const auto cause = judge.rejection(contraction)) // constraints, topology, filters, guards
    if (auto other = judge.elsewhere(contraction, *cause)) {
      other->error = candidate.error;
      return *other;
    }
  const Attempt verdict = judge.verdict(contraction); // stop policy, target, shape
  if (verdict.outcome == Outcome::contracted)
    contract(contraction);
  return verdict;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ORDER_ATTEMPT_H
