#ifndef QUADRILLE_INTERNAL_CORE_STATE_SURFACE_STATE_H
#define QUADRILLE_INTERNAL_CORE_STATE_SURFACE_STATE_H

#include <quadrille/internal/core/appearance/appearance.h>
#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/joined_vector.h>
#include <quadrille/internal/core/complex/link_condition.h>
#include <quadrille/internal/core/complex/topology_count.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/cost/vertex_importance.h>
#include <quadrille/internal/core/cost/vertex_states.h>
#include <quadrille/internal/core/input/surface_input.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/memory/vertex_arrays.h>
#include <quadrille/internal/core/pairs/pair_selection.h>
#include <quadrille/internal/core/policy/mesh_units.h>
#include <quadrille/internal/core/policy/pair_source.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/state/cleanup.h>
#include <quadrille/internal/core/state/components.h>
#include <quadrille/internal/core/state/contraction.h>
#include <quadrille/internal/core/state/doubled_faces.h>
#include <quadrille/internal/core/state/input_components.h>
#include <quadrille/internal/core/state/scratch.h>
#include <quadrille/internal/core/surface/box.h>
#include <quadrille/internal/core/surface/geometry.h>
#include <quadrille/internal/core/surface/kept_outlines.h>
#include <quadrille/internal/core/surface/kept_planes.h>
#include <quadrille/internal/core/surface/numbering.h>
#include <quadrille/internal/core/surface/scale.h>
#include <quadrille/internal/core/surface/shared_vertices.h>
#include <quadrille/pairs.h>
#include <quadrille/quadric_form.h>
#include <quadrille/report.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Edges that the user has named as creases, by the input indices of their ends.
class NamedCreases {
public:
  using Edge = std::array<Index, 2>;

  explicit NamedCreases(std::vector<Edge> edges) : edges_(std::move(edges)) {}

  /// Replaces their ends by the vertices into which they were merged.
  void follow(const Numbering& numbering) {
    for (auto& [v, w] : edges_)
      v = numbering.merged_vertex(v), w = numbering.merged_vertex(w);
    std::erase_if(edges_, [](const Edge& edge) { return edge[0] == edge[1]; });
  }

  /// By the engine's numbers; without those that have lost their faces.
  std::vector<Edge> left(const Numbering& numbering) const {
    std::vector<Edge> left;
    if (edges_.empty())
      return left;
    const InputIndices numbers = numbering.vertices.inverse();
    for (const auto& [v, w] : edges_)
      if (const Index p = numbers[v], q = numbers[w]; p != none && q != none)
        left.push_back({p, q});
    return left;
  }

private:
  std::vector<Edge> edges_;
};

/// The units of a surface in a box, with the weights that the cost gives its attributes. Floats are
/// written where something is promised that their rounding could break.
template <class Policies, std::size_t N>
Scale<N> scale_of(const SurfaceInput<N>& input, const Box<N>& box, const Policies& policies) {
  using Cost = typename Policies::Cost;
  const Cost& cost = policies.cost;
  Scale<N> scale(box, is_scale_free<Cost>);
  if (input.writes_floats && (needs_closed_surface<typename Policies::Placement> ||
                              !policies.guards.empty() || policies.stop.needs().distance))
    scale.write_floats();
  if constexpr (requires {
                  cost.attribute_weights(attributes_of(box.low), attributes_of(box.high), 1.0);
                })
    scale.set_attribute_weights(
        cost.attribute_weights(attributes_of(box.low), attributes_of(box.high), box.diagonal()),
        box);
  return scale;
}

/// The triangles of an input. A pair policy of the user's wants to see them once more.
template <std::size_t N>
Array<TriangleComplex::Triangle> take_triangles(const PairSource& pairs, SurfaceInput<N>& input) {
  if (pairs.selects())
    return input.triangles;
  return std::move(input.triangles);
}

/// Is topology kept? Unless the user says, it is free if there are pairs that are not edges.
inline bool keeps_topology(std::optional<Topology> topology, bool has_other_pairs) {
  return topology.value_or(has_other_pairs ? Topology::free : Topology::kept) != Topology::free;
}

/// One for each thread.
inline std::vector<Scratch> scratches_for(unsigned threads, const TriangleComplex& complex) {
  std::vector<Scratch> scratches;
  scratches.reserve(threads);
  for (unsigned i = 0; i < threads; ++i)
    scratches.emplace_back(complex.vertex_capacity(), complex.arena()).number = i;
  return scratches;
}

/// Which vertices no longer lie where they were in the input.
template <std::size_t N>
class MovedVertices {
public:
  /// `moved`: before the first contraction.
  MovedVertices(const Geometry<N>& geometry, const std::vector<Index>& moved, Arena* arena)
      : geometry_(geometry), is_moved_(geometry.positions().size(), 0, arena) {
    for (Index v : moved)
      is_moved_[v] = 1;
  }

  static auto vertex_arrays(auto& self) { return std::tie(self.is_moved_); }

  /// Before the vertex takes its place.
  template <class Event>
  void contract(const Event& event) {
    is_moved_[event.kept] |= event.contraction.target() != geometry_.position(event.kept);
  }

  /// All of it, which is no longer here then.
  Array<unsigned char> take() { return std::move(is_moved_); }

private:
  const Geometry<N>& geometry_;
  Array<unsigned char> is_moved_; // no bits: threads write to it
};

/// A surface that is being simplified: its faces, and all that is known of its vertices. It changes
/// by contract() only; who evaluates, checks, guards or records contractions reads it.
template <class Policies>
struct SurfaceState {
  using Cost = typename Policies::Cost;
  static constexpr std::size_t dimension = Cost::dimension;
  using Input = InputOf<dimension, Policies::has_channels>;

  /// Takes the input's arrays. `box`: of the surface's units, see box_of_units().
  SurfaceState(Input& input, const Box<dimension>& box, const Policies& given)
      : policies(given), scale(scale_of(input, box, given)),
        complex(input.positions.size(), take_triangles(policies.pairs, input),
                !policies.order.passes, policies.threads),
        scratches(scratches_for(policies.threads, complex)),
        listed(select_pairs(policies.pairs, input, complex, scratch().labels)),
        is_topology_kept(keeps_topology(policies.topology, listed.size() > 0)),
        creases(std::move(input.creases)),
        numbering({input.positions.size(), std::move(input.input_vertices)},
                  {complex.face_capacity(), std::move(input.input_faces)},
                  policies.order.passes.has_value()),
        geometry(complex, scale.scaled(std::move(input.positions)), std::move(input.is_fixed),
                 policies.threads),
        shared(std::move(input.is_shared), std::move(input.boundaries), numbering),
        planes(input.planes, scale, complex.arena()),
        outlines(input.planes, geometry.positions(), scale, complex.arena()),
        moved(geometry, input.moved, complex.arena()), states(complex.arena()),
        importance(relative_importances(input.importances)),
        appearance(policies, complex, geometry, states) {
    if (!is_topology_kept || input.has_duplicate_faces)
      resolve_doubled_faces(complex, numbering.faces, input, scratch().counters, policies.threads);
    if (policies.topology == Topology::components_may_vanish) {
      measure_components();
      components.measure_isolation(complex, geometry, scale);
    }
    appearance.read(input, numbering, scale, policies.pairs.includes_edges() && listed.size() == 0);
  }
  SurfaceState(const SurfaceState&) = delete; // its members refer to each other
  SurfaceState& operator=(const SurfaceState&) = delete;

  /// Returns the scratch space of the thread that does all sequential work.
  Scratch& scratch() { return scratches.front(); }
  /// The label of each face; may be empty.
  const Array<Index>& labels() const { return appearance.seams().labels(); }
  const ChannelsOf<Policies>& channels() const { return appearance.channels(); }

  /// Classifies vertices by their links or, with free topology, finds the components of the input.
  /// It is called once.
  void classify() {
    if (is_topology_kept)
      link_condition = LinkCondition(
          complex, [this](std::size_t worker) -> VertexLabels& { return scratches[worker].labels; },
          policies.threads);
    else
      input_components = InputComponents(complex, geometry, scale, numbering.vertices);
  }
  /// In linear time, the first time.
  void measure_components() {
    if (components.size() == 0)
      components = Components<dimension>(complex, geometry, scale, scale.diagonal());
  }
  /// Accumulates the current surface in the states of vertices.
  void accumulate() {
    const auto is_interior = [this](Index v) { return link_condition.is_interior(v); };
    states.accumulate(with_engine_lengths(policies.cost, scale), geometry.positions(), complex,
                      scratch().labels, creases.left(numbering), shared, is_interior,
                      policies.threads);
    states.accumulate_input(policies.cost, numbering);
    appearance.accumulate(link_condition);
  }

  /// Does a contraction. Attributes meet while faces still have their old corners.
  template <class Event>
  QUADRILLE_ALWAYS_INLINE void contract(const Event& event) {
    appearance.channels().contract(event);
    change_faces(event);
    listed.merge(event.kept, event.gone);
    numbering.merge(event.kept, event.gone);
    moved.contract(event); // looks at the old place
    geometry.contract(event);
    states.contract(event);
    link_condition.merge(event.kept, event.gone);
    appearance.seams().merge(event.kept, event.gone);
    planes.merge(event.kept, event.gone);
    outlines.contract(event);
    importance.merge(event.kept, event.gone);
  }

  /// Reports the remaining topology and the components that have vanished.
  void write_to(Report& report) {
    count_topology(complex, scratch().labels).write_to(report);
    report.components_before = is_topology_kept
                                   ? report.components_after + report.vanished_components
                                   : input_components.size();
    if (is_topology_kept && report.vanished_components > 0)
      report.error = (std::max)(
          report.error,
          scale.length_of_mesh(distance_of(components.gone(complex, scale), complex, geometry)));
    input_components.write_to(complex, geometry, scale, numbering, report);
  }

  /// The members with vertex arrays, to be packed, prefetched and counted: see vertex_arrays.h.
  static auto array_owners(auto& self) {
    return std::tie(self.appearance.channels(), self.appearance.seams(), self.numbering, self.moved,
                    self.states, self.geometry, self.shared, self.planes, self.outlines,
                    self.link_condition, self.importance, self.components);
  }

  const Policies& policies;
  Scale<dimension> scale;
  TriangleComplex complex;
  std::vector<Scratch> scratches; // one for each thread
  PairLists listed;               // pairs that are no edges
  bool is_topology_kept;
  LinkCondition link_condition;
  NamedCreases creases;
  Numbering numbering;
  Geometry<dimension> geometry;
  SharedVertices shared;
  KeptPlanes planes;     // mostly none
  KeptOutlines outlines; // of their regions
  MovedVertices<dimension> moved;
  Components<dimension> components; // none before they are measured
  InputComponents input_components; // none where topology is kept
  VertexStates<Cost> states;
  VertexImportance importance;
  Appearance<Policies> appearance;

private:
  template <class Event>
  QUADRILLE_ALWAYS_INLINE void change_faces(const Event& event) {
    Cleanup cleanup(complex, event.contraction.scratch(), labels());
    if constexpr (Event::is_in_pass) {
      complex.relabel(event.kept, event.gone);
      cleanup.remove_shared_faces();
    } else {
      complex.reserve_for_merge(event.kept, event.gone);
      cleanup.remove_shared_faces();
      complex.merge(event.kept, event.gone);
    }
    if (is_topology_kept)
      return;
    cleanup.remove_duplicate_faces();
    cleanup.remove_isolated_vertices(event.contraction.second());
  }
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_STATE_SURFACE_STATE_H
