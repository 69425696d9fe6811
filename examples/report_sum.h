#ifndef QUADRILLE_EXAMPLES_REPORT_SUM_H
#define QUADRILLE_EXAMPLES_REPORT_SUM_H

#include <quadrille/report.h>

#include <algorithm>
#include <cstddef>

namespace quadrille_examples {

/// The report of no surface, to which others are added.
inline quadrille::Report report_of_none() {
  quadrille::Report report;
  report.stop = quadrille::StopReason::target_met;
  report.distance_bound = 0;
  return report;
}

/// Adds the report of another surface: counts and times are sums, errors those of the worse one.
inline void add_report(quadrille::Report& sum, const quadrille::Report& report) {
  using quadrille::Report;
  for (const auto count :
       {&Report::faces_before, &Report::faces_after, &Report::vertices_before,
        &Report::vertices_after, &Report::contractions, &Report::non_edge_contractions,
        &Report::components_before, &Report::components_after, &Report::vanished_parts,
        &Report::non_manifold_edges, &Report::non_manifold_vertices, &Report::duplicated_vertices,
        &Report::counted_faces, &Report::doubled_faces, &Report::doubled_labels})
    sum.*count += report.*count;
  for (std::size_t cause = 0; cause < quadrille::rejection_causes; ++cause)
    sum.rejections[cause] += report.rejections[cause];
  sum.error = std::max(sum.error, report.error);
  sum.distance_bound = std::max(sum.distance_bound, report.distance_bound);
  sum.seconds.read += report.seconds.read;
  sum.seconds.prepare += report.seconds.prepare;
  sum.seconds.contract += report.seconds.contract;
  sum.seconds.write += report.seconds.write;
  if (!quadrille::is_target_reached(report.stop) || sum.stop == quadrille::StopReason::target_met)
    sum.stop = report.stop;
}

} // namespace quadrille_examples

#endif
