#ifndef QUADRILLE_INTERNAL_CORE_CONTRACTION_FINISHED_SURFACE_H
#define QUADRILLE_INTERNAL_CORE_CONTRACTION_FINISHED_SURFACE_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/surface/numbering.h>
#include <quadrille/internal/core/surface/scale.h>
#include <quadrille/quadric_form.h>

namespace quadrille::internal {

/// The final surface, in the engine's numbers and units.
template <class Cost, class ChannelsLeft>
struct FinishedSurface {
  Scale<Cost::dimension> scale;
  bool is_closed; ///< it had no boundary, and has none
  TriangleComplex complex;
  Array<Vector<Cost::dimension>> positions;
  Array<unsigned char> is_moved;
  UninitializedArray<typename Cost::State> states; ///< if they were asked for
  Numbering numbering;
  QUADRILLE_NO_UNIQUE_ADDRESS ChannelsLeft channels;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_CONTRACTION_FINISHED_SURFACE_H
