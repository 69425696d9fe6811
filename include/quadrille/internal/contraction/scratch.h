#ifndef QUADRILLE_INTERNAL_CONTRACTION_SCRATCH_H
#define QUADRILLE_INTERNAL_CONTRACTION_SCRATCH_H

#include <quadrille/internal/complex/star.h>
#include <quadrille/internal/complex/vertex_labels.h>
#include <quadrille/internal/distance/recent_faces.h>
#include <quadrille/internal/distance/star_deviation.h>
#include <quadrille/internal/memory/append_buffer.h>
#include <quadrille/report.h>

#include <array>
#include <cstddef>
#include <vector>

namespace quadrille::internal {

/// What contractions have done since they were last counted.
struct Tally {
  std::size_t faces = 0, vertices = 0; // that are gone
  std::size_t contractions = 0, non_edge_contractions = 0;
  std::array<std::size_t, rejection_causes> rejections{};
  double error = 0; // the greatest
};

struct VertexPair {
  Index first, second;
};

/// What the steps of a contraction need beside the surface. Threads that work on parts of a surface
/// with no vertex in common have one each.
struct Scratch {
  explicit Scratch(std::size_t vertices, Workspace* workspace = nullptr)
      : marks(vertices, workspace) {}

  Marks marks;
  PairStar star; // of the pair that was gathered last
  std::vector<StarFace> faces;
  StarDeviation deviation;
  RecentFaces faces_too_far;
  std::vector<float> bounds; // of the faces that the contraction changes, see DistanceBounds
  Room<VertexPair> pairs;
  Room<float> costs; // of these
  Tally tally;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CONTRACTION_SCRATCH_H
