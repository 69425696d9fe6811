#ifndef QUADRILLE_EXAMPLES_PROGRAM_ATTRIBUTE_RUN_H
#define QUADRILLE_EXAMPLES_PROGRAM_ATTRIBUTE_RUN_H

#include "../mesh_io/attributes/mesh_attributes.h"
#include "../mesh_io/mesh/indexed_mesh.h"

#include <quadrille/compiled.h>
#include <quadrille/report.h>

#include <cstddef>
#include <vector>

namespace quadrille_examples {

/// Attributes on their way through `simplify`.
struct AttributeRun {
  const MeshAttributes& attributes;
  IndexedMesh& mesh;
  const quadrille::SoupOptions& options;
  std::vector<std::size_t>& image;
};

/// With attributes that are carried along a cost of positions only.
quadrille::Report carry_by_edge_length(const AttributeRun& run);
quadrille::Report carry_by_memoryless_quadric(const AttributeRun& run);
quadrille::Report carry_by_quadric(const AttributeRun& run);
quadrille::Report carry_by_thin_feature_quadric(const AttributeRun& run);

/// With attributes as further dimensions, as many as vary: rounded up, since each number takes an
/// engine.
quadrille::Report simplify_dimensions(const AttributeRun& run);

} // namespace quadrille_examples

#endif
