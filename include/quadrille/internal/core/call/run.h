#ifndef QUADRILLE_INTERNAL_CORE_CALL_RUN_H
#define QUADRILLE_INTERNAL_CORE_CALL_RUN_H

#include <quadrille/internal/core/base/threads.h>
#include <quadrille/internal/core/call/engine.h>
#include <quadrille/internal/core/memory/vertex_arrays.h>
#include <quadrille/internal/core/policy/orders.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/report.h>

#include <cstddef>
#include <utility>

namespace quadrille::internal {

/// Returns the memory needs of a surface of that many vertices and faces, most of which will be
/// removed.
template <class Policies>
MemoryNeeds memory_needs(const Policies& policies, bool has_labels, std::size_t vertices,
                         std::size_t faces) {
  using Surface = WorkingSurface<Policies>;
  using ArrayOwners = decltype(Surface::array_owners(std::declval<Surface&>()));
  const bool has_queue = !policies.order.passes;
  const std::size_t arrays =
      RowsOf<ArrayOwners>::bytes +
      (has_labels ? bytes_a_vertex<typename Appearance<Policies>::Seams> : 0);
  // In addition to these: its list of corners, its label, the vertex it was merged into; with a
  // queue, the version of its pairs, and its rejected pairs.
  const std::size_t a_vertex = arrays + (has_queue ? 6 : 4) * sizeof(Index);
  // Its corners, and room for another one or its input index; its label, as read and in order.
  const std::size_t a_face =
      sizeof(TriangleComplex::Triangle) + (has_labels ? 6 : 4) * sizeof(Index);
  constexpr std::size_t passes = std::size_t{1} << 18; // proposals
  const std::size_t queue =
      PairQueue::bytes_for(PairQueue::expected_pairs(3 * faces / 2, vertices));
  const std::size_t least = vertices * a_vertex + faces * a_face + (has_queue ? queue : passes);
  constexpr std::size_t few = std::size_t{1} << 23; // whatever the size of the surface
  return {least, 2 * least + few};
}

/// Asks the visitor for the first time.
template <class Policies>
bool proceeds_at_beginning(const Policies& policies, const Report& report) {
  Status status;
  status.faces = status.initial_faces = report.faces_before;
  status.vertices = status.initial_vertices = report.vertices_before;
  return !policies.visitor || policies.visitor(status);
}

/// Returns the report for a surface that is unchanged because the visitor has cancelled.
inline Report untouched(Report report) {
  report.counted_faces = report.faces_after = report.faces_before;
  report.vertices_after = report.vertices_before;
  report.stop = StopReason::cancelled;
  return report;
}

/// Data flows one way: adapter, working surface, loop, result, adapter. `read` returns the input of
/// the adapter; it calls `reporter` as described for Reporter.
template <class Adapter, class Policies, class Read, class AnyReporter>
Report run_here(Adapter& adapter, const Policies& policies, Read read, AnyReporter reporter) {
  StopWatch watch;
  Report report;
  auto input = read(adapter);
  report.faces_before = input.triangles.size();
  report.vertices_before = input.positions.size();
  report.seconds.read = watch.lap();
  if (!proceeds_at_beginning(policies, report))
    return untouched(report);

  const auto result =
      simplify_input(std::move(input), policies, AnyReporter::asks_for_states, report, watch);
  if (!result)
    return untouched(report);
  report.duplicated_vertices = adapter.write(*result, reporter);
  report.vertices_after += report.duplicated_vertices;
  report.seconds.write = watch.lap();
  return report;
}

/// Runs a call with the threads that the order asks for.
template <class Adapter, class Policies, class Read, class AnyReporter>
Report run(Adapter& adapter, const Policies& policies, Read read, AnyReporter reporter) {
  Report report;
  with_threads(policies.threads, [&] { report = run_here(adapter, policies, read, reporter); });
  return report;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_CALL_RUN_H
