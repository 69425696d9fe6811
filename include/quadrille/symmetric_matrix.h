#ifndef QUADRILLE_SYMMETRIC_MATRIX_H
#define QUADRILLE_SYMMETRIC_MATRIX_H

#include <quadrille/vector.h>

#include <array>
#include <cstddef>

namespace quadrille {

/// A symmetric N × N matrix, kept as its lower triangle: N(N+1)/2 doubles.
template <std::size_t N>
class SymmetricMatrix {
public:
  constexpr SymmetricMatrix() = default;

  /// weight · v vᵀ.
  static constexpr SymmetricMatrix outer_product(const Vector<N>& v, double weight) {
    SymmetricMatrix m;
    std::size_t k = 0;
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t j = 0; j <= i; ++j)
        m.entries_[k++] = weight * v[i] * v[j];
    return m;
  }

  /// The entry (i, j), in any order of i and j.
  constexpr double operator()(std::size_t i, std::size_t j) const {
    return i < j ? entries_[at(j, i)] : entries_[at(i, j)];
  }

  /// The sum, entry by entry.
  constexpr SymmetricMatrix& operator+=(const SymmetricMatrix& other) {
    for (std::size_t k = 0; k < entries_.size(); ++k)
      entries_[k] += other.entries_[k];
    return *this;
  }
  /// The difference, entry by entry.
  constexpr SymmetricMatrix& operator-=(const SymmetricMatrix& other) {
    for (std::size_t k = 0; k < entries_.size(); ++k)
      entries_[k] -= other.entries_[k];
    return *this;
  }
  /// The sum, entry by entry.
  friend constexpr SymmetricMatrix operator+(const SymmetricMatrix& a, const SymmetricMatrix& b) {
    SymmetricMatrix sum;
    for (std::size_t k = 0; k < sum.entries_.size(); ++k)
      sum.entries_[k] = a.entries_[k] + b.entries_[k];
    return sum;
  }
  /// Multiplies each entry.
  constexpr SymmetricMatrix& operator*=(double factor) {
    for (double& entry : entries_)
      entry *= factor;
    return *this;
  }

  /// Adds the same to each entry of the diagonal.
  constexpr void add_to_diagonal(double value) {
    for (std::size_t i = 0; i < N; ++i)
      entries_[at(i, i)] += value;
  }

  /// Sets the entries (i, j) and (j, i).
  constexpr void set(std::size_t i, std::size_t j, double value) {
    entries_[i < j ? at(j, i) : at(i, j)] = value;
  }

  /// The sum of the diagonal, which is that of the eigenvalues.
  constexpr double trace() const {
    double sum = entries_[0];
    for (std::size_t i = 1; i < N; ++i)
      sum += entries_[at(i, i)];
    return sum;
  }

  /// The product of the eigenvalues.
  constexpr double determinant() const requires(N == 3) {
    const auto& [a, b, c, d, e, f] = entries_; // a; b c; d e f
    return a * (c * f - e * e) - b * (b * f - d * e) + d * (b * e - c * d);
  }

  /// The product with a vector.
  friend constexpr Vector<N> operator*(const SymmetricMatrix& m, const Vector<N>& x) {
    Vector<N> product;
    for (std::size_t i = 0; i < N; ++i) {
      double sum = m(i, 0) * x[0];
      for (std::size_t j = 1; j < N; ++j)
        sum += m(i, j) * x[j];
      product[i] = sum;
    }
    return product;
  }

private:
  static constexpr std::size_t at(std::size_t i, std::size_t j) { return i * (i + 1) / 2 + j; }

  std::array<double, N*(N + 1) / 2> entries_{}; // row by row
};

/// The factorisation A = LDLᵀ of a symmetric positive definite matrix, with which systems are
/// solved.
///
/// A matrix is called singular where a pivot is not above a part of the trace, 10⁻¹² by default.
/// The trace of a sum of quadrics is the sum of their weights, so the test is relative: neither
/// scale nor rotation nor the number of planes moves it. A pivot is at least the smallest
/// eigenvalue, and one of 10⁻¹² of the trace still leaves four digits of the solution.
template <std::size_t N>
class Factorization {
public:
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
/// and this is the innermost step of a simplification.
template <>
class Factorization<3> {
public:
  /// Factorises A, O(N³). `least_relative` is the part of the trace that a pivot has to be above.
  explicit constexpr Factorization(const SymmetricMatrix<3>& a,
                                   double least_relative = least_relative_pivot) {
    const double least_pivot = least_relative * a.trace();
    const double d0 = a(0, 0);
    if (!(d0 > least_pivot))
      return; // singular, or not a number
    inverse0_ = 1 / d0;
    l10_ = a(1, 0) * inverse0_;
    l20_ = a(2, 0) * inverse0_;
    const double d1 = a(1, 1) - l10_ * a(1, 0);
    if (!(d1 > least_pivot))
      return;
    inverse1_ = 1 / d1;
    const double below = a(2, 1) - l20_ * a(1, 0);
    l21_ = below * inverse1_;
    const double d2 = a(2, 2) - l20_ * a(2, 0) - l21_ * below;
    if (!(d2 > least_pivot))
      return;
    inverse2_ = 1 / d2;
    is_singular_ = false;
  }

  /// Is a pivot too small? Then nothing can be solved.
  constexpr bool is_singular() const { return is_singular_; }

  /// x with Ax = b, if A is not singular.
  constexpr Vector<3> solve(const Vector<3>& b) const {
    const double y0 = b[0];
    const double y1 = b[1] - l10_ * y0;
    const double y2 = b[2] - l20_ * y0 - l21_ * y1;
    const double x2 = y2 * inverse2_;
    const double x1 = y1 * inverse1_ - l21_ * x2;
    return {{y0 * inverse0_ - l10_ * x1 - l20_ * x2, x1, x2}};
  }

  static constexpr double least_relative_pivot = 1e-12; ///< of the trace

private:
  double l10_ = 0, l20_ = 0, l21_ = 0;
  double inverse0_ = 0, inverse1_ = 0, inverse2_ = 0; // of the pivots
  bool is_singular_ = true;
};

} // namespace quadrille

#endif // QUADRILLE_SYMMETRIC_MATRIX_H
