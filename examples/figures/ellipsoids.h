#ifndef QUADRILLE_EXAMPLES_FIGURES_ELLIPSOIDS_H
#define QUADRILLE_EXAMPLES_FIGURES_ELLIPSOIDS_H

#include "generate.h"
#include "surfaces.h"

#include <quadrille/quadric_form.h>
#include <quadrille/symmetric_matrix.h>
#include <quadrille/vector.h>

#include <array>
#include <cmath>
#include <cstddef>

/// Quadrics as ellipsoids.

namespace figures {

using QuadricForm = quadrille::QuadricForm<3>;
using QuadricMap = Mesh::Property_map<Vertex, QuadricForm>;

/// The quadrics of a mesh, for `simplify` to write.
inline QuadricMap quadrics(Mesh& mesh) {
  return mesh.add_property_map<Vertex, QuadricForm>("v:quadric").first;
}

/// Three vectors that the linear map to which they belong takes the unit sphere with to the
/// ellipsoid xᵀAx = 1: they are orthonormal as A measures.
inline std::array<quadrille::Vector<3>, 3>
conjugate_half_axes(const quadrille::SymmetricMatrix<3>& a) {
  std::array<quadrille::Vector<3>, 3> axes;
  for (std::size_t i = 0; i < 3; ++i) {
    quadrille::Vector<3> axis;
    axis[i] = 1;
    for (std::size_t j = 0; j < i; ++j)
      axis -= dot(axes[j], a * axis) * axes[j];
    axes[i] = (1 / std::sqrt(dot(axis, a * axis))) * axis;
  }
  return axes;
}

/// For each vertex the ellipsoid around it on which its quadric, but for the linear term, is
/// level² above its value at the vertex. No half axis is longer than `longest`.
inline Mesh ellipsoids(const Mesh& mesh, const QuadricMap& quadrics, double level, double longest) {
  const Mesh unit_sphere = sphere(16, 9);
  Mesh all;
  for (const Vertex v : mesh.vertices()) {
    quadrille::SymmetricMatrix<3> a = quadrics[v].matrix();
    a.add_to_diagonal(level * level / (longest * longest));
    const auto axes = conjugate_half_axes(a);
    Mesh ellipsoid = unit_sphere;
    for (const Vertex w : ellipsoid.vertices()) {
      const Point u = unit_sphere.point(w);
      const auto x = level * (u.x() * axes[0] + u.y() * axes[1] + u.z() * axes[2]);
      ellipsoid.point(w) = mesh.point(v) + Kernel::Vector_3(x[0], x[1], x[2]);
    }
    all += ellipsoid;
  }
  return all;
}

} // namespace figures

#endif
