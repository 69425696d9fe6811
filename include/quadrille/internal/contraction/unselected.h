#ifndef QUADRILLE_INTERNAL_CONTRACTION_UNSELECTED_H
#define QUADRILLE_INTERNAL_CONTRACTION_UNSELECTED_H

#include <quadrille/internal/complex/triangle_complex.h>
#include <quadrille/internal/contraction/cleanup.h>
#include <quadrille/internal/surface/numbering.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace quadrille::internal {

/// How many faces of a surface may not be changed, since they are not selected, and how many
/// vertices have no others: what the target does not count. `is_selected` is of each input face;
/// empty if all are. In linear time.
inline Loss count_unselected(const TriangleComplex& complex, const InputIndices& input_faces,
                             const std::vector<bool>& is_selected) {
  if (is_selected.empty())
    return {0, 0};
  std::size_t faces = 0;
  std::vector<bool> has_selected(complex.vertex_capacity());
  for (Index face = 0; face < complex.face_capacity(); ++face) {
    if (complex.is_removed(face))
      continue;
    if (!is_selected[input_faces[face]])
      faces += complex.backs().count(face);
    else
      for (Index v : complex.vertices(face))
        has_selected[v] = true;
  }
  const auto selected = std::count(has_selected.begin(), has_selected.end(), true);
  return {faces, complex.count_vertices() - static_cast<std::size_t>(selected)};
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CONTRACTION_UNSELECTED_H
