#ifndef QUADRILLE_INTERNAL_CORE_BASE_POWER_OF_TWO_H
#define QUADRILLE_INTERNAL_CORE_BASE_POWER_OF_TWO_H

#include <cmath>

namespace quadrille::internal {

/// Multiplies by 2^exponent, which itself may be out of range: in two steps.
class PowerOfTwo {
public:
  explicit PowerOfTwo(int exponent)
      : first_(std::ldexp(1.0, exponent / 2)), second_(std::ldexp(1.0, exponent - exponent / 2)) {}

  double operator()(double x) const { return x * first_ * second_; }

private:
  double first_, second_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_BASE_POWER_OF_TWO_H
