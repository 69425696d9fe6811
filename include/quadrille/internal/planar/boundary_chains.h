#ifndef QUADRILLE_INTERNAL_PLANAR_BOUNDARY_CHAINS_H
#define QUADRILLE_INTERNAL_PLANAR_BOUNDARY_CHAINS_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/surface/thinned_line.h>
#include <quadrille/internal/planar/patch_boundaries.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Straightens the boundaries of patches, in the same way for all patches that share them.
///
/// Boundary edges between kept vertices form *chains*, which are thinned out; a closed chain keeps
/// at least three vertices. Two chains never become one edge.
class BoundaryChains {
public:
  BoundaryChains(PatchBoundaries& boundaries, std::span<const Vector<3>> positions,
                 double tolerance)
      : boundaries_(boundaries), positions_(positions), tolerance_(tolerance),
        neighbors_(positions.size(), {none, none}), is_seen_(positions.size(), 0) {}

  void straighten() {
    link();
    for (const auto& [v, w] : boundaries_.edges()) {
      collect(v, w);
      collect(w, v);
    }
    for (Index v = 0; v < positions_.size(); ++v)
      if (is_free(v) && !is_seen_[v])
        collect_loop(v);
    for (const std::vector<Index>& chain : chains_)
      straighten(chain);
    keep_apart();
  }

private:
  using Chain = std::vector<Index>;

  // Links each vertex of a boundary that is not kept with its two neighbours.
  void link() {
    for (const auto& [v, w] : boundaries_.edges())
      for (const auto& [one, other] : {std::pair(v, w), std::pair(w, v)})
        if (is_free(one))
          neighbors_[one][neighbors_[one][0] == none ? 0 : 1] = other;
  }
  bool is_free(Index v) const { return boundaries_.degree(v) == 2 && !boundaries_.is_kept(v); }

  // Collects the chain that begins at a kept vertex along an edge, unless it has been collected
  // from its other end.
  void collect(Index first, Index second) {
    if (is_free(first) || !is_free(second) || is_seen_[second])
      return;
    Chain chain{first};
    for (Index v = second; is_free(v);)
      v = advance(chain, v);
    chains_.push_back(std::move(chain));
  }
  // Collects a chain without kept vertices; it begins and ends where it is farthest from some
  // vertex, which is a corner of its convex hull.
  void collect_loop(Index any) {
    Chain loop{neighbors_[any][1]};
    for (Index v = any; !is_seen_[v];)
      v = advance(loop, v);
    loop.pop_back(); // the chain is closed
    const Vector<3> p = positions_[any];
    const auto start = std::max_element(loop.begin(), loop.end(), [&](Index v, Index w) {
      return squared_distance(positions_[v], p) < squared_distance(positions_[w], p);
    });
    std::rotate(loop.begin(), start, loop.end());
    loop.push_back(loop.front());
    boundaries_.keep(loop.front());
    chains_.push_back(std::move(loop));
  }
  // Appends a vertex after the last one, and returns the next one.
  Index advance(Chain& chain, Index v) {
    const Index last = chain.back();
    chain.push_back(v);
    is_seen_[v] = 1;
    const Index next = neighbors_[v][0] == last ? neighbors_[v][1] : neighbors_[v][0];
    if (!is_free(next))
      chain.push_back(next);
    return next;
  }

  void straighten(const Chain& chain) {
    const std::vector<bool> stays = ThinnedLine::of(positions_, chain, tolerance_);
    for (std::size_t i = 0; i < chain.size(); ++i)
      if (stays[i])
        boundaries_.keep(chain[i]);
  }

  // Keeps all vertices of those sections of chains that would have the same two ends as another
  // section.
  void keep_apart() {
    struct Section {
      PatchBoundaries::Edge ends;
      const Chain* chain; // null: a single edge
      std::size_t begin, end;
    };
    std::vector<Section> sections;
    const auto add = [&](Index v, Index w, const Chain* chain, std::size_t begin, std::size_t end) {
      sections.push_back({{(std::min)(v, w), (std::max)(v, w)}, chain, begin, end});
    };
    for (const auto& [v, w] : boundaries_.edges())
      if (boundaries_.is_kept(v) && boundaries_.is_kept(w))
        add(v, w, nullptr, 0, 0);
    for (const Chain& chain : chains_)
      for (std::size_t begin = 0, end = 1; end < chain.size(); ++end)
        if (boundaries_.is_kept(chain[end])) {
          if (end > begin + 1)
            add(chain[begin], chain[end], &chain, begin, end);
          begin = end;
        }
    std::stable_sort(sections.begin(), sections.end(),
                     [](const Section& a, const Section& b) { return a.ends < b.ends; });
    for (std::size_t i = 0; i < sections.size(); ++i)
      if ((i > 0 && sections[i].ends == sections[i - 1].ends) ||
          (i + 1 < sections.size() && sections[i].ends == sections[i + 1].ends))
        for (std::size_t k = sections[i].begin; k < sections[i].end; ++k)
          boundaries_.keep((*sections[i].chain)[k]);
  }

  PatchBoundaries& boundaries_;
  std::span<const Vector<3>> positions_;
  double tolerance_;
  std::vector<std::array<Index, 2>> neighbors_;
  std::vector<unsigned char> is_seen_;
  std::vector<Chain> chains_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_PLANAR_BOUNDARY_CHAINS_H
