#ifndef QUADRILLE_INTERNAL_CORE_RECORDING_CORNERS_BY_INPUT_FACE_H
#define QUADRILLE_INTERNAL_CORE_RECORDING_CORNERS_BY_INPUT_FACE_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/surface/numbering.h>

#include <array>
#include <cstddef>
#include <vector>

namespace quadrille::internal {

/// Returns the value of at(face, corner, is_reverse) for each corner of each input face; a reverse
/// face is described by its forward face and the corner of that. `none` for faces that do not
/// exist.
template <class At>
std::vector<std::array<Index, 3>> corners_by_input_face(const TriangleComplex& complex,
                                                        const InputIndices& faces, At at) {
  std::vector<std::array<Index, 3>> corners(faces.input_count(), {none, none, none});
  const ReverseFaces& reverse_faces = complex.reverse_faces();
  for (Index face = 0; face < complex.face_capacity(); ++face) {
    if (complex.is_removed(face))
      continue;
    for (std::size_t i = 0; i < 3; ++i) {
      corners[faces[face]][i] = at(face, i, false);
      if (reverse_faces.has(face))
        corners[reverse_faces.input_face(face)][i] =
            at(face, reverse_faces.opposite(face, i), true);
    }
  }
  return corners;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_RECORDING_CORNERS_BY_INPUT_FACE_H
