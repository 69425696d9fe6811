#ifndef QUADRILLE_INTERNAL_POLICY_ORDERS_H
#define QUADRILLE_INTERNAL_POLICY_ORDERS_H

#include <quadrille/order.h>

#include <concepts>
#include <variant>

namespace quadrille::internal {

/// May an order be Which, for what its type tells?
template <class Which, class Order>
inline constexpr bool may_be = std::same_as<Order, Which> || std::same_as<Order, AnyOrder>;

/// An order if it is Which, else nullptr.
template <class Which, class Order>
const Which* order_if(const Order& order) {
  if constexpr (std::same_as<Order, Which>)
    return &order;
  else if constexpr (may_be<Which, Order>)
    return std::get_if<Which>(&order);
  else
    return nullptr;
}

/// Does it go in passes? They merge nothing before few faces are left.
template <class Order>
bool has_passes(const Order& order) {
  return order_if<RelaxedOrder>(order) != nullptr;
}

/// How many threads an order may use.
template <class Order>
unsigned threads_of(const Order& order) {
  const RelaxedOrder* const relaxed = order_if<RelaxedOrder>(order);
  return relaxed ? relaxed->threads : 1;
}

/// Throws std::invalid_argument for an order that makes no sense.
inline void validate(const AnyOrder& order) {
  if (const RelaxedOrder* const relaxed = order_if<RelaxedOrder>(order))
    relaxed->validate();
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_POLICY_ORDERS_H
