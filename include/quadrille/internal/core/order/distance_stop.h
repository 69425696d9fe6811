#ifndef QUADRILLE_INTERNAL_CORE_ORDER_DISTANCE_STOP_H
#define QUADRILLE_INTERNAL_CORE_ORDER_DISTANCE_STOP_H

#include <quadrille/internal/core/contraction/working_surface.h>
#include <quadrille/internal/core/pairs/candidate.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/state/contraction.h>
#include <quadrille/report.h>

#include <limits>

namespace quadrille::internal {

/// Does the stop policy stop at a distance, and at nothing else? Always false if it does not ask
/// for distances. The distance that it was asked about is announced as the next one.
template <class Policies>
class DistanceStop {
public:
  using Cost = typename Policies::Cost;

  explicit DistanceStop(WorkingSurface<Policies>& surface)
      : surface_(surface), is_asking_(surface.policies().stop.needs().distance),
        none_(surface.policies().stop.needs().reverse_distance ? 0 : infinity),
        unused_(surface.policies().stop.needs().tolerance ? 0 : infinity) {}

  bool is_asking() const { return is_asking_; }
  /// The contraction may get another target.
  bool is_too_far(Contraction<Cost>& contraction) {
    if (!is_asking_ || is_enough_without())
      return false;
    Status status = surface_.status();
    const bool result = surface_.distances()->is_too_far(contraction, status);
    announce(status.next_distance, status.next_reverse_distance, status.next_tolerance);
    surface_.progress().announce(contraction.error());
    return result;
  }
  /// Answers this, if it can be seen quickly, for a candidate whose position has been determined.
  bool is_beyond_high_valence(const Candidate<Cost>& candidate) {
    if constexpr (!looks_at_star<typename Policies::Placement>)
      return is_asking_ && !is_enough_without() &&
             surface_.distances()->is_beyond_high_valence(candidate, surface_.scratch(),
                                                          surface_.status());
    else
      return false;
  }
  /// Answers this for a component that would vanish: a distance in the mesh's unit. No point of it
  /// has a place then.
  bool is_too_far(double distance) {
    if (!is_asking_ || is_enough_without())
      return false;
    announce(distance, infinity, infinity);
    return surface_.progress().is_enough();
  }
  /// At a distance of 0, if it asks for any.
  bool is_enough_without() {
    if (is_asking_)
      announce(0, none_, unused_);
    return surface_.progress().is_enough();
  }

private:
  void announce(double distance, double reverse, double tolerance) {
    surface_.progress().announce_distance(distance);
    surface_.progress().announce_reverse_distance(reverse);
    surface_.progress().announce_tolerance(tolerance);
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();

  WorkingSurface<Policies>& surface_;
  const bool is_asking_;
  const double none_;   // the distance back where it does not count or has not been looked for
  const double unused_; // the same of tolerances
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ORDER_DISTANCE_STOP_H
