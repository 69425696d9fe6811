#ifndef QUADRILLE_MANIFOLD_H
#define QUADRILLE_MANIFOLD_H

#include <quadrille/internal/core/base/compiler.h> // first, since it reports which compiler this needs

#include <quadrille/internal/core/base/containers.h>
#include <quadrille/internal/core/base/points.h>
#include <quadrille/internal/core/base/read_surface.h>
#include <quadrille/internal/core/surface/manifold_split.h>

#include <array>
#include <cstddef>
#include <ranges>
#include <utility>
#include <vector>

/// \file
/// Non-manifold soups become manifold ones.

namespace quadrille {

/// The points that make_manifold() has added to a soup.
struct ManifoldChanges {
  std::size_t split_vertices = 0; ///< points that are copies of others
  std::size_t split_edges = 0;    ///< points in the middle of an edge
  /// The points from which each added point comes, in the order of the added points: twice the one
  /// that it is a copy of, or both ends of the edge, which may be an added point, but an earlier
  /// one. Values of points are carried along by it.
  std::vector<std::array<std::size_t, 2>> origins;
  /// The triangle of which each triangle of the result is a part.
  std::vector<std::size_t> triangles;
};

/// Cuts a soup into manifold sheets: afterwards each edge has one or two triangles, and those of
/// each point form a disc or half a disc.
///
/// At an edge of more than two triangles these are paired in the order in which they lie around it:
/// each with the next one on the other side of what the surface encloses, so that solids that touch
/// at an edge come apart, and sheets never cross. Then each point gets a copy for each further
/// group of its triangles that hang together by edges. Two sheets that touch along an edge and have
/// both of its ends in common get apart by a point in the middle of the edge of one of them. No
/// point moves, and the surface stays where it is. An edge with as many triangles that run along it
/// one way as the other has none left over, so an oriented surface without boundary stays without
/// one.
///
/// Points keep their indices; added points come behind them. Triangles keep their order, without
/// degenerate ones, and pieces of split triangles come behind them. The containers are those of
/// simplify() that can grow. In close to linear time.
///
/// Throws std::invalid_argument for a face that is not a triangle, or names a point that is not
/// there, and for a point that is not finite; the soup is then unchanged.
template <class Points, class Triangles>
requires requires(Points& points, Triangles& triangles) {
  points.push_back(points[0]);
  triangles.push_back(triangles[0]);
}
ManifoldChanges make_manifold(Points& points, Triangles& triangles) {
  using Point = std::ranges::range_value_t<Points>;
  const TriangleSoup<> surface =
      internal::read_surface("quadrille::make_manifold", points, triangles);
  const internal::ManifoldSplit split(surface);
  ManifoldChanges changes;
  changes.split_edges = split.split_edges;
  changes.split_vertices = split.added.size() - split.split_edges;
  changes.triangles.assign(split.faces.begin(), split.faces.end());
  Points new_points(points);
  for (const auto& [a, b] : split.added) {
    new_points.push_back(
        a == b ? Point(points[a])
               : internal::point_at<Point>(0.5 * internal::position_of(new_points[a]) +
                                           0.5 * internal::position_of(new_points[b])));
    changes.origins.push_back({a, b});
  }
  auto new_triangles = internal::empty_like(triangles);
  for (std::size_t i = 0; i < split.triangles.size(); ++i)
    new_triangles.push_back(internal::renumbered(triangles[split.faces[i]], [&](std::size_t k) {
      return std::size_t{split.triangles[i][k]};
    }));
  std::swap(points, new_points);
  std::swap(triangles, new_triangles);
  return changes;
}

} // namespace quadrille

#endif // QUADRILLE_MANIFOLD_H
