#ifndef QUADRILLE_INTERNAL_ARGUMENTS_H
#define QUADRILLE_INTERNAL_ARGUMENTS_H

#include <quadrille/attribute_quadric.h>
#include <quadrille/concepts.h>
#include <quadrille/filters.h>
#include <quadrille/internal/attributes.h>
#include <quadrille/internal/policies.h>
#include <quadrille/pairs.h>
#include <quadrille/parameters.h>
#include <quadrille/placement.h>
#include <quadrille/stop.h>
#include <quadrille/topology.h>
#include <quadrille/visitor.h>

#include <CGAL/Named_function_parameters.h>

#include <concepts>
#include <cstddef>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>

/// Recognising the arguments of `simplify` by the concept that each models.

namespace quadrille::internal {

template <class T>
struct IsNamedParameters : std::false_type {};
template <class T, class Tag, class Base>
struct IsNamedParameters<CGAL::Named_function_parameters<T, Tag, Base>> : std::true_type {};

template <class T>
struct IsCost : std::bool_constant<CostPolicy<T>> {};
template <class T>
struct IsStop : std::bool_constant<StopPolicy<T>> {};
template <class T>
struct IsTopology : std::is_same<T, Topology> {};

// A placement that needs a minimizer is recognised with every cost, so that the reason can be told.
template <class Cost>
struct Recognise {
  template <class T>
  struct IsPlacement
      : std::bool_constant<PlacementPolicy<T, Cost> || std::same_as<T, OptimalPlacement>> {};
  // Not asked of a placement: its body, if it takes anything, would not compile with a surface.
  template <class T>
  struct IsPairsItself : std::bool_constant<PairPolicy<T>> {};
  template <class T>
  struct IsPairs : std::conjunction<std::negation<IsPlacement<T>>, IsPairsItself<T>> {};
  template <class T>
  struct IsFilter : std::bool_constant<FilterPolicy<T, Cost>> {};
};

template <template <class> class Is, class... Arguments>
inline constexpr std::size_t count_of = (std::size_t{Is<Arguments>::value} + ... + 0);

/// The first argument that Is recognises, else the default.
template <template <class> class Is, class Default>
const Default& pick(const Default& by_default) {
  return by_default;
}
template <template <class> class Is, class Default, class First, class... Rest>
const auto& pick(const Default& by_default, const First& first, const Rest&... rest) {
  if constexpr (Is<First>::value)
    return first;
  else
    return pick<Is>(by_default, rest...);
}

template <template <class> class Is, class Default, class... Arguments>
using Picked = std::remove_cvref_t<decltype(pick<Is>(std::declval<const Default&>(),
                                                     std::declval<const Arguments&>()...))>;

/// The cost that a call uses: that among the arguments, or the template argument.
template <class Cost, class... Arguments>
using CostOf = Picked<IsCost, Cost, Arguments...>;

/// Is this an argument of `simplify` beside such a cost?
template <class T, class Cost>
inline constexpr bool is_argument =
    IsCost<T>::value || Recognise<Cost>::template IsPlacement<T>::value ||
    Recognise<Cost>::template IsPairs<T>::value || IsStop<T>::value ||
    Recognise<Cost>::template IsFilter<T>::value || IsTopology<T>::value ||
    IsNamedParameters<T>::value;

/// The filters among the arguments, as a tuple; with NormalFlip before them unless it is one of
/// them.
template <template <class> class IsFilter, class... Arguments>
auto pick_filters(const Arguments&... arguments) {
  const auto given = std::tuple_cat([](const auto& argument) {
    if constexpr (IsFilter<std::remove_cvref_t<decltype(argument)>>::value)
      return std::tuple(argument);
    else
      return std::tuple();
  }(arguments)...);
  if constexpr ((std::same_as<Arguments, NormalFlip> || ...))
    return given;
  else
    return std::tuple_cat(std::tuple(NormalFlip{}), given);
}

template <class Cost, class Placement, class Pairs, class Stop, class Visitor, class... Filters>
Policies(Cost, Placement, Pairs, Stop, Visitor, std::optional<Topology>, std::tuple<Filters...>)
    -> Policies<Cost, Placement, Pairs, Stop, Visitor, Filters...>;

/// All policies of a call, checked for fitting together.
template <class Cost_, class Placement_, class... Arguments>
auto pick_policies(const Arguments&... arguments) {
  using Cost = CostOf<Cost_, Arguments...>;
  using Recognised = Recognise<Cost>;
  using Placement = Picked<Recognised::template IsPlacement, Placement_, Arguments...>;
  static_assert(count_of<IsCost, Arguments...> <= 1, "simplify takes one cost: pass only one.");
  static_assert(count_of<Recognised::template IsPlacement, Arguments...> <= 1,
                "simplify takes one placement: pass only one.");
  static_assert(count_of<Recognised::template IsPairs, Arguments...> <= 1,
                "simplify takes one pair policy: pass only one.");
  static_assert(count_of<IsStop, Arguments...> <= 1,
                "simplify takes one stop policy: combine several with AnyOf or AllOf.");
  static_assert(count_of<IsNamedParameters, Arguments...> <= 1,
                "simplify takes one chain of named parameters: join them with a dot.");
  static_assert(PlacementPolicy<Placement, Cost>,
                "This placement does not fit this cost. OptimalPlacement needs a cost with a "
                "minimizer: with EdgeLength, use MidpointPlacement or EndpointPlacement.");

  const auto& named = pick<IsNamedParameters>(CGAL::parameters::default_values(), arguments...);
  const Visitor no_visitor;
  const auto& visitor = CGAL::parameters::choose_parameter(
      CGAL::parameters::get_parameter_reference(named, CGAL::internal_np::visitor), no_visitor);
  std::optional<Topology> topology;
  if constexpr (count_of < IsTopology, Arguments... >> 0)
    topology = pick<IsTopology>(Topology::kept, arguments...);
  Policies policies{pick<IsCost>(Cost_{}, arguments...),
                    pick<Recognised::template IsPlacement>(Placement_{}, arguments...),
                    pick<Recognised::template IsPairs>(EdgePairs{}, arguments...),
                    pick<IsStop>(FaceRatio{}, arguments...),
                    visitor,
                    topology,
                    pick_filters<Recognised::template IsFilter>(arguments...)};
  validate(policies.cost);
  validate(policies.pairs);
  validate(policies.stop);
  return policies;
}

/// The attributes that a cost looks at, in the property map that is their named parameter.
template <class Cost, class NamedParameters>
auto pick_attributes(const NamedParameters& named) {
  using CGAL::parameters::get_parameter;
  if constexpr (Cost::dimension == 3) {
    return NoAttributes{};
  } else {
    constexpr Attribute attribute = Cost::attribute;
    const auto map = [&] {
      if constexpr (attribute == Attribute::color)
        return get_parameter(named, CGAL::internal_np::vertex_color_map);
      else if constexpr (attribute == Attribute::texture)
        return get_parameter(named, CGAL::internal_np::vertex_texture_map);
      else if constexpr (attribute == Attribute::normal)
        return get_parameter(named, CGAL::internal_np::vertex_normal_map);
      else
        return get_parameter(named, parameters::vertex_attribute);
    }();
    using Map = std::remove_cvref_t<decltype(map)>;
    static_assert(
        !std::same_as<Map, CGAL::internal_np::Param_not_found>,
        "This cost needs attributes: pass their property map as a named parameter, "
        "vertex_color_map, vertex_texture_map or vertex_normal_map of CGAL::parameters, or "
        "vertex_attribute_map of quadrille::parameters.");
    return AttributeMap<Map, Cost::dimension - 3, attribute>(map);
  }
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ARGUMENTS_H
