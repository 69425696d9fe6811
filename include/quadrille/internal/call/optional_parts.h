#ifndef QUADRILLE_INTERNAL_CALL_OPTIONAL_PARTS_H
#define QUADRILLE_INTERNAL_CALL_OPTIONAL_PARTS_H

#include <quadrille/internal/call/intersection_choice.h>
#include <quadrille/internal/call/normal_choice.h>
#include <quadrille/internal/contraction/distance_check.h>
#include <quadrille/internal/contraction/recorder_teller.h>
#include <quadrille/internal/order/relaxed_passes.h>
#include <quadrille/internal/policy/engine_policies.h>
#include <quadrille/internal/policy/policies.h>
#include <quadrille/order.h>

#include <concepts>

namespace quadrille::internal {

/// The functions of the parts that a call may need, for what its types tell.
template <class Policies, class Stop, class Order, bool is_recorded, class Intersection,
          class NormalLimit>
OptionalParts<Policies> optional_parts([[maybe_unused]] const Intersection& intersection,
                                       [[maybe_unused]] const NormalLimit& normal_limit) {
  OptionalParts<Policies> parts;
  if constexpr (!std::same_as<Order, GreedyOrder>)
    parts.run_passes = &run_passes<Policies>;
  if constexpr (is_recorded)
    parts.make_recording = &make_recording<Policies>;
  if constexpr (needs_of<Stop>().distance)
    parts.distances = distance_calls<Policies, needs_of<Stop>().distance_back>();
  if constexpr (!std::same_as<Intersection, AnyIntersection>)
    if (intersection.is_asked)
      parts.make_intersection_check = &Intersection::template make_check<Policies::Cost::dimension>;
  if constexpr (!std::same_as<NormalLimit, AnyNormals>) {
    normal_limit.validate();
    if (normal_limit.degrees < 180) {
      parts.make_normal_check = &NormalLimit::template make_normal_check<Policies::Cost::dimension>;
      parts.normal_degrees = normal_limit.degrees;
    }
  }
  if constexpr (IsSolid<Intersection>)
    if (intersection.is_solid_asked)
      parts.require_solid = &Intersection::template require_solid<WorkingSurface<Policies>>;
  return parts;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CALL_OPTIONAL_PARTS_H
