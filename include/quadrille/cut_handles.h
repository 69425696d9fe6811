#ifndef QUADRILLE_CUT_HANDLES_H
#define QUADRILLE_CUT_HANDLES_H

#include <quadrille/internal/core/base/compiler.h> // first, since it reports which compiler this needs

#include <quadrille/internal/core/base/containers.h>
#include <quadrille/internal/core/base/parallel.h>
#include <quadrille/internal/core/base/points.h>
#include <quadrille/internal/core/base/read_surface.h>
#include <quadrille/internal/core/base/text.h>
#include <quadrille/internal/core/surface/flat_polygons.h>
#include <quadrille/internal/core/surface/handle_cuts.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <ranges>
#include <stdexcept>
#include <utility>
#include <vector>

/// \file
/// Soups lose the tunnels and handles that are narrower than a width.

namespace quadrille {

/// The points and triangles that cut_handles() has added to a soup.
struct HandleChanges {
  std::size_t cut_handles = 0; ///< the handles and tunnels that were cut; each is one genus less
  std::size_t split_components = 0; ///< the tunnels between two walls, which have come apart
  /// The points from which each added point comes, in the order of the added points: twice the one
  /// that it is a copy of, a sixteenth of an edge aside, or two, in the middle of which it lies.
  /// They may be added points themselves, but earlier ones.
  std::vector<std::array<std::size_t, 2>> origins;
  /// For each triangle of the result, the triangle of the input that it is, or is next to.
  std::vector<std::size_t> triangles;
  /// For each added triangle, one that was there before and has its first edge, by its index in the
  /// result.
  std::vector<std::size_t> neighbors;
  /// No point of the triangles at cuts is further than this from the input, in the unit of the
  /// points. Every point of the input is still there.
  double distance = 0;
};

namespace internal {

/// The size of cut_handles(). Throws std::invalid_argument if it is no length.
inline double valid_size(double size) {
  if (!(size >= 0) || !std::isfinite(size))
    throw std::invalid_argument("quadrille::cut_handles: the size " + text_of(size) +
                                " is no length");
  return size;
}

/// How far the triangles at cuts are from the input at most. A point of a fan is at most as far
/// from the edge of its triangle as the vertex in the middle; a point of a single triangle is as
/// far from the nearest edge as its incentre, at most. An edge is as far as the further of its
/// ends: a middle of an earlier fan, or a copy that lies aside.
class CapDistances {
public:
  explicit CapDistances(const HandleCuts& cuts)
      : surface_(cuts.surface()), added_(cuts.added),
        first_added_(surface_.vertices() - cuts.added.size()), of_middle_(cuts.added.size(), 0) {
    for (std::size_t i = 0; i < cuts.like.size(); ++i)
      add(surface_.triangle(static_cast<Index>(surface_.faces() - cuts.like.size() + i)));
  }

  double greatest() const { return greatest_; }

private:
  bool is_middle(Index v) const {
    return v >= first_added_ && added_[v - first_added_][0] != added_[v - first_added_][1];
  }
  double distance_of(Index v) const {
    if (v < first_added_)
      return 0;
    if (is_middle(v))
      return of_middle_[v - first_added_];
    const Index original = added_[v - first_added_].front();
    return distance_of(original) +
           std::sqrt(squared_distance(surface_.point(v), surface_.point(original)));
  }

  void add(const HalfEdges::Triangle& t) {
    const Vector<3>&a = surface_.point(t[0]), &b = surface_.point(t[1]), &c = surface_.point(t[2]);
    double distance = (std::max)(distance_of(t[0]), distance_of(t[1]));
    if (is_middle(t[2])) {
      distance += std::sqrt(squared_distance_to_segment(c, a, b));
      double& of_middle = of_middle_[t[2] - first_added_];
      of_middle = (std::max)(of_middle, distance);
    } else {
      distance = (std::max)(distance, distance_of(t[2])) + inner_radius(a, b, c);
    }
    greatest_ = (std::max)(greatest_, distance);
  }

  static double inner_radius(const Vector<3>& a, const Vector<3>& b, const Vector<3>& c) {
    const double perimeter = std::sqrt(squared_distance(a, b)) + std::sqrt(squared_distance(b, c)) +
                             std::sqrt(squared_distance(c, a));
    return perimeter > 0 ? std::sqrt(squared_length(cross(b - a, c - a))) / perimeter : 0;
  }

  const HalfEdges& surface_;
  const std::vector<std::array<Index, 2>>& added_;
  std::size_t first_added_;
  std::vector<double> of_middle_; // of the added vertices that are in the middle
  double greatest_ = 0;
};

inline HandleChanges changes_of(const HandleCuts& cuts, std::size_t triangles) {
  HandleChanges changes{cuts.handles, cuts.necks, {}, {}, {}, CapDistances(cuts).greatest()};
  for (const auto& [a, b] : cuts.added)
    changes.origins.push_back({a, b});
  for (std::size_t face = 0; face < triangles; ++face)
    changes.triangles.push_back(face);
  for (const Index face : cuts.like) { // may be an added one
    changes.triangles.push_back(std::size_t{changes.triangles[face]});
    changes.neighbors.push_back(face);
  }
  return changes;
}

} // namespace internal

inline namespace QUADRILLE_THREADING {

/// Cuts a soup at tunnels and handles up to a size, and closes it there: a manifold stays one,
/// closed where it was, with a handle less for each cut.
///
/// Wherever a loop of edges that is no wider than the size runs round a tunnel or a handle, the
/// surface is cut along it and closed on both sides: by a triangle each, or by a fan round a point
/// in the middle of the loop. A tunnel then ends in two dents, and a handle in two stumps, which
/// simplify() takes away at their price. A tunnel that joins two parts of the surface, as the outer
/// wall of a shell and its inner one, is the last that does so once others are cut; it is cut if
/// both parts are wider than the size, by four times the volume over the area, and reach five sizes
/// away from the tunnel. Nothing else is parted: limbs stay however thin they are. A surface that
/// encloses a negative volume as a whole is taken for one that is oriented inwards.
///
/// The width of a loop is four times the area inside it over its length, but at least a quarter of
/// the length: the side of a square, the diameter of a circle, half the sum of the sides of an
/// oblong rectangle. A tunnel is as wide as the loop round its narrowest place.
///
/// **What is promised.** No loop is cut that is wider than the size, and after the call no handle
/// has a narrower loop of edges, up to the search: it finds the shortest one through a vertex, and
/// draws it tight at its vertices. Where edges are long or run askew, loops of edges are longer
/// than the tunnel is wide, and where they are coarse, a round tunnel is narrower than its circle:
/// sizes between two thirds and one and a half of its width may cut it or not. Loops through points
/// of which the triangles do not form one disc that is oriented alike are not found: see
/// make_manifold().
///
/// No point moves. Points and triangles keep their indices; added ones come behind them. The
/// containers are those of simplify() that can grow. Where the surface is a disc three and a half
/// sizes around, this takes a few visits of each vertex; around tunnels, and where limbs are thin,
/// a search from one vertex in each ball of one size.
///
/// `is_kept`: empty, or for each point whether nothing is cut there. `threads`: the result does not
/// depend on it; more than one need oneTBB.
///
/// Throws std::invalid_argument for a size that is negative or not finite, for threads without
/// oneTBB, for a face that is not a triangle, or names a point that is not there, and for a point
/// that is not finite; the soup is then unchanged.
template <class Points, class Triangles>
requires requires(Points& points, Triangles& triangles) {
  points.push_back(points[0]);
  triangles.push_back(triangles[0]);
}
HandleChanges cut_handles(Points& points, Triangles& triangles, double size,
                          const std::vector<bool>& is_kept = {}, unsigned threads = 1) {
  using Point = std::ranges::range_value_t<Points>;
  constexpr const char* function = "quadrille::cut_handles";
  const TriangleSoup<> surface = internal::read_surface(function, points, triangles);
  const internal::HandleCuts cuts(surface, internal::valid_size(size), is_kept,
                                  internal::threads_of(function, threads));
  HandleChanges changes = internal::changes_of(cuts, surface.triangles.size());
  Points new_points(points);
  while (new_points.size() < cuts.surface().vertices())
    new_points.push_back(internal::point_at<Point>(
        cuts.surface().point(static_cast<internal::Index>(new_points.size()))));
  auto new_triangles = internal::empty_like(triangles);
  for (std::size_t face = 0; face < changes.triangles.size(); ++face)
    new_triangles.push_back(
        internal::renumbered(triangles[changes.triangles[face]], [&](std::size_t k) {
          return std::size_t{cuts.surface().triangle(static_cast<internal::Index>(face))[k]};
        }));
  std::swap(points, new_points);
  std::swap(triangles, new_triangles);
  return changes;
}

} // namespace QUADRILLE_THREADING

} // namespace quadrille

#endif // QUADRILLE_CUT_HANDLES_H
