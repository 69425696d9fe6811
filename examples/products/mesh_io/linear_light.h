#ifndef QUADRILLE_EXAMPLES_LINEAR_LIGHT_H
#define QUADRILLE_EXAMPLES_LINEAR_LIGHT_H

#include <cmath>

namespace quadrille_examples {

/// From sRGB to linear light. Source: IEC 61966-2-1.
inline double linear_light(double x) {
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

/// The way back.
inline double srgb(double x) {
  return x <= 0.0031308 ? x * 12.92 : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

} // namespace quadrille_examples

#endif
