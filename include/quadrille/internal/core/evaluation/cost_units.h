#ifndef QUADRILLE_INTERNAL_CORE_EVALUATION_COST_UNITS_H
#define QUADRILLE_INTERNAL_CORE_EVALUATION_COST_UNITS_H

#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/surface/scale.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace quadrille::internal {

/// The exponent of 2 that turns keys into costs in the mesh's units: see
/// PairEvaluator::key_of_cost. It is 0 for a scale-free cost that does not state its degree.
template <class Cost, std::size_t N>
double key_exponent([[maybe_unused]] const Cost& cost, const Scale<N>& scale) {
  if constexpr (!is_scale_free<Cost>)
    return -2.0 * scale.exponent();
  else if constexpr (CountsDegree<Cost>)
    return -static_cast<double>(cost.degree()) * scale.exponent();
  else
    return 0;
}

/// By what keys are multiplied to be costs in the mesh's units: the same bits with any C library,
/// if the degree of the cost is a multiple of 1/2.
template <class Cost, std::size_t N>
double cost_of_key(const Cost& cost, const Scale<N>& scale) {
  const double exponent = key_exponent(cost, scale), whole = std::floor(exponent);
  const double rest = exponent - whole;
  const double factor = rest == 0 ? 1 : rest == 0.5 ? std::numbers::sqrt2 : std::exp2(rest);
  return std::clamp(std::ldexp(factor, static_cast<int>(whole)),
                    (std::numeric_limits<double>::min)(), (std::numeric_limits<double>::max)());
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_EVALUATION_COST_UNITS_H
