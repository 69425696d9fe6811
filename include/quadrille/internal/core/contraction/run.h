#ifndef QUADRILLE_INTERNAL_CORE_CONTRACTION_RUN_H
#define QUADRILLE_INTERNAL_CORE_CONTRACTION_RUN_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/cost_histogram.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/complex/vertex_labels.h>
#include <quadrille/internal/core/contraction/measured_distances.h>
#include <quadrille/internal/core/contraction/progress.h>
#include <quadrille/internal/core/contraction/recording.h>
#include <quadrille/internal/core/contraction/target_rules.h>
#include <quadrille/internal/core/state/cleanup.h>
#include <quadrille/internal/core/state/component_event.h>
#include <quadrille/internal/core/state/feature_loss.h>
#include <quadrille/internal/core/state/scratch.h>
#include <quadrille/internal/core/state/surface_state.h>
#include <quadrille/internal/core/surface/numbering.h>
#include <quadrille/report.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace quadrille::internal {

/// Counts the edges of the faces that satisfy counts(face), each edge once however many faces it
/// has. In linear time.
template <class Counts>
std::size_t count_edges(const TriangleComplex& complex, VertexLabels& labels, Counts counts) {
  std::size_t edges = 0;
  for (Index v = 0; v < complex.vertex_capacity(); ++v) {
    labels.clear();
    complex.for_each_corner(v, [&](Index face, Index i) {
      if (!counts(face))
        return;
      const StarFace f = star_face_at(complex, face, i);
      for (const Index other : {f.second, f.third})
        edges += v < other && labels.insert(other);
    });
  }
  return edges;
}

/// How many edges these faces have.
inline std::size_t count_edges(const TriangleComplex& complex, std::span<const Index> faces) {
  std::vector<std::array<Index, 2>> edges;
  for (const Index face : faces) {
    const auto [a, b, c] = complex.vertices(face);
    for (const std::array<Index, 2>& edge : {std::array{a, b}, std::array{b, c}, std::array{c, a}})
      edges.push_back({(std::min)(edge[0], edge[1]), (std::max)(edge[0], edge[1])});
  }
  std::sort(edges.begin(), edges.end());
  return static_cast<std::size_t>(std::unique(edges.begin(), edges.end()) - edges.begin());
}

/// How many edges the contraction of a pair takes, of which `b` is the second end: its own; one for
/// each vertex that has an edge to both ends; and both of these where all faces of the vertex at
/// the pair are removed. Does not depend on what else is removed, since of faces that come to lie
/// on each other one is left.
inline std::size_t count_edges_taken(const PairStar& star, Index b, VertexLabels& labels) {
  enum : Index { at_first, at_second, is_counted, kinds };
  labels.clear(kinds);
  for (const StarFace& f : star.first)
    for (const Index v : {f.second, f.third})
      labels.set(v, at_first);
  std::size_t edges = !star.shared.empty();
  for (const StarFace& f : star.second)
    for (const Index v : {f.second, f.third}) {
      if (!labels.is_labelled(v)) {
        labels.set(v, at_second);
      } else if (labels.has_label(v, at_first)) {
        ++edges;
        labels.set(v, is_counted);
      }
    }
  for (const StarFace& f : star.shared) {
    const Index v = f.other_than(b);
    edges += !labels.is_labelled(v) ? 2 : !labels.has_label(v, is_counted);
    labels.set(v, is_counted);
  }
  return edges;
}

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
      faces += complex.reverse_faces().count(face);
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
  /// `histogram` is null if it is not needed.
  CountedCosts(CostHistogram* histogram, const TriangleComplex& complex)
      : histogram_(histogram), complex_(complex) {}

  template <class Event>
  QUADRILLE_ALWAYS_INLINE void before(const Event& event) {
    if (histogram_) [[unlikely]]
      count<Event::is_in_pass>(static_cast<float>(event.contraction.key()),
                               complex_.reverse_faces().count_all(event.contraction.star().shared));
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

  /// Counts the edges of selected faces, which the target counts. `is_selected` is of each input
  /// face, or empty if all are. It returns the largest number if edges need not be counted.
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
  void vanished(const ComponentEvent& event) {
    if (is_asked_)
      scratch_.counters.edges += count_edges(complex_, event.faces);
  }

private:
  QUADRILLE_NOINLINE static void count(const PairStar& star, Index second, Scratch& scratch) {
    scratch.counters.edges += count_edges_taken(star, second, scratch.labels);
  }

  bool is_asked_;
  const TriangleComplex& complex_;
  Scratch& scratch_; // of the thread that removes components
};

/// A run over a surface: its progress, its stop policy, and the recorder of its contractions and
/// rejections. It observes contractions.
template <class Policies>
class Run {
public:
  using Contraction = internal::Contraction<typename Policies::Cost>;

  Run(SurfaceState<Policies>& state, const OptionalDistances<Policies>& distances)
      : scratch_(state.scratch()), recording_({state, distances}),
        costs_(state.policies.optional.costs, state.complex),
        edges_(state.policies.stop.needs().edges, state.complex, scratch_),
        displacement_(state.scale.diagonal(), state.scale.length_from_mesh(state.scale.diagonal())),
        target_rules_(state), progress_(state.policies) {}

  /// Counts the surface, of which the faces that are selected may be changed.
  void start(const SurfaceState<Policies>& state, const std::vector<bool>& is_selected) {
    const TriangleComplex& complex = state.complex;
    const InputIndices& input_faces = state.numbering.faces;
    progress_.start({complex.count_faces(), complex.count_vertices()},
                    count_unselected(complex, input_faces, is_selected),
                    edges_.count(input_faces, is_selected), state.scale.diagonal());
  }

  Progress<Policies>& progress() { return progress_; }
  const Progress<Policies>& progress() const { return progress_; }
  TargetRules<Policies>& target_rules() { return target_rules_; }
  Recording<Policies>* recording() { return recording_.get(); } ///< nullptr if there is no recorder

  /// Counts a rejected pair, or a component, which has no ends, and reports it to a recorder that
  /// asks for rejections.
  void reject(const std::array<Index, 2>& ends, Rejection cause) {
    scratch_.counters.reject(cause);
    if (recording()) [[unlikely]]
      recording()->reject(ends, cause, progress_.status().next_error);
  }
  /// Rejects a pair in a pass, by any thread; recorders receive it when the stage has ended.
  void reject_in_pass(const std::array<Index, 2>& ends, Rejection cause, double error,
                      Scratch& scratch) {
    scratch.counters.reject(cause);
    if (recording()) [[unlikely]]
      recording()->reject_in_pass(ends, cause, error, scratch);
  }
  /// From here on, contractions and rejections of a thread belong to a block of a pass.
  void begin_block(std::size_t number, Scratch& scratch) {
    if (recording())
      recording()->begin_block(number, scratch);
  }
  /// Reports the work of the blocks to the recorder.
  void end_stage() {
    if (recording())
      recording()->end_stage();
  }

  /// How much a contraction of this error would move.
  std::uint64_t displacement_of(const Contraction& contraction, double error) const {
    return displacement_(error, contraction.pair().squared_ring_radius, contraction.cost());
  }

  template <class Event>
  QUADRILLE_ALWAYS_INLINE void before(const Event& event) {
    recording_.before(event);
    costs_.before(event);
    edges_.before(event);
  }
  /// Counts the changes; Progress adds them up.
  template <class Event>
  QUADRILLE_ALWAYS_INLINE void after(const Event& event) {
    recording_.after(event);
    const double error = event.feature_loss.error;
    event.contraction.scratch().counters.count_contraction(
        error, displacement_of(event.contraction, error));
  }
  void vanished(const ComponentEvent& event) {
    recording_.vanished(event);
    edges_.vanished(event);
  }

private:
  Scratch& scratch_; // of the thread that does what is not done in parallel
  OptionalRecording<Policies> recording_;
  CountedCosts costs_;
  CountedEdges edges_;
  Displacement displacement_;
  TargetRules<Policies> target_rules_;
  Progress<Policies> progress_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_CONTRACTION_RUN_H
