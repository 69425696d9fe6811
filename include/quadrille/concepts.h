#ifndef QUADRILLE_CONCEPTS_H
#define QUADRILLE_CONCEPTS_H

#include <quadrille/internal/policies.h>
#include <quadrille/report.h>
#include <quadrille/vector.h>

#include <concepts>
#include <cstddef>

namespace quadrille {

/// What does a vertex remember of the surface, and what does a target position cost?
template <class C>
concept CostPolicy = std::copy_constructible<C> &&
    requires(const C cost, typename C::Memory memory, const Vector<C::dimension> p) {
  requires std::semiregular<typename C::Memory>;
  {memory += memory};
  { cost.face(p, p, p) } -> std::convertible_to<typename C::Memory>;
  { cost(internal::PairOf<C>{}, p) } -> std::convertible_to<double>;
};

/// Where does the contracted vertex go?
template <class P, class Cost>
concept PlacementFor = CostPolicy<Cost> &&
    requires(const P placement, const Cost cost, const internal::PairOf<Cost> pair) {
  { placement(cost, pair) } -> std::convertible_to<Vector<Cost::dimension>>;
};

/// Is this enough?
template <class S>
concept StopPolicy = std::copy_constructible<S> && requires(const S stop, const Status status) {
  { stop(status) } -> std::convertible_to<bool>;
};

} // namespace quadrille

#endif // QUADRILLE_CONCEPTS_H
