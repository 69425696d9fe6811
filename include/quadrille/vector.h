#ifndef QUADRILLE_VECTOR_H
#define QUADRILLE_VECTOR_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/unrolled.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace quadrille {

/// A point or displacement of N real coordinates: three of space, then N − 3 attributes.
/// An aggregate of doubles; components are read and written with `v[i]`. Inside of the library a
/// scalar may stand for two numbers that are computed with at once.
template <std::size_t N, class Scalar = double>
struct Vector {
  std::array<Scalar, N> coordinates{}; ///< x, y, z; then attributes

  constexpr Scalar& operator[](std::size_t i) { return coordinates[i]; } ///< coordinate i, from 0
  /// Coordinate i, from 0.
  constexpr Scalar operator[](std::size_t i) const { return coordinates[i]; }

  /// The sum, coordinate by coordinate.
  QUADRILLE_ALWAYS_INLINE constexpr Vector& operator+=(const Vector& other) {
    internal::unrolled<N>([&](std::size_t i)
                              QUADRILLE_ALWAYS_INLINE_LAMBDA { coordinates[i] += other[i]; });
    return *this;
  }
  /// The difference, coordinate by coordinate.
  QUADRILLE_ALWAYS_INLINE constexpr Vector& operator-=(const Vector& other) {
    internal::unrolled<N>([&](std::size_t i)
                              QUADRILLE_ALWAYS_INLINE_LAMBDA { coordinates[i] -= other[i]; });
    return *this;
  }
  /// Multiplies each coordinate.
  QUADRILLE_ALWAYS_INLINE constexpr Vector& operator*=(Scalar factor) {
    internal::unrolled<N>([&](std::size_t i)
                              QUADRILLE_ALWAYS_INLINE_LAMBDA { coordinates[i] *= factor; });
    return *this;
  }
  /// The sum.
  QUADRILLE_ALWAYS_INLINE friend constexpr Vector operator+(Vector a, const Vector& b) {
    return a += b;
  }
  /// The difference.
  QUADRILLE_ALWAYS_INLINE friend constexpr Vector operator-(Vector a, const Vector& b) {
    return a -= b;
  }
  /// The opposite.
  QUADRILLE_ALWAYS_INLINE friend constexpr Vector operator-(Vector a) {
    internal::unrolled<N>([&](std::size_t i) QUADRILLE_ALWAYS_INLINE_LAMBDA { a[i] = -a[i]; });
    return a;
  }
  /// The multiple.
  QUADRILLE_ALWAYS_INLINE friend constexpr Vector operator*(Scalar factor, Vector a) {
    return a *= factor;
  }
  /// To the last bit, but that 0 is −0.
  friend constexpr bool operator==(const Vector&, const Vector&) = default;
};

/// The scalar product.
template <std::size_t N, class Scalar>
QUADRILLE_ALWAYS_INLINE constexpr Scalar dot(const Vector<N, Scalar>& a,
                                             const Vector<N, Scalar>& b) {
  static_assert(N > 0);
  Scalar sum = a[0] * b[0]; // not from 0: x + 0 is an addition that no compiler may leave out
  internal::unrolled<N - 1>([&](std::size_t i)
                                QUADRILLE_ALWAYS_INLINE_LAMBDA { sum += a[i + 1] * b[i + 1]; });
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
  const Vector<3> normal = double_area_vector(p, q, r); // inlined: no load is wider than its store
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
