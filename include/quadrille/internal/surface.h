#ifndef QUADRILLE_INTERNAL_SURFACE_H
#define QUADRILLE_INTERNAL_SURFACE_H

#include <quadrille/internal/triangle_complex.h>
#include <quadrille/vector.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace quadrille::internal {

/// What an adapter reads: positions (and attributes), triangles, constraints.
template <std::size_t N>
struct SurfaceInput {
  std::vector<Vector<N>> positions;
  std::vector<TriangleComplex::Triangle> triangles;
};

template <std::size_t N>
void require_finite(const std::vector<Vector<N>>& positions) {
  for (std::size_t v = 0; v < positions.size(); ++v)
    if (!is_finite(positions[v]))
      throw std::invalid_argument("quadrille::simplify: vertex " + std::to_string(v) +
                                  " is not finite");
}

/// A change of the unit of length by a power of two, which is exact both ways: the engine works on
/// a surface of a fixed size, so that no product of lengths over- or underflows, whatever the
/// mesh's unit.
class LengthUnit {
public:
  LengthUnit() = default;

  template <std::size_t N>
  explicit LengthUnit(const std::vector<Vector<N>>& positions) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Vector<3> low{{infinity, infinity, infinity}}, high = -1.0 * low;
    for (const Vector<N>& p : positions)
      for (std::size_t i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], p[i]);
        high[i] = std::max(high[i], p[i]);
      }
    if (positions.empty())
      return;
    const Vector<3> half = 0.5 * high - 0.5 * low; // halves first: their difference can't overflow
    const double extent = *std::max_element(half.coordinates.begin(), half.coordinates.end());
    if (!(extent > 0))
      return;
    exponent_ = size_exponent - std::ilogb(extent);
    diagonal_ = 2 * std::hypot(half[0], half[1], half[2]);
  }

  template <std::size_t N>
  void scale(std::vector<Vector<N>>& positions) const {
    // In two steps: 2^exponent itself can be out of range.
    const double first = std::ldexp(1.0, exponent_ / 2);
    const double second = std::ldexp(1.0, exponent_ - exponent_ / 2);
    for (Vector<N>& p : positions)
      for (std::size_t i = 0; i < 3; ++i)
        p[i] = p[i] * first * second;
  }

  /// A length or coordinate of the engine, in the mesh's unit.
  double in_mesh_units(double length) const { return std::ldexp(length, -exponent_); }

  double diagonal() const { return diagonal_; } ///< of the bounding box, in the mesh's unit

private:
  // With an extent of about 2^20 a cost, an area times a squared distance, is at most about 2^80,
  // and a float holds costs down to 2^-226 of that.
  static constexpr int size_exponent = 20;

  int exponent_ = 0;
  double diagonal_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_SURFACE_H
