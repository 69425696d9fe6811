#ifndef QUADRILLE_INTERNAL_CORE_STATE_INPUT_PARTS_H
#define QUADRILLE_INTERNAL_CORE_STATE_INPUT_PARTS_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/state/distance_to_rest.h>
#include <quadrille/internal/core/state/parts.h>
#include <quadrille/internal/core/surface/geometry.h>
#include <quadrille/internal/core/surface/numbering.h>
#include <quadrille/internal/core/surface/scale.h>
#include <quadrille/report.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace quadrille::internal {

/// The components of a surface with free topology, as they were in the input: none is removed on
/// purpose, but each may vanish as faces that come to lie on each other are removed.
class InputParts {
public:
  InputParts() = default;
  /// In linear time, before anything is contracted.
  template <std::size_t N>
  InputParts(const TriangleComplex& complex, const Geometry<N>& geometry, const Scale<N>& scale,
             const InputIndices& vertices)
      : part_(complex.workspace()) {
    const Parts<N> parts(complex, geometry, scale, scale.diagonal());
    for (Index part = 0; part < parts.size(); ++part) {
      sizes_.push_back(parts[part].size);
      traces_.push_back(trace_of(parts[part], scale));
    }
    if (sizes_.size() < 2)
      return;
    part_.resize(vertices.input_count(), none);
    for (Index v = 0; v < complex.vertex_capacity(); ++v)
      part_[vertices[v]] = parts.of(v);
  }

  std::size_t size() const { return sizes_.size(); }

  /// Reports the components of which no vertex is left or was merged into one that is. Merges are
  /// reported by input indices from then on.
  template <std::size_t N>
  void tell(const TriangleComplex& complex, const Geometry<N>& geometry, const Scale<N>& scale,
            Numbering& numbering, Report& report) const {
    if (part_.empty())
      return;
    numbering.use_input_indices();
    const std::vector<bool> is_left = left_parts(complex, numbering);
    std::vector<Trace> gone;
    for (std::size_t part = 0; part < is_left.size(); ++part) {
      if (is_left[part])
        continue;
      ++report.vanished_parts;
      report.largest_vanished_part = (std::max)(report.largest_vanished_part, sizes_[part]);
      gone.push_back(traces_[part]);
    }
    report.error =
        (std::max)(report.error, scale.length_of_mesh(distance_of(gone, complex, geometry)));
  }

private:
  std::vector<bool> left_parts(const TriangleComplex& complex, const Numbering& numbering) const {
    std::vector<bool> has_faces(part_.size()), is_left(sizes_.size());
    for (Index v = 0; v < complex.vertex_capacity(); ++v)
      if (complex.has_faces(v))
        has_faces[numbering.vertices[v]] = true;
    for (Index input = 0; input < part_.size(); ++input)
      if (part_[input] != none && has_faces[numbering.image(input)])
        is_left[part_[input]] = true;
    return is_left;
  }

  std::vector<double> sizes_; // of each part: see Part
  std::vector<Trace> traces_;
  Array<Index> part_; // of each input vertex; empty if there is only one
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_STATE_INPUT_PARTS_H
