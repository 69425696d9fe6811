#ifndef QUADRILLE_INTERNAL_PLANAR_PATCH_BOUNDARIES_H
#define QUADRILLE_INTERNAL_PLANAR_PATCH_BOUNDARIES_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/planar/surface_sides.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <span>
#include <tuple>
#include <vector>

namespace quadrille::internal {

/// The boundaries of patches, and which vertices are *kept*: the corners of boundaries, and the
/// vertices that must stay.
///
/// The corners around a vertex that are connected within a patch are a *sector*: an open one
/// between two boundary sides, or a closed one. A boundary vertex is kept unless exactly two
/// boundary edges meet there, each sector lies between these two, and no other boundary vertex is
/// at its position.
class PatchBoundaries {
public:
  using Edge = std::array<Index, 2>; ///< two vertices

  /// is_inside(side): does the side lie inside a patch? is_fixed(v): must a vertex stay?
  template <class IsInside, class IsFixed>
  PatchBoundaries(std::span<const Vector<3>> positions, const SurfaceSides& sides,
                  IsInside is_inside, IsFixed is_fixed)
      : sides_(sides), next_(sides.size(), none), degree_(positions.size(), 0),
        is_kept_(positions.size(), 0), place_(positions.size()) {
    find_boundaries(is_inside);
    const std::vector<unsigned char> is_through = find_sectors();
    std::vector<Index> closed(positions.size(), 0);
    for (Index corner : closed_sectors_)
      ++closed[sides.to(corner)];
    for (Index v = 0; v < positions.size(); ++v) {
      const bool is_corner =
          degree_[v] == 2 ? closed[v] > 0 || !is_through[v] : degree_[v] > 0 || closed[v] > 1;
      is_kept_[v] = is_corner || is_fixed(v);
    }
    find_places(positions);
  }

  bool is_boundary(Index side) const { return next_[side] != none; }
  /// The boundary side that follows a given one around the same patch.
  Index next(Index side) const { return next_[side]; }

  bool is_kept(Index v) const { return is_kept_[v] != 0; }
  void keep(Index v) { is_kept_[v] = 1; }
  /// The number of boundary edges of a vertex.
  Index degree(Index v) const { return degree_[v]; }
  /// The lowest of the vertices at its position that are on boundaries or kept.
  Index place(Index v) const { return place_[v]; }

  /// All boundary edges.
  const std::vector<Edge>& edges() const { return edges_; }
  /// For each closed sector, a side that leads to it.
  const std::vector<Index>& closed_sectors() const { return closed_sectors_; }

private:
  template <class IsInside>
  void find_boundaries(IsInside is_inside) {
    sides_.for_each_edge([&](std::span<const SurfaceSides::Keyed> sides) {
      if (is_inside(sides[0].second))
        return;
      for (const auto& [vertices, side] : sides)
        next_[side] = side; // until sectors are known
      const Edge ends{sides_.from(sides[0].second), sides_.to(sides[0].second)};
      edges_.push_back(ends);
      for (Index v : ends)
        ++degree_[v];
    });
  }

  // Finds for each vertex whether each of its sectors lies between two different edges.
  std::vector<unsigned char> find_sectors() {
    std::vector<unsigned char> is_through(degree_.size(), 1);
    std::vector<unsigned char> is_seen(next_.size(), 0); // for each corner
    for (Index s = 0; s < next_.size(); ++s) {
      if (!is_boundary(s))
        continue;
      is_seen[s] = 1;
      Index out = SurfaceSides::after(s);
      for (; !is_boundary(out); out = SurfaceSides::after(sides_.mate(out)))
        is_seen[sides_.mate(out)] = 1;
      next_[s] = out;
      if (sides_.from(s) == sides_.to(out))
        is_through[sides_.to(s)] = 0;
    }
    for (Index s = 0; s < next_.size(); ++s) {
      if (is_seen[s] || !sides_.is_triangle(SurfaceSides::face(s)))
        continue;
      closed_sectors_.push_back(s);
      for (Index c = s; !is_seen[c]; c = sides_.mate(SurfaceSides::after(c)))
        is_seen[c] = 1;
    }
    return is_through;
  }

  // Keeps boundary vertices that share a position.
  void find_places(std::span<const Vector<3>> positions) {
    std::iota(place_.begin(), place_.end(), Index{0});
    std::vector<Index> order;
    for (Index v = 0; v < positions.size(); ++v)
      if (degree_[v] > 0 || is_kept(v))
        order.push_back(v);
    const auto key = [&](Index v) {
      return std::tuple(positions[v][0], positions[v][1], positions[v][2]);
    };
    std::stable_sort(order.begin(), order.end(), [&](Index v, Index w) { return key(v) < key(w); });
    for (std::size_t i = 1; i < order.size(); ++i)
      if (key(order[i]) == key(order[i - 1])) {
        place_[order[i]] = place_[order[i - 1]];
        keep(order[i - 1]);
        keep(order[i]);
      }
  }

  const SurfaceSides& sides_;
  std::vector<Index> next_; // for each boundary side; none for others
  std::vector<Index> degree_;
  std::vector<unsigned char> is_kept_;
  std::vector<Index> place_;
  std::vector<Edge> edges_;
  std::vector<Index> closed_sectors_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_PLANAR_PATCH_BOUNDARIES_H
