#ifndef QUADRILLE_INTERNAL_CORE_APPEARANCE_LABELS_BY_FACE_H
#define QUADRILLE_INTERNAL_CORE_APPEARANCE_LABELS_BY_FACE_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/surface/numbering.h>

namespace quadrille::internal {

/// The label of each face, in the order of the complex.
inline Array<Index> labels_by_face(const Array<Index>& by_input, const InputIndices& faces,
                                   const TriangleComplex& complex) {
  if (by_input.empty())
    return Array<Index>(complex.arena());
  Array<Index> labels(complex.face_capacity(), complex.arena());
  for (Index face = 0; face < labels.size(); ++face)
    labels[face] = by_input[faces[face]];
  return labels;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_APPEARANCE_LABELS_BY_FACE_H
