#ifndef QUADRILLE_INTERNAL_CORE_SURFACE_POLYGON_CUT_H
#define QUADRILLE_INTERNAL_CORE_SURFACE_POLYGON_CUT_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/surface/constrained_triangulation.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Cuts a polygon, convex or not, into triangles: a quadrilateral, which need not be flat, along
/// the diagonal that folds it less; a larger polygon by the constrained Delaunay triangulation in
/// the coordinate plane that it faces most. A polygon becomes a fan if its projection crosses or
/// touches itself, or is flat, so that inside and outside cannot be distinguished.
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
    if (cut.project() && cut.triangulate())
      return std::move(cut.triangles_);
    if (fans)
      ++*fans;
    Triangles fan;
    for (std::uint32_t i = 2; i < count; ++i)
      fan.push_back({0, i - 1, i});
    return fan;
  }

private:
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
  // polygon run counter-clockwise. Returns false if that is no place.
  bool project() {
    Vector<3> normal{};
    for (std::size_t i = 0; i < outline_.size(); ++i)
      normal = normal + cross(outline_[i], outline_[(i + 1) % outline_.size()]);
    std::size_t along = 0;
    for (std::size_t axis = 1; axis < 3; ++axis)
      along = std::abs(normal[axis]) > std::abs(normal[along]) ? axis : along;
    const std::size_t turn = normal[along] < 0 ? 2 : 1;
    for (const Vector<3>& p : outline_) {
      if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
        return false;
      points_.emplace_back(p[(along + turn) % 3], p[(along + 2 * turn) % 3]);
    }
    return true;
  }

  bool triangulate() {
    ConstrainedTriangulation triangulation;
    if (!triangulation.insert(points_))
      return false;
    const auto count = static_cast<Index>(points_.size());
    for (Index i = 0; i < count; ++i)
      if (!triangulation.constrain(i, (i + 1) % count))
        return false;
    const std::vector<bool> is_outside = outside(triangulation.triangles());
    for (std::size_t t = 0; t < is_outside.size(); ++t)
      if (!is_outside[t])
        triangles_.push_back(triangulation.triangles()[t].corners);
    return true;
  }

  // Finds all that can be reached from infinity without crossing the outline.
  static std::vector<bool> outside(const std::vector<ConstrainedTriangulation::Triangle>& all) {
    std::vector<bool> is_outside(all.size(), false);
    std::vector<Index> reached;
    for (Index t = 0; t < all.size(); ++t)
      if (all[t].is_infinite())
        reached.push_back(t);
    while (!reached.empty()) {
      const Index t = reached.back();
      reached.pop_back();
      if (is_outside[t])
        continue;
      is_outside[t] = true;
      for (std::size_t i = 0; i < 3; ++i)
        if (!all[t].is_constrained[i])
          reached.push_back(all[t].mates[i]);
    }
    return is_outside;
  }

  std::vector<Vector<3>> outline_;
  std::vector<ConstrainedTriangulation::Point> points_; // of its projection
  Triangles triangles_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_SURFACE_POLYGON_CUT_H
