#ifndef QUADRILLE_INTERNAL_CORE_STATE_INPUT_COMPONENTS_H
#define QUADRILLE_INTERNAL_CORE_STATE_INPUT_COMPONENTS_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/state/components.h>
#include <quadrille/internal/core/state/distance_to_rest.h>
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
class InputComponents {
public:
  InputComponents() = default;
  /// In linear time, before anything is contracted.
  template <std::size_t N>
  InputComponents(const TriangleComplex& complex, const Geometry<N>& geometry,
                  const Scale<N>& scale, const InputIndices& vertices)
      : component_(complex.arena()) {
    const Components<N> components(complex, geometry, scale, scale.diagonal());
    for (Index component = 0; component < components.size(); ++component) {
      sizes_.push_back(components[component].size);
      traces_.push_back(trace_of(components[component], scale));
    }
    if (sizes_.size() < 2)
      return;
    component_.resize(vertices.input_count(), none);
    for (Index v = 0; v < complex.vertex_capacity(); ++v)
      component_[vertices[v]] = components.of(v);
  }

  std::size_t size() const { return sizes_.size(); }

  /// Reports the components of which no vertex is left or was merged into one that is. Merges are
  /// reported by input indices from then on.
  template <std::size_t N>
  void write_to(const TriangleComplex& complex, const Geometry<N>& geometry, const Scale<N>& scale,
                Numbering& numbering, Report& report) const {
    if (component_.empty())
      return;
    numbering.use_input_indices();
    const std::vector<bool> is_left = left_components(complex, numbering);
    std::vector<Trace> gone;
    for (std::size_t component = 0; component < is_left.size(); ++component) {
      if (is_left[component])
        continue;
      ++report.vanished_components;
      report.largest_vanished_component =
          (std::max)(report.largest_vanished_component, sizes_[component]);
      gone.push_back(traces_[component]);
    }
    report.error =
        (std::max)(report.error, scale.length_of_mesh(distance_of(gone, complex, geometry)));
  }

private:
  std::vector<bool> left_components(const TriangleComplex& complex,
                                    const Numbering& numbering) const {
    std::vector<bool> has_faces(component_.size()), is_left(sizes_.size());
    for (Index v = 0; v < complex.vertex_capacity(); ++v)
      if (complex.has_faces(v))
        has_faces[numbering.vertices[v]] = true;
    for (Index input = 0; input < component_.size(); ++input)
      if (component_[input] != none && has_faces[numbering.merged_vertex(input)])
        is_left[component_[input]] = true;
    return is_left;
  }

  std::vector<double> sizes_; // of each component: see Component
  std::vector<Trace> traces_;
  Array<Index> component_; // of each input vertex; empty if there is only one
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_STATE_INPUT_COMPONENTS_H
