#ifndef QUADRILLE_PLACEMENT_H
#define QUADRILLE_PLACEMENT_H

#include <quadrille/internal/core/policy/tie_break.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <type_traits>

namespace quadrille {

/// The position halfway between the two ends of a pair.
struct MidpointPlacement {
  using ScaleFree = MidpointPlacement; ///< scale-invariant

  /// Returns (first + second) / 2, attributes included.
  auto operator()(const auto& /*cost*/, const auto& pair) const {
    return 0.5 * (pair.first + pair.second);
  }
};

/// The cheaper end of a pair, or the first if both cost the same. The output's vertices are then a
/// subset of the input's, with exact positions and exact attributes.
struct EndpointPlacement {
  using ScaleFree = EndpointPlacement; ///< scale-invariant

  /// Returns one of the ends, unchanged.
  auto operator()(const auto& cost, const auto& pair) const {
    return cost(pair, pair.second) < cost(pair, pair.first) ? pair.second : pair.first;
  }
};

/// A cost with `cost.minimizer(pair)`, an optional position.
template <class Cost, class Pair>
concept HasMinimizer = requires(const Cost cost, const Pair pair) {
  *cost.minimizer(pair);
};

/// The position of least cost; if it differs from an end by rounding only, this end itself, bit for
/// bit. If the cost has no minimizer, or it lies further from both ends than the farthest neighbour
/// (whose squared distance is `pair.squared_ring_radius`), it is the cheapest of the two ends and
/// the midpoint.
///
/// Source: Garland and Heckbert 1997, section 4 (without the intermediate search along the segment:
/// where planes leave directions free, this library's costs choose a position in them, see
/// Quadric).
struct OptimalPlacement {
  using ScaleFree = OptimalPlacement; ///< scale-invariant

  /// Returns the position of least cost within the one-ring radius.
  template <class Cost, class Pair>
  requires HasMinimizer<Cost, Pair>
  auto operator()(const Cost& cost, const Pair& pair) const {
    if (const auto x = cost.minimizer(pair); x && is_within_ring(pair, *x))
      return is_rounded(pair, pair.first, *x)    ? pair.first
             : is_rounded(pair, pair.second, *x) ? pair.second
                                                 : *x;
    const auto end = EndpointPlacement{}(cost, pair);
    const auto midpoint = MidpointPlacement{}(cost, pair);
    return cost(pair, midpoint) < cost(pair, end) ? midpoint : end;
  }

  /// Returns whether the predicate holds for another position that costs as much as x, up to
  /// rounding: an end or the midpoint. In flat and straight regions filters may accept one of these
  /// where they reject x.
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
  // The threshold of rounding in the tie break: a distance of about a millionth of the pair's
  // length.
  static constexpr double rounding = 1e-3;

  // Returns whether x is that end, up to rounding.
  static bool is_rounded(const auto& pair, const auto& end, const auto& x) {
    return squared_distance(end, x) <= 0x1p-60 * pair.squared_ring_radius;
  }

  // Returns false for a position that is not finite.
  static bool is_within_ring(const auto& pair, const auto& x) {
    return (std::min)(squared_distance(space(x), space(pair.first)),
                      squared_distance(space(x), space(pair.second))) <= pair.squared_ring_radius;
  }
};

} // namespace quadrille

#endif // QUADRILLE_PLACEMENT_H
