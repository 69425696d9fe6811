#ifndef QUADRILLE_INTERNAL_CORE_ORDER_PASS_STOP_H
#define QUADRILLE_INTERNAL_CORE_ORDER_PASS_STOP_H

#include <quadrille/internal/core/contraction/working_surface.h>
#include <quadrille/report.h>

namespace quadrille::internal {

/// Does the stop policy stop at a contraction in a pass, while others may be done beside it?
template <class Policies>
bool is_stop_in_pass(const WorkingSurface<Policies>& surface,
                     typename WorkingSurface<Policies>::Contraction& contraction) {
  Status status = surface.status();
  status.next_error = contraction.error();
  const auto& stop = surface.policies().stop;
  if (stop.needs().cost)
    status.next_cost = surface.evaluator().cost_of_mesh(contraction.key());
  if (!stop.needs().distance)
    return stop(status);
  status.next_distance = 0;
  if (stop.needs().distance_back)
    status.next_distance_back = 0;
  if (stop.needs().tolerance)
    status.next_tolerance = 0;
  return stop(status) || surface.distances()->is_too_far(contraction, status);
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ORDER_PASS_STOP_H
