#ifndef QUADRILLE_INTERNAL_CALL_INTERSECTION_CHOICE_H
#define QUADRILLE_INTERNAL_CALL_INTERSECTION_CHOICE_H

#include <quadrille/internal/policy/orders.h>
#include <quadrille/order.h>
#include <quadrille/topology.h>

#include <concepts>
#include <optional>
#include <stdexcept>

namespace quadrille::internal {

/// Where faces may intersect as they like.
struct AnyIntersection {};

/// Is it NoSelfIntersection? That has a header of its own.
template <class T>
concept IsIntersection = requires(const T intersection) {
  { intersection.is_asked } -> std::convertible_to<bool>;
  &T::template make_check<3>;
};

/// Is it what keep_solid() makes? That has a header of its own, too.
template <class T>
concept IsSolid = IsIntersection<T> && requires(const T intersection) {
  { intersection.is_solid_asked } -> std::convertible_to<bool>;
};

/// The topology that a call keeps beside keep_solid(). Throws if it asks for another one.
template <class Intersection>
std::optional<Topology> topology_beside([[maybe_unused]] const Intersection& intersection,
                                        std::optional<Topology> topology) {
  if constexpr (IsSolid<Intersection>)
    if (intersection.is_solid_asked) {
      if (topology.value_or(Topology::kept) != Topology::kept)
        throw std::invalid_argument("quadrille::keep_solid keeps the topology: pass no "
                                    "Topology::free or Topology::parts_may_vanish beside it");
      return Topology::kept;
    }
  return topology;
}

/// Refuses an order in which faces cannot be kept apart, where that is asked for.
template <class Intersection, class Order>
void check_order([[maybe_unused]] const Intersection& intersection,
                 [[maybe_unused]] const Order& order) {
  if constexpr (!std::same_as<Intersection, AnyIntersection>) {
    static_assert(
        !std::same_as<Order, RelaxedOrder>,
        "NoSelfIntersection needs GreedyOrder, since the blocks of a pass do not see each "
        "other: leave RelaxedOrder out.");
    if (intersection.is_asked && has_passes(order))
      throw std::invalid_argument("quadrille::NoSelfIntersection needs GreedyOrder, since the "
                                  "blocks of a pass do not see each other");
  }
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CALL_INTERSECTION_CHOICE_H
