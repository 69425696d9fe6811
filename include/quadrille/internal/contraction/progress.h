#ifndef QUADRILLE_INTERNAL_CONTRACTION_PROGRESS_H
#define QUADRILLE_INTERNAL_CONTRACTION_PROGRESS_H

#include <quadrille/internal/contraction/scratch.h>
#include <quadrille/report.h>

#include <algorithm>
#include <cstddef>

namespace quadrille::internal {

/// How far a simplification has come, for stop policies and for the report.
struct Progress {
  Status status;
  Tally total;

  void start(std::size_t faces, std::size_t vertices, double diagonal) {
    status.faces = status.initial_faces = faces;
    status.vertices = status.initial_vertices = vertices;
    status.diagonal = diagonal;
  }

  /// Adds what contractions have changed, and forgets it.
  void count(Tally& tally) {
    status.faces -= tally.faces;
    status.vertices -= tally.vertices;
    status.contractions += tally.contractions;
    total.non_edge_contractions += tally.non_edge_contractions;
    total.error = std::max(total.error, tally.error);
    for (std::size_t cause = 0; cause < rejection_causes; ++cause)
      total.rejections[cause] += tally.rejections[cause];
    tally = {};
  }

  void tell(Report& report) const {
    report.faces_after = status.faces;
    report.vertices_after = status.vertices;
    report.contractions = status.contractions;
    report.non_edge_contractions = total.non_edge_contractions;
    report.rejections = total.rejections;
    report.error = total.error;
  }
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CONTRACTION_PROGRESS_H
