#ifndef QUADRILLE_INTERNAL_CORE_CALL_ARGUMENT_KINDS_H
#define QUADRILLE_INTERNAL_CORE_CALL_ARGUMENT_KINDS_H

#include <quadrille/concepts.h>
#include <quadrille/internal/core/base/optional.h>
#include <quadrille/internal/core/call/carried.h>
#include <quadrille/internal/core/call/named_parameters.h>
#include <quadrille/internal/core/policy/guard_set.h>
#include <quadrille/internal/core/policy/orders.h>
#include <quadrille/placement.h>
#include <quadrille/recorded.h>
#include <quadrille/topology.h>

#include <concepts>
#include <type_traits>

/// What an argument of `simplify` is, by the concept that it models; of a std::optional, what it
/// holds.

namespace quadrille::internal {

enum class Kind {
  cost,
  placement,
  pairs,
  stop,
  order,
  filter,
  topology,
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

/// Is a type meant to be a cost? Nothing else has these members.
template <class T>
concept LooksLikeCost = requires {
  typename T::Memory;
}
|| requires {
  T::dimension;
};

/// Is a type meant to be a placement? What it gives for a pair is something, if not a position.
template <class T, class Cost>
concept LooksLikePlacement = requires(const T placement,
                                      const typename SeenByPlacement<T, Cost>::Costs cost,
                                      const typename SeenByPlacement<T, Cost>::Pair pair) {
  requires !std::is_void_v<decltype(placement(cost, pair))>;
};

/// The kind of a std::optional of an argument of that kind. What a call is compiled for is told by
/// types, and so it is there or not.
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

/// The kind of an argument beside such a cost. Each concept is asked only if the argument is of no
/// kind before it: to ask what a call results in instantiates the body of a user's function. An
/// OptimalPlacement is one beside every cost, so that pick_policies can say what to do.
template <class T, class Cost>
constexpr Kind kind_of() {
  if constexpr (IsOptional<T>)
    return kind_if_optional(kind_of<Held<T>, Cost>());
  else if constexpr (IsNamedParameters<T>::value)
    return Kind::named_parameters;
  else if constexpr (std::same_as<T, Topology>)
    return Kind::topology;
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

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_CALL_ARGUMENT_KINDS_H
