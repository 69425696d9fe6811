#ifndef QUADRILLE_INTERNAL_CORE_BASE_POINTS_H
#define QUADRILLE_INTERNAL_CORE_BASE_POINTS_H

#include <quadrille/quadric_form.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <concepts>
#include <limits>
#include <type_traits>
#include <utility>

namespace quadrille::internal {

/// A point of a CGAL kernel, or another one to be read like that.
template <class P>
concept NamedPoint = requires(const P& p) {
  CGAL::to_double(p.x());
  CGAL::to_double(p.y());
  CGAL::to_double(p.z());
};

/// Three numbers by index, as std::array<float, 3>.
template <class P>
concept IndexedPoint = std::is_trivially_destructible_v<P> && requires(P& p) {
  p[0] = p[1];
  requires std::is_floating_point_v<std::remove_cvref_t<decltype(p[0])>>;
  requires sizeof(P) == 3 * sizeof(p[0]);
};

template <class P>
concept ReadablePoint = NamedPoint<P> || IndexedPoint<P>;

/// The coordinates, or the nearest doubles.
template <class Point>
Vector<3> position_of(const Point& p) {
  static_assert(ReadablePoint<Point>,
                "quadrille: a point has to be a point of a CGAL kernel, or three numbers by index "
                "such as std::array<double, 3>");
  if constexpr (NamedPoint<Point>)
    return {{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}};
  else if constexpr (IndexedPoint<Point>)
    return {{static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])}};
  else
    return {};
}

/// Are the coordinates of a point floats?
template <class Point>
constexpr bool has_float_coordinates() {
  if constexpr (NamedPoint<Point>)
    return std::same_as<std::remove_cvref_t<decltype(std::declval<const Point&>().x())>, float>;
  else if constexpr (IndexedPoint<Point>)
    return std::same_as<std::remove_cvref_t<decltype(std::declval<Point&>()[0])>, float>;
  else
    return false;
}

/// A finite number of type T: what lies beyond the greatest becomes that.
template <class T>
T to_number(double x) {
  constexpr double greatest_double = (std::numeric_limits<double>::max)();
  if constexpr (std::floating_point<T> && sizeof(T) < sizeof(double)) {
    constexpr auto greatest = static_cast<double>((std::numeric_limits<T>::max)());
    return static_cast<T>(std::clamp(x, -greatest, greatest));
  } else {
    return T(std::clamp(x, -greatest_double, greatest_double));
  }
}

/// A point of the given type at a position.
template <class Point>
Point point_at(const Vector<3>& position) {
  const auto [x, y, z] = position.coordinates;
  if constexpr (IndexedPoint<Point>) {
    using Number = std::remove_cvref_t<decltype(std::declval<Point&>()[0])>;
    Point point{};
    point[0] = to_number<Number>(x);
    point[1] = to_number<Number>(y);
    point[2] = to_number<Number>(z);
    return point;
  } else {
    using FT = typename CGAL::Kernel_traits<Point>::Kernel::FT;
    return Point(to_number<FT>(x), to_number<FT>(y), to_number<FT>(z));
  }
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_BASE_POINTS_H
