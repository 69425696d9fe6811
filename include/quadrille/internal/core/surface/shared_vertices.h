#ifndef QUADRILLE_INTERNAL_CORE_SURFACE_SHARED_VERTICES_H
#define QUADRILLE_INTERNAL_CORE_SURFACE_SHARED_VERTICES_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/memory/append_buffer.h>
#include <quadrille/internal/core/surface/numbering.h>

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The vertices of a chunk of a surface that other chunks have as well. They are fixed here, and
/// these rules ensure that chunks fit after each has been simplified by itself.
///
/// An edge of one face between two shared vertices is a *seam*, as a rule, and no boundary: the
/// face on its other side is in another chunk. Such edges that are boundaries of the whole surface
/// are listed.
class SharedVertices {
public:
  using Edge = std::array<Index, 2>;

  /// `is_shared` is of each vertex, or empty if none is; `boundaries` are by input indices.
  SharedVertices(std::vector<bool> is_shared, std::vector<Edge> boundaries,
                 const Numbering& numbering)
      : is_shared_(std::move(is_shared)), boundaries_(std::move(boundaries)),
        numbering_(numbering) {
    for (auto& [v, w] : boundaries_)
      if (v > w)
        std::swap(v, w);
    std::sort(boundaries_.begin(), boundaries_.end());
  }

  bool is_any() const { return !is_shared_.empty(); }
  bool has(Index v) const { return !is_shared_.empty() && is_shared_[v]; }

  /// Is an edge of one face a seam, and no boundary?
  bool is_seam(Index v, Index w) const {
    if (!has(v) || !has(w))
      return false;
    const auto [low, high] = std::minmax({numbering_.vertices[v], numbering_.vertices[w]});
    return !std::binary_search(boundaries_.begin(), boundaries_.end(), Edge{low, high});
  }

  /// Would a contraction of ab, of which one end at most is shared, make an edge between shared
  /// vertices that is not here yet, or a face of three of them? Another chunk may have or make the
  /// same, unseen from here: four faces would meet at the edge, or two lie on the face.
  ///
  /// If topology is kept, the common neighbours of both ends are those opposite to ab; if it is
  /// free, this also rejects edges that are here but not opposite.
  QUADRILLE_NOINLINE bool makes_chord(const PairStar& star, Index a, Index b) const {
    if (!has(a) && !has(b))
      return false;
    const auto is_opposite = [&](Index v) {
      return std::any_of(star.shared.begin(), star.shared.end(),
                         [&](const StarFace& f) { return f.other_than(b) == v; });
    };
    const AppendBuffer<StarFace>& changed = has(a) ? star.second : star.first;
    return std::any_of(changed.begin(), changed.end(), [&](const StarFace& f) {
      const bool has_second = has(f.second), has_third = has(f.third);
      return (has_second && has_third) || (has_second && !is_opposite(f.second)) ||
             (has_third && !is_opposite(f.third));
    });
  }

  static auto vertex_arrays(auto& self) { return std::tie(self.is_shared_); }

private:
  std::vector<bool> is_shared_;
  std::vector<Edge> boundaries_; // by input indices, the lower first, sorted
  const Numbering& numbering_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_SURFACE_SHARED_VERTICES_H
