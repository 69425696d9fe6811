#ifndef QUADRILLE_INTERNAL_CORE_BASE_SAFE_LENGTH_H
#define QUADRILLE_INTERNAL_CORE_BASE_SAFE_LENGTH_H

#include <algorithm>
#include <cmath>

namespace quadrille::internal {

/// √(x² + y² + z²), where squares may over- or underflow: as std::hypot, but with the same bits
/// whatever the standard library.
inline double safe_length(double x, double y, double z) {
  const double largest = (std::max)({std::abs(x), std::abs(y), std::abs(z)});
  if (!(largest > 0))
    return 0;
  const double a = x / largest, b = y / largest, c = z / largest;
  return largest * std::sqrt(a * a + b * b + c * c);
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_BASE_SAFE_LENGTH_H
