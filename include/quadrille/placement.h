#ifndef QUADRILLE_PLACEMENT_H
#define QUADRILLE_PLACEMENT_H

#include <quadrille/internal/core/policy/tie_break.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <type_traits>

namespace quadrille {

/// The position halfway between the two ends of a pair.
struct MidpointPlacement {
  using ScaleFree = MidpointPlacement; ///< as well in any unit of length

  /// (first + second) / 2, attributes too.
  auto operator()(const auto& /*cost*/, const auto& pair) const {
    return 0.5 * (pair.first + pair.second);
  }
};

/// The cheaper end of a pair, the first if both cost the same. The output's vertices are a subset
/// of the input's: exact positions, exact attributes.
struct EndpointPlacement {
  using ScaleFree = EndpointPlacement; ///< as well in any unit of length

  /// One of the ends, as it is.
  auto operator()(const auto& cost, const auto& pair) const {
    return cost(pair, pair.second) < cost(pair, pair.first) ? pair.second : pair.first;
  }
};

/// A cost with `cost.minimizer(pair)`, an optional position.
template <class Cost, class Pair>
concept HasMinimizer = requires(const Cost cost, const Pair pair) {
  *cost.minimizer(pair);
};

/// The position of least cost; an end itself, to the last bit, where rounding alone parts it from
/// that. Where the cost has none, or it lies further from both ends than `pair.squared_reach`, the
/// distance to the farthest neighbour, the cheapest of the two ends and the midpoint.
///
/// Source: Garland and Heckbert 1997, section 4 (without the segment as a step in between: where
/// planes leave directions free, costs of ours choose in these, see Quadric).
struct OptimalPlacement {
  using ScaleFree = OptimalPlacement; ///< as well in any unit of length

  /// The position of least cost that is in reach.
  template <class Cost, class Pair>
  requires HasMinimizer<Cost, Pair>
  auto operator()(const Cost& cost, const Pair& pair) const {
    if (const auto x = cost.minimizer(pair); x && is_within_reach(pair, *x))
      return is_rounded(pair, pair.first, *x)    ? pair.first
             : is_rounded(pair, pair.second, *x) ? pair.second
                                                 : *x;
    const auto end = EndpointPlacement{}(cost, pair);
    const auto midpoint = MidpointPlacement{}(cost, pair);
    return cost(pair, midpoint) < cost(pair, end) ? midpoint : end;
  }

  /// Does the predicate hold of another position that costs as much as x, up to rounding: of an end
  /// or the midpoint? On flat and straight parts filters may take one where they refuse x.
  template <class Cost, class Pair, class Predicate>
  requires HasMinimizer<Cost, Pair>
  static bool any_equal(const Cost& cost, const Pair& pair, const auto& x, Predicate predicate) {
    if constexpr (internal::BreaksTies<Cost, Pair, std::decay_t<decltype(x)>>) {
      const double most = cost(pair, x) + rounding * cost.tie_break(pair, x);
      for (const auto& y : {pair.first, pair.second, MidpointPlacement{}(cost, pair)})
        if (cost(pair, y) <= most && predicate(y))
          return true;
    }
    return false;
  }

private:
  // Of what tells equal costs apart: a distance of about a millionth of the pair's.
  static constexpr double rounding = 1e-3;

  // Is x that end, up to rounding?
  static bool is_rounded(const auto& pair, const auto& end, const auto& x) {
    return squared_distance(end, x) <= 0x1p-60 * pair.squared_reach;
  }

  // False for a position that is not finite.
  static bool is_within_reach(const auto& pair, const auto& x) {
    return (std::min)(squared_distance(space(x), space(pair.first)),
                      squared_distance(space(x), space(pair.second))) <= pair.squared_reach;
  }
};

} // namespace quadrille

#endif // QUADRILLE_PLACEMENT_H
