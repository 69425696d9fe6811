#ifndef QUADRILLE_INTERNAL_VERIFY_GREATEST_EXCESS_H
#define QUADRILLE_INTERNAL_VERIFY_GREATEST_EXCESS_H

#include <quadrille/internal/verify/allowed_faces.h>
#include <quadrille/internal/verify/check_progress.h>

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Computes by how much, at most, points of triangles exceed the distances that faces allow; it is
/// 0 if none does. Triangles are cut along the sides of the faces below them. The excess over one
/// face is convex, so its maximum over a polygon is at a corner. A polygon is done when all of its
/// corners are near enough to one face, or when it is so small that its centre decides. So where
/// the surfaces coincide in a plane, the number of polygons depends on the number of faces of both
/// surfaces there, however small the error is.
class GreatestExcess {
public:
  /// `error` is the positive amount by which the result may be less than the true value. `known` is
  /// the excess of other triangles: smaller excesses are not searched for.
  GreatestExcess(const AllowedFaces& faces, double error, CheckProgress& progress, double known = 0)
      : faces_(faces), error_(error), greatest_(known), progress_(progress) {}

  double greatest() const { return greatest_; }
  /// The point with the greatest excess, if there is one.
  const DistancePoint& place() const { return place_; }

  /// Takes in the corners of a triangle whose points may be further away by `allowance`. If the
  /// corners of all triangles are taken in first, the rest is faster.
  void look_at_corners(const DistanceTriangle& t, double allowance) {
    progress_.step();
    for (int i = 0; i < 3; ++i)
      measure(t[i], allowance);
  }

  /// Takes in all points of a triangle.
  void look_at(const DistanceTriangle& t, double allowance) {
    cells_.push_back({{t[0], t[1], t[2]}, 0});
    while (!cells_.empty()) {
      progress_.step();
      const Cell cell = std::move(cells_.back());
      cells_.pop_back();
      look_at(cell, allowance);
    }
  }

private:
  using Polygon = std::vector<DistancePoint>; // convex
  struct Cell {
    Polygon corners;
    int cuts; ///< the number of cuts along faces that led to this polygon
  };
  static constexpr int most_cuts = 60;
  static constexpr double rounding = 0x1p-44; // for coordinates in the frame, which are about 1

  double measure(const DistancePoint& p, double allowance) {
    const auto [face, excess] = faces_.nearest(p, hint_);
    hint_ = face;
    if (excess - allowance > greatest_) {
      greatest_ = excess - allowance;
      place_ = p;
    }
    return excess - allowance;
  }

  void look_at(const Cell& cell, double allowance) {
    const DistancePoint middle = middle_of(cell.corners);
    const double excess = measure(middle, allowance);
    const std::size_t face = hint_;
    const double farthest = std::sqrt(CGAL::squared_distance(middle, farthest_from(middle, cell)));
    if (excess + farthest <= greatest_ + error_ || is_near(cell.corners, face, allowance))
      return;
    if (cell.cuts < most_cuts && cut_along(face, cell, allowance))
      return;
    halve(cell, middle);
  }

  bool is_near(const Polygon& corners, std::size_t face, double allowance) const {
    return std::all_of(corners.begin(), corners.end(), [&](const DistancePoint& p) {
      return faces_.excess(face, p) - allowance <= greatest_ + error_;
    });
  }

  static DistancePoint middle_of(const Polygon& corners) {
    DistanceVector sum(0, 0, 0);
    for (const DistancePoint& p : corners)
      sum = sum + (p - CGAL::ORIGIN);
    return CGAL::ORIGIN + sum / static_cast<double>(corners.size());
  }
  static DistancePoint farthest_from(const DistancePoint& middle, const Cell& cell) {
    return *std::max_element(cell.corners.begin(), cell.corners.end(),
                             [&](const DistancePoint& p, const DistancePoint& q) {
                               return CGAL::squared_distance(p, middle) <
                                      CGAL::squared_distance(q, middle);
                             });
  }

  /// Cuts off the parts beyond the sides of a face; false if there are none, or if nothing else
  /// would be left.
  bool cut_along(std::size_t face, const Cell& cell, double allowance) {
    const DistanceTriangle& t = faces_.triangle(face);
    const DistanceVector normal = CGAL::cross_product(t[1] - t[0], t[2] - t[0]);
    Polygon over = cell.corners;
    std::vector<Polygon> beyond;
    for (int i = 0; i < 3; ++i) {
      DistanceVector out = CGAL::cross_product(t[(i + 1) % 3] - t[i], normal);
      const double length = std::sqrt(out.squared_length());
      if (!(length > 0))
        return false;
      auto [inner, outer] = cut(over, t[i], out / length);
      if (inner.empty())
        return false;
      if (!outer.empty())
        beyond.push_back(std::move(outer));
      over = std::move(inner);
    }
    if (beyond.empty())
      return false;
    for (Polygon& polygon : beyond)
      cells_.push_back({std::move(polygon), cell.cuts + 1});
    if (!is_near(over, face, allowance))
      halve({over, cell.cuts + 1}, middle_of(over));
    return true;
  }

  void halve(const Cell& cell, const DistancePoint& middle) {
    const DistanceVector along = farthest_from(middle, cell) - middle;
    auto [first, second] = cut(cell.corners, middle, along / std::sqrt(along.squared_length()));
    for (Polygon* half : {&first, &second})
      if (!half->empty())
        cells_.push_back({std::move(*half), cell.cuts});
  }

  /// Returns the part of a polygon behind a plane and the part in front of it. If the polygon
  /// reaches beyond the plane only by a rounding error, that side alone is empty.
  static std::array<Polygon, 2> cut(const Polygon& polygon, const DistancePoint& origin,
                                    const DistanceVector& direction) {
    std::vector<double> heights;
    for (const DistancePoint& p : polygon)
      heights.push_back((p - origin) * direction);
    const auto [lowest, highest] = std::minmax_element(heights.begin(), heights.end());
    if (*highest <= rounding)
      return {polygon, Polygon()};
    if (*lowest >= -rounding)
      return {Polygon(), polygon};
    std::array<Polygon, 2> sides;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const std::size_t j = (i + 1) % polygon.size();
      const double h = heights[i], k = heights[j];
      if (h <= 0)
        sides[0].push_back(polygon[i]);
      if (h >= 0)
        sides[1].push_back(polygon[i]);
      if ((h < 0 && k > 0) || (h > 0 && k < 0))
        for (Polygon& side : sides)
          side.push_back(polygon[i] + h / (h - k) * (polygon[j] - polygon[i]));
    }
    return sides;
  }

  const AllowedFaces& faces_;
  double error_, greatest_;
  CheckProgress& progress_;
  DistancePoint place_{0, 0, 0};
  std::size_t hint_ = 0;
  std::vector<Cell> cells_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VERIFY_GREATEST_EXCESS_H
