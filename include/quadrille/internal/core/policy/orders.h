#ifndef QUADRILLE_INTERNAL_CORE_POLICY_ORDERS_H
#define QUADRILLE_INTERNAL_CORE_POLICY_ORDERS_H

#include <quadrille/order.h>

#include <concepts>
#include <optional>
#include <variant>

namespace quadrille::internal {

template <class T>
inline constexpr bool is_order = std::same_as<T, GreedyOrder> || std::same_as<T, RelaxedOrder> ||
                                 std::same_as<T, std::variant<GreedyOrder, RelaxedOrder>>;

/// How passes go: see RelaxedOrder.
struct PassSettings {
  double share;
  bool refresh;
  unsigned threads;
};

/// The order of a call: greedy, after passes if there are any.
struct CallOrder {
  std::optional<PassSettings> passes = {};

  /// How many threads it may use.
  unsigned threads() const { return passes ? passes->threads : 1; }
};

/// An order as the engine has it. Throws std::invalid_argument for one that makes no sense. A
/// RelaxedOrder is known where it is passed: see <quadrille/relaxed_order.h>.
inline CallOrder call_order(const GreedyOrder&) {
  return {};
}
template <std::same_as<RelaxedOrder> Relaxed>
CallOrder call_order(const Relaxed& relaxed) {
  relaxed.validate();
  return {PassSettings{relaxed.share, relaxed.refresh, relaxed.threads}};
}
template <class... Orders>
CallOrder call_order(const std::variant<Orders...>& order) {
  return std::visit([](const auto& chosen) { return call_order(chosen); }, order);
}
template <class Order>
CallOrder call_order(const std::optional<Order>& order) {
  return order ? call_order(*order) : CallOrder{};
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_POLICY_ORDERS_H
