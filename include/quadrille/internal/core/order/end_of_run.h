#ifndef QUADRILLE_INTERNAL_CORE_ORDER_END_OF_RUN_H
#define QUADRILLE_INTERNAL_CORE_ORDER_END_OF_RUN_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/contraction/working_surface.h>
#include <quadrille/internal/core/order/blockage.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/state/contraction.h>
#include <quadrille/internal/core/state/feature_loss.h>
#include <quadrille/report.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace quadrille::internal {

/// Does the stop policy stop at a count, whatever the distance and the cost? If only distance and
/// cost stop it, they are sufficient rules.
template <class Policies>
bool stops_at_a_count(const WorkingSurface<Policies>& surface) {
  Status status = surface.status();
  status.faces = status.vertices = status.edges = 0;
  status.next_error = status.next_distance = status.next_reverse_distance = status.next_tolerance =
      status.next_cost = 0;
  return surface.policies().stop(status);
}

/// Near the end of what constraints allow: which contractions are not worth the faces that they
/// save?
///
/// If most of a surface is constrained, the rest of it pays for the target. The total error of
/// contractions (Displacement) grows with a power of the faces that are gone: without constraints,
/// by about a fifth while a tenth of the faces is removed. It must not grow by more than
/// `greatest_growth` in that time; and no large component of the surface may be spoiled.
///
/// The decision depends only on the history of the run, so a target does not change which
/// contractions are done before it. Nothing is checked before many rejected pairs wait.
template <class Policies>
class EndOfRun {
public:
  using Cost = typename Policies::Cost;
  using Contraction = internal::Contraction<Cost>;

  explicit EndOfRun(WorkingSurface<Policies>& surface)
      : surface_(surface), blockage_(surface), has_count_(stops_at_a_count(surface)) {}

  /// See stops_at_a_count().
  bool has_count() const { return has_count_; }

  /// Are so many constrained pairs waiting that the end may be near, and does each vertex represent
  /// many? The mean over all planes in their states hides the positions of some of them.
  bool is_near(std::size_t waiting) const {
    const Status& status = surface_.status();
    return waiting > 0 && many * status.faces < status.initial_faces && blockage_.is_awake(waiting);
  }

  /// Is it here, where what destroys is rejected?
  bool is_here(std::size_t waiting) {
    return waiting > 0 && has_count_ && blockage_.is_awake(waiting) && blockage_.is_of_most();
  }

  /// Would the contraction destroy what constraints leave free? `waiting` constrained pairs wait.
  bool is_destroyed_by(const Contraction& contraction, std::size_t waiting) {
    return waiting > 0 && has_count_ && destroys(contraction, waiting);
  }

private:
  QUADRILLE_NOINLINE bool destroys(const Contraction& contraction, std::size_t waiting) {
    if (!blockage_.is_awake(waiting))
      return false;
    take_note();
    return (is_cliff(contraction) || surface_.shape_check().spoils(contraction) ||
            is_coarse(contraction)) &&
           blockage_.is_of_most();
  }

  // Each chart that is kept is constrained on its own, and so is each region of labels: its
  // remainder counts in addition to its neighbours.
  bool is_coarse(const Contraction& contraction) const {
    const TargetRules<Policies>& rules = surface_.run().target_rules();
    return has_kept_seams() ? rules.is_coarse(contraction)
                            : !surface_.state().labels().empty() &&
                                  rules.is_coarse(contraction, coarse_in_regions);
  }
  bool has_kept_seams() const {
    return Policies::has_channels && surface_.state().appearance.seams().keeps_channels() &&
           surface_.progress().rejected(Rejection::seam) > 0;
  }

  // The total displacement at a number of remaining faces.
  struct Note {
    std::size_t faces;
    double moved;
  };

  double moved() const { return Displacement::fraction(surface_.progress().moved()); }

  // Once for each hundredth of the faces.
  void take_note() {
    const std::size_t faces = surface_.status().faces;
    if (notes_.empty() || 100 * faces <= 99 * notes_.back().faces)
      notes_.push_back({faces, moved()});
  }

  // Returns the total displacement when there were a tenth more faces.
  double moved_before() {
    const std::size_t faces = surface_.status().faces;
    while (oldest_ + 1 < notes_.size() && 10 * notes_[oldest_ + 1].faces >= 11 * faces)
      ++oldest_;
    return notes_[oldest_].moved;
  }

  bool is_cliff(const Contraction& contraction) {
    if constexpr (knows_errors<Cost>) {
      const double after = moved() + Displacement::fraction(surface_.displacement_of(contraction));
      return std::sqrt(after) > greatest_growth * std::sqrt(moved_before()) + next_to_nothing;
    } else {
      return false;
    }
  }

  static constexpr std::size_t many = 20;          // faces have become one
  static constexpr double greatest_growth = 1.3;   // of the error, while a tenth of the faces goes
  static constexpr double coarse_in_regions = 0.2; // of the distance to the farthest neighbour
  static constexpr double next_to_nothing = 1e-4;  // of the diagonal, over a square of it

  WorkingSurface<Policies>& surface_;
  Blockage<Policies> blockage_;
  const bool has_count_;
  std::vector<Note> notes_;
  std::size_t oldest_ = 0; // of the notes that count
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ORDER_END_OF_RUN_H
