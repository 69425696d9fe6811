#ifndef QUADRILLE_SYMMETRIC_MATRIX_H
#define QUADRILLE_SYMMETRIC_MATRIX_H

#include <quadrille/vector.h>

#include <array>
#include <cstddef>
#include <optional>

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

  constexpr SymmetricMatrix& operator+=(const SymmetricMatrix& other) {
    for (std::size_t k = 0; k < entries_.size(); ++k)
      entries_[k] += other.entries_[k];
    return *this;
  }
  constexpr SymmetricMatrix& operator-=(const SymmetricMatrix& other) {
    for (std::size_t k = 0; k < entries_.size(); ++k)
      entries_[k] -= other.entries_[k];
    return *this;
  }
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

  constexpr void set(std::size_t i, std::size_t j, double value) {
    entries_[i < j ? at(j, i) : at(i, j)] = value;
  }

  constexpr double trace() const {
    double sum = 0;
    for (std::size_t i = 0; i < N; ++i)
      sum += entries_[at(i, i)];
    return sum;
  }

  friend constexpr Vector<N> operator*(const SymmetricMatrix& m, const Vector<N>& x) {
    Vector<N> product;
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t j = 0; j < N; ++j)
        product[i] += m(i, j) * x[j];
    return product;
  }

  /// A factorisation LDLᵀ, with which systems are solved.
  class Factorization {
  public:
    /// A⁻¹b.
    constexpr Vector<N> solve(Vector<N> x) const {
      for (std::size_t i = 0; i < N; ++i)
        for (std::size_t k = 0; k < i; ++k)
          x[i] -= l_[at(i, k)] * x[k];
      for (std::size_t i = N; i-- > 0;) {
        x[i] *= l_[at(i, i)];
        for (std::size_t k = i + 1; k < N; ++k)
          x[i] -= l_[at(k, i)] * x[k];
      }
      return x;
    }

  private:
    friend class SymmetricMatrix;
    std::array<double, N*(N + 1) / 2> l_; // L below the diagonal, and 1/D on it
  };

  /// The factorisation of a positive definite matrix, or nothing where it is singular: where a
  /// pivot is not above 10⁻¹² of the trace.
  ///
  /// The trace of a sum of quadrics is the sum of their weights, so the test is relative: neither
  /// scale nor rotation nor the number of planes moves it. A pivot is at least the smallest
  /// eigenvalue, and one of 10⁻¹² of the trace still leaves four digits of the solution.
  constexpr std::optional<Factorization> factorize() const {
    Factorization f;
    Vector<N> pivots;
    const double least_pivot = 1e-12 * trace();
    for (std::size_t j = 0; j < N; ++j) {
      double pivot = entries_[at(j, j)];
      for (std::size_t k = 0; k < j; ++k)
        pivot -= f.l_[at(j, k)] * f.l_[at(j, k)] * pivots[k];
      if (!(pivot > least_pivot))
        return std::nullopt; // singular, or not a number
      pivots[j] = pivot;
      f.l_[at(j, j)] = 1 / pivot;
      for (std::size_t i = j + 1; i < N; ++i) {
        double sum = entries_[at(i, j)];
        for (std::size_t k = 0; k < j; ++k)
          sum -= f.l_[at(i, k)] * f.l_[at(j, k)] * pivots[k];
        f.l_[at(i, j)] = sum * f.l_[at(j, j)];
      }
    }
    return f;
  }

private:
  static constexpr std::size_t at(std::size_t i, std::size_t j) { return i * (i + 1) / 2 + j; }

  std::array<double, N*(N + 1) / 2> entries_{}; // row by row
};

} // namespace quadrille

#endif // QUADRILLE_SYMMETRIC_MATRIX_H
