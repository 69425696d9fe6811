#ifndef QUADRILLE_INTERNAL_CALL_OPTIONAL_PARTS_H
#define QUADRILLE_INTERNAL_CALL_OPTIONAL_PARTS_H

#include <quadrille/internal/contraction/distance_check.h>
#include <quadrille/internal/contraction/recorder_teller.h>
#include <quadrille/internal/order/relaxed_passes.h>
#include <quadrille/internal/policy/engine_policies.h>
#include <quadrille/internal/policy/policies.h>
#include <quadrille/order.h>

#include <concepts>

namespace quadrille::internal {

/// The functions of the parts that a call may need, for what its types tell.
template <class Policies, class Stop, class Order, bool is_recorded>
OptionalParts<Policies> optional_parts() {
  OptionalParts<Policies> parts;
  if constexpr (!std::same_as<Order, GreedyOrder>)
    parts.run_passes = &run_passes<Policies>;
  if constexpr (is_recorded)
    parts.make_recording = &make_recording<Policies>;
  if constexpr (needs_of<Stop>().distance)
    parts.distances = distance_calls<Policies, needs_of<Stop>().distance_back>();
  return parts;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CALL_OPTIONAL_PARTS_H
