#ifndef QUADRILLE_INTERNAL_CORE_ORDER_BLOCKAGE_H
#define QUADRILLE_INTERNAL_CORE_ORDER_BLOCKAGE_H

#include <quadrille/internal/core/complex/edge_sides.h>
#include <quadrille/internal/core/contraction/working_surface.h>
#include <quadrille/internal/core/order/attempt.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/state/scratch.h>
#include <quadrille/pairs.h>
#include <quadrille/report.h>

#include <cstddef>
#include <optional>

namespace quadrille::internal {

/// Is most of a surface constrained, so that contractions must take place in the rest of it,
/// whatever that does to the shape? This does not depend on the target.
template <class Policies>
class Blockage {
public:
  explicit Blockage(WorkingSurface<Policies>& surface) : surface_(surface) {}

  /// May that cause constrain a pair whatever its position? Flips, distances and hulls do not.
  static bool is_by(Rejection cause) {
    switch (cause) {
    case Rejection::topology:
    case Rejection::constraint:
    case Rejection::chord:
    case Rejection::shape:
    case Rejection::degree:
    case Rejection::destruction:
    case Rejection::seam:
    case Rejection::texture:
    case Rejection::filter:
      return true;
    default:
      return false;
    }
  }

  /// Are there enough waiting pairs that have been rejected for this?
  bool is_awake(std::size_t waiting) const {
    const Status& status = surface_.status();
    return least_fraction * waiting >= surface_.pairs().count(status.faces, status.vertices);
  }

  /// Are more than half of the edges constrained? Once they are, they are taken to stay so; before,
  /// they are checked again when a tenth of the faces is gone: in linear time in all.
  bool is_of_most() {
    const Status& status = surface_.status();
    if (!is_of_most_ && 10 * status.faces < 9 * faces_counted_) {
      faces_counted_ = status.faces;
      is_of_most_ = counts_most();
    }
    return is_of_most_;
  }

private:
  static constexpr std::size_t least_fraction = 8; // of the pairs wait

  // Contracts nothing.
  struct OnlyAsks : Judge<Policies> {
    using Judge<Policies>::Judge;
    Attempt verdict(typename Judge<Policies>::Contraction& contraction) {
      return Attempt::deferred(contraction.key());
    }
  };

  bool counts_most() {
    if (!scratch_)
      scratch_.emplace(surface_.complex().vertex_capacity());
    const auto& geometry = surface_.evaluator().state().geometry;
    const bool has_unselected = surface_.progress().has_unselected();
    std::size_t edges = 0, blocked = 0;
    for_each_edge(surface_.complex(), [&](Index v, Index w, const auto&) {
      if (has_unselected && geometry.is_fixed(v) && geometry.is_fixed(w))
        return; // most of them lie in what is not selected
      ++edges;
      blocked += is_blocked(v, w);
    });
    return 2 * blocked > edges;
  }

  bool is_blocked(Index v, Index w) {
    OnlyAsks judge(surface_);
    const Attempt attempt = internal::attempt(surface_, v, w, *scratch_, judge, [](const auto&) {});
    return attempt.outcome == Outcome::rejected && is_by(attempt.cause) &&
           (attempt.cause != Rejection::topology || stays(v));
  }

  // The topology of what may vanish is no reason to.
  bool stays(Index v) const {
    return surface_.policies().topology != Topology::components_may_vanish ||
           surface_.state().components.stays(v);
  }

  WorkingSurface<Policies>& surface_;
  std::optional<Scratch>
      scratch_; // the scratch space of the surface is in use for the current contraction
  std::size_t faces_counted_ = ~std::size_t{0} / 16;
  bool is_of_most_ = false;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ORDER_BLOCKAGE_H
