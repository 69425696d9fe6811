#ifndef QUADRILLE_INTERNAL_CORE_CONTRACTION_COUNTS_H
#define QUADRILLE_INTERNAL_CORE_CONTRACTION_COUNTS_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/cost_histogram.h>
#include <quadrille/internal/core/complex/edge_count.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/state/cleanup.h>
#include <quadrille/internal/core/state/part_event.h>
#include <quadrille/internal/core/state/scratch.h>
#include <quadrille/internal/core/surface/numbering.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace quadrille::internal {

/// How many faces of a surface may not be changed, since they are not selected, and how many
/// vertices have no others: what the target does not count. `is_selected` is of each input face;
/// empty if all are. In linear time.
inline Loss count_unselected(const TriangleComplex& complex, const InputIndices& input_faces,
                             const std::vector<bool>& is_selected) {
  if (is_selected.empty())
    return {0, 0};
  std::size_t faces = 0;
  std::vector<bool> has_selected(complex.vertex_capacity());
  for (Index face = 0; face < complex.face_capacity(); ++face) {
    if (complex.is_removed(face))
      continue;
    if (!is_selected[input_faces[face]])
      faces += complex.backs().count(face);
    else
      for (Index v : complex.vertices(face))
        has_selected[v] = true;
  }
  const auto selected = std::count(has_selected.begin(), has_selected.end(), true);
  return {faces, complex.count_vertices() - static_cast<std::size_t>(selected)};
}

/// Counts the faces that contractions take at their edges, by what these cost, where that is asked
/// for. In greedy order a contraction counts as costly as the most costly one before it, so that
/// the faces up to a cost are those that a run up to it would have taken; in a pass by its own key.
class CountedCosts {
public:
  /// `histogram` is null if nobody asks.
  CountedCosts(CostHistogram* histogram, const TriangleComplex& complex)
      : histogram_(histogram), complex_(complex) {}

  template <class Event>
  QUADRILLE_ALWAYS_INLINE void before(const Event& event) {
    if (histogram_) [[unlikely]]
      count<Event::is_in_pass>(static_cast<float>(event.contraction.key()),
                               complex_.backs().count_all(event.contraction.star().shared));
  }

private:
  template <bool is_in_pass>
  QUADRILLE_NOINLINE void count(float key, std::size_t faces) {
    if constexpr (is_in_pass) {
      histogram_->add_in_pass(key, faces);
    } else {
      highest_ = (std::max)(highest_, key);
      histogram_->add(highest_, faces);
    }
  }

  CostHistogram* histogram_;
  const TriangleComplex& complex_;
  float highest_ = 0;
};

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

#endif // QUADRILLE_INTERNAL_CORE_CONTRACTION_COUNTS_H
