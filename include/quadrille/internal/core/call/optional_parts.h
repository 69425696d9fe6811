#ifndef QUADRILLE_INTERNAL_CORE_CALL_OPTIONAL_PARTS_H
#define QUADRILLE_INTERNAL_CORE_CALL_OPTIONAL_PARTS_H

#include <quadrille/internal/core/policy/engine_policies.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/order.h>

#include <concepts>
#include <type_traits>

namespace quadrille::internal {

struct DistanceHeader;

/// Has <quadrille/distance_limits.h> been included?
template <class Policies>
concept HasDistanceHeader = requires {
  sizeof(std::conditional_t<std::is_void_v<Policies>, Policies, DistanceHeader>);
};

/// The functions of the parts that a call may need, for what its types tell.
template <class Policies, class Stop, class Order, bool is_recorded>
OptionalParts<Policies> optional_parts() {
  OptionalParts<Policies> parts;
  if constexpr (!std::same_as<Order, GreedyOrder>)
    parts.run_passes = &run_passes<Policies>;
  if constexpr (is_recorded)
    parts.make_recording = &make_recording<Policies>;
  if constexpr (needs_of<Stop>().distance) {
    static_assert(HasDistanceHeader<Policies>,
                  "The stop policy needs distances: include <quadrille/distance_limits.h>.");
    parts.make_distances = &make_distances<Policies, needs_of<Stop>().distance_back>;
  }
  return parts;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_CALL_OPTIONAL_PARTS_H
