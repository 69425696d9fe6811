#ifndef QUADRILLE_INTERNAL_CONTRACTION_FINISHED_SURFACE_H
#define QUADRILLE_INTERNAL_CONTRACTION_FINISHED_SURFACE_H

#include <quadrille/internal/appearance/channel.h>
#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/memory/array.h>
#include <quadrille/internal/surface/numbering.h>
#include <quadrille/internal/surface/scale.h>
#include <quadrille/vector.h>

#include <cstddef>
#include <vector>

namespace quadrille::internal {

/// What has become of a surface, in the engine's numbers and units.
template <class Cost>
struct FinishedSurface {
  Scale<Cost::dimension> scale;
  bool is_closed; ///< it had no border, and has none
  TriangleComplex complex;
  Array<Vector<Cost::dimension>> positions;
  Array<unsigned char> is_moved;
  UninitializedArray<typename Cost::Memory> memories; ///< if they were asked for
  Numbering numbering;
  std::vector<Channel> channels;
  std::vector<std::size_t> back_channels; ///< see BackValues
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CONTRACTION_FINISHED_SURFACE_H
