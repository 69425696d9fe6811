// SPDX-License-Identifier: MIT
//
// What is measured of a contender's answer.

#ifndef QUADRILLE_BENCHMARK_MEASURE_H
#define QUADRILLE_BENCHMARK_MEASURE_H

#include "contender.h"

#include <quadrille/distance.h>

namespace bench {

struct Quality {
  std::size_t faces;
  quadrille::SurfaceDistance distance; ///< a is the input, b the answer; in the input's diagonal
  std::size_t flipped_faces;           ///< see flipped_faces()
  std::size_t non_manifold_edges;      ///< edges of three faces or more
  std::size_t highest_degree;          ///< the most edges at one vertex
  double smallest_angle;               ///< of a face, in degrees
  double low_angle;                    ///< below which the smallest angle of 1 % of the faces is
};

Quality measure(const Soup& input, const Soup& answer, std::size_t samples);

} // namespace bench

#endif
