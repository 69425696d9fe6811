#ifndef QUADRILLE_INTERNAL_POINTS_H
#define QUADRILLE_INTERNAL_POINTS_H

#include <quadrille/vector.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/number_utils.h>

namespace quadrille::internal {

/// The nearest doubles of a point of any CGAL kernel.
template <class Point>
Vector<3> from_cgal(const Point& p) {
  return {{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}};
}

/// A point of the given kernel at a position.
template <class Point>
Point to_cgal(const Vector<3>& p) {
  using FT = typename CGAL::Kernel_traits<Point>::Kernel::FT;
  return Point(FT(p[0]), FT(p[1]), FT(p[2]));
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_POINTS_H
