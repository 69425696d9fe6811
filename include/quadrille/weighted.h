#ifndef QUADRILLE_WEIGHTED_H
#define QUADRILLE_WEIGHTED_H

#include <quadrille/internal/core/policy/tie_break.h>
#include <quadrille/quadric_form.h>

#include <concepts>
#include <cstddef>

namespace quadrille {

/// The weight of a position: a constant function of a Vector<3>, in the mesh's unit of length, that
/// returns a number.
template <class F>
concept WeightFunction = std::copy_constructible<F> &&
    requires(const F function, const Vector<3> place) {
  { function(place) } -> std::convertible_to<double>;
};

/// Another cost times a function of the position: more faces stay where the function is large.
///
/// ```cpp
/// simplify(mesh, Weighted(Quadric{}, [eye](const Vector<3>& p) {
///   return 1 / squared_distance(p, eye); // as large as it looks from there
/// }));
/// ```
///
/// The function is evaluated at the midpoint of the pair, so that one factor applies to all
/// targets. The position of least cost is that of the other cost, its tie break is multiplied by
/// the same factor, and the error in Status and Report excludes the factor, as a distance. Only
/// ratios of weights matter: a constant factor changes nothing.
///
/// Not checked: a weight is finite and at least 0. The function has the mesh's unit of length, so
/// this cost is not scale-free, see concepts.h.
template <class Cost, WeightFunction Function>
struct Weighted : Cost {
  using Position = Vector<Cost::dimension>; ///< as the other cost has it
  using TieBreak = Weighted;                ///< has the scale of this class's values

  Function function; ///< the weight of a position

  /// A cost times a function.
  Weighted(const Cost& cost, const Function& f) : Cost(cost), function(f) {}

  /// Returns the weight of a pair.
  double weight(const auto& pair) const {
    return function(0.5 * (space(pair.first) + space(pair.second)));
  }

  /// Returns the other cost of the position, times the weight of the pair.
  double operator()(const auto& pair, const Position& x) const {
    return weight(pair) * Cost::operator()(pair, x);
  }

  /// Returns the tie break of the other cost, if it has one, times the weight of the pair.
  template <class Pair>
  requires internal::BreaksTies<Cost, Pair, Position>
  double tie_break(const Pair& pair, const Position& x) const {
    return weight(pair) * Cost::tie_break(pair, x);
  }

  /// Returns the squared error of the other cost, independent of the weight.
  double squared_error(const auto& pair, double cost) const {
    const double w = weight(pair);
    const double unweighted = w > 0 ? cost / w : 0;
    if constexpr (requires { Cost::squared_error(pair, unweighted); })
      return Cost::squared_error(pair, unweighted);
    else
      return unweighted;
  }
};

} // namespace quadrille

#endif // QUADRILLE_WEIGHTED_H
