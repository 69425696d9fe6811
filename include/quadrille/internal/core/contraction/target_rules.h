#ifndef QUADRILLE_INTERNAL_CORE_CONTRACTION_TARGET_RULES_H
#define QUADRILLE_INTERNAL_CORE_CONTRACTION_TARGET_RULES_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/contraction/shape_check.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/state/cleanup.h>
#include <quadrille/internal/core/state/contraction.h>
#include <quadrille/internal/core/state/surface_state.h>
#include <quadrille/report.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace quadrille::internal {

/// How a surface comes to the target of the stop policy: a count is met exactly where that is to be
/// had, and what can't be reached is not approached by destruction.
template <class Policies>
class TargetRules {
public:
  using Cost = typename Policies::Cost;
  using Contraction = internal::Contraction<Cost>;

  explicit TargetRules(SurfaceState<Policies>& state) : state_(state) {}

  /// Would the contraction go beyond the target, where another one might not?
  bool overshoots(const Contraction& contraction, const Status& status) {
    if (state_.link_condition.is_closed() && state_.complex.reverse_faces().is_empty())
      return false; // each contraction takes two faces
    return is_passed_after(contraction, status);
  }

  /// Does the surface lie beyond the target of the stop policy, once it has lost that?
  bool is_passed_without(const Loss& loss, const Status& status) const {
    Status after = status;
    after.faces -= (std::min)(after.faces, loss.faces);
    after.vertices -= (std::min)(after.vertices, loss.vertices);
    return internal::is_passed(state_.policies.stop, after);
  }

  /// Returns the reason why the stop policy stops, if it does: have contractions gone beyond its
  /// target?
  StopReason reason_of_stop(const Status& status) const {
    const bool is_passed = status.vertices < status.initial_vertices &&
                           internal::is_passed(state_.policies.stop, status);
    return is_passed ? StopReason::target_passed : StopReason::target_met;
  }

  /// Is the error of the contraction more than that fraction of the distance to the farthest
  /// neighbour? An edge of a cube of twelve faces is more than a tenth, a corner of a square of two
  /// faces as well. Only a cost that reports its error as a distance to the surface can answer
  /// this.
  bool is_coarse(const Contraction& contraction, double fraction = 0.1) const {
    if constexpr (knows_errors<Cost>)
      return contraction.error() > fraction * state_.scale.length_of_mesh(std::sqrt(
                                                  contraction.pair().squared_ring_radius));
    else
      return false;
  }

private:
  QUADRILLE_NOINLINE bool is_passed_after(const Contraction& contraction, const Status& status) {
    const ReverseFaces& reverse_faces = state_.complex.reverse_faces();
    const PairStar& star = contraction.star();
    if (state_.is_topology_kept)
      return is_passed_without({reverse_faces.count_all(star.shared), 1}, status);
    return is_passed_without(most_loss(star, reverse_faces), status) &&
           is_passed_without(Cleanup(state_.complex, contraction.scratch(), state_.labels())
                                 .loss(contraction.second()),
                             status);
  }

  SurfaceState<Policies>& state_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_CONTRACTION_TARGET_RULES_H
