#ifndef QUADRILLE_INTERNAL_CORE_SURFACE_DISC_SURROUNDINGS_H
#define QUADRILLE_INTERNAL_CORE_SURFACE_DISC_SURROUNDINGS_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/surface/half_edges.h>
#include <quadrille/quadric_form.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace quadrille::internal {

/// The neighbours of each vertex inside a surface, in their order around it.
class VertexRings {
public:
  explicit VertexRings(const HalfEdges& surface) {
    begin_.reserve(surface.vertices() + 1);
    neighbors_.reserve(3 * surface.faces());
    for (Index v = 0; v < surface.vertices(); ++v) {
      begin_.push_back(neighbors_.size());
      if (surface.is_inside(v))
        surface.for_each_out(v, [&](Index h) { neighbors_.push_back(surface.target(h)); });
    }
    begin_.push_back(neighbors_.size());
  }
  /// Empty for a vertex that is not inside.
  std::span<const Index> ring(Index v) const {
    return {neighbors_.data() + begin_[v], neighbors_.data() + begin_[v + 1]};
  }

private:
  std::vector<std::size_t> begin_;
  std::vector<Index> neighbors_;
};

/// Determines quickly whether what hangs together with a vertex within a ball is a disc, so that no loop
/// there runs round anything: vertices less edges, plus faces, are one then.
class DiscSurroundings {
public:
  DiscSurroundings(const HalfEdges& surface, const VertexRings& rings)
      : surface_(surface), rings_(rings), state_(surface.vertices(), 0) {}

  /// Is it so within `radius` of a vertex? Only vertices inside the surface count.
  bool is_disc(Index base, double radius) {
    now_ += 2;
    base_ = surface_.point(base);
    radius_ = radius;
    reached_.assign(1, base);
    state_[base] = now_;
    std::size_t twice_edges = 0, thrice_faces = 0;
    for (std::size_t i = 0; i < reached_.size(); ++i) {
      const std::span<const Index> ring = rings_.ring(reached_[i]);
      bool was_here = visit(ring.back());
      for (const Index v : ring) {
        const bool is_here = visit(v);
        twice_edges += is_here;
        thrice_faces += is_here && was_here;
        was_here = is_here;
      }
    }
    return reached_.size() + thrice_faces / 3 == twice_edges / 2 + 1;
  }

  /// The vertices of the last call.
  const std::vector<Index>& reached() const { return reached_; }
  /// Is a vertex that close to the base of the last call?
  bool is_within(Index v, double distance) const {
    return squared_length(surface_.point(v) - base_) <= distance * distance;
  }

private:
  bool visit(Index v) {
    if (state_[v] < now_ - 1) {
      const bool is_here = surface_.is_inside(v) && is_within(v, radius_);
      state_[v] = is_here ? now_ : now_ - 1;
      if (is_here)
        reached_.push_back(v);
    }
    return state_[v] == now_;
  }

  const HalfEdges& surface_;
  const VertexRings& rings_;
  Vector<3> base_{};
  double radius_ = 0;
  std::uint32_t now_ = 0;            // the number of the call, twice
  std::vector<std::uint32_t> state_; // of each vertex: now_ if it is reached, one less if not
  std::vector<Index> reached_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_SURFACE_DISC_SURROUNDINGS_H
