#ifndef QUADRILLE_SYMMETRIC_MATRIX_H
#define QUADRILLE_SYMMETRIC_MATRIX_H

#include <quadrille/internal/core/base/lanes.h>
#include <quadrille/vector.h>

#include <array>
#include <concepts>
#include <cstddef>

namespace quadrille {

/// A symmetric N × N matrix, kept as its lower triangle: N(N+1)/2 doubles. See Vector for scalars.
template <std::size_t N, class Scalar = double>
class SymmetricMatrix {
public:
  constexpr SymmetricMatrix() = default;

  /// weight · v vᵀ.
  static constexpr SymmetricMatrix outer_product(const Vector<N, Scalar>& v, Scalar weight) {
    SymmetricMatrix m;
    std::size_t k = 0;
    internal::unrolled<N>([&](std::size_t i) QUADRILLE_ALWAYS_INLINE_LAMBDA {
      internal::unrolled<N>([&](std::size_t j) QUADRILLE_ALWAYS_INLINE_LAMBDA {
        if (j <= i)
          m.entries_[k++] = weight * v[i] * v[j];
      });
    });
    return m;
  }

  /// The entry (i, j), in any order of i and j.
  constexpr Scalar operator()(std::size_t i, std::size_t j) const {
    return i < j ? entries_[at(j, i)] : entries_[at(i, j)];
  }

  /// The sum, entry by entry.
  QUADRILLE_ALWAYS_INLINE constexpr SymmetricMatrix& operator+=(const SymmetricMatrix& other) {
    internal::unrolled<size>(
        [&](std::size_t k) QUADRILLE_ALWAYS_INLINE_LAMBDA { entries_[k] += other.entries_[k]; });
    return *this;
  }
  /// The difference, entry by entry.
  QUADRILLE_ALWAYS_INLINE constexpr SymmetricMatrix& operator-=(const SymmetricMatrix& other) {
    internal::unrolled<size>(
        [&](std::size_t k) QUADRILLE_ALWAYS_INLINE_LAMBDA { entries_[k] -= other.entries_[k]; });
    return *this;
  }
  /// The sum, entry by entry.
  QUADRILLE_ALWAYS_INLINE friend constexpr SymmetricMatrix operator+(const SymmetricMatrix& a,
                                                                     const SymmetricMatrix& b) {
    SymmetricMatrix sum;
    internal::unrolled<size>([&](std::size_t k) QUADRILLE_ALWAYS_INLINE_LAMBDA {
      sum.entries_[k] = a.entries_[k] + b.entries_[k];
    });
    return sum;
  }
  /// Multiplies each entry.
  QUADRILLE_ALWAYS_INLINE constexpr SymmetricMatrix& operator*=(Scalar factor) {
    for (Scalar& entry : entries_)
      entry *= factor;
    return *this;
  }

  /// Adds the same to each entry of the diagonal.
  constexpr void add_to_diagonal(Scalar value) {
    internal::unrolled<N>([&](std::size_t i)
                              QUADRILLE_ALWAYS_INLINE_LAMBDA { entries_[at(i, i)] += value; });
  }

  /// Sets the entries (i, j) and (j, i).
  constexpr void set(std::size_t i, std::size_t j, Scalar value) {
    entries_[i < j ? at(j, i) : at(i, j)] = value;
  }

  /// The sum of the diagonal, which is that of the eigenvalues.
  constexpr Scalar trace() const {
    Scalar sum = entries_[0];
    internal::unrolled<N - 1>(
        [&](std::size_t i) QUADRILLE_ALWAYS_INLINE_LAMBDA { sum += entries_[at(i + 1, i + 1)]; });
    return sum;
  }

  /// The product of the eigenvalues.
  constexpr Scalar determinant() const requires(N == 3) {
    const auto& [a, b, c, d, e, f] = entries_; // a; b c; d e f
    return a * (c * f - e * e) - b * (b * f - d * e) + d * (b * e - c * d);
  }

  /// The product with a vector.
  QUADRILLE_ALWAYS_INLINE friend constexpr Vector<N, Scalar> operator*(const SymmetricMatrix& m,
                                                                       const Vector<N, Scalar>& x) {
    Vector<N, Scalar> product;
    internal::unrolled<N>([&](std::size_t i) QUADRILLE_ALWAYS_INLINE_LAMBDA {
      Scalar sum = m(i, 0) * x[0];
      internal::unrolled<N - 1>(
          [&](std::size_t j) QUADRILLE_ALWAYS_INLINE_LAMBDA { sum += m(i, j + 1) * x[j + 1]; });
      product[i] = sum;
    });
    return product;
  }

private:
  static constexpr std::size_t size = N * (N + 1) / 2;
  static constexpr std::size_t at(std::size_t i, std::size_t j) { return i * (i + 1) / 2 + j; }

  std::array<Scalar, size> entries_{}; // row by row
};

/// The factorisation A = LDLᵀ of a symmetric positive definite matrix, with which systems are
/// solved.
///
/// A matrix is called singular where a pivot is not above a part of the trace, 10⁻¹² by default.
/// The trace of a sum of quadrics is the sum of their weights, so the test is relative: neither
/// scale nor rotation nor the number of planes moves it. A pivot is at least the smallest
/// eigenvalue, and one of 10⁻¹² of the trace still leaves four digits of the solution.
template <std::size_t N, class Scalar = double>
class Factorization {
public:
  static_assert(std::same_as<Scalar, double>, "Two matrices at once are factorised in space only.");

  /// Factorises A, O(N³). `least_relative` is the part of the trace that a pivot has to be above.
  explicit constexpr Factorization(const SymmetricMatrix<N>& a,
                                   double least_relative = least_relative_pivot) {
    const double least_pivot = least_relative * a.trace();
    for (std::size_t j = 0; j < N; ++j) {
      double pivot = a(j, j);
      for (std::size_t k = 0; k < j; ++k)
        pivot -= l_[j][k] * l_[j][k] * pivot_[k];
      if (!(pivot > least_pivot))
        return; // singular, or not a number
      pivot_[j] = pivot;
      for (std::size_t i = j + 1; i < N; ++i) {
        double sum = a(i, j);
        for (std::size_t k = 0; k < j; ++k)
          sum -= l_[i][k] * l_[j][k] * pivot_[k];
        l_[i][j] = sum / pivot;
      }
    }
    is_singular_ = false;
  }

  /// Is a pivot too small? Then nothing can be solved.
  constexpr bool is_singular() const { return is_singular_; }

  /// A⁻¹b, for a matrix that is not singular.
  constexpr Vector<N> solve(Vector<N> x) const {
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t k = 0; k < i; ++k)
        x[i] -= l_[i][k] * x[k];
    for (std::size_t i = N; i-- > 0;) {
      x[i] /= pivot_[i];
      for (std::size_t k = i + 1; k < N; ++k)
        x[i] -= l_[k][i] * x[k];
    }
    return x;
  }

  static constexpr double least_relative_pivot = 1e-12; ///< of the trace

private:
  std::array<std::array<double, N>, N> l_{}; // below the diagonal
  std::array<double, N> pivot_{};
  bool is_singular_ = true;
};

/// The same in space, in scalars: compilers keep them in registers, where arrays go through memory,
/// and this is the innermost step of a simplification. Of two matrices at once each may be
/// singular.
template <class Scalar>
class Factorization<3, Scalar> {
public:
  /// Factorises A, O(N³). `least_relative` is the part of the trace that a pivot has to be above.
  explicit constexpr Factorization(const SymmetricMatrix<3, Scalar>& a,
                                   double least_relative = least_relative_pivot) {
    const Scalar least_pivot = least_relative * a.trace();
    const Scalar d0 = a(0, 0);
    if (internal::is_nowhere(d0 > least_pivot)) // or not a number
      return;
    inverse0_ = 1.0 / d0;
    l10_ = a(1, 0) * inverse0_;
    l20_ = a(2, 0) * inverse0_;
    const Scalar d1 = a(1, 1) - l10_ * a(1, 0);
    if (internal::is_nowhere(d1 > least_pivot))
      return;
    inverse1_ = 1.0 / d1;
    const Scalar below = a(2, 1) - l20_ * a(1, 0);
    l21_ = below * inverse1_;
    const Scalar d2 = a(2, 2) - l20_ * a(2, 0) - l21_ * below;
    if (internal::is_nowhere(d2 > least_pivot))
      return;
    inverse2_ = 1.0 / d2;
    is_regular_ = (d0 > least_pivot) & (d1 > least_pivot) & (d2 > least_pivot);
  }

  /// Is a pivot too small? Then nothing can be solved.
  constexpr bool is_singular() const { return !is_regular_; }
  /// Is none too small? Of two matrices at once this tells both.
  constexpr auto is_regular() const { return is_regular_; }

  /// x with Ax = b, if A is not singular.
  constexpr Vector<3, Scalar> solve(const Vector<3, Scalar>& b) const {
    const Scalar y0 = b[0];
    const Scalar y1 = b[1] - l10_ * y0;
    const Scalar y2 = b[2] - l20_ * y0 - l21_ * y1;
    const Scalar x2 = y2 * inverse2_;
    const Scalar x1 = y1 * inverse1_ - l21_ * x2;
    return {{y0 * inverse0_ - l10_ * x1 - l20_ * x2, x1, x2}};
  }

  static constexpr double least_relative_pivot = 1e-12; ///< of the trace

private:
  Scalar l10_{}, l20_{}, l21_{};
  Scalar inverse0_{}, inverse1_{}, inverse2_{}; // of the pivots
  decltype(Scalar{} > Scalar{}) is_regular_{};
};

} // namespace quadrille

#endif // QUADRILLE_SYMMETRIC_MATRIX_H
