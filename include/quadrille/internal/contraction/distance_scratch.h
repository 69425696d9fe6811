#ifndef QUADRILLE_INTERNAL_CONTRACTION_DISTANCE_SCRATCH_H
#define QUADRILLE_INTERNAL_CONTRACTION_DISTANCE_SCRATCH_H

#include <quadrille/internal/distance/back_deviation.h>
#include <quadrille/internal/distance/recent_faces.h>
#include <quadrille/internal/distance/star_deviation.h>
#include <quadrille/internal/distance/tolerances.h>

#include <vector>

namespace quadrille::internal {

/// What a check of distances works with, of each thread.
struct DistanceScratch {
  StarDeviation deviation;
  BackDeviation back;
  RecentFaces faces_too_far;
  StarTolerance tolerance;   // of the star
  std::vector<float> bounds; // of the faces that the contraction changes, see DistanceBounds
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CONTRACTION_DISTANCE_SCRATCH_H
