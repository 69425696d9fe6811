#ifndef QUADRILLE_INTERNAL_INTERSECTION_TRIANGLE_PAIR_H
#define QUADRILLE_INTERNAL_INTERSECTION_TRIANGLE_PAIR_H

#include <quadrille/internal/base/compiler.h>
#include <quadrille/internal/base/index.h>
#include <quadrille/vector.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Intersections_3/Segment_3_Triangle_3.h>
#include <CGAL/Intersections_3/Triangle_3_Triangle_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

/// \file
/// Do two triangles of a surface meet beyond the vertices that they have in common? Decided
/// exactly, by CGAL's kernel, where doubles cannot tell.

namespace quadrille::internal {

/// A face: its vertices, and where they lie.
struct FaceCorners {
  std::array<Index, 3> vertices;
  std::array<Vector<3>, 3> points;

  void swap(std::size_t i, std::size_t j) {
    std::swap(vertices[i], vertices[j]);
    std::swap(points[i], points[j]);
  }
};

/// A sum of products that doubles have computed, and what its terms add up to in size.
struct RoundedSum {
  double value = 0, size = 0;

  void add(double term) {
    value += term;
    size += std::abs(term);
  }
  bool is_positive() const { return value - tolerance * size > least; }
  bool is_negative() const { return -value - tolerance * size > least; }

  // Differences, their products and each sum are rounded once: a few times 2⁻⁵³ of a term, or next
  // to nothing where it underflows. NaN is neither positive nor negative.
  static constexpr double tolerance = 0x1p-49;
  static constexpr double least = 0x1p-1000;
};

/// Of differences of points, or with a vector that need not be exact.
inline RoundedSum rounded_dot(const Vector<3>& a, const Vector<3>& b) {
  RoundedSum sum;
  for (std::size_t i = 0; i < 3; ++i)
    sum.add(a[i] * b[i]);
  return sum;
}

/// Two triangles, of which the common vertices come first.
class TrianglePair {
public:
  TrianglePair(FaceCorners first, FaceCorners second) : first_(first), second_(second) {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = common_; j < 3; ++j)
        if (first_.vertices[i] == second_.vertices[j]) {
          first_.swap(i, common_);
          second_.swap(j, common_);
          ++common_;
          break;
        }
  }

  /// Do they meet in more than what they have in common? A triangle without an area meets none, and
  /// neither do two with the same three vertices.
  bool intersect() const {
    switch (common_) {
    case 0:
      return !are_apart() && intersect_exactly();
    case 1:
      return !are_apart_but_for_a_vertex() && intersect_exactly();
    case 2:
      return !are_apart_but_for_an_edge() && intersect_exactly();
    default:
      return false;
    }
  }

private:
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Point = Kernel::Point_3;

  static Point point(const Vector<3>& p) { return {p[0], p[1], p[2]}; }
  Point p(std::size_t i) const { return point(first_.points[i]); }
  Point q(std::size_t i) const { return point(second_.points[i]); }

  // Is there a plane across the line between the middles, with one on each side?
  bool are_apart() const {
    const std::array<Vector<3>, 3>&a = first_.points, &b = second_.points;
    const Vector<3> way = (b[0] + b[1] + b[2]) - (a[0] + a[1] + a[2]);
    for (const Vector<3>& from : a)
      for (const Vector<3>& to : b)
        if (!rounded_dot(way, to - from).is_positive())
          return false;
    return true;
  }

  // The same through the common vertex.
  bool are_apart_but_for_a_vertex() const {
    const Vector<3>& v = first_.points[0];
    const std::array sides{first_.points[1] - v, first_.points[2] - v, second_.points[1] - v,
                           second_.points[2] - v};
    const auto direction = [&](std::size_t i) {
      return (1 / std::sqrt(squared_length(sides[i]))) * sides[i];
    };
    const Vector<3> way = direction(0) + direction(1) - direction(2) - direction(3);
    return rounded_dot(way, sides[0]).is_positive() && rounded_dot(way, sides[1]).is_positive() &&
           rounded_dot(way, sides[2]).is_negative() && rounded_dot(way, sides[3]).is_negative();
  }

  // Is the angle between them an obtuse one?
  bool are_apart_but_for_an_edge() const {
    const auto& [v, w, apex] = first_.points;
    const Vector<3> edge = w - v, a = apex - v, b = second_.points[2] - v;
    // (e × a)·(e × b) = e·e a·b − e·a e·b
    const RoundedSum ee = rounded_dot(edge, edge), ab = rounded_dot(a, b),
                     ea = rounded_dot(edge, a), eb = rounded_dot(edge, b);
    const double value = ee.value * ab.value - ea.value * eb.value;
    const double size = ee.size * ab.size + ea.size * eb.size;
    return -value - 4 * RoundedSum::tolerance * size > RoundedSum::least;
  }

  QUADRILLE_NOINLINE bool intersect_exactly() const {
    const Point a = p(0), b = p(1), c = p(2), d = q(0), e = q(1), f = q(2);
    if (common_ == 2)
      return CGAL::orientation(a, b, c, f) == CGAL::COPLANAR && !CGAL::collinear(a, b, c) &&
             !CGAL::collinear(a, b, f) &&
             CGAL::coplanar_orientation(a, b, c, f) == CGAL::POSITIVE;
    if (is_on_one_side(a, b, c, {d, e, f}) || is_on_one_side(d, e, f, {a, b, c}))
      return false;
    if (CGAL::collinear(a, b, c) || CGAL::collinear(d, e, f))
      return false;
    const Kernel::Triangle_3 s(a, b, c), t(d, e, f);
    if (common_ == 0)
      return CGAL::do_intersect(s, t);
    return CGAL::do_intersect(s, Kernel::Segment_3(e, f)) ||
           CGAL::do_intersect(t, Kernel::Segment_3(b, c));
  }

  // Are those of the other triangle that are not in common on the same side of a plane, none on it?
  bool is_on_one_side(const Point& a, const Point& b, const Point& c,
                      const std::array<Point, 3>& others) const {
    const CGAL::Orientation side = CGAL::orientation(a, b, c, others[2]);
    return side != CGAL::COPLANAR && CGAL::orientation(a, b, c, others[1]) == side &&
           (common_ == 1 || CGAL::orientation(a, b, c, others[0]) == side);
  }

  FaceCorners first_, second_;
  std::size_t common_ = 0;
};

/// Has a triangle no area?
inline bool is_degenerate(const FaceCorners& face) {
  const auto& [a, b, c] = face.points;
  const Vector<3> ab = b - a, ac = c - a;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    RoundedSum normal;
    normal.add(ab[i] * ac[j]);
    normal.add(-ab[j] * ac[i]);
    if (normal.is_positive() || normal.is_negative())
      return false;
  }
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  const auto point = [](const Vector<3>& p) { return Point(p[0], p[1], p[2]); };
  return CGAL::collinear(point(a), point(b), point(c));
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_INTERSECTION_TRIANGLE_PAIR_H
