#ifndef QUADRILLE_INTERNAL_CORE_STATE_SURFACE_STATE_H
#define QUADRILLE_INTERNAL_CORE_STATE_SURFACE_STATE_H

#include <quadrille/internal/core/appearance/appearance.h>
#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/complex/link_condition.h>
#include <quadrille/internal/core/complex/topology_count.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/cost/vertex_importance.h>
#include <quadrille/internal/core/cost/vertex_memories.h>
#include <quadrille/internal/core/input/surface_input.h>
#include <quadrille/internal/core/memory/columns.h>
#include <quadrille/internal/core/pairs/pair_selection.h>
#include <quadrille/internal/core/policy/mesh_units.h>
#include <quadrille/internal/core/state/cleanup.h>
#include <quadrille/internal/core/state/contraction.h>
#include <quadrille/internal/core/state/doubled_faces.h>
#include <quadrille/internal/core/state/input_parts.h>
#include <quadrille/internal/core/state/moved_vertices.h>
#include <quadrille/internal/core/state/parts.h>
#include <quadrille/internal/core/state/scratch.h>
#include <quadrille/internal/core/state/setup.h>
#include <quadrille/internal/core/surface/geometry.h>
#include <quadrille/internal/core/surface/numbering.h>
#include <quadrille/internal/core/surface/scale.h>
#include <quadrille/internal/core/surface/shared_vertices.h>
#include <quadrille/report.h>
#include <quadrille/topology.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// A surface that is being simplified: its faces, and all that is known of its vertices. It changes
/// by contract() only; who evaluates, checks, guards or records contractions reads it.
template <class Policies>
struct SurfaceState {
  using Cost = typename Policies::Cost;
  static constexpr std::size_t dimension = Cost::dimension;
  using Input = InputOf<dimension, Policies::has_channels>;

  /// Takes the input's arrays. `box`: of the surface's units, see box_of_units().
  SurfaceState(Input& input, const Box<dimension>& box, const Policies& policies)
      : policies(policies), scale(scale_of(input, box, policies)),
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
        shared(std::move(input.is_shared), std::move(input.borders), numbering),
        moved(geometry, complex.workspace()), memories(complex.workspace()),
        importance(relative_importances(input.importances)),
        appearance(policies, complex, geometry, memories) {
    if (!is_topology_kept || input.has_duplicate_faces)
      settle_doubled_faces(complex, numbering.faces, input, scratch().tally, policies.threads);
    if (policies.topology == Topology::parts_may_vanish) {
      measure_parts();
      parts.measure_isolation(complex, geometry, scale);
    }
    appearance.read(input, numbering, scale, policies.pairs.includes_edges() && listed.size() == 0);
  }
  SurfaceState(const SurfaceState&) = delete; // its members refer to each other
  SurfaceState& operator=(const SurfaceState&) = delete;

  /// Of the thread that does what is not done in parallel.
  Scratch& scratch() { return scratches.front(); }
  /// Of each face; or empty.
  const Array<Index>& labels() const { return appearance.seams().labels(); }
  const ChannelsOf<Policies>& channels() const { return appearance.channels(); }

  /// Once: what links tell of vertices, or, where topology is free, which parts the input has.
  void classify() {
    if (is_topology_kept)
      link_condition = LinkCondition(
          complex, [this](std::size_t worker) -> VertexLabels& { return scratches[worker].labels; },
          policies.threads);
    else
      input_parts = InputParts(complex, geometry, scale, numbering.vertices);
  }
  /// In linear time, the first time.
  void measure_parts() {
    if (parts.size() == 0)
      parts = Parts<dimension>(complex, geometry, scale, scale.diagonal());
  }
  /// Vertices remember the surface as it is now.
  void remember() {
    const auto is_interior = [this](Index v) { return link_condition.is_interior(v); };
    memories.remember(with_engine_lengths(policies.cost, scale), geometry.positions(), complex,
                      scratch().labels, creases.left(numbering), shared, is_interior,
                      policies.threads);
    memories.remember_input(policies.cost, numbering);
    appearance.remember();
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
    memories.contract(event);
    link_condition.merge(event.kept, event.gone);
    appearance.seams().merge(event.kept, event.gone);
    importance.merge(event.kept, event.gone);
  }

  /// What is left of its topology, and which parts have vanished.
  void tell(Report& report) {
    count_topology(complex, scratch().labels).tell(report);
    report.components_before =
        is_topology_kept ? report.components_after + report.vanished_parts : input_parts.size();
    if (is_topology_kept && report.vanished_parts > 0)
      report.error = (std::max)(report.error, scale.length_of_mesh(distance_of(
                                                  parts.gone(complex, scale), complex, geometry)));
    input_parts.tell(complex, geometry, scale, numbering, report);
  }

  /// The members with columns, to be packed, prefetched and counted: see columns.h.
  static auto columns(auto& self) {
    return std::tie(self.appearance.channels(), self.appearance.seams(), self.numbering, self.moved,
                    self.memories, self.geometry, self.shared, self.link_condition, self.importance,
                    self.parts);
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
  MovedVertices<dimension> moved;
  Parts<dimension> parts; // none before they are measured
  InputParts input_parts; // none where topology is kept
  VertexMemories<Cost> memories;
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
