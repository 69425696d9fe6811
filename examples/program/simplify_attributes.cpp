#include "run_engine.h"
#include "simplify_mesh.h"

#include <quadrille/attribute_quadric.h>
#include <quadrille/edge_length.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/thin_feature_quadric.h>

namespace quadrille_examples {

quadrille::Report simplify_attributes(const MeshAttributes& attributes, IndexedMesh& mesh,
                                      const Options& options) {
  const auto carrying = [&](const auto& cost) {
    return simplify_carrying(attributes, mesh, options, cost);
  };
  if (options.cost == "length")
    return carrying(quadrille::EdgeLength{});
  if (options.cost == "memoryless")
    return carrying(with_weights(quadrille::MemorylessQuadric{}, options));
  if (options.cost == "thin-features")
    return carrying(with_weights(quadrille::ThinFeatureQuadric{}, options));
  if (options.cost != "quadric")
    return simplify_dimensions(attributes, mesh, options);
  return carrying(with_weights(quadrille::Quadric{}, options));
}

} // namespace quadrille_examples
