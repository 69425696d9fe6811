#ifndef QUADRILLE_VECTOR_H
#define QUADRILLE_VECTOR_H

#include <quadrille/internal/base/compiler.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace quadrille {

/// A point or displacement of N real coordinates: three of space, then N − 3 attributes.
/// An aggregate of doubles; components are read and written with `v[i]`.
template <std::size_t N>
struct Vector {
  std::array<double, N> coordinates{}; ///< x, y, z; then attributes

  constexpr double& operator[](std::size_t i) { return coordinates[i]; } ///< coordinate i, from 0
  /// Coordinate i, from 0.
  constexpr double operator[](std::size_t i) const { return coordinates[i]; }

  /// The sum, coordinate by coordinate.
  constexpr Vector& operator+=(const Vector& other) {
    for (std::size_t i = 0; i < N; ++i)
      coordinates[i] += other[i];
    return *this;
  }
  /// The difference, coordinate by coordinate.
  constexpr Vector& operator-=(const Vector& other) {
    for (std::size_t i = 0; i < N; ++i)
      coordinates[i] -= other[i];
    return *this;
  }
  /// Multiplies each coordinate.
  constexpr Vector& operator*=(double factor) {
    for (std::size_t i = 0; i < N; ++i)
      coordinates[i] *= factor;
    return *this;
  }
  friend constexpr Vector operator+(Vector a, const Vector& b) { return a += b; } ///< the sum
  /// The difference.
  friend constexpr Vector operator-(Vector a, const Vector& b) { return a -= b; }
  /// The multiple.
  friend constexpr Vector operator*(double factor, Vector a) { return a *= factor; }
  /// To the last bit, but that 0 is −0.
  friend constexpr bool operator==(const Vector&, const Vector&) = default;
};

/// The scalar product.
template <std::size_t N>
QUADRILLE_ALWAYS_INLINE constexpr double dot(const Vector<N>& a, const Vector<N>& b) {
  static_assert(N > 0);
  double sum = a[0] * b[0]; // not from 0: x + 0 is an addition that no compiler may leave out
  for (std::size_t i = 1; i < N; ++i)
    sum += a[i] * b[i];
  return sum;
}

/// The square of the length.
template <std::size_t N>
QUADRILLE_ALWAYS_INLINE constexpr double squared_length(const Vector<N>& a) {
  return dot(a, a);
}

/// The square of the distance.
template <std::size_t N>
QUADRILLE_ALWAYS_INLINE constexpr double squared_distance(const Vector<N>& a, const Vector<N>& b) {
  return squared_length(a - b);
}

/// The vector product.
constexpr Vector<3> cross(const Vector<3>& a, const Vector<3>& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

/// Twice the area vector of the triangle pqr: its length is twice the area, its direction the
/// normal.
QUADRILLE_ALWAYS_INLINE constexpr Vector<3>
double_area_vector(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) {
  return cross(q - p, r - p);
}

/// The same, but zero, no normal, if the three points lie on a line up to the rounding of their
/// coordinates. A triangle higher than a millionth of its length has one, however few bits tell it.
QUADRILLE_ALWAYS_INLINE constexpr Vector<3> normal_vector(const Vector<3>& p, const Vector<3>& q,
                                                          const Vector<3>& r) {
  const Vector<3> normal = double_area_vector(p, q, r);
  const double edges = squared_distance(p, q) + squared_distance(p, r);
  if (squared_length(normal) > 0x1p-40 * edges * edges)
    return normal;
  const double sizes = squared_length(p) + squared_length(q) + squared_length(r);
  return squared_length(normal) > 0x1p-102 * sizes * edges ? normal : Vector<3>{};
}

/// Is each coordinate finite?
template <std::size_t N>
bool is_finite(const Vector<N>& a) {
  double sum = 0;
  for (double x : a.coordinates)
    sum += x - x; // 0 for a finite x, NaN for any other
  return sum == 0;
}

/// The three coordinates of space of a position with attributes.
template <std::size_t N>
constexpr Vector<3> space(const Vector<N>& a) {
  return {{a[0], a[1], a[2]}};
}

/// A position itself: nothing is copied where there are no attributes.
constexpr const Vector<3>& space(const Vector<3>& a) {
  return a;
}

} // namespace quadrille

#endif // QUADRILLE_VECTOR_H
