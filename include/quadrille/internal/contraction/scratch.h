#ifndef QUADRILLE_INTERNAL_CONTRACTION_SCRATCH_H
#define QUADRILLE_INTERNAL_CONTRACTION_SCRATCH_H

#include <quadrille/internal/complex/star.h>
#include <quadrille/internal/contraction/part_event.h>
#include <quadrille/internal/contraction/record_buffer.h>
#include <quadrille/internal/contraction/refusals.h>
#include <quadrille/internal/distance/recent_faces.h>
#include <quadrille/internal/distance/star_deviation.h>
#include <quadrille/internal/pairs/pair_tools.h>
#include <quadrille/report.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace quadrille::internal {

/// What contractions have done since they were last counted.
struct Tally {
  std::size_t faces = 0, vertices = 0; // that are gone
  std::size_t contractions = 0, non_edge_contractions = 0;
  std::size_t doubled_faces = 0, doubled_labels = 0, vanished_parts = 0; // see Report
  std::array<std::size_t, rejection_causes> rejections{};
  double error = 0; // the greatest

  void count_contraction(double its_error) {
    ++contractions;
    ++vertices;
    error = (std::max)(error, its_error);
  }
  void count_part(const PartEvent& part, std::size_t its_faces) {
    faces += its_faces;
    vertices += part.vertices.size();
    ++vanished_parts;
    error = (std::max)(error, part.radius);
  }
  void reject(Rejection cause) { ++rejections[static_cast<std::size_t>(cause)]; }
};

/// Memory that contractions share, one after the other. Threads that work on parts of a surface
/// with no vertex in common have one each.
struct Scratch : PairTools {
  using PairTools::PairTools;

  PairStar star; // of the contraction at hand
  std::vector<StarFace> faces;
  StarDeviation deviation;
  RecentFaces faces_too_far;
  std::vector<float> bounds; // of the faces that the contraction changes, see DistanceBounds
  Tally tally;
  std::vector<Index> duplicates; // faces that the contraction at hand has removed as such
  RecordBuffer recorded;
  Refusals refusals; // where a recorder wants to know
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CONTRACTION_SCRATCH_H
