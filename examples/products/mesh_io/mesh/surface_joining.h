#ifndef QUADRILLE_EXAMPLES_MESH_IO_SURFACE_JOINING_H
#define QUADRILLE_EXAMPLES_MESH_IO_SURFACE_JOINING_H

#include "edge_sectors.h"
#include "indexed_mesh.h"
#include "shared_places.h"
#include "sheet_sides.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// Finds the vertices at exactly one place that are one vertex of a surface.
///
/// Many programs give a vertex several times, with other normals, colours or materials, or for each
/// polygon. There an edge of one face lies at the place of another one: the two are one edge. This
/// is decided edge by edge, so a place at which parts only touch says nothing about the rest:
///
/// - An edge of two faces is whole, whatever else lies at its place: bodies that touch stay apart.
/// - Two edges of one face at a place are one, unless they belong to the same face twice.
/// - Of more than two, those are one that bound the same body (EdgeSectors); if that does not tell,
///   all are.
/// - An edge of one face at the place of a whole one goes to it: so a wall stands on a floor.
/// - The sides of a sheet, faces that run against each other at the same three places, are one from
///   such edges on (SheetSides).
class SurfaceJoining {
public:
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;

  /// The first of the vertices that are one with each. In O(n log n).
  static std::vector<std::uint32_t> first_vertices(const std::vector<Point>& points,
                                                   const Triangles& triangles) {
    SurfaceJoining joining(points, triangles);
    joining.find_sides();
    for (auto begin = joining.sides_.begin(); begin != joining.sides_.end();) {
      const auto end = std::find_if(begin, joining.sides_.end(),
                                    [&](const Side& side) { return !begin->is_next_to(side); });
      joining.join_edges({begin, end});
      begin = end;
    }
    SheetSides(points, triangles, joining.mates_, joining.vertices_).join();
    return joining.vertices_.firsts();
  }

private:
  /// A face at an edge between two places, of which the lower is `low`.
  struct Side {
    std::uint32_t low, high;               ///< places
    std::uint32_t low_vertex, high_vertex; ///< at these
    std::uint32_t face, corner;            ///< of the face, where the edge begins
    bool runs_up;

    bool is_next_to(const Side& other) const { return low == other.low && high == other.high; }
    auto key() const { return std::tie(low, high, low_vertex, high_vertex, face); }
  };
  using Sides = std::vector<Side>;

  SurfaceJoining(const std::vector<Point>& points, const Triangles& triangles)
      : points_(points), triangles_(triangles), vertices_(points.size()) {}

  /// Those of which an end is at a place of several vertices. The other one may be alone at its
  /// place, as around a pole that each face has for itself.
  void find_sides() {
    const std::vector<std::uint32_t> places = SharedPlaces::of(points_, triangles_);
    if (places.empty())
      return;
    for (std::uint32_t face = 0; face < triangles_.size(); ++face) {
      const auto& t = triangles_[face];
      if (join_flat_corners(t, places))
        continue;
      for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t v = t[i], w = t[(i + 1) % 3];
        if (places[v] == SharedPlaces::none && places[w] == SharedPlaces::none)
          continue;
        const std::uint32_t p = std::min(places[v], v), q = std::min(places[w], w);
        sides_.push_back(p < q ? Side{p, q, v, w, face, i, true}
                               : Side{q, p, w, v, face, i, false});
      }
    }
    std::sort(sides_.begin(), sides_.end(),
              [](const Side& a, const Side& b) { return a.key() < b.key(); });
  }

  /// A face of which two corners are at one place has no area, and must not keep its neighbours
  /// apart. Is it one?
  bool join_flat_corners(const std::array<std::uint32_t, 3>& t,
                         const std::vector<std::uint32_t>& places) {
    bool is_flat = false;
    for (std::size_t i = 0; i < 3; ++i)
      if (const std::uint32_t v = t[i], w = t[(i + 1) % 3];
          places[v] != SharedPlaces::none && places[v] == places[w]) {
        vertices_.join(v, w);
        is_flat = true;
      }
    return is_flat;
  }

  /// The sides between two places, ordered by the edges of the file.
  void join_edges(const Sides& sides) {
    Sides single;
    const Side* whole = nullptr;
    for (auto begin = sides.begin(); begin != sides.end();) {
      const auto end = std::find_if(begin, sides.end(), [&](const Side& side) {
        return side.low_vertex != begin->low_vertex || side.high_vertex != begin->high_vertex;
      });
      if (end - begin == 1)
        single.push_back(*begin);
      else if (!whole)
        whole = &*begin;
      begin = end;
    }
    if (single.size() == 2)
      join_two(single[0], single[1]);
    else if (single.size() > 2)
      join_several(single);
    else if (single.size() == 1 && whole && !lies_on_another(single[0], sides))
      join(single[0], *whole);
  }

  void join(const Side& a, const Side& b) {
    vertices_.join(a.low_vertex, b.low_vertex);
    vertices_.join(a.high_vertex, b.high_vertex);
  }

  void mate(const Side& a, const Side& b) {
    join(a, b);
    mates_.push_back({FaceEdge{a.face, a.corner}, FaceEdge{b.face, b.corner}});
  }

  void join_two(const Side& a, const Side& b) {
    if (a.runs_up != b.runs_up || third(a) != third(b))
      mate(a, b);
  }

  void join_several(const Sides& sides) {
    std::vector<EdgeFace> faces;
    for (const Side& side : sides)
      faces.push_back({third(side), side.runs_up});
    const auto pairs =
        EdgeSectors::pairs(points_[sides.front().low_vertex], points_[sides.front().high_vertex],
                           faces, is_inside_out());
    for (const auto& [i, j] : pairs)
      mate(sides[i], sides[j]);
    for (std::size_t i = 1; i < sides.size() && pairs.empty(); ++i)
      join(sides[0], sides[i]);
  }

  /// Is the volume within all faces below 0?
  bool is_inside_out() {
    if (!is_inside_out_) {
      double volume = 0;
      for (const auto& [a, b, c] : triangles_)
        volume += CGAL::determinant(points_[a] - points_[0], points_[b] - points_[0],
                                    points_[c] - points_[0]);
      is_inside_out_ = volume < 0;
    }
    return *is_inside_out_;
  }

  const Point& third(const Side& side) const {
    return points_[triangles_[side.face][(side.corner + 2) % 3]];
  }

  /// Is another face at the same three places, as where a decal lies on a wall?
  bool lies_on_another(const Side& one, const Sides& sides) const {
    return std::any_of(sides.begin(), sides.end(), [&](const Side& side) {
      return side.face != one.face && third(side) == third(one);
    });
  }

  const std::vector<Point>& points_;
  const Triangles& triangles_;
  Sides sides_;
  std::vector<FaceMates> mates_;
  JoinedVertices vertices_;
  std::optional<bool> is_inside_out_; // once it has been asked
};

} // namespace quadrille_examples

#endif
