#ifndef QUADRILLE_INTERNAL_CORE_POLICY_BUILT_IN_PLACEMENT_H
#define QUADRILLE_INTERNAL_CORE_POLICY_BUILT_IN_PLACEMENT_H

#include <quadrille/placement.h>

#include <concepts>
#include <type_traits>

namespace quadrille::internal {

/// OptimalPlacement, EndpointPlacement or MidpointPlacement, chosen at run time: one engine is
/// compiled for all three. OptimalPlacement needs a cost with a minimizer.
class BuiltInPlacement {
public:
  using ScaleFree = BuiltInPlacement; ///< as each of them is
  enum class Kind { optimal, endpoint, midpoint };

  explicit BuiltInPlacement(Kind kind) : kind_(kind) {}
  explicit BuiltInPlacement(OptimalPlacement) : kind_(Kind::optimal) {}
  explicit BuiltInPlacement(EndpointPlacement) : kind_(Kind::endpoint) {}
  explicit BuiltInPlacement(MidpointPlacement) : kind_(Kind::midpoint) {}

  Kind kind() const { return kind_; }
  bool is_optimal() const { return kind_ == Kind::optimal; }

  template <class Cost, class Pair>
  auto operator()(const Cost& cost, const Pair& pair) const
      -> std::remove_cvref_t<decltype(pair.first)> {
    if constexpr (HasMinimizer<Cost, Pair>)
      if (is_optimal())
        return OptimalPlacement{}(cost, pair);
    return kind_ == Kind::midpoint ? MidpointPlacement{}(cost, pair)
                                   : EndpointPlacement{}(cost, pair);
  }

  /// See OptimalPlacement.
  template <class Cost, class Pair, class Predicate>
  requires HasMinimizer<Cost, Pair>
  bool any_equal(const Cost& cost, const Pair& pair, const auto& x, Predicate predicate) const {
    return is_optimal() && OptimalPlacement::any_equal(cost, pair, x, predicate);
  }

private:
  Kind kind_;
};

template <class Placement>
inline constexpr bool is_built_in =
    std::same_as<Placement, OptimalPlacement> || std::same_as<Placement, EndpointPlacement> ||
    std::same_as<Placement, MidpointPlacement>;

/// A placement as the engine is compiled for it.
template <class Placement>
using EnginePlacement = std::conditional_t<is_built_in<Placement>, BuiltInPlacement, Placement>;

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_POLICY_BUILT_IN_PLACEMENT_H
