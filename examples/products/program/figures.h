#ifndef QUADRILLE_EXAMPLES_PROGRAM_FIGURES_H
#define QUADRILLE_EXAMPLES_PROGRAM_FIGURES_H

/// \file
/// Numbers as people read them.

#include <cmath>
#include <cstddef>
#include <iomanip>
#include <sstream>
#include <string>

namespace quadrille_examples {

/// 69,451
inline std::string with_commas(std::size_t n) {
  std::string digits = std::to_string(n);
  for (std::size_t i = digits.size(); i > 3;)
    digits.insert(i -= 3, 1, ',');
  return digits;
}

/// Of two significant digits.
inline std::string two_digits(double x) {
  std::ostringstream out;
  out.precision(2);
  if (std::abs(x) >= 10)
    out << std::fixed << std::setprecision(0);
  out << x;
  return out.str();
}

/// The next number of two significant digits that is not below x, as bounds are told.
inline double rounded_up(double x) {
  if (!(x > 0))
    return x;
  const double unit = std::pow(10, std::floor(std::log10(x)) - 1);
  return std::ceil(x / unit * (1 - 1e-12)) * unit;
}

/// A part of something: 1.4 %
inline std::string percent_text(double part) {
  return two_digits(100 * part) + " %";
}

/// 48 ms, 1.2 s, 3 min
inline std::string duration_text(double seconds) {
  if (seconds < 0.9995)
    return two_digits(1000 * seconds) + " ms";
  return seconds < 120 ? two_digits(seconds) + " s" : two_digits(seconds / 60) + " min";
}

} // namespace quadrille_examples

#endif
