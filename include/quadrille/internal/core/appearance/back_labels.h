#ifndef QUADRILLE_INTERNAL_CORE_APPEARANCE_BACK_LABELS_H
#define QUADRILLE_INTERNAL_CORE_APPEARANCE_BACK_LABELS_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/surface/numbering.h>

#include <map>
#include <utility>

namespace quadrille::internal {

/// The labels of faces of which some have a back, told as labels of the fronts: one for both sides.
/// Where it changes, or where backs begin, there is a border. `labels`: of each input face; or
/// empty.
inline void join_labels_of_backs(const TriangleComplex& complex, const InputIndices& faces,
                                 Array<Index>& labels) {
  const Backs& backs = complex.backs();
  bool is_partial = false; // have some faces a back, and some none?
  for_each_face(complex, [&](Index face) { is_partial |= !backs.has(face); });
  if (labels.empty() && !is_partial)
    return;
  std::map<std::pair<Index, Index>, Index> numbers;
  const auto label = [&](Index face) { return labels.empty() ? Index{0} : labels[face]; };
  Array<Index> joined(faces.input_count(), Index{0}, complex.workspace());
  for_each_face(complex, [&](Index face) {
    const Index front = faces[face];
    const Index back = backs.has(face) ? label(backs.input_face(face)) : none;
    joined[front] =
        numbers.try_emplace({label(front), back}, static_cast<Index>(numbers.size())).first->second;
  });
  labels = std::move(joined);
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_APPEARANCE_BACK_LABELS_H
