#ifndef QUADRILLE_INTERNAL_CORE_SURFACE_HANDLE_CUTS_H
#define QUADRILLE_INTERNAL_CORE_SURFACE_HANDLE_CUTS_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/surface/half_edges.h>
#include <quadrille/internal/core/surface/loop_sides.h>
#include <quadrille/internal/core/surface/short_loops.h>
#include <quadrille/triangle_soup.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Cuts a surface along loops up to a length that run round tunnels and handles.
///
/// Vertices are taken in their order, and the surroundings of each searched for loops, but for
/// those that lie so close to an earlier one that a loop through them was in reach from there. A
/// loop is drawn tight before it is judged by its length: it gives way to the shortest one through
/// its vertices. Tunnels come first: once they are filled, walls between them are no handles.
class HandleCuts {
public:
  std::size_t handles = 0, necks = 0; ///< how many were cut
  std::vector<std::array<Index, 2>>
      added; ///< the two vertices in the middle of which each lies; twice one for a copy
  std::vector<Index> like; ///< for each added face, a face next to it

  /// `size`: a third of the length of the longest loop. `is_kept`: empty, or of each vertex whether
  /// no loop may go through it.
  HandleCuts(const SurfaceView& surface, double size, const std::vector<bool>& is_kept)
      : surface_(surface, is_kept), loops_(surface_), shorter_(surface_), sides_(surface_),
        size_(size), longest_(3 * size), slack_(longest_ / 3),
        is_covered_(surface_.vertices(), false) {
    for (Index v = 0; v < surface_.vertices(); ++v) // also those that are added
      search_from(v);
    only_tunnels_ = false;
    for (const Index v : std::exchange(near_handles_, {})) {
      is_covered_[v] = false;
      search_from(v);
    }
  }

  const HalfEdges& surface() const { return surface_; }

private:
  // From a vertex, and then from all at which the surface has been cut.
  void search_from(Index v) {
    to_search_.push_back(v);
    while (!to_search_.empty()) {
      const Index base = to_search_.back();
      to_search_.pop_back();
      if (!is_covered_[base] && surface_.is_inside(base))
        look_around(base);
    }
  }
  void look_around(Index base) {
    has_handles_ = false;
    while (const auto loop = loop_around(base))
      cut(*loop);
    if (has_handles_)
      near_handles_.push_back(base);
    is_covered_[base] = true;
    loops_.for_each_within(slack_, [&](Index v) { is_covered_[v] = true; });
  }

  // A loop that is to be cut.
  std::optional<EdgeLoop> loop_around(Index base) {
    std::optional<EdgeLoop> found;
    loops_.search(base, radius(), [&](EdgeLoop loop) {
      if (loop.length > longest_ + 2 * slack_ || !is_cuttable(loop))
        return false;
      draw_tight(loop);
      if (loop.length <= longest_)
        found = std::move(loop);
      return found.has_value();
    });
    return found;
  }
  double radius() const { return longest_ / 2 + slack_; }
  bool is_cuttable(const EdgeLoop& loop) {
    if (only_tunnels_ && !is_round_tunnel(surface_, loop)) {
      has_handles_ |= !sides_.is_in_disc(loop);
      return false;
    }
    return sides_.kind(loop, size_) != LoopKind::limb;
  }

  void draw_tight(EdgeLoop& loop) {
    const std::vector<Index> half_edges = loop.half_edges;
    for (const Index h : half_edges)
      shorter_.search(surface_.origin(h), loop.length / 2, [&](EdgeLoop other) {
        if (other.length >= loop.length || !is_cuttable(other))
          return false;
        loop = std::move(other);
        return true;
      });
  }

  void cut(const EdgeLoop& loop) {
    if (sides_.kind(loop, size_) == LoopKind::handle) {
      ++handles;
    } else {
      ++necks;
      sides_.split();
    }
    surface_.cut(
        loop.half_edges,
        [&](Index a, Index b) {
          added.push_back({a, b});
          is_covered_.push_back(false);
        },
        [&](Index face) { like.push_back(face); });
    for (const Index h : loop.half_edges) {
      is_covered_[surface_.origin(h)] = false;
      to_search_.push_back(surface_.origin(h));
    }
  }

  HalfEdges surface_;
  ShortLoops loops_, shorter_;
  LoopSides sides_;
  double size_, longest_, slack_;
  std::vector<bool> is_covered_;
  std::vector<Index> to_search_;
  std::vector<Index> near_handles_; // from which others than tunnels have been seen
  bool only_tunnels_ = true, has_handles_ = false;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_SURFACE_HANDLE_CUTS_H
