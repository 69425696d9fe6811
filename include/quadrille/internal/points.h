#ifndef QUADRILLE_INTERNAL_POINTS_H
#define QUADRILLE_INTERNAL_POINTS_H

#include <quadrille/vector.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <concepts>
#include <limits>

namespace quadrille::internal {

/// The nearest doubles of a point of any CGAL kernel.
template <class Point>
Vector<3> from_cgal(const Point& p) {
  return {{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}};
}

/// A finite number of type T: what lies beyond the greatest becomes that.
template <class T>
T to_number(double x) {
  constexpr double greatest_double = std::numeric_limits<double>::max();
  if constexpr (std::floating_point<T> && sizeof(T) < sizeof(double)) {
    constexpr double greatest = std::numeric_limits<T>::max();
    return static_cast<T>(std::clamp(x, -greatest, greatest));
  } else {
    return T(std::clamp(x, -greatest_double, greatest_double));
  }
}

/// A point of the given kernel at a position.
template <class Point>
Point to_cgal(const Vector<3>& p) {
  using FT = typename CGAL::Kernel_traits<Point>::Kernel::FT;
  return Point(to_number<FT>(p[0]), to_number<FT>(p[1]), to_number<FT>(p[2]));
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_POINTS_H
