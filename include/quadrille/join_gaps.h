#ifndef QUADRILLE_JOIN_GAPS_H
#define QUADRILLE_JOIN_GAPS_H

#include <quadrille/internal/core/base/compiler.h> // first, since it reports which compiler this needs

#include <quadrille/internal/core/base/containers.h>
#include <quadrille/internal/core/base/points.h>
#include <quadrille/internal/core/base/read_surface.h>
#include <quadrille/internal/core/base/text.h>
#include <quadrille/internal/gaps/gap_joins.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <ranges>
#include <stdexcept>
#include <utility>
#include <vector>

/// \file
/// The components of a soup are joined across narrow gaps. <quadrille/simplify.h> does not include
/// this header.

namespace quadrille {

/// The changes that join_gaps() has made to a soup.
struct GapChanges {
  std::size_t joined_gaps = 0; ///< the gaps that were bridged; each is one component less
  /// The gaps that were not bridged, since every bridge that was tried crossed the surface: so many
  /// components less there would be.
  std::size_t open_gaps = 0;
  /// The two points in the middle of which each added point lies, in the order of the added points.
  /// They may be added points themselves, but earlier ones.
  std::vector<std::array<std::size_t, 2>> origins;
  /// For each triangle of the result, the triangle of the input of which it is a fragment, or at a
  /// side of which a bridge begins.
  std::vector<std::size_t> triangles;
};

namespace internal {

inline GapChanges changes_of(const GapJoins& joins) {
  GapChanges changes{joins.joined, joins.open, {}, {}};
  for (const auto& [a, b] : joins.added)
    changes.origins.push_back({a, b});
  changes.triangles.assign(joins.sources.begin(), joins.sources.end());
  return changes;
}

} // namespace internal

/// Joins the components of a soup where the gap between them is at most as wide as a size: closed
/// manifolds become one, of which the genus is the sum of theirs.
///
/// A gap is where the walls of two components face each other: the shortest way from one to the
/// other begins on the outer side of both, to which triangles of closed components have to look. So
/// the two walls of a shell are not joined however thin it is, and the components of an empty room
/// in a solid are joined to its wall. Both walls are opened where they are near each other, around
/// the closest place, and a strip of triangles from one edge to the other closes the surface again:
/// the gap is filled there. What is opened is a disc on either side, as wide as the gap allows; it
/// is narrower where a strip would cross the surface or itself.
///
/// **What is promised.** Two components are joined only where a point of one is at most a size away
/// from the other. The closest come first, and those that already hang together are not joined once
/// more: no handle comes, and each bridge is one component less. No added triangle crosses
/// another one, or one of the input. Where nothing is joined, triangles stay as they are.
///
/// No point moves, and points keep their indices; those in the middle of a disc that was taken out
/// are left without triangles. Triangles keep their order; those of bridges come last. A triangle
/// with edges longer than the size of which only one end is near a wall is split first, at added
/// points in the middle of edges. Triangles are connected by the points that they name: points at
/// the same place are not joined. Triangles without an area, and those with points at a boundary,
/// at edges of more than two triangles, or of `is_kept`, stay: see make_manifold(). Bridges between
/// components that touch have triangles without an area.
///
/// The containers are those of simplify() that can grow. The time is that of a search around each
/// point as far as the size, and close to linear while that is a few edges; bridges take the
/// product of the numbers of points around both of their ends.
///
/// `is_kept`: empty, or for each point whether it must keep its triangles.
///
/// Throws std::invalid_argument for a size that is negative or not finite, for a face that is not a
/// triangle, or names a point that is not there, and for a point that is not finite; the soup is
/// then unchanged.
template <class Points, class Triangles>
requires requires(Points& points, Triangles& triangles) {
  points.push_back(points[0]);
  triangles.push_back(triangles[0]);
}
GapChanges join_gaps(Points& points, Triangles& triangles, double size,
                     const std::vector<bool>& is_kept = {}) {
  using Point = std::ranges::range_value_t<Points>;
  const TriangleSoup<> surface = internal::read_surface("quadrille::join_gaps", points, triangles);
  if (!(size >= 0) || !std::isfinite(size))
    throw std::invalid_argument("quadrille::join_gaps: the size " + internal::text_of(size) +
                                " is no length");
  const internal::GapJoins joins(surface, size, is_kept);
  GapChanges changes = internal::changes_of(joins);
  Points new_points(points);
  for (std::size_t i = 0; i < changes.origins.size(); ++i)
    new_points.push_back(internal::point_at<Point>(
        joins.surface().point(static_cast<internal::Index>(surface.points.size() + i))));
  auto new_triangles = internal::empty_like(triangles);
  for (std::size_t i = 0; i < changes.triangles.size(); ++i)
    new_triangles.push_back(
        internal::renumbered(triangles[changes.triangles[i]],
                             [&](std::size_t k) { return std::size_t{joins.triangles[i][k]}; }));
  std::swap(points, new_points);
  std::swap(triangles, new_triangles);
  return changes;
}

} // namespace quadrille

#endif // QUADRILLE_JOIN_GAPS_H
