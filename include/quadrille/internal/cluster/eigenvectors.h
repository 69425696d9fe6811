#ifndef QUADRILLE_INTERNAL_CLUSTER_EIGENVECTORS_H
#define QUADRILLE_INTERNAL_CLUSTER_EIGENVECTORS_H

#include <quadrille/symmetric_matrix.h>
#include <quadrille/vector.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace quadrille::internal {

/// The eigenvalues of a symmetric matrix, in no order, and unit eigenvectors, by the cyclic Jacobi
/// method (Golub and Van Loan, Matrix Computations, section 8.5): small eigenvalues of a positive
/// matrix are exact to the rounding of the greatest.
class Eigenvectors {
public:
  explicit Eigenvectors(SymmetricMatrix<3> a) {
    for (std::size_t i = 0; i < 3; ++i)
      vectors_[i][i] = 1;
    for (int sweep = 0; sweep < 12 && !is_diagonal(a); ++sweep) { // five are usual
      rotate(a, 0, 1);
      rotate(a, 0, 2);
      rotate(a, 1, 2);
    }
    for (std::size_t i = 0; i < 3; ++i)
      values_[i] = a(i, i);
  }

  double value(std::size_t i) const { return values_[i]; }
  const Vector<3>& vector(std::size_t i) const { return vectors_[i]; }

private:
  static bool is_diagonal(const SymmetricMatrix<3>& a) {
    return std::abs(a(1, 0)) + std::abs(a(2, 0)) + std::abs(a(2, 1)) <= 0x1p-60 * a.trace();
  }

  // Turns the axes p and q so that a(p, q) becomes 0.
  void rotate(SymmetricMatrix<3>& a, std::size_t p, std::size_t q) {
    const double off = a(p, q);
    if (off == 0)
      return;
    const double cotangent = (a(q, q) - a(p, p)) / (2 * off); // of twice the angle
    const double tangent =
        std::copysign(1 / (std::abs(cotangent) + std::hypot(cotangent, 1.0)), cotangent);
    const double cosine = 1 / std::sqrt(tangent * tangent + 1), sine = tangent * cosine;
    const std::size_t r = 3 - p - q;
    const double rp = a(r, p), rq = a(r, q);
    a.set(p, p, a(p, p) - tangent * off);
    a.set(q, q, a(q, q) + tangent * off);
    a.set(p, q, 0);
    a.set(r, p, cosine * rp - sine * rq);
    a.set(r, q, sine * rp + cosine * rq);
    const Vector<3> vp = vectors_[p], vq = vectors_[q];
    vectors_[p] = cosine * vp - sine * vq;
    vectors_[q] = sine * vp + cosine * vq;
  }

  std::array<double, 3> values_;
  std::array<Vector<3>, 3> vectors_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CLUSTER_EIGENVECTORS_H
