#ifndef QUADRILLE_INTERNAL_DIAGNOSTICS_H
#define QUADRILLE_INTERNAL_DIAGNOSTICS_H

#include <quadrille/concepts.h>
#include <quadrille/internal/arguments.h>
#include <quadrille/placement.h>
#include <quadrille/quadric.h>
#include <quadrille/report.h>

#include <type_traits>

/// Overloads of `simplify` that are never chosen. Where an argument is no policy, the compiler
/// tells for each of them which concept the argument does not model, and which expression it lacks.

namespace quadrille {

namespace internal {

struct NoArgument {};

/// The first argument that is none of `simplify`, or NoArgument.
template <class Cost, class... Arguments>
struct FirstUnknown {
  using type = NoArgument;
};
template <class Cost, class First, class... Rest>
struct FirstUnknown<Cost, First, Rest...>
    : std::conditional_t<is_argument<First, Cost>, FirstUnknown<Cost, Rest...>,
                         std::type_identity<First>> {};

template <class Cost, class... Arguments>
using Unknown = typename FirstUnknown<CostOf<Cost, Arguments...>, Arguments...>::type;

/// Was a type meant to be a cost? Then the other concepts need not be named.
template <class T>
concept MeantAsCost = requires {
  typename T::Memory;
}
|| requires {
  T::dimension;
};
template <class T>
concept MeantAsAnother = !MeantAsCost<T> && !std::same_as<T, NoArgument>;

} // namespace internal

template <class Cost = Quadric, class Placement = OptimalPlacement, class Mesh, class... Arguments,
          class Argument = internal::Unknown<Cost, Arguments...>>
requires internal::MeantAsCost<Argument> && CostPolicy<Argument>
    Report simplify(Mesh&, const Arguments&...)
= delete;

template <class Cost = Quadric, class Placement = OptimalPlacement, class Mesh, class... Arguments,
          class Argument = internal::Unknown<Cost, Arguments...>>
requires internal::MeantAsAnother<Argument> && PlacementPolicy<Argument, Cost>
    Report simplify(Mesh&, const Arguments&...)
= delete;

template <class Cost = Quadric, class Placement = OptimalPlacement, class Mesh, class... Arguments,
          class Argument = internal::Unknown<Cost, Arguments...>>
requires internal::MeantAsAnother<Argument> && PairPolicy<Argument>
    Report simplify(Mesh&, const Arguments&...)
= delete;

template <class Cost = Quadric, class Placement = OptimalPlacement, class Mesh, class... Arguments,
          class Argument = internal::Unknown<Cost, Arguments...>>
requires internal::MeantAsAnother<Argument> && StopPolicy<Argument>
    Report simplify(Mesh&, const Arguments&...)
= delete;

template <class Cost = Quadric, class Placement = OptimalPlacement, class Mesh, class... Arguments,
          class Argument = internal::Unknown<Cost, Arguments...>>
requires internal::MeantAsAnother<Argument> && FilterPolicy<Argument, Cost>
    Report simplify(Mesh&, const Arguments&...)
= delete;

} // namespace quadrille

#endif // QUADRILLE_INTERNAL_DIAGNOSTICS_H
