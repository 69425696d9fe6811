#ifndef QUADRILLE_INTERNAL_FILE_POLYGON_CUT_H
#define QUADRILLE_INTERNAL_FILE_POLYGON_CUT_H

#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Cuts a polygon, convex or not, into triangles, as readers of files in memory do: a quadrilateral
/// along the diagonal that folds it less, a larger polygon by the constrained Delaunay
/// triangulation in the coordinate plane that it faces most. That triangulation is found by ear
/// clipping (Meisters 1975) and by flipping diagonals while their circles are not empty (Lawson
/// 1977). A polygon that crosses itself or is flat becomes a fan. It takes O(n³) at worst, and
/// usually about O(n²).
class PolygonCut {
public:
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;

  /// The result uses the numbers of the polygon's corners; there are three or more. `fans` counts
  /// the polygons that become a fan.
  static Triangles triangles(const std::vector<Vector<3>>& corners, std::uint64_t* fans = nullptr) {
    const auto count = static_cast<std::uint32_t>(corners.size());
    if (count == 3)
      return {{0, 1, 2}};
    PolygonCut cut(corners);
    if (count == 4)
      return cut.quadrilateral();
    cut.project();
    if (cut.cut_ears()) {
      cut.turn_diagonals();
      return std::move(cut.triangles_);
    }
    if (fans)
      ++*fans;
    Triangles fan;
    for (std::uint32_t i = 2; i < count; ++i)
      fan.push_back({0, i - 1, i});
    return fan;
  }

private:
  using Point = std::array<double, 2>;

  // The polygon is moved to the origin and scaled by a power of two to a size of about one, so that
  // no area overflows or underflows.
  explicit PolygonCut(const std::vector<Vector<3>>& corners) {
    double size = 0;
    for (const Vector<3>& p : corners)
      for (std::size_t i = 0; i < 3; ++i)
        size = (std::max)(size, std::abs(p[i] - corners[0][i]));
    const int exponent = size > 0 && std::isfinite(size) ? -std::ilogb(size) : 0;
    for (const Vector<3>& p : corners) {
      Vector<3>& q = outline_.emplace_back();
      for (std::size_t i = 0; i < 3; ++i)
        q[i] = std::scalbn(p[i] - corners[0][i], exponent);
    }
  }

  // The product of the normals is larger for a flatter pair of triangles with better shapes; it is
  // negative for the diagonal outside a non-convex quadrilateral.
  Triangles quadrilateral() const {
    const auto normal = [&](std::size_t a, std::size_t b, std::size_t c) {
      return cross(outline_[b] - outline_[a], outline_[c] - outline_[a]);
    };
    if (dot(normal(0, 1, 2), normal(0, 2, 3)) >= dot(normal(1, 2, 3), normal(1, 3, 0)))
      return {{0, 1, 2}, {0, 2, 3}};
    return {{1, 2, 3}, {1, 3, 0}};
  }

  // Projects along the axis that is closest to Newell's normal, in the direction that makes the
  // polygon run counter-clockwise.
  void project() {
    Vector<3> normal{};
    for (std::size_t i = 0; i < outline_.size(); ++i)
      normal = normal + cross(outline_[i], outline_[(i + 1) % outline_.size()]);
    std::size_t along = 0;
    for (std::size_t axis = 1; axis < 3; ++axis)
      along = std::abs(normal[axis]) > std::abs(normal[along]) ? axis : along;
    const std::size_t turn = normal[along] < 0 ? 2 : 1;
    for (const Vector<3>& p : outline_)
      points_.push_back({p[(along + turn) % 3], p[(along + 2 * turn) % 3]});
  }

  // Twice the area, positive if the corners run counter-clockwise.
  double area(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const Point &p = points_[a], &q = points_[b], &r = points_[c];
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  }

  // Returns false if no ear is left, as for a polygon that crosses itself.
  bool cut_ears() {
    std::vector<std::uint32_t> left(points_.size());
    for (std::uint32_t i = 0; i < left.size(); ++i)
      left[i] = i;
    while (left.size() > 3) {
      const std::size_t ear = find_ear(left);
      if (ear == left.size())
        return false;
      add_ear(left, ear);
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    add_ear(left, 1);
    return area(left[0], left[1], left[2]) > 0;
  }
  void add_ear(const std::vector<std::uint32_t>& left, std::size_t i) {
    triangles_.push_back(
        {left[(i + left.size() - 1) % left.size()], left[i], left[(i + 1) % left.size()]});
  }

  std::size_t find_ear(const std::vector<std::uint32_t>& left) const {
    for (std::size_t i = 0; i < left.size(); ++i) {
      const std::uint32_t a = left[(i + left.size() - 1) % left.size()], b = left[i],
                          c = left[(i + 1) % left.size()];
      if (area(a, b, c) > 0 && std::none_of(left.begin(), left.end(), [&](std::uint32_t p) {
            return p != a && p != b && p != c && area(a, b, p) >= 0 && area(b, c, p) >= 0 &&
                   area(c, a, p) >= 0;
          }))
        return i;
    }
    return left.size();
  }

  // Is d within the circle of a, b and c, by more than a rounding error?
  bool is_in_circle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    const auto row = [&](std::uint32_t v) {
      const double x = points_[v][0] - points_[d][0], y = points_[v][1] - points_[d][1];
      return Vector<3>{{x, y, x * x + y * y}};
    };
    return dot(row(a), cross(row(b), row(c))) > 1e-12;
  }

  // Flips the edge of pairs of triangles until none is flipped any more.
  void turn_diagonals() {
    bool has_turned = true;
    for (std::size_t round = 0; has_turned && round < 2 * points_.size(); ++round) {
      has_turned = false;
      for (std::size_t s = 0; s < triangles_.size(); ++s)
        for (std::size_t t = s + 1; t < triangles_.size(); ++t)
          has_turned = turn(triangles_[s], triangles_[t]) || has_turned;
    }
  }

  bool turn(std::array<std::uint32_t, 3>& s, std::array<std::uint32_t, 3>& t) const {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const std::uint32_t a = s[i], b = s[(i + 1) % 3], c = s[(i + 2) % 3];
        if (t[j] != b || t[(j + 1) % 3] != a)
          continue;
        const std::uint32_t d = t[(j + 2) % 3];
        if (!is_in_circle(a, b, c, d) || !(area(a, d, c) > 0) || !(area(d, b, c) > 0))
          return false;
        s = {a, d, c};
        t = {d, b, c};
        return true;
      }
    return false;
  }

  std::vector<Vector<3>> outline_;
  std::vector<Point> points_; // of its projection
  Triangles triangles_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_POLYGON_CUT_H
