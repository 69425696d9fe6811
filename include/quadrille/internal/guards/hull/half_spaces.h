#ifndef QUADRILLE_INTERNAL_GUARDS_HULL_HALF_SPACES_H
#define QUADRILLE_INTERNAL_GUARDS_HULL_HALF_SPACES_H

#include <quadrille/quadric_form.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

namespace quadrille::internal {

/// The points x with normal · x >= offset. The normal has a length of 1.
struct HalfSpace {
  Vector<3> normal;
  double offset;
};

/// The point of an intersection of half-spaces at which a strictly convex quadratic function is
/// least: a quadratic programme in three unknowns.
///
/// Violated half-spaces are taken one after the other, the farthest first, into a basis of at most
/// three whose planes contain the point. For a basis and one more, each subset with the new one is
/// tried for the conditions of Karush, Kuhn and Tucker: there are seven. The value grows with each
/// step, so no basis comes twice. O(n) for each step, of which there are three or four as a rule.
///
/// Source: Sharir and Welzl, A combinatorial bound for linear programming and related problems,
/// 1992 (bases); Goldfarb and Idnani, A numerically stable dual method for solving strictly convex
/// quadratic programs, 1983 (steps of the dual method).
class LeastInHalfSpaces {
public:
  /// The half-spaces are moved inwards by `margin`; one that is violated by no more than
  /// `tolerance` then is taken for satisfied. `hessian` is that of the function, up to a factor.
  LeastInHalfSpaces(std::span<const HalfSpace> half_spaces, const Factorization<3>& hessian,
                    double margin, double tolerance)
      : half_spaces_(half_spaces), hessian_(hessian), margin_(margin), tolerance_(tolerance) {}

  /// Begins at the point where the function is least everywhere. Nothing if the intersection is
  /// empty, or so narrow that rounding hides it.
  std::optional<Vector<3>> operator()(const Vector<3>& least) {
    start_ = x_ = least;
    size_ = 0;
    for (int step = 0; step < most_steps; ++step) {
      const std::optional<Row> worst = most_violated();
      if (!worst)
        return x_;
      if (!enter(*worst))
        return std::nullopt;
    }
    return std::nullopt;
  }

private:
  // A half-space whose plane may contain the point, and the direction in which its plane is moved:
  // H⁻¹ normal.
  struct Row {
    Vector<3> normal, push;
    double offset; // from where the search has begun
  };
  static constexpr int most_steps = 32;
  static constexpr double least_determinant = 1e-12; // of unit diagonals

  std::optional<Row> most_violated() const {
    double most = tolerance_;
    const HalfSpace* worst = nullptr;
    for (const HalfSpace& h : half_spaces_)
      if (const double violation = h.offset + margin_ - dot(h.normal, x_); violation > most) {
        most = violation;
        worst = &h;
      }
    if (!worst)
      return std::nullopt;
    return Row{worst->normal, hessian_.solve(worst->normal),
               worst->offset + margin_ - dot(worst->normal, start_)};
  }

  // Makes a basis of the old one and a new row. False if there is none.
  bool enter(const Row& row) {
    const std::array<Row, 3> old = basis_;
    const std::size_t old_size = size_;
    for (const unsigned members : {0u, 1u, 2u, 4u, 3u, 5u, 6u}) { // of the old ones, as bits
      if (members >> old_size != 0)
        continue;
      basis_[0] = row;
      size_ = 1;
      for (std::size_t i = 0; i < old_size; ++i)
        if ((members >> i & 1) != 0)
          basis_[size_++] = old[i];
      if (solve() && contain_all(old, old_size, members))
        return true;
    }
    return false;
  }

  bool contain_all(const std::array<Row, 3>& rows, std::size_t size, unsigned members) const {
    for (std::size_t i = 0; i < size; ++i)
      if ((members >> i & 1) == 0 &&
          dot(rows[i].normal, x_ - start_) < rows[i].offset - 0.5 * tolerance_)
        return false;
    return true;
  }

  // Puts the point where the function is least on the planes of the basis. False if one of them
  // would have to pull, or they have no point in common.
  bool solve() {
    std::array<double, 3> force{};
    if (!(size_ == 1 ? solve_one(force) : size_ == 2 ? solve_two(force) : solve_three(force)))
      return false;
    Vector<3> displacement{};
    for (std::size_t i = 0; i < size_; ++i) {
      if (!(force[i] >= 0))
        return false;
      displacement += force[i] * basis_[i].push;
    }
    x_ = start_ + displacement;
    return true;
  }

  double gram(std::size_t i, std::size_t j) const { return dot(basis_[i].normal, basis_[j].push); }

  bool solve_one(std::array<double, 3>& force) const {
    force[0] = basis_[0].offset / gram(0, 0);
    return true;
  }

  bool solve_two(std::array<double, 3>& force) const {
    const double a = gram(0, 0), b = gram(0, 1), c = gram(1, 1);
    const double determinant = a * c - b * b;
    if (!(determinant > least_determinant * a * c))
      return false;
    const double p = basis_[0].offset, q = basis_[1].offset;
    force[0] = (c * p - b * q) / determinant;
    force[1] = (a * q - b * p) / determinant;
    return true;
  }

  // By Cramer's rule, with the cofactors of the symmetric matrix.
  bool solve_three(std::array<double, 3>& force) const {
    const double a = gram(0, 0), b = gram(0, 1), c = gram(1, 1), d = gram(0, 2), e = gram(1, 2),
                 f = gram(2, 2);
    const double aa = c * f - e * e, ab = d * e - b * f, ad = b * e - c * d;
    const double determinant = a * aa + b * ab + d * ad;
    if (!(determinant > least_determinant * a * c * f))
      return false;
    const double bb = a * f - d * d, be = b * d - a * e, ff = a * c - b * b;
    const double p = basis_[0].offset, q = basis_[1].offset, r = basis_[2].offset;
    force[0] = (aa * p + ab * q + ad * r) / determinant;
    force[1] = (ab * p + bb * q + be * r) / determinant;
    force[2] = (ad * p + be * q + ff * r) / determinant;
    return true;
  }

  std::span<const HalfSpace> half_spaces_;
  const Factorization<3>& hessian_;
  double margin_, tolerance_;
  Vector<3> start_{}, x_{};
  std::array<Row, 3> basis_{};
  std::size_t size_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GUARDS_HULL_HALF_SPACES_H
