#ifndef QUADRILLE_INTERNAL_EVALUATION_TWO_QUADRICS_H
#define QUADRILLE_INTERNAL_EVALUATION_TWO_QUADRICS_H

#include <quadrille/internal/base/compiler.h>
#include <quadrille/internal/base/lanes.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/quadric.h>
#include <quadrille/quadric_form.h>
#include <quadrille/symmetric_matrix.h>
#include <quadrille/vector.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <limits>

namespace quadrille::internal {

/// \file
/// The innermost step of a simplification, for two pairs at the price of one.

/// Two vectors in space.
struct LaneVector {
  Lanes x, y, z;

  static LaneVector of(const Vector<3>& a, const Vector<3>& b) {
    return {Lanes{a[0], b[0]}, Lanes{a[1], b[1]}, Lanes{a[2], b[2]}};
  }
  static LaneVector twice(const Vector<3>& a) { return of(a, a); }

  friend LaneVector operator+(const LaneVector& a, const LaneVector& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend LaneVector operator-(const LaneVector& a, const LaneVector& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend LaneVector operator-(const LaneVector& a) { return {-a.x, -a.y, -a.z}; }
  friend LaneVector operator*(Lanes factor, const LaneVector& a) {
    return {factor * a.x, factor * a.y, factor * a.z};
  }
  friend Lanes dot(const LaneVector& a, const LaneVector& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  }
};

/// Two symmetric matrices.
struct LaneMatrix {
  Lanes xx, yx, yy, zx, zy, zz;

  static LaneMatrix of(const SymmetricMatrix<3>& a, const SymmetricMatrix<3>& b) {
    const auto entry = [&](std::size_t i, std::size_t j) { return Lanes{a(i, j), b(i, j)}; };
    return {entry(0, 0), entry(1, 0), entry(1, 1), entry(2, 0), entry(2, 1), entry(2, 2)};
  }
  static LaneMatrix twice(const SymmetricMatrix<3>& a) { return of(a, a); }

  friend LaneMatrix operator+(const LaneMatrix& a, const LaneMatrix& b) {
    return {a.xx + b.xx, a.yx + b.yx, a.yy + b.yy, a.zx + b.zx, a.zy + b.zy, a.zz + b.zz};
  }
  friend LaneMatrix operator-(const LaneMatrix& a, const LaneMatrix& b) {
    return {a.xx - b.xx, a.yx - b.yx, a.yy - b.yy, a.zx - b.zx, a.zy - b.zy, a.zz - b.zz};
  }
  /// Adds the same to each entry of the diagonal.
  friend LaneMatrix operator+(const LaneMatrix& a, Lanes value) {
    return {a.xx + value, a.yx, a.yy + value, a.zx, a.zy, a.zz + value};
  }
  Lanes trace() const { return xx + yy + zz; }
  friend LaneVector operator*(const LaneMatrix& a, const LaneVector& v) {
    return {a.xx * v.x + a.yx * v.y + a.zx * v.z, a.yx * v.x + a.yy * v.y + a.zy * v.z,
            a.zx * v.x + a.zy * v.y + a.zz * v.z};
  }
};

/// See Factorization<3>.
class LaneFactorization {
public:
  explicit LaneFactorization(const LaneMatrix& a) {
    const Lanes least_pivot = Factorization<3>::least_relative_pivot * a.trace();
    inverse0_ = 1.0 / a.xx;
    l10_ = a.yx * inverse0_;
    l20_ = a.zx * inverse0_;
    const Lanes pivot1 = a.yy - l10_ * a.yx;
    inverse1_ = 1.0 / pivot1;
    const Lanes below = a.zy - l20_ * a.yx;
    l21_ = below * inverse1_;
    const Lanes pivot2 = a.zz - l20_ * a.zx - l21_ * below;
    inverse2_ = 1.0 / pivot2;
    is_regular_ = (a.xx > least_pivot) & (pivot1 > least_pivot) & (pivot2 > least_pivot);
  }

  LaneMask is_regular() const { return is_regular_; }

  LaneVector solve(const LaneVector& b) const {
    const Lanes y1 = b.y - l10_ * b.x;
    const Lanes y2 = b.z - l20_ * b.x - l21_ * y1;
    const Lanes z = y2 * inverse2_;
    const Lanes y = y1 * inverse1_ - l21_ * z;
    return {b.x * inverse0_ - l10_ * y - l20_ * z, y, z};
  }

private:
  Lanes l10_, l20_, l21_, inverse0_, inverse1_, inverse2_;
  LaneMask is_regular_;
};

/// A value where the matrix is not singular and the position no further than √reach from the first
/// or the second point of the pair; no number elsewhere.
inline Lanes value_if_found(Lanes value, const LaneFactorization& factorization,
                            const LaneVector& x, const LaneVector& to_second, Lanes squared_reach) {
  const LaneVector e = x - to_second;
  const LaneMask is_within = (dot(x, x) <= squared_reach) | (dot(e, e) <= squared_reach);
  constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
  return select(factorization.is_regular() & is_within, value, Lanes{no_number, no_number});
}

/// Two quadrics in space.
struct LaneForm {
  LaneMatrix matrix;
  LaneVector gradient;
  Lanes constant;

  static LaneForm of(const QuadricForm<3>& a, const QuadricForm<3>& b) {
    return {LaneMatrix::of(a.matrix(), b.matrix()), LaneVector::of(a.gradient(), b.gradient()),
            Lanes{a.constant(), b.constant()}};
  }
  /// See QuadricForm::sum_about_first.
  static LaneForm sum_about_first(const LaneForm& first, const LaneForm& second,
                                  const LaneVector& d) {
    const LaneVector ad = second.matrix * d;
    return {first.matrix + second.matrix, first.gradient + second.gradient - ad,
            first.constant + second.constant + dot(d, ad) - 2.0 * dot(second.gradient, d)};
  }

  LaneForm& operator+=(const LaneForm& other) {
    matrix = matrix + other.matrix;
    gradient = gradient + other.gradient;
    constant += other.constant;
    return *this;
  }
  /// Adds weight · (normal · x + offset)².
  QUADRILLE_ALWAYS_INLINE void add_squared_plane(const LaneVector& normal, Lanes offset,
                                                 Lanes weight) {
    const LaneVector n = weight * normal;
    matrix.xx += n.x * normal.x;
    matrix.yx += n.y * normal.x;
    matrix.yy += n.y * normal.y;
    matrix.zx += n.z * normal.x;
    matrix.zy += n.z * normal.y;
    matrix.zz += n.z * normal.z;
    gradient = gradient + offset * n;
    constant += weight * offset * offset;
  }
};

struct NothingAdded {};

/// The least values of two quadrics in space, each the sum of one of `firsts` and of one about the
/// point `displacement` from it, with what tells those of equal cost apart (see TieBreak). A value
/// that can't be had so, because the matrix is singular or the position lies further than √reach
/// from both points, is NaN.
///
/// `added` are further quadrics about the first points, a LaneForm, or NothingAdded.
template <class Added>
QUADRILLE_ALWAYS_INLINE inline Lanes
least_values(const std::array<const QuadricForm<3>*, 2>& firsts,
             const std::array<const QuadricForm<3>*, 2>& others,
             const std::array<Vector<3>, 2>& displacements, Lanes squared_reach,
             [[maybe_unused]] const Added& added) {
  // The sum, about the first point: see QuadricForm::sum_about_first.
  const auto& [p, q] = firsts;
  const auto& [r, s] = others;
  const LaneVector d = LaneVector::of(displacements[0], displacements[1]);
  const LaneMatrix b = LaneMatrix::of(r->matrix(), s->matrix());
  const LaneVector h = LaneVector::of(r->gradient(), s->gradient());
  LaneMatrix a = LaneMatrix::of(p->matrix(), q->matrix()) + b;
  if constexpr (!std::same_as<Added, NothingAdded>)
    a = a + added.matrix;
  const Lanes weight = shape_weight * a.trace(); // half of it at each end
  const LaneVector bd = b * d + 0.5 * weight * d;
  LaneVector g = LaneVector::of(p->gradient(), q->gradient()) + h - bd;
  Lanes c = Lanes{p->constant(), q->constant()} + Lanes{r->constant(), s->constant()} + dot(d, bd) -
            2.0 * dot(h, d);
  if constexpr (!std::same_as<Added, NothingAdded>) {
    g = g + added.gradient;
    c = c + added.constant;
  }

  const LaneFactorization factorization(a + weight);
  const LaneVector x = factorization.solve(-g);
  return value_if_found(c + dot(g, x), factorization, x, d, squared_reach); // Ax = −g
}

/// Values, and the positions that have them.
struct LaneMinima {
  Lanes values;
  LaneVector positions;
};

/// The same for memoryless costs: see MemorylessQuadric::join and minimizer.
template <class Added>
LaneMinima minima(const MemorylessQuadric::Current& first,
                  const std::array<const MemorylessQuadric::Current*, 2>& others,
                  const std::array<MemorylessQuadric::Current, 2>& shared,
                  const std::array<Vector<3>, 2>& displacements, Lanes squared_reach,
                  [[maybe_unused]] const Added& added) {
  const auto& [p, q] = others;
  const auto& [s, t] = shared;
  const LaneVector d = LaneVector::of(displacements[0], displacements[1]);
  const LaneMatrix b = LaneMatrix::of(p->matrix, q->matrix);
  LaneMatrix a = LaneMatrix::twice(first.matrix) + b - LaneMatrix::of(s.matrix, t.matrix);
  if constexpr (!std::same_as<Added, NothingAdded>)
    a = a + added.matrix;
  const Lanes weight = shape_weight * a.trace(); // half of it at each end
  LaneVector bd = b * d + 0.5 * weight * d;
  Lanes c = dot(bd, d);
  if constexpr (!std::same_as<Added, NothingAdded>) {
    bd = bd - added.gradient;
    c = c + added.constant;
  }
  const LaneVector other_area = LaneVector::of(p->doubled_area, q->doubled_area);
  const LaneVector normal = LaneVector::twice(first.doubled_area) + other_area -
                            LaneVector::of(s.doubled_area, t.doubled_area);

  const LaneFactorization factorization(a + weight);
  const LaneVector x = factorization.solve(bd); // without the plane: it costs c − dᵀBx
  const LaneVector across = factorization.solve(normal);
  const Lanes slope = dot(normal, across);
  const Lanes off = dot(other_area, d) - dot(normal, x);
  const Lanes way = select(slope > Lanes{}, off / slope, Lanes{});
  const LaneVector position = x + way * across;
  return {
      value_if_found(c - dot(bd, x) + way * way * slope, factorization, position, d, squared_reach),
      position};
}

/// How much farther from the planes, in sum of squares, the positions x are than the points where
/// the forms are at home. The first form belongs to both.
inline Lanes growth(const QuadricForm<3>& first, const std::array<const QuadricForm<3>*, 2>& others,
                    const std::array<Vector<3>, 2>& displacements, const LaneVector& x) {
  const auto& [p, q] = others;
  const LaneVector y = x - LaneVector::of(displacements[0], displacements[1]);
  const LaneMatrix a = LaneMatrix::twice(first.matrix());
  const LaneMatrix b = LaneMatrix::of(p->matrix(), q->matrix());
  const LaneVector g = LaneVector::twice(first.gradient());
  const LaneVector h = LaneVector::of(p->gradient(), q->gradient());
  return dot(a * x, x) + 2.0 * dot(g, x) + dot(b * y, y) + 2.0 * dot(h, y);
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_EVALUATION_TWO_QUADRICS_H
