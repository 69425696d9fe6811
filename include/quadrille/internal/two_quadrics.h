#ifndef QUADRILLE_INTERNAL_TWO_QUADRICS_H
#define QUADRILLE_INTERNAL_TWO_QUADRICS_H

#include <quadrille/quadric_form.h>
#include <quadrille/symmetric_matrix.h>
#include <quadrille/vector.h>

#include <array>

namespace quadrille::internal {

/// Two doubles that are computed with at once, with what every 64-bit machine has for that.
using Lanes = double __attribute__((vector_size(16)));

/// The least values of two quadrics in space, each the sum of `first` and of one about the point
/// `displacement` from it: the innermost step of a simplification, for two pairs at the price of
/// one. A value that can't be had so, because the matrix is singular (see Factorization) or the
/// position lies further than √reach from both points, is NaN.
inline Lanes least_values(const QuadricForm<3>& first,
                          const std::array<const QuadricForm<3>*, 2>& others,
                          const std::array<Vector<3>, 2>& displacements, Lanes squared_reach) {
  const auto both = [&](double x, double y0, double y1) { return Lanes{x + y0, x + y1}; };
  const auto entry = [&](std::size_t i, std::size_t j) {
    return Lanes{others[0]->matrix()(i, j), others[1]->matrix()(i, j)};
  };
  const auto sum_entry = [&](std::size_t i, std::size_t j, Lanes other) {
    return both(first.matrix()(i, j), other[0], other[1]);
  };
  const auto along = [&](std::size_t i) { return Lanes{displacements[0][i], displacements[1][i]}; };
  const auto gradient = [&](std::size_t i) {
    return Lanes{others[0]->gradient()[i], others[1]->gradient()[i]};
  };

  // The sum, about the first point: see QuadricForm::sum_about_first.
  const Lanes dx = along(0), dy = along(1), dz = along(2);
  const Lanes b00 = entry(0, 0), b10 = entry(1, 0), b11 = entry(1, 1);
  const Lanes b20 = entry(2, 0), b21 = entry(2, 1), b22 = entry(2, 2);
  const Lanes bdx = b00 * dx + b10 * dy + b20 * dz;
  const Lanes bdy = b10 * dx + b11 * dy + b21 * dz;
  const Lanes bdz = b20 * dx + b21 * dy + b22 * dz;
  const Lanes hx = gradient(0), hy = gradient(1), hz = gradient(2);
  const Lanes gx = first.gradient()[0] + hx - bdx;
  const Lanes gy = first.gradient()[1] + hy - bdy;
  const Lanes gz = first.gradient()[2] + hz - bdz;
  const Lanes c = both(first.constant(), others[0]->constant(), others[1]->constant()) +
                  (dx * bdx + dy * bdy + dz * bdz) - 2.0 * (hx * dx + hy * dy + hz * dz);
  const Lanes a00 = sum_entry(0, 0, b00), a10 = sum_entry(1, 0, b10), a11 = sum_entry(1, 1, b11);
  const Lanes a20 = sum_entry(2, 0, b20), a21 = sum_entry(2, 1, b21), a22 = sum_entry(2, 2, b22);

  // Its minimizer: see Factorization<3>.
  const Lanes least_pivot = Factorization<3>::least_relative_pivot * (a00 + a11 + a22);
  const Lanes inverse0 = 1.0 / a00;
  const Lanes l10 = a10 * inverse0, l20 = a20 * inverse0;
  const Lanes pivot1 = a11 - l10 * a10;
  const Lanes inverse1 = 1.0 / pivot1;
  const Lanes below = a21 - l20 * a10;
  const Lanes l21 = below * inverse1;
  const Lanes pivot2 = a22 - l20 * a20 - l21 * below;
  const Lanes y1 = l10 * gx - gy;
  const Lanes y2 = l20 * gx - gz - l21 * y1;
  const Lanes z = y2 / pivot2;
  const Lanes y = y1 * inverse1 - l21 * z;
  const Lanes x = -gx * inverse0 - l10 * y - l20 * z;

  const Lanes ex = x - dx, ey = y - dy, ez = z - dz;
  const auto is_regular = (a00 > least_pivot) & (pivot1 > least_pivot) & (pivot2 > least_pivot);
  const auto is_within =
      (x * x + y * y + z * z <= squared_reach) | (ex * ex + ey * ey + ez * ez <= squared_reach);
  const Lanes value = c + (gx * x + gy * y + gz * z); // Ax = −g
  const Lanes no_number = {__builtin_nan(""), __builtin_nan("")};
  return is_regular & is_within ? value : no_number;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_TWO_QUADRICS_H
