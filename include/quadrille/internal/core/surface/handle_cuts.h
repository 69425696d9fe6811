#ifndef QUADRILLE_INTERNAL_CORE_SURFACE_HANDLE_CUTS_H
#define QUADRILLE_INTERNAL_CORE_SURFACE_HANDLE_CUTS_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/threads.h>
#include <quadrille/internal/core/surface/disc_surroundings.h>
#include <quadrille/internal/core/surface/half_edges.h>
#include <quadrille/internal/core/surface/loop_sides.h>
#include <quadrille/internal/core/surface/short_loops.h>
#include <quadrille/triangle_soup.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Cuts a surface along loops up to a width that run round tunnels and handles.
///
/// Vertices are taken in their order, and the surroundings of each searched for loops, but for
/// those that lie so close to an earlier one that a loop through them was in reach from there. A
/// loop is drawn tight before it is judged by its width: it gives way to the shortest one through
/// its vertices. Tunnels come first: once they are filled, walls between them are no handles.
class HandleCuts {
public:
  std::size_t handles = 0, necks = 0; ///< how many were cut
  std::vector<std::array<Index, 2>>
      added; ///< the two vertices in the middle of which each lies; twice one for a copy
  std::vector<Index> like; ///< for each added face, a face next to it

  /// `size`: the width of the widest loop. `is_kept`: empty, or of each vertex whether no loop may
  /// go through it.
  HandleCuts(const SurfaceView& surface, double size, const std::vector<bool>& is_kept,
             Threads threads)
      : surface_(surface, is_kept), loops_(surface_), shorter_(surface_), sides_(surface_),
        size_(size), longest_(4 * size), slack_(longest_ / 3), is_covered_(surface_.vertices(), 0) {
    with_threads(threads, [&] { cover_discs(threads); });
    for (Index v = 0; v < surface_.vertices(); ++v) // also those that are added
      search_from(v);
    only_tunnels_ = false;
    for (const Index v : std::exchange(near_handles_, {})) {
      is_covered_[v] = 0;
      search_from(v);
    }
  }

  const HalfEdges& surface() const { return surface_; }

private:
  // Most vertices lie in discs, which need no search: in large ones, which are few, or else in
  // smaller ones. Vertices are taken in blocks, so that the result does not depend on the threads.
  void cover_discs(Threads threads) {
    constexpr Index block = 1 << 16;
    const auto vertices = static_cast<Index>(surface_.vertices());
    const VertexRings rings(surface_);
    std::vector<std::optional<DiscSurroundings>> of_worker(threads);
    for (const double slack : {2 * slack_, slack_, slack_ / 2}) {
      std::vector<unsigned char> is_seen = is_covered_;
      parallel_for(threads, (vertices + block - 1) / block, [&](std::size_t i, std::size_t worker) {
        if (!of_worker[worker])
          of_worker[worker].emplace(surface_, rings);
        DiscSurroundings& surroundings = *of_worker[worker];
        const Index first = static_cast<Index>(i) * block,
                    beyond = (std::min)(vertices, first + block);
        for (Index v = first; v < beyond; ++v) {
          if (is_seen[v] != 0 || !surface_.is_inside(v))
            continue;
          const bool is_disc = surroundings.is_disc(v, longest_ / 2 + slack);
          for (const Index w : surroundings.reached())
            if (w >= first && w < beyond && is_seen[w] == 0 && surroundings.is_within(w, slack)) {
              is_seen[w] = 1;
              is_covered_[w] |= static_cast<unsigned char>(is_disc);
            }
        }
      });
    }
  }
  // From a vertex, and then from all at which the surface has been cut.
  void search_from(Index v) {
    to_search_.push_back(v);
    while (!to_search_.empty()) {
      const Index base = to_search_.back();
      to_search_.pop_back();
      if (is_covered_[base] == 0 && surface_.is_inside(base))
        look_around(base);
    }
  }
  void look_around(Index base) {
    has_handles_ = false;
    while (const auto loop = loop_around(base))
      cut(*loop);
    if (has_handles_)
      near_handles_.push_back(base);
    is_covered_[base] = 1;
    loops_.for_each_within(slack_, [&](Index v) { is_covered_[v] = 1; });
  }

  struct Cut {
    EdgeLoop loop;
    LoopKind kind;
  };

  // A loop that is to be cut.
  std::optional<Cut> loop_around(Index base) {
    std::optional<Cut> found;
    loops_.search(base, radius(), [&](EdgeLoop loop) {
      if (loop.length > longest_ + 2 * slack_)
        return false;
      const LoopKind kind = kind_of(loop);
      if (kind == LoopKind::limb)
        return false;
      Cut cut{std::move(loop), kind};
      draw_tight(cut);
      if (width_of(surface_, cut.loop) <= size_)
        found = std::move(cut);
      return found.has_value();
    });
    return found;
  }
  double radius() const { return longest_ / 2 + slack_; }
  // A limb is also what waits until the tunnels are cut.
  LoopKind kind_of(const EdgeLoop& loop) {
    if (only_tunnels_ && !sides_.is_round_tunnel(loop)) {
      has_handles_ |= !sides_.is_in_disc(loop);
      return LoopKind::limb;
    }
    return sides_.kind(loop, size_);
  }

  void draw_tight(Cut& cut) {
    const std::vector<Index> half_edges = cut.loop.half_edges;
    for (const Index h : half_edges)
      shorter_.search(surface_.origin(h), (std::min)(cut.loop.length, longest_) / 2,
                      [&](EdgeLoop other) {
                        if (other.length >= cut.loop.length)
                          return false;
                        const LoopKind kind = kind_of(other);
                        if (kind == LoopKind::limb)
                          return false;
                        cut = {std::move(other), kind};
                        return true;
                      });
  }

  void cut(const Cut& at) {
    const EdgeLoop& loop = at.loop;
    if (at.kind == LoopKind::handle) {
      ++handles;
    } else {
      ++necks;
      sides_.split(loop);
    }
    surface_.cut(
        loop.half_edges,
        [&](Index a, Index b) {
          added.push_back({a, b});
          is_covered_.push_back(0);
        },
        [&](Index face) { like.push_back(face); });
    for (const Index h : loop.half_edges) {
      is_covered_[surface_.origin(h)] = 0;
      to_search_.push_back(surface_.origin(h));
    }
  }

  HalfEdges surface_;
  ShortLoops loops_, shorter_;
  LoopSides sides_;
  double size_, longest_, slack_;
  std::vector<unsigned char> is_covered_;
  std::vector<Index> to_search_;
  std::vector<Index> near_handles_; // from which others than tunnels have been seen
  bool only_tunnels_ = true, has_handles_ = false;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_SURFACE_HANDLE_CUTS_H
