#ifndef QUADRILLE_EXAMPLES_PROGRAM_MEASURE_H
#define QUADRILLE_EXAMPLES_PROGRAM_MEASURE_H

/// \file
/// How far a result is from the input, by measures that share nothing with the engine: --measure.

#include <quadrille/texture_deviation.h>

#include <optional>
#include <vector>

namespace quadrille_examples {

struct IndexedMesh;

/// Distances are in the units of the mesh.
struct Measurement {
  double area = 0;                     ///< of the result
  double rms = 0;                      ///< root mean square of both directions
  double greatest = 0;                 ///< sampled, so a lower bound of the Hausdorff distance
  double to_input = 0, from_input = 0; ///< the greatest of each direction
  std::optional<quadrille::TextureDeviation> texture; ///< where both have texture coordinates
};

/// Nothing where one of the two has no face.
std::optional<Measurement> measure(const IndexedMesh& input, const IndexedMesh& result);

/// Of a result.
struct TextureMeasurement {
  double area;
  quadrille::TextureDeviation deviation;
};

/// Nothing where one of the two has no face with a texture.
std::optional<TextureMeasurement> measure_texture(const IndexedMesh& input,
                                                  const IndexedMesh& result);

/// That of several surfaces, each of which is measured by itself: means by area. Nothing if there
/// are none.
std::optional<quadrille::TextureDeviation> united(const std::vector<TextureMeasurement>& surfaces);

} // namespace quadrille_examples

#endif
