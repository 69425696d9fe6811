#ifndef QUADRILLE_HIDDEN_H
#define QUADRILLE_HIDDEN_H

#include <quadrille/internal/core/base/compiler.h> // first, since it reports which compiler this needs

#include <quadrille/internal/core/base/containers.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/parallel.h>
#include <quadrille/internal/core/base/points.h>
#include <quadrille/internal/core/base/read_surface.h>
#include <quadrille/internal/core/base/text.h>
#include <quadrille/internal/core/call/meshes.h>
#include <quadrille/internal/visibility/closed_removal.h>
#include <quadrille/internal/visibility/hidden_caps.h>
#include <quadrille/internal/visibility/hidden_groups.h>
#include <quadrille/internal/visibility/hidden_search.h>
#include <quadrille/internal/visibility/joined_places.h>
#include <quadrille/internal/visibility/visible_fractions.h>
#include <quadrille/triangle_soup.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <ranges>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

/// \file
/// Faces that are not seen from outside, and how much of each face is. <quadrille/simplify.h> does
/// not include this header.

namespace quadrille {

/// Options of hidden_faces() and remove_hidden().
struct HiddenOptions {
  /// The rays that each face gets at first, at least 16: see hidden_faces(). Time is proportional
  /// to it.
  std::size_t directions = 64;
  /// A face is hidden if it is seen from at most this fraction of the directions on each of its
  /// sides: at least 0 and less than 1. By default the inside of a shell is hidden although some
  /// rays reach it through small holes. With 0, one free ray is enough to be seen.
  double threshold = 0.001;
  /// If true, a face that only its back is seen of is hidden: for closed surfaces that are oriented
  /// outward. Otherwise both sides of a face count.
  bool front_only = false;
  unsigned threads = 1; ///< more than one need oneTBB; the result does not depend on it
  /// Called with the fraction that is done, from time to time; the search ends when it returns
  /// false.
  std::function<bool(double fraction)> progress = {};
};

/// The kinds of hidden groups of faces.
enum class HiddenKind {
  cavity,          ///< closed, with its front inside: the wall of an empty space in a solid
  inner_component, ///< closed, with its front outside, or without any volume
  inner_surface    ///< not closed: it ends, or it continues in faces that are seen
};

/// Returns the name of a kind: "cavity", "inner component" or "inner surface".
constexpr std::string_view to_string(HiddenKind kind) {
  constexpr std::array<std::string_view, 3> names{"cavity", "inner component", "inner surface"};
  return names[static_cast<std::size_t>(kind)];
}

/// Hidden faces that are connected by edges.
struct HiddenGroup {
  HiddenKind kind = HiddenKind::inner_surface; ///< the kind
  std::vector<std::size_t> faces;              ///< the indices of its faces in the input, ascending
  double area = 0;                             ///< in the unit of the points, squared
  double volume = 0;   ///< the enclosed volume, at least 0; 0 if it is not closed
  double diagonal = 0; ///< the length of the diagonal of its bounding box
};

/// The hidden faces of a surface.
struct HiddenFaces {
  std::vector<bool> is_hidden;     ///< a value for each face of the input
  std::size_t count = 0;           ///< the number of hidden faces
  double area = 0;                 ///< the area of the hidden faces
  double whole_area = 0;           ///< the area of all faces
  std::vector<HiddenGroup> groups; ///< the largest area first
  /// The edges that hidden faces share with others, and that would become boundary edges if all
  /// hidden faces and nothing else were removed.
  std::size_t cut_edges = 0;
  bool is_cancelled = false; ///< by HiddenOptions::progress: then no face is hidden
};

/// The hidden faces that remove_hidden() has found, and its changes.
struct HiddenRemoval {
  HiddenFaces found;            ///< the hidden faces of the input
  std::size_t removed = 0;      ///< the number of removed faces
  std::size_t caps = 0;         ///< the number of loops that were closed
  std::size_t added_points = 0; ///< the points in the middle of caps
  /// For each added point, two points of the loop in the middle of which it lies.
  std::vector<std::array<std::size_t, 2>> origins;
  /// For each triangle of the result, the triangle of the input that it is, or, if it belongs to a
  /// cap, one that it has an edge in common with or that is at the same loop.
  std::vector<std::size_t> triangles;
};

/// Options of visibility() and visibility_importance().
struct VisibilityOptions {
  std::size_t directions = 256; ///< the rays that each face gets, at least 16
  bool front_only = false;      ///< does the back of a face count? See HiddenOptions
  unsigned threads = 1;         ///< see HiddenOptions
  /// Called with the fraction that is done, from time to time. If it returns false, the result is
  /// empty.
  std::function<bool(double fraction)> progress = {};
};

/// The fractions of a surface that are visible.
struct Visibility {
  std::vector<double> faces; ///< for each face, the fraction of free rays, from 0 to 1
  /// For each vertex, the mean over the area of its faces and of those of other vertices at the
  /// same place; 0 without faces.
  std::vector<double> vertices;
};

namespace internal {

template <class Options>
void require_sense(const char* function, const Options& options) {
  const std::size_t directions = options.directions;
  if (directions < 16 || directions > std::size_t{1} << 20)
    throw std::invalid_argument(std::string(function) + ": " + std::to_string(directions) +
                                " directions are not between 16 and 1048576");
  if constexpr (requires { options.threshold; })
    if (!(options.threshold >= 0 && options.threshold < 1))
      throw std::invalid_argument(std::string(function) + ": the threshold " +
                                  text_of(options.threshold) +
                                  " is not at least 0 and less than 1");
  if (options.threads < 1)
    throw std::invalid_argument(std::string(function) + ": there has to be a thread");
}

inline HiddenGroup hidden_group(FaceGroup&& group) {
  HiddenGroup result{.faces = std::move(group.faces),
                     .area = group.area,
                     .volume = group.is_closed ? std::abs(group.volume) : 0,
                     .diagonal = group.diagonal};
  if (group.is_closed)
    result.kind = group.volume < 0 ? HiddenKind::cavity : HiddenKind::inner_component;
  return result;
}

inline HiddenFaces hidden_faces_of(TriangleSoup<> surface, const HiddenOptions& options,
                                   Threads threads) {
  join_places(surface);
  HiddenFaces result;
  HiddenSearch search(surface, options.directions, options.threshold, options.front_only);
  result.is_cancelled = !search.run(threads, options.progress);
  result.is_hidden =
      result.is_cancelled ? std::vector<bool>(surface.triangles.size()) : search.hidden();
  FaceGroups groups(surface, result.is_hidden);
  result.cut_edges = groups.cut_edges();
  for (FaceGroup& group : groups.take()) {
    result.count += group.faces.size();
    result.area += group.area;
    result.groups.push_back(hidden_group(std::move(group)));
  }
  for (std::size_t face = 0; face < surface.triangles.size(); ++face)
    result.whole_area += FaceGroups::area(surface, face);
  return result;
}

inline Visibility visibility_of(const TriangleSoup<>& surface, const VisibilityOptions& options,
                                Threads threads) {
  TriangleSoup<> joined = surface;
  join_places(joined);
  VisibleFractions fractions(surface, joined, options.directions, options.front_only);
  if (!fractions.run(threads, options.progress))
    return {};
  return {fractions.faces(), fractions.vertices()};
}

inline void require_least(const char* function, double least) {
  if (!(least >= 0 && least <= 1))
    throw std::invalid_argument(std::string(function) + ": the least importance " + text_of(least) +
                                " is not between 0 and 1");
}

inline std::vector<double> importances_of(std::vector<double> fractions, double least) {
  for (double& x : fractions)
    x = (std::max)(x, least);
  return fractions;
}

/// A surface without its hidden faces.
struct ClosedRest {
  HiddenRemoval changes;
  std::vector<bool> is_removed;  ///< a value for each face of the input
  std::vector<Vector<3>> points; ///< the added points
  std::vector<std::array<Index, 3>> cap_triangles =
      {}; ///< indices of points of the input and added ones
};

/// Returns the number of sides of faces that are no edge of exactly two faces wound alike.
inline std::size_t sides_without_twin(const SurfaceView& surface) {
  const HalfEdges half_edges(surface);
  std::size_t count = 0;
  for (Index h = 0; h < 3 * half_edges.faces(); ++h)
    count += half_edges.twin(h) == none;
  return count;
}

/// Removes hidden faces. Faces are connected by points of `connected`, and name those of `surface`.
inline ClosedRest closed_rest_of(const TriangleSoup<>& surface, const SurfaceView& connected,
                                 HiddenFaces found, const HiddenOptions& options) {
  ClosedRest rest;
  HiddenRemoval& changes = rest.changes;
  changes.found = std::move(found);
  rest.is_removed = changes.found.is_hidden;
  std::vector<std::size_t> like;
  if (changes.found.count > 0) {
    const ClosedRemoval removal(connected, changes.found.is_hidden, options.directions,
                                options.threshold, options.front_only);
    rest.is_removed = removal.is_removed();
    removal.for_each_cap([&](const HiddenCap& cap, const Vector<3>& middle) {
      ++changes.caps;
      const auto origin = [&](std::size_t side) {
        return surface.triangles[HalfEdges::face(cap.sides[side])][cap.sides[side] % 3];
      };
      const auto added = static_cast<Index>(surface.points.size() + rest.points.size());
      for (const auto& triangle : cap.triangles) {
        auto& corners = rest.cap_triangles.emplace_back();
        for (std::size_t k = 0; k < 3; ++k)
          corners[k] = triangle[k] < cap.sides.size() ? origin(triangle[k]) : added;
        like.push_back(HalfEdges::face(cap.sides[triangle[1]]));
      }
      if (cap.has_middle) {
        rest.points.push_back(middle);
        changes.origins.push_back({origin(0), origin(cap.sides.size() / 2)});
      }
    });
  }
  changes.added_points = rest.points.size();
  for (std::size_t face = 0; face < rest.is_removed.size(); ++face)
    if (rest.is_removed[face])
      ++changes.removed;
    else
      changes.triangles.push_back(face);
  changes.triangles.insert(changes.triangles.end(), like.begin(), like.end());
  return rest;
}

} // namespace internal

inline namespace QUADRILLE_THREADING {

/// Finds the faces of a polygon soup that no ray from outside reaches.
///
/// Each face sends rays from points spread over it into directions spread over the sphere, and is
/// seen if one of them meets no other face, or more of them than HiddenOptions::threshold allows.
/// Unseen faces next to seen ones get 16 times as many rays, until none of them turns out to be
/// seen. Points and directions are always the same, and so is the result, whatever the threads.
///
/// So no face is hidden that a ray has left unhindered. But a face which is seen through an opening
/// so small that no ray has met it, and whose neighbours are not seen either, counts as hidden: one
/// that is seen from a fraction f of the directions is missed with a probability of about
/// (1 - f)^(directions/2), and a region of k such faces with a probability of about
/// (1 - f)^(k directions/2). A face gets the more rays the larger it is: `directions` for the mean
/// area, or for 1/4096 of the whole area if that is less, up to 1024 times that.
///
/// Faces that intersect or touch hide what is behind them. A face does not hide its duplicate or
/// reverse, but of a face with a reverse only the front counts: of a double-sided sheet nothing is
/// hidden, of two coincident walls the inner one is. Open surfaces and non-manifold ones are
/// allowed. Faces are connected to those that have two points in common with them; points at the
/// same place are one.
///
/// Expected time: O(n log n) for n faces, with about 0.4 µs per ray; hidden faces take all their
/// rays, others a few. Memory: about 150 bytes per face.
///
/// Points and triangles are those of surface_distance(): ranges of anything with coordinates, and
/// of three indices. Throws std::invalid_argument for options that make no sense, a face that is
/// not a triangle or names a point that is not there, and a point that is not finite.
template <class Points, class Triangles>
requires internal::ReadableSoup<Points, Triangles> HiddenFaces
hidden_faces(const Points& points, const Triangles& triangles, const HiddenOptions& options = {}) {
  constexpr const char* function = "quadrille::hidden_faces";
  internal::require_sense(function, options);
  return internal::hidden_faces_of(internal::read_surface(function, points, triangles), options,
                                   internal::threads_of(function, options.threads));
}

/// Finds the hidden faces of a mesh, a model of CGAL's FaceListGraph, which are numbered in their
/// order.
template <internal::ReadableGraph Mesh>
HiddenFaces hidden_faces(const Mesh& mesh, const HiddenOptions& options = {}) {
  constexpr const char* function = "quadrille::hidden_faces";
  internal::require_sense(function, options);
  return internal::hidden_faces_of(internal::read_surface(function, mesh), options,
                                   internal::threads_of(function, options.threads));
}

/// Removes the hidden faces of a polygon soup, see hidden_faces(), and closes what that opens.
/// Returns what has been found and changed.
///
/// If hidden faces continue in others, as in the tunnels through the wall of a shell, each loop
/// of edges between them gets a cap: triangles between its points, or a fan round a point in the
/// middle. So edges of one triangle, and edges along which the triangles run more often one way
/// than the other, only remain where they have been, and a closed manifold stays one, oriented
/// alike. For that, loops do not pass through points of which the triangles do not form one disc,
/// and not twice through the same point: hidden triangles around those stay.
///
/// Caps do not hide what is seen: where most of the rays that reach a cap from outside would go on
/// to triangles that stay, or leave on the other side, hidden triangles around it stay. Parts of
/// the surface that were seen only through openings that now have caps are removed, too.
///
/// The other triangles keep their order, and caps follow them. No point moves; added ones come
/// behind the others. Points without triangles may be left; simplify() drops them. The containers
/// are those of simplify() that can grow. If an exception is thrown or the search is cancelled, the
/// soup is unchanged.
template <class Points, class Triangles>
requires internal::ReadableSoup<Points, Triangles> &&
    requires(Points& points, Triangles& triangles) {
  points.push_back(points[0]);
  triangles.push_back(triangles[0]);
}
HiddenRemoval remove_hidden(Points& points, Triangles& triangles,
                            const HiddenOptions& options = {}) {
  using Point = std::ranges::range_value_t<Points>;
  constexpr const char* function = "quadrille::remove_hidden";
  internal::require_sense(function, options);
  const TriangleSoup<> surface = internal::read_surface(function, points, triangles);
  TriangleSoup<> joined = surface; // connects seams, but also sheets that touch
  internal::join_places(joined);
  const bool has_seams =
      internal::sides_without_twin(joined) < internal::sides_without_twin(surface);
  internal::ClosedRest rest = internal::closed_rest_of(
      surface, has_seams ? joined : surface,
      internal::hidden_faces_of(surface, options, internal::threads_of(function, options.threads)),
      options);
  Points new_points(points);
  for (const Vector<3>& p : rest.points)
    new_points.push_back(internal::point_at<Point>(p));
  const std::vector<std::size_t>& like = rest.changes.triangles;
  const std::size_t kept = like.size() - rest.cap_triangles.size();
  auto new_triangles = internal::empty_like(triangles);
  for (std::size_t i = 0; i < like.size(); ++i)
    if (i < kept)
      new_triangles.push_back(triangles[like[i]]);
    else
      new_triangles.push_back(internal::renumbered(triangles[like[i]], [&](std::size_t k) {
        return std::size_t{rest.cap_triangles[i - kept][k]};
      }));
  std::swap(points, new_points);
  std::swap(triangles, new_triangles);
  return std::move(rest.changes);
}

/// Removes the hidden faces of a mesh, a model of CGAL's MutableFaceGraph, and vertices and edges
/// that have no other face, and closes what that opens as remove_hidden() of a soup does. All else
/// keeps its descriptors. Added vertices and faces have a position, and no value in other property
/// maps. Loops do not pass through the boundary of the mesh.
template <internal::FaceGraph Mesh>
HiddenRemoval remove_hidden(Mesh& mesh, const HiddenOptions& options = {}) {
  using Graph = boost::graph_traits<Mesh>;
  constexpr const char* function = "quadrille::remove_hidden";
  internal::require_sense(function, options);
  const TriangleSoup<> surface = internal::read_surface(function, mesh);
  internal::ClosedRest rest = internal::closed_rest_of(
      surface, surface,
      internal::hidden_faces_of(surface, options, internal::threads_of(function, options.threads)),
      options);
  std::vector<typename Graph::vertex_descriptor> vertex_at;
  for (const auto v : vertices(mesh))
    vertex_at.push_back(v);
  std::vector<typename Graph::face_descriptor> removed;
  std::size_t number = 0;
  for (const auto face : faces(mesh))
    if (rest.is_removed[number++])
      removed.push_back(face);
  for (const auto face : removed)
    CGAL::Euler::remove_face(halfedge(face, mesh), mesh);
  const auto points = get(CGAL::vertex_point, mesh);
  using Point = typename boost::property_traits<std::remove_cv_t<decltype(points)>>::value_type;
  for (const Vector<3>& p : rest.points) {
    vertex_at.push_back(add_vertex(mesh));
    put(points, vertex_at.back(), internal::point_at<Point>(p));
  }
  for (const auto& [a, b, c] : rest.cap_triangles)
    CGAL::Euler::add_face(std::array{vertex_at[a], vertex_at[b], vertex_at[c]}, mesh);
  return std::move(rest.changes);
}

/// Returns how much of each face and vertex of a polygon soup is seen from outside: the fraction of
/// all directions on one side of a face in which nothing is in the way, in the mean over the face;
/// of its better side, unless only the front counts. Each face of a convex surface has 1, and a
/// hidden one 0. The standard deviation is about sqrt(f (1 - f) 2 / directions) at most.
///
/// Rays, arguments and errors are those of hidden_faces(); all faces get all their rays.
template <class Points, class Triangles>
requires internal::ReadableSoup<Points, Triangles>
    Visibility visibility(const Points& points, const Triangles& triangles,
                          const VisibilityOptions& options = {}) {
  constexpr const char* function = "quadrille::visibility";
  internal::require_sense(function, options);
  return internal::visibility_of(internal::read_surface(function, points, triangles), options,
                                 internal::threads_of(function, options.threads));
}

/// Returns how much of each face and vertex of a mesh is seen, in their order.
template <internal::ReadableGraph Mesh>
Visibility visibility(const Mesh& mesh, const VisibilityOptions& options = {}) {
  constexpr const char* function = "quadrille::visibility";
  internal::require_sense(function, options);
  return internal::visibility_of(internal::read_surface(function, mesh), options,
                                 internal::threads_of(function, options.threads));
}

} // namespace QUADRILLE_THREADING

/// Returns importances for vertex_importance_map from what visibility() has found: its fractions at
/// the vertices, but at least `least`. Regions that are not seen then get about least^(1/3) times
/// the faces: an eighth with 1/512. They may be multiplied with another map.
///
/// Throws std::invalid_argument if `least` is not between 0 and 1.
inline std::vector<double> visibility_importance(const Visibility& visibility,
                                                 double least = 1. / 512) {
  internal::require_least("quadrille::visibility_importance", least);
  return internal::importances_of(visibility.vertices, least);
}

} // namespace quadrille

#endif // QUADRILLE_HIDDEN_H
