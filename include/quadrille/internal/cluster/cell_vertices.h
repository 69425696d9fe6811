#ifndef QUADRILLE_INTERNAL_CLUSTER_CELL_VERTICES_H
#define QUADRILLE_INTERNAL_CLUSTER_CELL_VERTICES_H

#include <quadrille/internal/cluster/cell_grid.h>
#include <quadrille/internal/cluster/clusters.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/quadric.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace quadrille::internal {

/// Computes the eigenvalues of a symmetric matrix, in no order, and unit eigenvectors, by the
/// cyclic Jacobi method (Golub and Van Loan, Matrix Computations, section 8.5): small eigenvalues
/// of a positive matrix are accurate to the rounding error of the greatest.
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
    const double cotangent = (a(q, q) - a(p, p)) / (2 * off); // the cotangent of twice the angle
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

/// The positions of the vertices of cells.
class CellVertices {
public:
  /// Places the vertices at the means of the points of each cell.
  template <class Soup>
  CellVertices(const Soup& soup, const Clusters& clusters) : cells_(clusters.cell_count()) {
    for (Index v = 0; v < soup.point_count(); ++v)
      if (soup.is_used(v))
        cells_[clusters.cell(v)].add(v, soup.position(v));
    for (Cell& cell : cells_)
      cell.displacement *= 1 / static_cast<double>(cell.points);
  }

  /// Moves each vertex to the point nearest to the planes of the triangles at its cell's points, or
  /// as far towards it as the cell extends: so the vertices of a flat region stay in its plane.
  template <class Soup>
  void minimize_quadrics(const Soup& soup, const Clusters& clusters, const CellGrid& grid) {
    const std::vector<QuadricForm<3>> quadrics = quadrics_of(soup, clusters);
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      Cell& cell = cells_[i];
      if (cell.points == 1)
        continue; // all planes meet in it
      const Vector<3> mean = cell.displacement, best = robust_minimizer(quadrics[i], mean);
      const double fraction =
          grid.fraction_in_cell_of(cell.anchor, cell.anchor + mean, cell.anchor + best);
      cell.displacement += fraction * (best - mean);
    }
  }

  /// The first point of the cell.
  Index first(Index cell) const { return cells_[cell].first; }
  Vector<3> position(Index cell) const { return cells_[cell].anchor + cells_[cell].displacement; }

private:
  // Sums are relative to a point of the cell, so they are as accurate far from the origin as near
  // to it.
  struct Cell {
    Vector<3> anchor, displacement; // the first point, and the vertex from there
    Index first = none, points = 0;

    void add(Index v, const Vector<3>& p) {
      if (points++ == 0) {
        anchor = p;
        first = v;
      }
      displacement += p - anchor;
    }
  };

  // Returns the quadric of each cell, relative to its anchor.
  template <class Soup>
  std::vector<QuadricForm<3>> quadrics_of(const Soup& soup, const Clusters& clusters) const {
    std::vector<QuadricForm<3>> quadrics(cells_.size());
    for (std::size_t f = 0; f < soup.triangle_count(); ++f) {
      const auto corners = soup.corners(f);
      const std::array positions{soup.position(corners[0]), soup.position(corners[1]),
                                 soup.position(corners[2])};
      const QuadricForm<3> plane = Quadric{}.face(positions[0], positions[1], positions[2]);
      for (std::size_t i = 0; i < 3; ++i)
        if (const Index cell = clusters.cell(corners[i]); cell != none) {
          QuadricForm<3> about_anchor = plane; // which goes through each corner
          about_anchor.move_origin(cells_[cell].anchor - positions[i]);
          quadrics[cell] += about_anchor;
        }
    }
    return quadrics;
  }

  /// Returns the minimizer that is nearest to `mean`: eigenvalues of the form below 10⁻³ of the
  /// greatest leave directions free. Source: Lindstrom, Out-of-core simplification of large
  /// polygonal models, 2000, section 3.3, which begins at the centre of the cell instead; beginning
  /// at the mean keeps flat regions with boundaries from growing.
  static Vector<3> robust_minimizer(const QuadricForm<3>& form, const Vector<3>& mean) {
    const Eigenvectors eigen(form.matrix());
    const double greatest = (std::max)({eigen.value(0), eigen.value(1), eigen.value(2)});
    const Vector<3> half_gradient = form.matrix() * mean + form.gradient();
    Vector<3> x = mean;
    for (std::size_t i = 0; i < 3; ++i)
      if (eigen.value(i) > 1e-3 * greatest)
        x -= (dot(eigen.vector(i), half_gradient) / eigen.value(i)) * eigen.vector(i);
    return x;
  }

  std::vector<Cell> cells_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CLUSTER_CELL_VERTICES_H
