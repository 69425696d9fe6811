#ifndef QUADRILLE_INTERNAL_VISIBILITY_RAY_TREE_H
#define QUADRILLE_INTERNAL_VISIBILITY_RAY_TREE_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/surface/box.h>
#include <quadrille/internal/core/surface/box_tree.h>
#include <quadrille/internal/core/surface/scale.h>
#include <quadrille/quadric_form.h>
#include <quadrille/triangle_soup.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// A ray to infinity, with what a test against boxes needs.
class Ray {
public:
  Ray(const Vector<3>& origin, const Vector<3>& direction)
      : origin_(origin), direction_(direction) {
    for (std::size_t i = 0; i < 3; ++i) {
      constexpr double least = 1e-20; // no division by 0
      const double step =
          std::abs(direction[i]) > least ? direction[i] : std::copysign(least, direction[i]);
      at_[i] = static_cast<float>(origin[i]);
      inverse_[i] = static_cast<float>(1 / step);
    }
  }

  /// A bit for each box that the ray may hit: boxes have to be padded by more than the rounding of
  /// floats.
  std::uint32_t hits(const EightBoxes& boxes) const {
    const auto& x = side(boxes, 0);
    const auto& y = side(boxes, 1);
    const auto& z = side(boxes, 2);
    const auto& far_x = far_side(boxes, 0);
    const auto& far_y = far_side(boxes, 1);
    const auto& far_z = far_side(boxes, 2);
    std::array<std::int32_t, EightBoxes::width> does;
    for (std::size_t lane = 0; lane < EightBoxes::width; ++lane) {
      const float near_xy =
          larger((x[lane] - at_[0]) * inverse_[0], (y[lane] - at_[1]) * inverse_[1]);
      const float near_z = larger((z[lane] - at_[2]) * inverse_[2], 0);
      const float far_xy =
          smaller((far_x[lane] - at_[0]) * inverse_[0], (far_y[lane] - at_[1]) * inverse_[1]);
      const float end = smaller(far_xy, (far_z[lane] - at_[2]) * inverse_[2]);
      does[lane] = std::int32_t{larger(near_xy, near_z) <= end};
    }
    std::uint32_t bits = 0;
    for (std::size_t lane = 0; lane < EightBoxes::width; ++lane)
      bits |= static_cast<std::uint32_t>(does[lane]) << lane;
    return bits;
  }

  Ray reversed() const { return {origin_, -1.0 * direction_}; }

  /// Returns how far away the ray hits a triangle, in lengths of its direction; a negative number
  /// if it does not. Edges and corners belong to the triangle. The test of an edge has the same
  /// bits for both of its triangles, so no ray passes between them. Source: Jiménez, Segura and
  /// Feito, A robust segment/triangle intersection algorithm for interference tests, 2010 (signs of
  /// volumes).
  double distance(const Vector<3>& p, const Vector<3>& q, const Vector<3>& r) const {
    const Vector<3> a = p - origin_, b = q - origin_, c = r - origin_;
    const Vector<3> bc = cross(b, c);
    const double u = dot(direction_, bc), v = dot(direction_, cross(c, a)),
                 w = dot(direction_, cross(a, b));
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0))
      return -1;
    const double volume = u + v + w;
    const double height = dot(a, cross(b - a, c - a));
    return volume != 0 ? height / volume : -1;
  }

private:
  using Lanes8 = std::array<float, EightBoxes::width>;
  const Lanes8& side(const EightBoxes& boxes, std::size_t i) const {
    return inverse_[i] > 0 ? boxes.low[i] : boxes.high[i];
  }
  const Lanes8& far_side(const EightBoxes& boxes, std::size_t i) const {
    return inverse_[i] > 0 ? boxes.high[i] : boxes.low[i];
  }
  static float larger(float a, float b) { return a > b ? a : b; }
  static float smaller(float a, float b) { return a < b ? a : b; }

  Vector<3> origin_, direction_;
  std::array<float, 3> at_{}, inverse_{};
};

/// The triangles of a surface in a tree of boxes, in which rays look for anything in their way. The
/// places of triangles in the tree are *slots*: neighbours in space have neighbouring slots.
/// Lengths are in a unit in which the surface reaches from -1 to 1 or less.
class RayTree {
public:
  using Triangle = std::array<Index, 3>;

  explicit RayTree(const SurfaceView& surface) {
    take_points(surface);
    sort_faces(surface);
    take_triangles(surface);
    build();
  }

  std::size_t size() const { return faces_.size(); }
  /// Returns the input index of the face in a slot.
  Index face(std::size_t slot) const { return faces_[slot]; }
  /// Returns numbers of the corners of a face, which mean something for this tree only.
  const Triangle& triangle(std::size_t slot) const { return triangles_[slot]; }
  const std::vector<Vector<3>>& points() const { return points_; }
  std::array<Vector<3>, 3> corners(std::size_t slot) const {
    const auto [a, b, c] = triangles_[slot];
    return {points_[a], points_[b], points_[c]};
  }

  /// Is any triangle in the way, but those for which ignores(slot) is true? `recent`, the block of
  /// slots in which something was last, is looked at first: the answer does not depend on it, only
  /// the time.
  template <class Ignores>
  bool is_blocked(const Ray& ray, const Ignores& ignores, Index& recent) const {
    const auto blocks = [&](std::size_t slot) {
      return !ignores(slot) && distance(slot, ray) > least_distance;
    };
    if (recent != none && levels_.size() > 1 && descend(1, recent, ray, blocks, recent))
      return true;
    return !levels_.empty() && descend(levels_.size() - 1, 0, ray, blocks, recent);
  }

  /// Returns the slot of the first triangle in the way for which ignores(slot) is false, or none.
  template <class Ignores>
  Index nearest(const Ray& ray, const Ignores& ignores) const {
    Index first = none, recent = none;
    double nearest = std::numeric_limits<double>::infinity();
    const auto look = [&](std::size_t slot) {
      if (const double there = ignores(slot) ? -1 : distance(slot, ray);
          there > least_distance && there < nearest) {
        nearest = there;
        first = static_cast<Index>(slot);
      }
      return false;
    };
    if (!levels_.empty())
      descend(levels_.size() - 1, 0, ray, look, recent);
    return first;
  }

private:
  static constexpr std::size_t width = EightBoxes::width;
  static constexpr double least_distance =
      1e-9; // more than rounding: coplanar faces do not hide each other
  static constexpr float padding = 1e-6F;

  // The centre is at the origin.
  void take_points(const SurfaceView& surface) {
    points_.assign(surface.points.begin(), surface.points.end());
    const Scale<3> scale(Box<3>(points_), true);
    const Box<3> box(points_ = scale.scaled(std::move(points_)));
    double extent = 0;
    for (std::size_t i = 0; i < 3; ++i)
      extent = (std::max)(extent, box.half_extent(i));
    const Vector<3> centre = 0.5 * (box.low + box.high);
    for (Vector<3>& p : points_)
      p = (extent > 0 ? 1 / extent : 1) * (p - centre);
  }

  void sort_faces(const SurfaceView& surface) {
    std::vector<std::array<float, 3>> centres;
    centres.reserve(surface.triangles.size());
    for (const auto& [a, b, c] : surface.triangles) {
      const Vector<3> sum = points_[a] + points_[b] + points_[c];
      centres.push_back(floats(sum));
    }
    faces_.resize(surface.triangles.size());
    std::iota(faces_.begin(), faces_.end(), Index{0});
    sort_for_box_tree(faces_.data(), faces_.data() + faces_.size(),
                      [&](Index face) { return centres[face]; });
  }

  // Points get the order in which the tree first meets them, so that neighbours are in one cache
  // line.
  void take_triangles(const SurfaceView& surface) {
    std::vector<Index> number(points_.size(), none);
    std::vector<Vector<3>> ordered;
    ordered.reserve(points_.size());
    triangles_.reserve(faces_.size());
    for (const Index face : faces_) {
      Triangle triangle = surface.triangles[face];
      for (Index& v : triangle) {
        if (number[v] == none) {
          number[v] = static_cast<Index>(ordered.size());
          ordered.push_back(points_[v]);
        }
        v = number[v];
      }
      triangles_.push_back(triangle);
    }
    points_ = std::move(ordered);
  }

  void build() {
    for (std::size_t size = faces_.size(); size > 0;) {
      const std::size_t blocks = (size + width - 1) / width;
      levels_.emplace_back(blocks);
      size = blocks > 1 ? blocks : 0;
    }
    for (std::size_t slot = 0; slot < faces_.size(); ++slot)
      levels_[0][slot / width].set(slot % width, padded_box(slot));
    for (std::size_t level = 1; level < levels_.size(); ++level)
      for (std::size_t block = 0; block < levels_[level - 1].size(); ++block)
        levels_[level][block / width].set(block % width, levels_[level - 1][block].around());
  }

  static std::array<float, 3> floats(const Vector<3>& p) {
    return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
  }

  FloatBox padded_box(std::size_t slot) const {
    FloatBox box = FloatBox::empty();
    for (const Vector<3>& p : corners(slot))
      box.add(floats(p));
    for (std::size_t i = 0; i < 3; ++i) {
      box.low[i] -= padding;
      box.high[i] += padding;
    }
    return box;
  }

  // Visits triangles until a call returns true.
  template <class Visit>
  bool descend(std::size_t level, std::size_t block, const Ray& ray, const Visit& visit,
               Index& recent) const {
    for (std::uint32_t hits = ray.hits(levels_[level][block]); hits != 0; hits &= hits - 1) {
      const std::size_t slot = block * width + static_cast<std::size_t>(std::countr_zero(hits));
      if (level > 0 ? descend(level - 1, slot, ray, visit, recent) : visit(slot)) {
        if (level == 1)
          recent = static_cast<Index>(block);
        return true;
      }
    }
    return false;
  }

  double distance(std::size_t slot, const Ray& ray) const {
    const auto [a, b, c] = triangles_[slot];
    return ray.distance(points_[a], points_[b], points_[c]);
  }

  std::vector<Vector<3>> points_;
  std::vector<Index> faces_;
  std::vector<Triangle> triangles_;
  std::vector<std::vector<EightBoxes>> levels_; // from the triangles' boxes to one around them all
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_VISIBILITY_RAY_TREE_H
