#ifndef QUADRILLE_INTERNAL_CALL_DIAGNOSTICS_H
#define QUADRILLE_INTERNAL_CALL_DIAGNOSTICS_H

#include <quadrille/concepts.h>
#include <quadrille/internal/call/arguments.h>

/// Overloads of `simplify` that are never chosen. Where an argument is none that `simplify` knows,
/// the compiler tells for each of them which concept the argument does not model, and what it
/// lacks.

namespace quadrille {

template <class Cost = internal::NotGiven, class Placement = internal::NotGiven, class Surface,
          class... Arguments, class Argument = internal::Unknown<Cost, Arguments...>>
requires PlacementPolicy<Argument, internal::CostOf<Cost, Arguments...>>
void simplify(Surface&, const Arguments&...) = delete;

template <class Cost = internal::NotGiven, class Placement = internal::NotGiven, class Surface,
          class... Arguments, class Argument = internal::Unknown<Cost, Arguments...>>
requires PairPolicy<Argument>
void simplify(Surface&, const Arguments&...) = delete;

template <class Cost = internal::NotGiven, class Placement = internal::NotGiven, class Surface,
          class... Arguments, class Argument = internal::Unknown<Cost, Arguments...>>
requires StopPolicy<Argument>
void simplify(Surface&, const Arguments&...) = delete;

template <class Cost = internal::NotGiven, class Placement = internal::NotGiven, class Surface,
          class... Arguments, class Argument = internal::Unknown<Cost, Arguments...>>
requires FilterPolicy<Argument, internal::CostOf<Cost, Arguments...>>
void simplify(Surface&, const Arguments&...) = delete;

/// A constant mesh would otherwise be taken by CGAL::simplify(x), which is found beside ours.
template <class Mesh>
requires requires(const Mesh& mesh) {
  halfedges(mesh);
}
void simplify(const Mesh&) = delete; // a constant mesh cannot be simplified

} // namespace quadrille

#endif // QUADRILLE_INTERNAL_CALL_DIAGNOSTICS_H
