#ifndef QUADRILLE_QUADRIC_FORM_H
#define QUADRILLE_QUADRIC_FORM_H

#include <quadrille/vector.h>

#include <array>
#include <cstddef>
#include <optional>

namespace quadrille {

/// A quadric: the function Q(x) = xᵀAx + 2gᵀx + c on Rᴺ, with A symmetric and positive
/// semidefinite.
///
/// The argument x is a displacement from an origin that the user of the form chooses; all three
/// terms are kept, so nothing is lost when the origin moves. Kept about a point of the surface,
/// every term is of the size of the local error, and Q keeps its relative precision at any distance
/// from zero; about zero its noise floor would be √ε·|x|. Storage is (N+1)(N+2)/2 doubles: 10 in
/// space, 28 with colour. Source: Garland and Heckbert 1997, section 5; 1998, section 3 for N > 3.
template <std::size_t N>
class QuadricForm {
public:
  using Position = Vector<N>;

  constexpr QuadricForm() = default;

  /// weight · (normal · x)²: the squared distance to a plane through the origin, for a unit normal.
  static constexpr QuadricForm plane(const Position& normal, double weight) {
    QuadricForm form;
    std::size_t k = 0;
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t j = 0; j <= i; ++j)
        form.a_[k++] = weight * normal[i] * normal[j];
    return form;
  }

  /// weight · |x|²: the squared distance to the origin.
  static constexpr QuadricForm point(double weight) {
    QuadricForm form;
    for (std::size_t i = 0; i < N; ++i)
      form.a_[at(i, i)] = weight;
    return form;
  }

  constexpr QuadricForm& operator+=(const QuadricForm& other) {
    for (std::size_t k = 0; k < a_.size(); ++k)
      a_[k] += other.a_[k];
    g_ += other.g_;
    c_ += other.c_;
    return *this;
  }
  constexpr QuadricForm& operator-=(const QuadricForm& other) {
    for (std::size_t k = 0; k < a_.size(); ++k)
      a_[k] -= other.a_[k];
    g_ -= other.g_;
    c_ -= other.c_;
    return *this;
  }
  constexpr QuadricForm& operator*=(double factor) {
    for (double& a : a_)
      a *= factor;
    g_ *= factor;
    c_ *= factor;
    return *this;
  }
  friend constexpr QuadricForm operator+(QuadricForm a, const QuadricForm& b) { return a += b; }

  /// Expresses the same function about the point `d`, given relative to the old origin.
  constexpr void move_origin(const Position& d) {
    const Position ad = times(d);
    c_ += dot(d, ad) + 2 * dot(g_, d);
    g_ += ad;
  }

  /// Q(x).
  constexpr double operator()(const Position& x) const {
    return dot(x, times(x)) + 2 * dot(g_, x) + c_;
  }

  /// The displacement of least value, −A⁻¹g, or nothing where A is singular.
  ///
  /// A is factored as LDLᵀ and called singular when a pivot is not above 10⁻¹² of the trace. The
  /// trace is the sum of the weights in the form, so the test is relative: neither scale nor
  /// rotation nor the number of planes moves it. A pivot bounds the smallest eigenvalue from above,
  /// and one of 10⁻¹² of the trace still leaves four digits of the displacement.
  constexpr std::optional<Position> minimizer() const {
    std::array<double, size> l = a_;
    Position inverse_pivots;
    const double least_pivot = 1e-12 * trace();
    for (std::size_t j = 0; j < N; ++j) {
      double pivot = l[at(j, j)];
      for (std::size_t k = 0; k < j; ++k)
        pivot -= l[at(j, k)] * l[at(j, k)] * l[at(k, k)];
      if (!(pivot > least_pivot))
        return std::nullopt; // singular, or not a number
      l[at(j, j)] = pivot;
      inverse_pivots[j] = 1 / pivot;
      for (std::size_t i = j + 1; i < N; ++i) {
        double sum = l[at(i, j)];
        for (std::size_t k = 0; k < j; ++k)
          sum -= l[at(i, k)] * l[at(j, k)] * l[at(k, k)];
        l[at(i, j)] = sum * inverse_pivots[j];
      }
    }
    return solve(l, inverse_pivots);
  }

  constexpr double trace() const {
    double sum = 0;
    for (std::size_t i = 0; i < N; ++i)
      sum += a_[at(i, i)];
    return sum;
  }

  /// A(i, j), in any order of i and j.
  constexpr double matrix(std::size_t i, std::size_t j) const {
    return i < j ? a_[at(j, i)] : a_[at(i, j)];
  }
  constexpr const Position& gradient() const {
    return g_;
  }                                                ///< g, half of the gradient at the origin.
  constexpr double constant() const { return c_; } ///< c, the value at the origin.

  /// Adds `value` to A(i, j) and, by symmetry, to A(j, i).
  constexpr void add_to_matrix(std::size_t i, std::size_t j, double value) {
    a_[i < j ? at(j, i) : at(i, j)] += value;
  }

private:
  static constexpr std::size_t size = N * (N + 1) / 2;

  static constexpr std::size_t at(std::size_t i, std::size_t j) { return i * (i + 1) / 2 + j; }

  constexpr Position times(const Position& x) const {
    Position ax;
    std::size_t k = 0;
    for (std::size_t i = 0; i < N; ++i, ++k) {
      for (std::size_t j = 0; j < i; ++j, ++k) {
        ax[i] += a_[k] * x[j];
        ax[j] += a_[k] * x[i];
      }
      ax[i] += a_[k] * x[i];
    }
    return ax;
  }

  constexpr Position solve(const std::array<double, size>& l,
                           const Position& inverse_pivots) const {
    Position x = -1.0 * g_;
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t k = 0; k < i; ++k)
        x[i] -= l[at(i, k)] * x[k];
    for (std::size_t i = N; i-- > 0;) {
      x[i] *= inverse_pivots[i];
      for (std::size_t k = i + 1; k < N; ++k)
        x[i] -= l[at(k, i)] * x[k];
    }
    return x;
  }

  std::array<double, size> a_{}; // the lower triangle of A, row by row
  Position g_{};
  double c_ = 0;
};

} // namespace quadrille

#endif // QUADRILLE_QUADRIC_FORM_H
