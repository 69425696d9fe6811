#ifndef QUADRILLE_INTERNAL_POLICY_ORDERS_H
#define QUADRILLE_INTERNAL_POLICY_ORDERS_H

#include <quadrille/order.h>

#include <concepts>
#include <optional>
#include <variant>

namespace quadrille::internal {

template <class T>
inline constexpr bool is_order =
    std::same_as<T, GreedyOrder> || std::same_as<T, RelaxedOrder> || std::same_as<T, AnyOrder>;

/// An order that may be given; greedy order where none is.
template <class Order>
Order given_order(const Order& order) {
  return order;
}
template <class Order>
AnyOrder given_order(const std::optional<Order>& order) {
  return order ? AnyOrder(*order) : AnyOrder(GreedyOrder{});
}

/// Does it go in passes? They merge nothing before few faces are left.
inline bool has_passes(const AnyOrder& order) {
  return std::holds_alternative<RelaxedOrder>(order);
}

/// How many threads an order may use.
inline unsigned threads_of(const AnyOrder& order) {
  const auto* const relaxed = std::get_if<RelaxedOrder>(&order);
  return relaxed ? relaxed->threads : 1;
}

/// Throws std::invalid_argument for an order that makes no sense.
inline void validate(const AnyOrder& order) {
  if (const auto* const relaxed = std::get_if<RelaxedOrder>(&order))
    relaxed->validate();
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_POLICY_ORDERS_H
