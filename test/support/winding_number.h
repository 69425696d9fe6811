#ifndef QUADRILLE_TEST_WINDING_NUMBER_H
#define QUADRILLE_TEST_WINDING_NUMBER_H

#include "soups.h"

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

/// \file
/// Winding numbers of soups, exactly, with nothing of the engine and none of CGAL's predicates.

namespace test {

using Rational = CGAL::Exact_rational;

/// The sign of the determinant of q − p, r − p, s − p, exactly: positive if s lies on the side of
/// pqr to which its normal points.
inline int orientation(const Position& p, const Position& q, const Position& r, const Position& s) {
  const Position a = q - p, b = r - p, c = s - p;
  const auto size = [](const Position& v) {
    return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  };
  const double value = dot(a, cross(b, c));
  if (std::abs(value) > 1e-13 * size(a) * size(b) * size(c) + 1e-280)
    return value > 0 ? 1 : -1;
  const auto row = [&](const Position& v) {
    std::array<Rational, 3> difference;
    for (std::size_t i = 0; i < 3; ++i)
      difference[i] = Rational(v[i]) - Rational(p[i]);
    return difference;
  };
  const auto x = row(q), y = row(r), z = row(s);
  const Rational exact = x[0] * (y[1] * z[2] - y[2] * z[1]) - x[1] * (y[0] * z[2] - y[2] * z[0]) +
                         x[2] * (y[0] * z[1] - y[1] * z[0]);
  return exact > 0 ? 1 : exact < 0 ? -1 : 0;
}

/// Counts by a segment from a point to one outside of the box of a closed surface: +1 where it goes
/// out of it, −1 where it goes in.
class WindingNumber {
public:
  explicit WindingNumber(const Soup& soup) : soup_(soup), length_(4 * diagonal(soup)) {}

  /// Nothing for a point on the surface.
  std::optional<int> operator()(const Position& q) const {
    Random random(17);
    for (;;) {
      const Position end =
          q + Position{{random(-0.01, 0.01) * length_, random(-0.01, 0.01) * length_, length_}};
      if (const std::optional<Count> count = count_along(q, end))
        return count->is_on_surface ? std::nullopt : std::optional(count->crossings);
    }
  }

private:
  struct Count {
    int crossings;
    bool is_on_surface;
  };

  // Nothing if the segment meets an edge.
  std::optional<Count> count_along(const Position& q, const Position& end) const {
    Count count{0, false};
    for (const auto& [i, j, k] : soup_.triangles) {
      const Position &a = soup_.points[i], &b = soup_.points[j], &c = soup_.points[k];
      if (are_apart(q, end, a, b, c))
        continue;
      const int from = orientation(a, b, c, q), to = orientation(a, b, c, end);
      if (from == to || to == 0)
        continue; // lies beside its plane, or in it: then no segment that matters
      const std::array<int, 3> sides{orientation(q, end, a, b), orientation(q, end, b, c),
                                     orientation(q, end, c, a)};
      const auto [least, most] = std::minmax_element(sides.begin(), sides.end());
      if (*least < 0 && *most > 0)
        continue;
      if (from == 0)
        count.is_on_surface = true;
      else if (*least * *most == 0)
        return std::nullopt;
      else
        count.crossings += to;
    }
    return count;
  }

  static bool are_apart(const Position& q, const Position& end, const Position& a,
                        const Position& b, const Position& c) {
    for (std::size_t i = 0; i < 3; ++i)
      if (std::max({a[i], b[i], c[i]}) < std::min(q[i], end[i]) ||
          std::min({a[i], b[i], c[i]}) > std::max(q[i], end[i]))
        return true;
    return false;
  }

  const Soup& soup_;
  double length_;
};

} // namespace test

#endif // QUADRILLE_TEST_WINDING_NUMBER_H
