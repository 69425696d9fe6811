// SPDX-License-Identifier: MIT
//
// What is measured of an answer with attributes.

#ifndef QUADRILLE_BENCHMARK_ATTRIBUTES_MEASURE_H
#define QUADRILLE_BENCHMARK_ATTRIBUTES_MEASURE_H

#include "model.h"

#include <quadrille/distance.h>
#include <quadrille/texture_deviation.h>

namespace bench {

/// The difference between the colours of two surfaces at their nearest points, in the mean over
/// components.
struct ColorDifference {
  double rms = 0; ///< of both directions
  double in_to_out = 0, out_to_in = 0;
};

struct AttributeQuality {
  std::size_t faces;
  std::size_t open_edges;              ///< of other than two faces; points at one place are one
  quadrille::SurfaceDistance distance; ///< a is the input, b the answer; in the input's diagonal
  quadrille::TextureDeviation texture; ///< in the input's diagonal
  ColorDifference color;
};

AttributeQuality measure(const Model& input, const Soup& answer, std::size_t samples);

/// The less, the better: by which the factor of a contender is chosen.
double score(const AttributeQuality& quality, Kind kind);

/// Edges of other than two faces, if points at the same place are one.
std::size_t open_edges(const Soup& soup);

} // namespace bench

#endif
