#ifndef QUADRILLE_QUADRIC_FORM_H
#define QUADRILLE_QUADRIC_FORM_H

#include <quadrille/symmetric_matrix.h>
#include <quadrille/vector.h>

#include <cstddef>
#include <optional>

namespace quadrille {

/// A quadric: the function Q(x) = xᵀAx + 2gᵀx + c on Rᴺ, with A symmetric and positive
/// semidefinite.
///
/// The argument x is a displacement from an origin that the user of the form chooses; all three
/// terms are kept, so nothing is lost when the origin moves. Kept about a point of the surface,
/// every term is of the size of the local error, and Q keeps its relative precision at any distance
/// from zero; about zero its noise floor would be √ε·|x|.
/// Storage is (N+1)(N+2)/2 doubles: 10 in space, 28 with colour.
/// Source: Garland and Heckbert 1997, section 5; 1998, section 3 for N > 3. See Vector for scalars.
template <std::size_t N, class Scalar = double>
class QuadricForm {
public:
  using Position = Vector<N, Scalar>; ///< a displacement from the origin

  constexpr QuadricForm() = default;
  /// xᵀAx + 2gᵀx + c.
  explicit constexpr QuadricForm(const SymmetricMatrix<N, Scalar>& a, const Position& g = {},
                                 Scalar c = Scalar())
      : a_(a), g_(g), c_(c) {}

  /// weight · (normal · x)²: the squared distance to a plane through the origin, for a unit normal.
  static constexpr QuadricForm plane(const Position& normal, Scalar weight) {
    return QuadricForm(SymmetricMatrix<N, Scalar>::outer_product(normal, weight));
  }

  /// weight · |x|²: the squared distance to the origin.
  static constexpr QuadricForm point(Scalar weight) {
    QuadricForm form;
    form.a_.add_to_diagonal(weight);
    return form;
  }

  /// Adds a form about the same origin.
  constexpr QuadricForm& operator+=(const QuadricForm& other) {
    a_ += other.a_;
    g_ += other.g_;
    c_ += other.c_;
    return *this;
  }
  /// Takes away a form about the same origin.
  constexpr QuadricForm& operator-=(const QuadricForm& other) {
    a_ -= other.a_;
    g_ -= other.g_;
    c_ -= other.c_;
    return *this;
  }
  /// Multiplies all values.
  constexpr QuadricForm& operator*=(Scalar factor) {
    a_ *= factor;
    g_ *= factor;
    c_ *= factor;
    return *this;
  }
  /// The sum of two forms about the same origin.
  friend constexpr QuadricForm operator+(QuadricForm a, const QuadricForm& b) { return a += b; }

  /// Expresses the same function about the point `d`, given relative to the old origin.
  constexpr void move_origin(const Position& d) {
    const Position ad = a_ * d;
    c_ += dot(d, ad) + 2.0 * dot(g_, d);
    g_ += ad;
  }

  /// The sum of a form and of one about the point d, about the origin of the first.
  static constexpr QuadricForm sum_about_first(const QuadricForm& first, const QuadricForm& second,
                                               const Position& d) {
    const Position ad = second.a_ * d;
    QuadricForm sum(first.a_ + second.a_);
    internal::unrolled<N>([&](std::size_t i) QUADRILLE_ALWAYS_INLINE_LAMBDA {
      sum.g_[i] = first.g_[i] + second.g_[i] - ad[i];
    });
    sum.c_ = first.c_ + second.c_ + dot(d, ad) - 2.0 * dot(second.g_, d);
    return sum;
  }

  /// Q(x).
  constexpr Scalar operator()(const Position& x) const {
    return dot(x, a_ * x) + 2.0 * dot(g_, x) + c_;
  }

  /// The displacement of least value, −A⁻¹g, or nothing where A is singular: see
  /// Factorization.
  constexpr std::optional<Position> minimizer() const {
    const Factorization<N> factorization(a_);
    if (factorization.is_singular())
      return std::nullopt;
    return factorization.solve(-1.0 * g_);
  }

  /// The displacement of least value, and where A leaves directions free the one that is nearest to
  /// m in these; or nothing where A + weight · I is singular. What A determines is moved by less
  /// than (weight / λ)² of the way to m, for eigenvalues λ of A well above the weight.
  ///
  /// Source: two steps of the proximal point algorithm (Rockafellar, Monotone operators and the
  /// proximal point algorithm, 1976): each minimises Q(x) + weight · |x − where the step began|².
  constexpr std::optional<Position> minimizer_near(const Position& m, double weight) const {
    if (const Factorization<N> direct(a_, 1e-4); !direct.is_singular())
      return direct.solve(-1.0 * g_); // A leaves nothing free
    const Factorization<N> factorization(regular_matrix(weight));
    if (factorization.is_singular())
      return std::nullopt;
    Position x = m;
    for (int step = 0; step < 2; ++step)
      x -= factorization.solve(half_gradient(x));
    return x;
  }

  /// The same on the plane n · x = h. Where n has no length there is no plane.
  constexpr std::optional<Position> minimizer_near_on_plane(const Position& m, double weight,
                                                            const Position& n, double h) const {
    const Factorization<N> factorization(regular_matrix(weight));
    if (factorization.is_singular())
      return std::nullopt;
    const Position across = factorization.solve(n);
    const double slope = dot(n, across);
    Position x = m;
    for (int step = 0; step < 2; ++step) {
      x -= factorization.solve(half_gradient(x));
      if (slope > 0)
        x += ((h - dot(n, x)) / slope) * across;
    }
    return x;
  }

  constexpr const SymmetricMatrix<N, Scalar>& matrix() const { return a_; } ///< A
  constexpr SymmetricMatrix<N, Scalar>& matrix() { return a_; }             ///< A, to be changed
  constexpr const Position& gradient() const { return g_; } ///< g, half of the gradient at 0
  constexpr Scalar constant() const { return c_; }          ///< c, the value at 0
  constexpr Scalar trace() const { return a_.trace(); }     ///< of A: the sum of the weights

private:
  constexpr SymmetricMatrix<N, Scalar> regular_matrix(double weight) const {
    SymmetricMatrix<N, Scalar> regular = a_;
    regular.add_to_diagonal(weight);
    return regular;
  }
  constexpr Position half_gradient(const Position& x) const { return a_ * x + g_; }

  SymmetricMatrix<N, Scalar> a_;
  Position g_;
  Scalar c_{};
};

} // namespace quadrille

#endif // QUADRILLE_QUADRIC_FORM_H
