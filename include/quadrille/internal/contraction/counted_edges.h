#ifndef QUADRILLE_INTERNAL_CONTRACTION_COUNTED_EDGES_H
#define QUADRILLE_INTERNAL_CONTRACTION_COUNTED_EDGES_H

#include <quadrille/internal/base/compiler.h>
#include <quadrille/internal/complex/edge_count.h>
#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/contraction/part_event.h>
#include <quadrille/internal/contraction/scratch.h>
#include <quadrille/internal/surface/numbering.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace quadrille::internal {

/// Keeps count of the edges that contractions take, where the stop policy asks for them.
class CountedEdges {
public:
  CountedEdges(bool is_asked, const TriangleComplex& complex, Scratch& scratch)
      : is_asked_(is_asked), complex_(complex), scratch_(scratch) {}

  /// How many edges selected faces have: what the target counts. `is_selected` is of each input
  /// face, or empty if all are. As many as can be where nobody asks.
  std::size_t count(const InputIndices& input_faces, const std::vector<bool>& is_selected) const {
    if (!is_asked_)
      return (std::numeric_limits<std::size_t>::max)();
    return count_edges(complex_, scratch_.labels, [&](Index face) {
      return is_selected.empty() || is_selected[input_faces[face]];
    });
  }

  template <class Event>
  QUADRILLE_ALWAYS_INLINE void before(const Event& event) {
    if (is_asked_) [[unlikely]]
      count(event.contraction.star(), event.contraction.second(), event.contraction.scratch());
  }
  void vanished(const PartEvent& event) {
    if (is_asked_)
      scratch_.tally.edges += count_edges(complex_, event.faces);
  }

private:
  QUADRILLE_NOINLINE static void count(const PairStar& star, Index second, Scratch& scratch) {
    scratch.tally.edges += count_edges_taken(star, second, scratch.labels);
  }

  bool is_asked_;
  const TriangleComplex& complex_;
  Scratch& scratch_; // of the thread that removes parts
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CONTRACTION_COUNTED_EDGES_H
