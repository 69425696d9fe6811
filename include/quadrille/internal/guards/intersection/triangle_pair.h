#ifndef QUADRILLE_INTERNAL_GUARDS_INTERSECTION_TRIANGLE_PAIR_H
#define QUADRILLE_INTERNAL_GUARDS_INTERSECTION_TRIANGLE_PAIR_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/quadric_form.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Intersections_3/Segment_3_Triangle_3.h>
#include <CGAL/Intersections_3/Triangle_3_Triangle_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

/// \file
/// Do two triangles of a surface meet beyond the vertices that they have in common? This is
/// decided exactly, by CGAL's kernel, if doubles cannot decide it.

namespace quadrille::internal {

/// A face: its vertices, and where they lie.
struct FaceCorners {
  std::array<Index, 3> vertices;
  std::array<Vector<3>, 3> points;
};

/// A sum of products that doubles have computed, and what its terms add up to in size.
struct RoundedSum {
  double value = 0, size = 0;

  QUADRILLE_ALWAYS_INLINE void add(double term) {
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

QUADRILLE_ALWAYS_INLINE inline Vector<3> difference(const Vector<3>& a, const Vector<3>& b) {
  return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
}

/// Returns a product of differences of points, or with a vector that need not be exact.
QUADRILLE_ALWAYS_INLINE inline RoundedSum rounded_dot(const Vector<3>& a, const Vector<3>& b) {
  const double x = a[0] * b[0], y = a[1] * b[1], z = a[2] * b[2];
  return {x + y + z, std::abs(x) + std::abs(y) + std::abs(z)};
}

/// Two triangles, of which the common vertices come first.
class TrianglePair {
public:
  /// The corners are not copied: they have to be there as long as this is.
  TrianglePair(const FaceCorners& first, const FaceCorners& second)
      : first_{&first.points[0], &first.points[1], &first.points[2]}, second_{&second.points[0],
                                                                              &second.points[1],
                                                                              &second.points[2]} {
    std::array<Index, 3> others = second.vertices;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = common_; j < 3; ++j)
        if (first.vertices[i] == others[j]) {
          std::swap(first_[i], first_[common_]);
          std::swap(second_[j], second_[common_]);
          std::swap(others[j], others[common_]);
          ++common_;
          break;
        }
  }
  TrianglePair(const FaceCorners&&, const FaceCorners&) = delete;
  TrianglePair(const FaceCorners&, const FaceCorners&&) = delete;
  TrianglePair(const FaceCorners&&, const FaceCorners&&) = delete;

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

  /// Have they points in common that are inside of both, and do not lie in one plane? Then each has
  /// corners on both sides of the other's plane, and of the line that both planes have in common
  /// each has a segment. The signs of two volumes show whether these overlap: Guigue and Devillers,
  /// Fast and robust triangle-triangle overlap test using orientation predicates, 2003.
  QUADRILLE_NOINLINE bool pass_through() const {
    std::array s{point(first_[0]), point(first_[1]), point(first_[2])};
    std::array t{point(second_[0]), point(second_[1]), point(second_[2])};
    return common_ < 2 && begin_alone(s, t) && begin_alone(t, s) &&
           CGAL::orientation(s[0], s[1], t[0], t[1]) == CGAL::NEGATIVE &&
           CGAL::orientation(s[0], s[2], t[2], t[0]) == CGAL::NEGATIVE;
  }

private:
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Point = Kernel::Point_3;
  using Points = std::array<const Vector<3>*, 3>;

  static Point point(const Vector<3>* p) { return {(*p)[0], (*p)[1], (*p)[2]}; }

  // Is there a plane across the line between the middles, with one on each side?
  bool are_apart() const {
    const Points &a = first_, &b = second_;
    Vector<3> direction;
    for (std::size_t i = 0; i < 3; ++i)
      direction[i] =
          ((*b[0])[i] + (*b[1])[i] + (*b[2])[i]) - ((*a[0])[i] + (*a[1])[i] + (*a[2])[i]);
    for (const Vector<3>* from : a)
      for (const Vector<3>* to : b)
        if (!rounded_dot(direction, difference(*to, *from)).is_positive())
          return false;
    return true;
  }

  // Are the triangles apart but for the common vertex? Then a plane through it separates them.
  bool are_apart_but_for_a_vertex() const {
    const Vector<3>& v = *first_[0];
    const std::array sides{difference(*first_[1], v), difference(*first_[2], v),
                           difference(*second_[1], v), difference(*second_[2], v)};
    std::array<double, 4> inverse_lengths;
    for (std::size_t i = 0; i < 4; ++i)
      inverse_lengths[i] = 1 / std::sqrt(rounded_dot(sides[i], sides[i]).value);
    Vector<3> direction;
    for (std::size_t i = 0; i < 3; ++i)
      direction[i] = inverse_lengths[0] * sides[0][i] + inverse_lengths[1] * sides[1][i] -
                     inverse_lengths[2] * sides[2][i] - inverse_lengths[3] * sides[3][i];
    return rounded_dot(direction, sides[0]).is_positive() &&
           rounded_dot(direction, sides[1]).is_positive() &&
           rounded_dot(direction, sides[2]).is_negative() &&
           rounded_dot(direction, sides[3]).is_negative();
  }

  // Is the angle between them an obtuse one?
  bool are_apart_but_for_an_edge() const {
    const Vector<3>& v = *first_[0];
    const Vector<3> edge = difference(*first_[1], v), a = difference(*first_[2], v),
                    b = difference(*second_[2], v);
    // (e × a)·(e × b) = e·e a·b − e·a e·b
    const RoundedSum ee = rounded_dot(edge, edge), ab = rounded_dot(a, b),
                     ea = rounded_dot(edge, a), eb = rounded_dot(edge, b);
    const double value = ee.value * ab.value - ea.value * eb.value;
    const double size = ee.size * ab.size + ea.size * eb.size;
    return -value - 4 * RoundedSum::tolerance * size > RoundedSum::least;
  }

  QUADRILLE_NOINLINE bool intersect_exactly() const {
    const Point a = point(first_[0]), b = point(first_[1]), c = point(first_[2]),
                d = point(second_[0]), e = point(second_[1]), f = point(second_[2]);
    if (common_ == 2)
      return CGAL::orientation(a, b, c, f) == CGAL::COPLANAR && !CGAL::collinear(a, b, c) &&
             !CGAL::collinear(a, b, f) && CGAL::coplanar_orientation(a, b, c, f) == CGAL::POSITIVE;
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

  // Turns s so that its first corner is alone in front of the plane of t, and another one behind
  // it; t is turned over if that is on its other side. Returns false if no corner is.
  static bool begin_alone(std::array<Point, 3>& s, std::array<Point, 3>& t) {
    for (int i = 0; i < 3; ++i) {
      const CGAL::Orientation side = CGAL::orientation(t[0], t[1], t[2], s[0]),
                              next = CGAL::orientation(t[0], t[1], t[2], s[1]),
                              last = CGAL::orientation(t[0], t[1], t[2], s[2]);
      if (side != CGAL::COPLANAR && next != side && last != side &&
          (next == -side || last == -side)) {
        if (side == CGAL::NEGATIVE)
          std::swap(t[1], t[2]);
        return true;
      }
      std::rotate(s.begin(), s.begin() + 1, s.end());
    }
    return false;
  }

  Points first_, second_;
  std::size_t common_ = 0;
};

/// Has a triangle no area?
inline bool is_degenerate(const FaceCorners& face) {
  const auto& [a, b, c] = face.points;
  const Vector<3> ab = difference(b, a), ac = difference(c, a);
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

#endif // QUADRILLE_INTERNAL_GUARDS_INTERSECTION_TRIANGLE_PAIR_H
