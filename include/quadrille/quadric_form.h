#ifndef QUADRILLE_QUADRIC_FORM_H
#define QUADRILLE_QUADRIC_FORM_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/lanes.h>
#include <quadrille/internal/core/base/unrolled.h>

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <optional>

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

/// Returns that vector, but zero, no normal, if the three points lie on a line up to the rounding
/// of their coordinates. A triangle higher than a millionth of its length has one, however few bits
/// define it.
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
/// A matrix is called singular where a pivot is not above a fraction of the trace, 10⁻¹² by
/// default. The trace of a sum of quadrics is the sum of their weights, so the test is relative:
/// neither scale nor rotation nor the number of planes moves it. A pivot is at least the smallest
/// eigenvalue, and one of 10⁻¹² of the trace still leaves four digits of the solution.
template <std::size_t N, class Scalar = double>
class Factorization {
public:
  static_assert(std::same_as<Scalar, double>,
                "Only matrices of three dimensions are factorised two at a time.");

  /// Factorises A, O(N³). `least_relative` is the fraction of the trace that a pivot has to be
  /// above.
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

  static constexpr double least_relative_pivot = 1e-12; ///< a fraction of the trace

private:
  std::array<std::array<double, N>, N> l_{}; // below the diagonal
  std::array<double, N> pivot_{};
  bool is_singular_ = true;
};

/// This specialization for space uses scalars: compilers keep them in registers, where arrays go
/// through memory, and this is the innermost step of a simplification. Of two matrices at once each
/// may be singular.
template <class Scalar>
class Factorization<3, Scalar> {
public:
  /// Factorises A, O(N³). `least_relative` is the fraction of the trace that a pivot has to be
  /// above.
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
  /// Is none too small? For two matrices at once the result is that of each.
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

  static constexpr double least_relative_pivot = 1e-12; ///< a fraction of the trace

private:
  Scalar l10_{}, l20_{}, l21_{};
  Scalar inverse0_{}, inverse1_{}, inverse2_{}; // of the pivots
  decltype(Scalar{} > Scalar{}) is_regular_{};
};

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

  /// Returns the minimizer on the plane n · x = h; none if n has no length.
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
  /// The trace of A: the sum of the weights.
  constexpr Scalar trace() const { return a_.trace(); }

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
