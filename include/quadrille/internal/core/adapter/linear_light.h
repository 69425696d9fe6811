#ifndef QUADRILLE_INTERNAL_CORE_ADAPTER_LINEAR_LIGHT_H
#define QUADRILLE_INTERNAL_CORE_ADAPTER_LINEAR_LIGHT_H

#include <cmath>

/// The transfer of sRGB: IEC 61966-2-1, 1999. Both are odd functions and inverse to one another.

namespace quadrille::internal {

inline double light_of_srgb(double x) {
  const double size = std::abs(x);
  return std::copysign(size <= 0.04045 ? size / 12.92 : std::pow((size + 0.055) / 1.055, 2.4), x);
}

inline double srgb_of_light(double x) {
  const double size = std::abs(x);
  return std::copysign(
      size <= 0.04045 / 12.92 ? 12.92 * size : 1.055 * std::pow(size, 1 / 2.4) - 0.055, x);
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ADAPTER_LINEAR_LIGHT_H
