#ifndef QUADRILLE_INTERNAL_CORE_EVALUATION_TWO_QUADRICS_H
#define QUADRILLE_INTERNAL_CORE_EVALUATION_TWO_QUADRICS_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/lanes.h>
#include <quadrille/quadric.h>
#include <quadrille/quadric_form.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <limits>

namespace quadrille::internal {

/// \file
/// The innermost step of a simplification, for two pairs at the price of one.

using LaneVector = Vector<3, Lanes>;
using LaneMatrix = SymmetricMatrix<3, Lanes>;
using LaneForm = QuadricForm<3, Lanes>;

QUADRILLE_ALWAYS_INLINE inline LaneVector both(const Vector<3>& a, const Vector<3>& b) {
  return {{Lanes{a[0], b[0]}, Lanes{a[1], b[1]}, Lanes{a[2], b[2]}}};
}
QUADRILLE_ALWAYS_INLINE inline LaneMatrix both(const SymmetricMatrix<3>& a,
                                               const SymmetricMatrix<3>& b) {
  LaneMatrix matrix;
  const auto set = [&](std::size_t i, std::size_t j) QUADRILLE_ALWAYS_INLINE_LAMBDA {
    matrix.set(i, j, Lanes{a(i, j), b(i, j)});
  };
  set(0, 0);
  set(1, 0);
  set(1, 1);
  set(2, 0);
  set(2, 1);
  set(2, 2);
  return matrix;
}
QUADRILLE_ALWAYS_INLINE inline LaneForm both(const QuadricForm<3>& a, const QuadricForm<3>& b) {
  return LaneForm(both(a.matrix(), b.matrix()), both(a.gradient(), b.gradient()),
                  Lanes{a.constant(), b.constant()});
}

/// Returns the value if the matrix is not singular and the position no further than a one-ring
/// radius from the first or the second point of the pair; otherwise NaN.
inline Lanes value_if_found(Lanes value, const Factorization<3, Lanes>& factorization,
                            const LaneVector& x, const LaneVector& to_second,
                            Lanes squared_ring_radius) {
  const LaneVector e = x - to_second;
  const LaneMask is_within =
      (dot(x, x) <= squared_ring_radius) | (dot(e, e) <= squared_ring_radius);
  constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
  return select(factorization.is_regular() & is_within, value, Lanes{no_number, no_number});
}

struct NothingAdded {};

/// Returns the least values of two quadrics in space, each the sum of one of `firsts` and of one
/// about the point `displacement` from it, with the tie breaks of equal costs (see TieBreak). A
/// value that cannot be computed in this way, because the matrix is singular or the position lies
/// further than a one-ring radius from both points, is NaN.
///
/// `added` are further quadrics about the first points, a LaneForm, or NothingAdded.
template <class Added>
QUADRILLE_ALWAYS_INLINE inline Lanes
least_values(const std::array<const QuadricForm<3>*, 2>& firsts,
             const std::array<const QuadricForm<3>*, 2>& others,
             const std::array<Vector<3>, 2>& displacements, Lanes squared_ring_radius,
             [[maybe_unused]] const Added& added) {
  // The sum, about the first point: see QuadricForm::sum_about_first.
  const auto& [p, q] = firsts;
  const auto& [r, s] = others;
  const LaneVector d = both(displacements[0], displacements[1]);
  const LaneMatrix b = both(r->matrix(), s->matrix());
  const LaneVector h = both(r->gradient(), s->gradient());
  LaneMatrix a = both(p->matrix(), q->matrix()) + b;
  if constexpr (!std::same_as<Added, NothingAdded>)
    a += added.matrix();
  const Lanes weight = shape_weight * a.trace(); // half of it at each end
  const LaneVector bd = b * d + 0.5 * weight * d;
  LaneVector g = both(p->gradient(), q->gradient()) + h - bd;
  Lanes c = Lanes{p->constant(), q->constant()} + Lanes{r->constant(), s->constant()} + dot(d, bd) -
            2.0 * dot(h, d);
  if constexpr (!std::same_as<Added, NothingAdded>) {
    g += added.gradient();
    c += added.constant();
  }

  a.add_to_diagonal(weight);
  const Factorization<3, Lanes> factorization(a);
  const LaneVector x = factorization.solve(-g);
  return value_if_found(c + dot(g, x), factorization, x, d, squared_ring_radius); // Ax = −g
}

/// Values, and the positions that have them.
struct LaneMinima {
  Lanes values;
  LaneVector positions;
};

/// Returns these values for memoryless costs: see MemorylessQuadric::join and minimizer, to which
/// `Current` belongs.
template <class Current, class Added>
LaneMinima minima(const Current& first, const std::array<const Current*, 2>& others,
                  const std::array<Current, 2>& shared,
                  const std::array<Vector<3>, 2>& displacements, Lanes squared_ring_radius,
                  [[maybe_unused]] const Added& added) {
  const auto& [p, q] = others;
  const auto& [s, t] = shared;
  const LaneVector d = both(displacements[0], displacements[1]);
  const LaneMatrix b = both(p->matrix, q->matrix);
  LaneMatrix a = both(first.matrix, first.matrix) + b;
  a -= both(s.matrix, t.matrix);
  if constexpr (!std::same_as<Added, NothingAdded>)
    a += added.matrix();
  const Lanes weight = shape_weight * a.trace(); // half of it at each end
  LaneVector bd = b * d + 0.5 * weight * d;
  Lanes c = dot(bd, d);
  if constexpr (!std::same_as<Added, NothingAdded>) {
    bd -= added.gradient();
    c += added.constant();
  }
  const LaneVector other_area = both(p->doubled_area, q->doubled_area);
  const LaneVector normal = both(first.doubled_area, first.doubled_area) + other_area -
                            both(s.doubled_area, t.doubled_area);

  a.add_to_diagonal(weight);
  const Factorization<3, Lanes> factorization(a);
  const LaneVector x = factorization.solve(bd); // without the plane: it costs c − dᵀBx
  const LaneVector across = factorization.solve(normal);
  const Lanes slope = dot(normal, across);
  const Lanes off = dot(other_area, d) - dot(normal, x);
  const Lanes displacement = select(slope > Lanes{}, off / slope, Lanes{});
  const LaneVector position = x + displacement * across;
  return {value_if_found(c - dot(bd, x) + displacement * displacement * slope, factorization,
                         position, d, squared_ring_radius),
          position};
}

/// How much farther from the planes, in sum of squares, the positions x are than the points where
/// the forms are at home. The first form belongs to both.
inline Lanes growth(const QuadricForm<3>& first, const std::array<const QuadricForm<3>*, 2>& others,
                    const std::array<Vector<3>, 2>& displacements, const LaneVector& x) {
  const auto& [p, q] = others;
  const LaneVector y = x - both(displacements[0], displacements[1]);
  const LaneMatrix a = both(first.matrix(), first.matrix());
  const LaneMatrix b = both(p->matrix(), q->matrix());
  const LaneVector g = both(first.gradient(), first.gradient());
  const LaneVector h = both(p->gradient(), q->gradient());
  return dot(a * x, x) + 2.0 * dot(g, x) + dot(b * y, y) + 2.0 * dot(h, y);
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_EVALUATION_TWO_QUADRICS_H
