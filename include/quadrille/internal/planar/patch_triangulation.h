#ifndef QUADRILLE_INTERNAL_PLANAR_PATCH_TRIANGULATION_H
#define QUADRILLE_INTERNAL_PLANAR_PATCH_TRIANGULATION_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/surface/constrained_triangulation.h>
#include <quadrille/internal/planar/patch_boundaries.h>
#include <quadrille/internal/planar/surface_sides.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

namespace quadrille::internal {

/// A straight section of the boundary of a patch, from the corner at the end of one boundary side
/// to the corner at the end of another; the patch is on its left.
struct BoundarySection {
  Index from, to; ///< boundary sides
};

/// A triangle of a patch that has been triangulated again.
struct PatchTriangle {
  std::array<Index, 3> corners; ///< sides of the input that lead to the original corners
  std::array<Index, 3> mates; ///< the triangle beyond the side to each corner; none on the boundary
};

/// The constrained Delaunay triangulation of a patch, projected to its plane.
///
/// The boundary, which has the patch on its left, determines which triangles are inside, so holes,
/// islands, and boundaries with the patch on both sides need no special treatment. Corners of
/// several vertices at one position are distinguished by their sectors.
class PatchTriangulation {
public:
  PatchTriangulation(std::span<const Vector<3>> positions, const SurfaceSides& sides,
                     const PatchBoundaries& boundaries)
      : positions_(positions), sides_(sides), boundaries_(boundaries),
        number_(positions.size(), none) {}

  /// `inner` are the corners of vertices inside. Returns the triangles, or nothing if boundaries
  /// intersect, touch where they have no vertex, or do not bound a region of the plane.
  std::optional<std::vector<PatchTriangle>> triangulate(const Vector<3>& normal,
                                                        std::span<const BoundarySection> boundary,
                                                        std::span<const Index> inner) {
    collect_places(boundary, inner);
    std::optional<std::vector<PatchTriangle>> triangles;
    if (insert(normal, boundary) && find_sides(boundary) && find_inside() &&
        find_corners(boundary, inner))
      triangles = inside_triangles();
    for (Index v : places_)
      number_[v] = none;
    return triangles;
  }

private:
  struct FaceInfo {
    std::array<Index, 3> sections{none, none, none}; // sections of the boundary, opposite to each
                                                     // corner, with the face on the left
    std::array<Index, 3> corners{none, none, none}; // sides of the input
    Index number = none;                            // its number among the triangles inside
  };
  using Triangle = ConstrainedTriangulation::Triangle;

  static std::size_t ccw(std::size_t i) { return (i + 1) % 3; }
  static std::size_t cw(std::size_t i) { return (i + 2) % 3; }

  const Triangle& triangle(Index face) const { return triangulation_.triangles()[face]; }
  Index place(Index side) const { return boundaries_.place(sides_.to(side)); }
  Index number(Index side) const { return number_[place(side)]; }

  void collect_places(std::span<const BoundarySection> boundary, std::span<const Index> inner) {
    places_.clear();
    const auto add = [&](Index side) {
      const Index v = place(side);
      if (number_[v] != none)
        return;
      number_[v] = static_cast<Index>(places_.size());
      places_.push_back(v);
    };
    for (const BoundarySection& section : boundary)
      add(section.to);
    for (Index side : inner)
      add(side);
  }

  // Returns false if there is no plane, if two positions coincide, or if constraints intersect.
  bool insert(const Vector<3>& normal, std::span<const BoundarySection> boundary) {
    if (boundary.empty() || normal == Vector<3>{})
      return false;
    points_.clear();
    const auto [u, v] = axes(normal);
    for (Index place : places_) {
      const Vector<3> p = positions_[place] - positions_[places_[0]];
      points_.emplace_back(dot(p, u), dot(p, v));
    }
    return triangulation_.insert(points_) &&
           std::all_of(boundary.begin(), boundary.end(), [&](const BoundarySection& section) {
             return triangulation_.constrain(number(section.from), number(section.to));
           });
  }

  // Returns two vectors of length 1 that form a right-handed frame with a normal.
  static std::array<Vector<3>, 2> axes(const Vector<3>& normal) {
    std::size_t least = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (std::abs(normal[i]) < std::abs(normal[least]))
        least = i;
    Vector<3> axis;
    axis[least] = 1;
    Vector<3> u = cross(normal, axis);
    u *= 1 / std::sqrt(squared_length(u));
    return {u, cross(normal, u)};
  }

  // Stores for each face the sections of the boundary along its sides. Returns false if a section
  // is not an edge, or occurs twice.
  bool find_sides(std::span<const BoundarySection> boundary) {
    struct Directed {
      Index from, to, section;
      auto ends() const { return std::tie(from, to); }
    };
    std::vector<Directed> directed;
    for (Index i = 0; i < boundary.size(); ++i)
      directed.push_back({number(boundary[i].from), number(boundary[i].to), i});
    const auto is_less = [](const Directed& a, const Directed& b) { return a.ends() < b.ends(); };
    std::sort(directed.begin(), directed.end(), is_less);
    std::size_t found = 0;
    infos_.assign(triangulation_.triangles().size(), {});
    for (Index face = 0; face < infos_.size(); ++face)
      for (std::size_t i = 0; i < 3; ++i) {
        const Triangle& t = triangle(face);
        if (t.is_infinite() || !t.is_constrained[i])
          continue;
        const Directed wanted{t.corners[ccw(i)], t.corners[cw(i)], none};
        const auto [begin, end] =
            std::equal_range(directed.begin(), directed.end(), wanted, is_less);
        if (begin == end)
          continue;
        infos_[face].sections[i] = begin->section;
        ++found;
      }
    return found == boundary.size();
  }

  // Numbers the faces on the left of the boundary, and the faces that are connected with them.
  // Returns false if that leads to the right of the boundary.
  bool find_inside() {
    inside_.clear();
    const auto add = [&](Index face) {
      if (infos_[face].number != none)
        return;
      infos_[face].number = static_cast<Index>(inside_.size());
      inside_.push_back(face);
    };
    for (Index face = 0; face < infos_.size(); ++face)
      if (infos_[face].sections != std::array<Index, 3>{none, none, none})
        add(face);
    for (std::size_t k = 0; k < inside_.size(); ++k)
      for (std::size_t i = 0; i < 3; ++i) {
        const Triangle& t = triangle(inside_[k]);
        if (t.is_constrained[i] && infos_[inside_[k]].sections[i] == none)
          return false;
        if (t.is_constrained[i])
          continue;
        if (triangle(t.mates[i]).is_infinite())
          return false;
        add(t.mates[i]);
      }
    return !inside_.empty();
  }

  // Assigns to all corners of a sector the end of the boundary section that leads to it, and to all
  // corners of a vertex inside its own. Returns false if a corner is left.
  bool find_corners(std::span<const BoundarySection> boundary, std::span<const Index> inner) {
    for (Index first : inside_)
      for (std::size_t i = 0; i < 3; ++i) {
        const Index section = infos_[first].sections[i];
        if (section == none)
          continue;
        const Index v = triangle(first).corners[cw(i)];
        for (Index face = first;;) {
          const std::size_t at = triangle(face).corner(v);
          infos_[face].corners[at] = boundary[section].to;
          if (triangle(face).is_constrained[cw(at)])
            break;
          face = triangle(face).mates[cw(at)];
        }
      }
    std::vector<Index> corner_inside(places_.size(), none);
    for (Index side : inner)
      corner_inside[number(side)] = side;
    for (Index face : inside_)
      for (std::size_t i = 0; i < 3; ++i) {
        Index& corner = infos_[face].corners[i];
        if (corner == none)
          corner = corner_inside[triangle(face).corners[i]];
        if (corner == none)
          return false;
      }
    return true;
  }

  std::vector<PatchTriangle> inside_triangles() const {
    std::vector<PatchTriangle> triangles;
    for (Index face : inside_) {
      PatchTriangle made{infos_[face].corners, {none, none, none}};
      for (std::size_t i = 0; i < 3; ++i) { // the side to a corner is opposite to the next one
        const std::size_t opposite = ccw(i);
        if (!triangle(face).is_constrained[opposite])
          made.mates[i] = infos_[triangle(face).mates[opposite]].number;
      }
      triangles.push_back(made);
    }
    return triangles;
  }

  std::span<const Vector<3>> positions_;
  const SurfaceSides& sides_;
  const PatchBoundaries& boundaries_;
  std::vector<Index> number_; // for each vertex, its index in places_; none for others
  std::vector<Index> places_;
  std::vector<ConstrainedTriangulation::Point> points_; // for each place
  ConstrainedTriangulation triangulation_;
  std::vector<FaceInfo> infos_; // for each of its triangles
  std::vector<Index> inside_;   // triangles
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_PLANAR_PATCH_TRIANGULATION_H
