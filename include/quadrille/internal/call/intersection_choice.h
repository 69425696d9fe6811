#ifndef QUADRILLE_INTERNAL_CALL_INTERSECTION_CHOICE_H
#define QUADRILLE_INTERNAL_CALL_INTERSECTION_CHOICE_H

#include <quadrille/internal/policy/orders.h>
#include <quadrille/order.h>

#include <concepts>
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
