#ifndef QUADRILLE_INTERNAL_CORE_ORDER_COST_STOP_H
#define QUADRILLE_INTERNAL_CORE_ORDER_COST_STOP_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/contraction/working_surface.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/report.h>

#include <bit>
#include <cstdint>
#include <limits>

namespace quadrille::internal {

/// Reports costs to a stop policy that asks for them; does nothing for any other.
template <class Policies>
class CostStop {
public:
  explicit CostStop(WorkingSurface<Policies>& surface)
      : surface_(surface), is_asking_(surface.policies().stop.needs().cost) {
    announce_none();
  }

  bool is_asking() const { return is_asking_; }

  /// Announces the key of the next contraction.
  void announce(double key) {
    if (is_asking_) [[unlikely]]
      surface_.progress().announce_cost(surface_.evaluator().cost_of_mesh(key));
  }
  /// Does the stop policy stop at what comes next, of that key, by whatever it asks for?
  QUADRILLE_ALWAYS_INLINE bool is_enough_at(double key) {
    announce(key);
    return surface_.progress().is_enough();
  }
  /// Nothing comes next whose cost is known: the policy is asked about the surface.
  void announce_none() {
    if (is_asking_)
      surface_.progress().announce_cost(0);
  }
  /// Nothing comes next at all: that costs more than anything.
  void announce_end() {
    if (is_asking_)
      surface_.progress().announce_cost(std::numeric_limits<double>::infinity());
  }

  /// Does it stop at a key?
  bool is_beyond(double key) const {
    Status status = surface_.status();
    status.next_cost = surface_.evaluator().cost_of_mesh(key);
    return surface_.policies().stop(status);
  }
  /// Does it stop at the contraction that comes next, and not at one that costs nothing?
  bool is_stop_by_cost() const {
    return is_asking_ && surface_.progress().is_enough() && !is_beyond(0);
  }

  /// The greatest key at which it does not stop, the surface being as it is; infinity if there is
  /// no limit. It is asked 32 times.
  float limit() const {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    if (!is_asking_ || !is_stop_at(infinity))
      return infinity;
    std::uint32_t allowed = 0, rejected = std::bit_cast<std::uint32_t>(infinity);
    while (rejected - allowed > 1) { // floats that are not negative lie as their bits do
      const std::uint32_t middle = allowed + (rejected - allowed) / 2;
      (is_stop_at(std::bit_cast<float>(middle)) ? rejected : allowed) = middle;
    }
    return std::bit_cast<float>(allowed);
  }

private:
  bool is_stop_at(float key) const { return is_beyond(static_cast<double>(key)); }

  WorkingSurface<Policies>& surface_;
  const bool is_asking_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ORDER_COST_STOP_H
