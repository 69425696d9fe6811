#ifndef QUADRILLE_INTERNAL_CORE_CONTRACTION_CHECKS_H
#define QUADRILLE_INTERNAL_CORE_CONTRACTION_CHECKS_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/contraction/guard_list.h>
#include <quadrille/internal/core/evaluation/pair_names.h>
#include <quadrille/internal/core/policy/contraction_view.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/policy/star_view.h>
#include <quadrille/internal/core/state/cleanup.h>
#include <quadrille/internal/core/state/contraction.h>
#include <quadrille/internal/core/state/surface_state.h>
#include <quadrille/report.h>

#include <cmath>
#include <cstddef>
#include <optional>

namespace quadrille::internal {

/// May a contraction be done at all: does it leave what is fixed, and the topology if that is kept,
/// and do the filters allow it?
template <class Policies>
class Checks {
public:
  using Cost = typename Policies::Cost;
  using Placement = typename Policies::Placement;
  static constexpr std::size_t dimension = Cost::dimension;
  using Position = Vector<dimension>;
  using Contraction = internal::Contraction<Cost>;

  Checks(const SurfaceState<Policies>& state, const GuardList<dimension>& guards)
      : state_(state), guards_(guards),
        goes_where_written_(!guards.empty() ||
                            (state.scale.writes_floats() && state.policies.stop.needs().distance)) {
  }

  /// Returns why the contraction must not be done, if it must not. If only filters reject it, and
  /// they accept another position of the same cost, it gets that position. If there are guards, or
  /// distances are bounded, it gets a position that can be written unchanged.
  std::optional<Rejection> rejection(Contraction& contraction) const {
    const PairStar& star = contraction.star();
    const Index a = contraction.first(), b = contraction.second();
    if (state_.appearance.seams().is_changed_by(star, a, b))
      return Rejection::seam;
    if (state_.geometry.is_any_fixed()) [[unlikely]]
      if (const auto cause = rejection_next_to_fixed(star, a, b))
        return cause;
    if (!is_finite(contraction.target()) || !std::isfinite(contraction.cost()))
      return Rejection::position;
    if (!state_.planes.empty()) [[unlikely]]
      if (state_.planes.of_pair(a, b) == none ||
          state_.planes.flatten(star, a, b, state_.geometry, state_.scale))
        return Rejection::constraint;
    if (state_.is_topology_kept &&
        !state_.link_condition.holds(star, a, b, contraction.scratch().labels))
      return Rejection::topology;
    if (goes_where_written_) [[unlikely]]
      contraction.move_to(state_.scale.as_written(contraction.target()));
    const std::optional<Rejection> cause = rejection(contraction, contraction.target());
    if (cause && !stays(star, a) && !stays(star, b) && finds_other_place(contraction, *cause))
      return std::nullopt;
    return cause;
  }

private:
  bool is_fixed(Index v) const { return state_.geometry.is_fixed(v); }
  bool stays(const PairStar& star, Index end) const {
    return is_fixed(end) || star.high_valence == end;
  }

  // Why what is fixed or shared rejects a contraction, if it does.
  QUADRILLE_NOINLINE std::optional<Rejection> rejection_next_to_fixed(const PairStar& star, Index a,
                                                                      Index b) const {
    if (stays(star, a) && stays(star, b))
      return Rejection::constraint;
    const auto is_fixed = [this](Index v) { return state_.geometry.is_fixed(v); };
    if (!state_.is_topology_kept && takes_a_fixed_vertex_away(star, a, b, is_fixed))
      return Rejection::constraint;
    if (state_.shared.makes_chord(star, a, b))
      return Rejection::chord;
    return std::nullopt;
  }

  // Why a filter rejects a target, if one does.
  std::optional<Rejection> rejection(const Contraction& contraction, const Position& target) const {
    if (!state_.planes.empty()) [[unlikely]]
      if (const Index a = contraction.first(), b = contraction.second();
          !state_.planes.admit(a, b, target, state_.scale) ||
          !state_.outlines.admit(a, b, space(target)))
        return Rejection::constraint;
    const ContractionView<dimension> view(
        contraction.star(), state_.complex, state_.geometry.positions().data(),
        contraction.pair().first, contraction.pair().second, target);
    std::optional<Rejection> cause =
        state_.policies.filters.rejection(view, contraction, state_.numbering, state_.scale);
    if constexpr (Policies::has_channels)
      if (!cause && state_.channels().turn_over(contraction.star(), contraction.first(),
                                                contraction.second(), target))
        return Rejection::texture;
    if constexpr (looks_at_star<Placement>)
      if (!cause &&
          !state_.policies.placement.admits(seen_pair(contraction), star_view(contraction), target))
        return Placement::cause;
    if (!cause && !guards_.empty()) [[unlikely]]
      return guards_.rejection(contraction, target);
    return cause;
  }

  decltype(auto) seen_pair(const Contraction& contraction) const {
    return PairNames<Policies>(state_.numbering)
        .for_placement(contraction.pair(), contraction.first(), contraction.second());
  }
  auto star_view(const Contraction& contraction) const {
    return StarView<dimension>(contraction.star(), contraction.first(), contraction.second(),
                               state_.geometry.positions().data(), state_.scale);
  }

  QUADRILLE_NOINLINE bool finds_other_place(Contraction& contraction,
                                            [[maybe_unused]] Rejection cause) const { // seldom
    const auto takes = [&](const Position& place) {
      const Position x = goes_where_written_ ? state_.scale.as_written(place) : place;
      if (rejection(contraction, x))
        return false;
      contraction.move_to(x);
      return true;
    };
    const auto& placement =
        state_.policies.placement; // a derived one may want none of these places
    if constexpr (requires {
                    placement.any_further(state_.policies.cost, seen_pair(contraction),
                                          star_view(contraction), takes);
                  })
      if (cause == Placement::cause)
        return placement.any_further(state_.policies.cost, seen_pair(contraction),
                                     star_view(contraction), takes);
    if constexpr (is_scale_free<Placement> && requires {
                    placement.any_equal(state_.policies.cost, seen_pair(contraction), Position{},
                                        takes);
                  })
      return placement.any_equal(state_.policies.cost, seen_pair(contraction),
                                 Position(contraction.target()), takes);
    else
      return false;
  }

  const SurfaceState<Policies>& state_;
  const GuardList<dimension>& guards_;
  bool goes_where_written_; // see rejection()
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_CONTRACTION_CHECKS_H
