#ifndef QUADRILLE_INTERNAL_GUARDS_INTERSECTION_TREE_ORDER_H
#define QUADRILLE_INTERNAL_GUARDS_INTERSECTION_TREE_ORDER_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/surface/box_tree.h>

#include <array>
#include <cstddef>
#include <vector>

namespace quadrille::internal {

/// The faces of a surface in the order in which a tree of their boxes has them: box_of(face).
template <class BoxOf>
std::vector<Index> faces_in_tree_order(const TriangleComplex& complex, BoxOf box_of) {
  struct Centre {
    Index face;
    std::array<float, 3> point;
    bool operator<(const Centre& other) const { return face < other.face; }
  };
  std::vector<Centre> centres;
  for (Index face = 0; face < complex.face_capacity(); ++face) {
    if (complex.is_removed(face))
      continue;
    const FloatBox box = box_of(face);
    Centre centre{face, {}};
    for (std::size_t i = 0; i < 3; ++i)
      centre.point[i] = box.low[i] + box.high[i];
    centres.push_back(centre);
  }
  sort_for_box_tree(centres.data(), centres.data() + centres.size(),
                    [](const Centre& centre) { return centre.point; });
  std::vector<Index> faces;
  faces.reserve(centres.size());
  for (const Centre& centre : centres)
    faces.push_back(centre.face);
  return faces;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_GUARDS_INTERSECTION_TREE_ORDER_H
