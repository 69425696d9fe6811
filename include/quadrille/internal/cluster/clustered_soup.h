#ifndef QUADRILLE_INTERNAL_CLUSTER_CLUSTERED_SOUP_H
#define QUADRILLE_INTERNAL_CLUSTER_CLUSTERED_SOUP_H

#include <quadrille/internal/core/base/containers.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/points.h>
#include <quadrille/internal/core/base/read_surface.h>
#include <quadrille/internal/core/surface/box.h>
#include <quadrille/internal/core/surface/scale.h>
#include <quadrille/quadric_form.h>

#include <array>
#include <cstddef>
#include <ranges>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadrille::internal {

[[noreturn]] inline void reject_clustering(const std::string& what) {
  throw std::invalid_argument("quadrille::cluster_vertices: " + what);
}

/// The user's soup, read in place: nothing is copied. Positions are in the engine's unit.
template <class Points, class Triangles>
class ClusteredSoup {
public:
  using Point = std::ranges::range_value_t<Points>;
  using Corners = std::array<Index, 3>;

  /// Throws std::invalid_argument for an invalid triangle, for a triangle that names a point that
  /// does not exist, and for a point that is not finite; throws std::length_error if 32 bits cannot
  /// number the points and triangles.
  ClusteredSoup(Points& points, Triangles& triangles) : points_(points), triangles_(triangles) {
    require_numbers("quadrille::cluster_vertices", point_count(), triangle_count());
    for (std::size_t v = 0; v < point_count(); ++v)
      if (!is_finite(position_of(points_[v])))
        reject_clustering("point " + std::to_string(v) + " is not finite");
    is_used_.resize(point_count());
    for (std::size_t f = 0; f < triangle_count(); ++f) {
      const auto [a, b, c] =
          read_triangle("quadrille::cluster_vertices", triangles_[f], f, point_count());
      if (a != b && b != c && c != a)
        is_used_[a] = is_used_[b] = is_used_[c] = 1;
    }
    scale_ = Scale<3>(box_of([this](std::size_t v) { return position_of(points_[v]); }), true);
  }

  std::size_t point_count() const { return std::ranges::size(points_); }
  std::size_t triangle_count() const { return std::ranges::size(triangles_); }

  /// Does a triangle of three different points use it?
  bool is_used(std::size_t v) const { return is_used_[v] != 0; }

  Vector<3> position(std::size_t v) const {
    return scale_.position_from_mesh(position_of(points_[v]));
  }
  Corners corners(std::size_t f) const {
    const auto& t = triangles_[f];
    return {static_cast<Index>(t[0]), static_cast<Index>(t[1]), static_cast<Index>(t[2])};
  }

  /// The box around the points that are used.
  Box<3> box() const {
    return box_of([this](std::size_t v) { return position(v); });
  }
  const Scale<3>& scale() const { return scale_; }

  /// Returns a point like v at another position.
  Point moved(std::size_t v, const Vector<3>& x) const {
    return x == position(v) ? points_[v] : point_at<Point>(scale_.position_of_mesh(x));
  }

  /// Rewrites the soup: its points become point(i), and its triangles those in `left`, with the
  /// corners corner(point of the input).
  void rewrite(std::size_t size, const auto& point, const std::vector<Index>& left,
               const auto& corner) {
    Points points = empty_like(points_);
    for (std::size_t i = 0; i < size; ++i)
      points.push_back(point(i));
    Triangles triangles = empty_like(triangles_);
    for (Index f : left) {
      const Corners old = corners(f);
      triangles.push_back(renumbered(triangles_[f], [&](std::size_t i) { return corner(old[i]); }));
    }
    std::swap(points_, points);
    std::swap(triangles_, triangles);
  }

private:
  // This is the interface that Box requires.
  template <class PositionAt>
  struct Positions {
    std::size_t count;
    PositionAt at;
    std::size_t size() const { return count; }
    Vector<3> operator[](std::size_t v) const { return at(v); }
  };

  template <class PositionAt>
  Box<3> box_of(PositionAt at) const {
    return Box<3>(Positions<PositionAt>{point_count(), at},
                  [this](std::size_t v) { return is_used(v); });
  }

  Points& points_;
  Triangles& triangles_;
  std::vector<unsigned char> is_used_;
  Scale<3> scale_{Box<3>(std::array<Vector<3>, 0>{}), true};
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CLUSTER_CLUSTERED_SOUP_H
