#ifndef QUADRILLE_EXAMPLES_MESH_IO_NAMED_NUMBERS_H
#define QUADRILLE_EXAMPLES_MESH_IO_NAMED_NUMBERS_H

/// \file
/// Numbers of vertices or faces that a file gives names to, as the scalar properties of PLY.

#include <quadrille/internal/file/ply_header.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace quadrille_examples {

/// A type of numbers in a file. `double` holds every value of each.
using NumberType = quadrille::internal::PlyType;

/// A number of each vertex, or of each face.
struct NamedNumbers {
  std::string name;
  NumberType type;
  std::vector<double> values;

  /// Do any two? What is no number differs from any.
  bool differ() const {
    return std::any_of(values.begin(), values.end(), [&](double x) { return x != values[0]; });
  }
};

/// The finite number of single precision next to one.
inline float nearest_float(double x) {
  constexpr double greatest = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(x, -greatest, greatest));
}

/// The value of a type next to a number. What is no number, or infinite, is of each type that is
/// not of integers.
inline double nearest_of(const NumberType& type, double x) {
  if (type.is_integer) {
    const int bits = 8 * static_cast<int>(type.size) - (type.is_signed ? 1 : 0);
    const double greatest = std::ldexp(1., bits) - 1;
    return std::clamp(std::round(x), type.is_signed ? -greatest - 1 : 0., greatest);
  }
  if (type.size == 8 || !std::isfinite(x))
    return x;
  return nearest_float(x);
}

/// Makes the numbers some of their types; a text may hold others. Returns how many integers were
/// out of range.
inline std::size_t mend_numbers(std::vector<NamedNumbers>& columns) {
  std::size_t out_of_range = 0;
  for (NamedNumbers& column : columns)
    for (double& value : column.values) {
      const double before = value;
      value = nearest_of(column.type, value);
      out_of_range += column.type.is_integer && value != before;
    }
  return out_of_range;
}

} // namespace quadrille_examples

#endif
