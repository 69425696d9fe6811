#ifndef QUADRILLE_INTERNAL_GAPS_GAP_REFINEMENT_H
#define QUADRILLE_INTERNAL_GAPS_GAP_REFINEMENT_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/surface/half_edges.h>
#include <quadrille/internal/gaps/facing_walls.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Splits faces that are near it only at one end a wall that they face, until their edges are no
/// longer than the size. The surface stays where it is. Source: Rivara, New mathematical tools and
/// techniques for the refinement of triangulations, 1996: always the longest edge of a face, after
/// longer ones of its neighbours.
class GapRefinement {
public:
  std::vector<std::array<Index, 2>> added; ///< vertices in the middle between two others
  std::vector<Index> sources;              ///< for each face, the one of which it is a fragment

  /// `component`: of each vertex, with those that are added.
  GapRefinement(HalfEdges& surface, std::vector<Index>& component, const FacingWalls& walls)
      : surface_(surface), component_(component), walls_(walls) {
    for (Index face = 0; face < surface.faces(); ++face)
      sources.push_back(face);
    for (Index face = 0; face < surface.faces(); ++face) // also those that are added
      while (is_near_at_one_end(face) && split_longest(face))
        ;
  }

private:
  using Length = std::tuple<double, Index, Index>; // no two edges have the same

  bool is_near_at_one_end(Index face) {
    return std::get<0>(length(longest(face))) > walls_.size() * walls_.size() &&
           !is_all_near(face) && walls_.is_any_near(face);
  }
  bool is_all_near(Index face) {
    const auto& [a, b, c] = surface_.triangle(face);
    return wall(a) != none && wall(b) == wall(a) && wall(c) == wall(a);
  }
  // The component that a vertex faces.
  Index wall(Index v) {
    wall_.resize(surface_.vertices());
    if (!wall_[v])
      wall_[v] = walls_.nearest(v).component;
    return *wall_[v];
  }

  Length length(Index h) const {
    const Index a = surface_.origin(h), b = surface_.target(h);
    return {squared_distance(surface_.point(a), surface_.point(b)), (std::min)(a, b),
            (std::max)(a, b)};
  }
  Index longest(Index face) const {
    Index h = 3 * face;
    for (Index other = h + 1; other < 3 * face + 3; ++other)
      if (length(other) > length(h))
        h = other;
    return h;
  }
  // Faces that have a vertex at a boundary, or one that is kept, stay as they are.
  bool can_split(Index h) const {
    const Index twin = surface_.twin(h);
    return twin != none && is_inside(HalfEdges::face(h)) && is_inside(HalfEdges::face(twin));
  }
  bool is_inside(Index face) const {
    const auto& [a, b, c] = surface_.triangle(face);
    return surface_.is_inside(a) && surface_.is_inside(b) && surface_.is_inside(c);
  }

  bool split_longest(Index face) {
    Index h = longest(face);
    if (!can_split(h))
      return false;
    for (;;) {
      const Index next = longest(HalfEdges::face(surface_.twin(h)));
      if (length(next) == length(h) || !can_split(next))
        break;
      h = next;
    }
    surface_.split(
        h,
        [&](Index a, Index b) {
          added.push_back({a, b});
          component_.push_back(Index{component_[a]});
        },
        [&](Index like) { sources.push_back(Index{sources[like]}); });
    return true;
  }

  HalfEdges& surface_;
  std::vector<Index>& component_;
  const FacingWalls& walls_;
  std::vector<std::optional<Index>> wall_; // of vertices that were asked for
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GAPS_GAP_REFINEMENT_H
