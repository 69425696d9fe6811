#ifndef QUADRILLE_INTERNAL_CORE_CALL_ARGUMENTS_H
#define QUADRILLE_INTERNAL_CORE_CALL_ARGUMENTS_H

#include <quadrille/concepts.h>
#include <quadrille/filters.h>
#include <quadrille/internal/core/base/optional.h>
#include <quadrille/internal/core/base/parallel.h>
#include <quadrille/internal/core/call/carried.h>
#include <quadrille/internal/core/call/named_parameters.h>
#include <quadrille/internal/core/policy/built_in_placement.h>
#include <quadrille/internal/core/policy/engine_policies.h>
#include <quadrille/internal/core/policy/guard_set.h>
#include <quadrille/internal/core/policy/mesh_units.h>
#include <quadrille/internal/core/policy/orders.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/policy/stored_visitor.h>
#include <quadrille/order.h>
#include <quadrille/pairs.h>
#include <quadrille/parameters.h>
#include <quadrille/placement.h>
#include <quadrille/quadric.h>
#include <quadrille/recorded.h>
#include <quadrille/stop.h>

#include <CGAL/Named_function_parameters.h>

#include <concepts>
#include <cstddef>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>

/// The kind of an argument of `simplify`, by the concept that it models; of a std::optional, by its
/// value type.

namespace quadrille::internal {

enum class Kind {
  cost,
  placement,
  pairs,
  stop,
  order,
  filter,
  topology,
  planes,
  voxels,
  labels,
  channel,
  split_vertices,
  recorder,
  guard,
  named_parameters,
  unknown
};

template <class T>
inline constexpr bool is_recorder = false;
template <class R>
inline constexpr bool is_recorder<RecordInto<R>> = true;

/// Is a type meant to be a cost? Nothing else has a dimension, or a state and a function `face`.
template <class T>
concept LooksLikeCost = requires {
  T::dimension;
}
|| requires(const T cost, const Vector<3> p) {
  typename T::State;
  cost.face(p, p, p);
};

/// Is a type meant to be a placement? Its result for a pair is not void, even if it is no position.
template <class T, class Cost>
concept LooksLikePlacement = requires(const T placement,
                                      const typename SeenByPlacement<T, Cost>::Costs cost,
                                      const typename SeenByPlacement<T, Cost>::Pair pair) {
  requires !std::is_void_v<decltype(placement(cost, pair))>;
};

/// The kind of a std::optional of an argument of that kind. Arguments on whose types compilation
/// depends cannot be optional.
constexpr Kind kind_if_optional(Kind kind) {
  switch (kind) {
  case Kind::cost:
  case Kind::placement:
  case Kind::channel:
  case Kind::split_vertices:
  case Kind::named_parameters:
    return Kind::unknown;
  default:
    return kind;
  }
}

/// The kind of an argument in a call with such a cost. Each concept is tested only if the argument
/// is of no kind before it: to test the result of a call instantiates the body of a user's
/// function. An OptimalPlacement is one with every cost, so that pick_policies can report what to
/// do.
template <class T, class Cost>
constexpr Kind kind_of() {
  if constexpr (IsOptional<T>)
    return kind_if_optional(kind_of<Contained<T>, Cost>());
  else if constexpr (IsNamedParameters<T>::value)
    return Kind::named_parameters;
  else if constexpr (std::same_as<T, Topology>)
    return Kind::topology;
  else if constexpr (std::same_as<T, KeepPlanes>)
    return Kind::planes;
  else if constexpr (std::same_as<T, VoxelSize>)
    return Kind::voxels;
  else if constexpr (is_labels<T>)
    return Kind::labels;
  else if constexpr (is_channel<T>)
    return Kind::channel;
  else if constexpr (std::same_as<T, SplitVertices>)
    return Kind::split_vertices;
  else if constexpr (is_recorder<T>)
    return Kind::recorder;
  else if constexpr (is_guard<T>)
    return Kind::guard;
  else if constexpr (is_order<T>)
    return Kind::order;
  else if constexpr (LooksLikeCost<T>)
    return CostPolicy<T> ? Kind::cost : Kind::unknown;
  else if constexpr (FilterPolicy<T, Cost>)
    return Kind::filter;
  else if constexpr (StopPolicy<T>)
    return Kind::stop;
  else if constexpr (std::same_as<T, OptimalPlacement>)
    return Kind::placement;
  else if constexpr (LooksLikePlacement<T, Cost>)
    return PlacementPolicy<T, Cost> ? Kind::placement : Kind::unknown;
  else if constexpr (PairPolicy<T>)
    return Kind::pairs;
  else
    return Kind::unknown;
}

struct DistanceHeader;

/// Has <quadrille/distance_limits.h> been included?
template <class Policies>
concept HasDistanceHeader = requires {
  sizeof(std::conditional_t<std::is_void_v<Policies>, Policies, DistanceHeader>);
};

/// The optional functions that a call may need, according to its types.
template <class Policies, class Stop, class Order, bool is_recorded>
OptionalModules<Policies> optional_modules() {
  OptionalModules<Policies> modules;
  if constexpr (!std::same_as<Order, GreedyOrder>)
    modules.run_passes = &run_passes<Policies>;
  if constexpr (is_recorded)
    modules.make_recording = &make_recording<Policies>;
  if constexpr (needs_of<Stop>().distance) {
    static_assert(HasDistanceHeader<Policies>,
                  "The stop policy needs distances: include <quadrille/distance_limits.h>.");
    modules.make_distances = &make_distances<Policies, needs_of<Stop>().reverse_distance>;
  }
  return modules;
}

} // namespace quadrille::internal

/// Recognising the arguments of `simplify` by the concept that each models.

namespace quadrille::internal {

/// In place of a cost or a placement that is no template argument.
struct NotGiven {};
template <class Policy, class Default>
using Given = std::conditional_t<std::same_as<Policy, NotGiven>, Default, Policy>;

/// The cost that a call uses: that among the arguments, or the template argument.
template <class Cost, class... Arguments>
struct FirstCost : std::type_identity<Given<Cost, Quadric>> {};
template <class Cost, class First, class... Rest>
struct FirstCost<Cost, First, Rest...>
    : std::conditional_t<LooksLikeCost<First>, std::type_identity<First>,
                         FirstCost<Cost, Rest...>> {};
template <class Cost, class... Arguments>
using CostOf = typename FirstCost<Cost, Arguments...>::type;

template <Kind kind, class Cost, class... Arguments>
inline constexpr std::size_t count_of = (std::size_t{kind_of<Arguments, Cost>() == kind} + ... + 0);

/// The first argument of a kind, else the default. It may be a std::optional.
template <Kind kind, class Cost, class Default>
Default pick() {
  static_assert(std::default_initializable<Default>,
                "This policy has no default constructor: pass a value of it to simplify instead of "
                "a template argument.");
  return Default{};
}
template <Kind kind, class Cost, class Default, class First, class... Rest>
auto pick(const First& first, const Rest&... rest) {
  if constexpr (kind_of<First, Cost>() == kind)
    return first;
  else
    return pick<kind, Cost, Default>(rest...);
}

/// The filters among the arguments.
template <class Cost, class... Arguments>
auto pick_filters(const Arguments&... arguments) {
  const auto given = std::tuple_cat([](const auto& argument) {
    if constexpr (kind_of<std::remove_cvref_t<decltype(argument)>, Cost>() == Kind::filter)
      return std::tuple(argument);
    else
      return std::tuple();
  }(arguments)...);
  return std::apply(
      [](const auto&... filter) { return FilterList<Cost::dimension>::of(filter...); }, given);
}

/// The guards among the arguments.
template <class Cost, class... Arguments>
auto pick_guards(const Arguments&... arguments) {
  GuardSet<Cost::dimension> guards;
  const auto add = [&]<class T>([[maybe_unused]] const T& argument) {
    if constexpr (kind_of<T, Cost>() == Kind::guard)
      if_given(argument, [&](const auto& guard) { guards.add(guard); });
  };
  (add(arguments), ...);
  return guards;
}

/// Can a guard be used with an order of this type? If either is chosen at run time, that is checked
/// at run time too.
template <class Guard, class Order>
inline constexpr bool suits_order =
    !std::same_as<Order, RelaxedOrder> || !IsGuard<Guard> || works_in_passes<Guard>;

/// An argument of no kind, as compilers name it: `position` counts all arguments of the call
/// from 1.
template <std::size_t position, class Argument>
struct ArgumentIsNoPolicy : std::type_identity<Argument> {};

/// The first argument of no kind, where the policies begin at a position; else NoArgument.
struct NoArgument {};
template <std::size_t position, class Cost, class... Arguments>
struct FirstUnknown : std::type_identity<NoArgument> {};
template <std::size_t position, class Cost, class First, class... Rest>
struct FirstUnknown<position, Cost, First, Rest...>
    : std::conditional_t<kind_of<First, Cost>() == Kind::unknown,
                         std::type_identity<ArgumentIsNoPolicy<position, First>>,
                         FirstUnknown<position + 1, Cost, Rest...>> {};
template <std::size_t position, class Cost, class... Arguments>
using Unknown = typename FirstUnknown<position, CostOf<Cost, Arguments...>, Arguments...>::type;

/// The placement that a call uses; for OptimalPlacement, which pick_policies explains, one that
/// fits every cost.
template <class Cost, class Placement, class... Arguments>
struct PlacementFor {
  using Picked = decltype(pick<Kind::placement, Cost, Given<Placement, OptimalPlacement>>(
      std::declval<const Arguments&>()...));
  using type =
      std::conditional_t<std::is_same_v<Picked, OptimalPlacement>, MidpointPlacement, Picked>;
};
template <class Cost, class Placement, class... Arguments>
using PlacementOf =
    typename PlacementFor<CostOf<Cost, Arguments...>, Placement, Arguments...>::type;

template <class UnknownArgument>
concept AllAreKnown = std::is_same_v<UnknownArgument, NoArgument>;

/// The requirements of `simplify` on its arguments: each of them is known, and the placement fits
/// the cost.
template <class Cost, class Placement, class... Arguments>
concept Fitting =
    CostPolicy<CostOf<Cost, Arguments...>> && AllAreKnown<Unknown<0, Cost, Arguments...>> &&
    PlacementPolicy<PlacementOf<Cost, Placement, Arguments...>, CostOf<Cost, Arguments...>>;

/// The type-erased recorder of a call; empty if there is none.
template <class Cost, class... Arguments>
std::optional<RecorderHandle> pick_recorder([[maybe_unused]] const Arguments&... arguments) {
  std::optional<RecorderHandle> handle;
  if constexpr (count_of < Kind::recorder, Cost, Arguments... >> 0)
    if_given(pick<Kind::recorder, Cost, NotGiven, Arguments...>(arguments...),
             [&](const auto& into) { handle.emplace(*into.recorder); });
  return handle;
}

/// The topology of a call, if it is among the arguments.
template <class Cost, class... Arguments>
std::optional<Topology> pick_topology([[maybe_unused]] const Arguments&... arguments) {
  if constexpr (count_of < Kind::topology, Cost, Arguments... >> 0)
    return pick<Kind::topology, Cost, Topology>(arguments...);
  else
    return std::nullopt;
}

/// Adds what an argument of a kind does to an input before it is simplified, if it is given.
template <Kind kind, class Cost, class... Arguments>
void add_preparation([[maybe_unused]] Preparations<Cost::dimension>& preparations,
                     [[maybe_unused]] const Arguments&... arguments) {
  if constexpr (count_of < kind, Cost, Arguments... >> 0)
    if_given(pick<kind, Cost, NotGiven>(arguments...), [&](const auto& given) {
      validate(given);
      preparations.push_back(
          [given](SurfaceInput<Cost::dimension>& input) { given.prepare(input); });
    });
}

/// Returns these in their order: a surface is smooth before its planes are found.
template <class Cost, class... Arguments>
Preparations<Cost::dimension> pick_preparations(const Arguments&... arguments) {
  Preparations<Cost::dimension> preparations;
  add_preparation<Kind::voxels, Cost>(preparations, arguments...);
  add_preparation<Kind::planes, Cost>(preparations, arguments...);
  return preparations;
}

/// Rejects, at compile time, a call with two arguments where one is meant.
template <class CostArgument, class PlacementArgument, class Cost, class... Arguments>
constexpr void check_counts() {
  static_assert(count_of<Kind::cost, Cost, Arguments...> <= 1,
                "simplify takes one cost: pass only one.");
  static_assert(count_of<Kind::cost, Cost, Arguments...> == 0 ||
                    std::same_as<CostArgument, NotGiven>,
                "simplify takes one cost: pass it as a template argument or as a value, not both.");
  static_assert(count_of<Kind::placement, Cost, Arguments...> <= 1,
                "simplify takes one placement: pass only one.");
  static_assert(count_of<Kind::placement, Cost, Arguments...> == 0 ||
                    std::same_as<PlacementArgument, NotGiven>,
                "simplify takes one placement: pass it as a template argument or as a value, not "
                "both.");
  static_assert(count_of<Kind::pairs, Cost, Arguments...> <= 1,
                "simplify takes one pair policy: pass only one.");
  static_assert(
      count_of<Kind::stop, Cost, Arguments...> <= 1,
      "simplify takes one stop policy: combine several with AnyOf or AllOf. A lambda of a "
      "Status is a stop policy; a filter is a class with a member allows(contraction).");
  static_assert(count_of<Kind::order, Cost, Arguments...> <= 1,
                "simplify takes one order: pass only one.");
  static_assert(count_of<Kind::recorder, Cost, Arguments...> <= 1,
                "simplify takes one recorder: pass record_into only once.");
  static_assert(count_of<Kind::topology, Cost, Arguments...> <= 1,
                "simplify takes one Topology: pass only one.");
  static_assert(count_of<Kind::planes, Cost, Arguments...> <= 1,
                "simplify takes one KeepPlanes: pass only one.");
  static_assert(count_of<Kind::voxels, Cost, Arguments...> <= 1,
                "simplify takes one VoxelSize: pass only one.");
  static_assert(count_of<Kind::named_parameters, Cost, Arguments...> <= 1,
                "simplify takes one chain of named parameters: join them with a dot.");
}

inline namespace QUADRILLE_THREADING {

template <class Placement, class Cost>
constexpr void check_placement() {
  static_assert(PlacementPolicy<Placement, Cost>,
                "OptimalPlacement needs a cost with a minimizer, and this one has none: use "
                "MidpointPlacement or EndpointPlacement, as in "
                "simplify<EdgeLength, MidpointPlacement>(mesh).");
}

template <class Stop, class Cost>
constexpr void check_stop() {
  static_assert(
      !needs_of<Stop>().cost || has_cost_in_mesh_units<Cost>,
      "The stop policy needs costs in the mesh's units, which this ScaleFree cost does not "
      "have: give it a member degree(), see <quadrille/concepts.h>.");
}

template <class Order, class... Arguments>
constexpr void check_guards() {
  static_assert((suits_order<Arguments, Order> && ...),
                "A guard of this call needs GreedyOrder, since the blocks of a pass do not see "
                "each other: NoSelfIntersection, KeepSolid{}, or one without works_in_passes. "
                "Leave RelaxedOrder out.");
}

/// The policies of a call with a cost, a placement, and what it carries in addition to the shape.
template <class Cost, class Placement, class Carried>
using PoliciesOf =
    Policies<std::remove_const_t<Cost>, EnginePlacement<std::remove_const_t<Placement>>,
             std::remove_const_t<Carried>::has_channels>;

/// All policies of a call, checked for fitting together. Cost and placement may be template
/// arguments, or NotGiven.
template <class CostArgument, class PlacementArgument, class... Arguments>
auto pick_policies(const Arguments&... arguments) {
  using CGAL::parameters::get_parameter;
  using Cost = CostOf<CostArgument, Arguments...>;
  check_counts<CostArgument, PlacementArgument, Cost, Arguments...>();
  const auto placement =
      pick<Kind::placement, Cost, Given<PlacementArgument, OptimalPlacement>>(arguments...);
  check_placement<decltype(placement), Cost>();
  const auto cost = pick<Kind::cost, Cost, Given<CostArgument, Quadric>>(arguments...);
  const auto pairs = pick<Kind::pairs, Cost, EdgePairs>(arguments...);
  const auto stop = pick<Kind::stop, Cost, FaceRatio>(arguments...);
  const auto given_order = pick<Kind::order, Cost, GreedyOrder>(arguments...);
  using Order = std::remove_const_t<decltype(given_order)>;
  check_stop<Contained<decltype(stop)>, Cost>();
  validate_all(cost, placement, pairs, stop);
  const CallOrder order = call_order(given_order);
  check_guards<Order, Arguments...>();
  const auto guards = pick_guards<Cost>(arguments...);
  guards.require_greedy_order(order.passes.has_value());
  const auto carried = pick_carried<Cost>(arguments...);
  using Policies = PoliciesOf<decltype(cost), decltype(placement), decltype(carried)>;
  constexpr bool is_recorded = count_of<Kind::recorder, Cost, Arguments...> == 1;
  Policies policies{
      cost,
      typename Policies::Placement(placement),
      region_boundary_weight(carried),
      use_or_default<EdgePairs>(pairs, [](const auto& given) { return PairSource::of(given); }),
      use_or_default<FaceRatio>(stop, [](const auto& given) { return StopRule::of(given); }),
      order,
      store_visitor(get_parameter(pick_named(arguments...), CGAL::internal_np::visitor)),
      threads_here(order.threads()),
      pick_recorder<Cost>(arguments...),
      guards.topology_with(pick_topology<Cost>(arguments...)),
      pick_preparations<Cost>(arguments...),
      pick_filters<Cost>(arguments...),
      guards,
      optional_modules<Policies, Contained<decltype(stop)>, Contained<Order>, is_recorded>()};
  policies.threads.validate("quadrille::RelaxedOrder");
  return policies;
}

} // namespace QUADRILLE_THREADING

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_CALL_ARGUMENTS_H
