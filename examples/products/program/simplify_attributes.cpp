#include "attribute_run.h"
#include "simplify_mesh.h"

#include <cstddef>
#include <vector>

namespace quadrille_examples {

quadrille::Report simplify_attributes(const MeshAttributes& attributes, IndexedMesh& mesh,
                                      const Options& options, const quadrille::SoupOptions& soup,
                                      std::vector<std::size_t>* image) {
  std::vector<std::size_t> unasked;
  const AttributeRun run{attributes, mesh, soup, image ? *image : unasked};
  if (options.cost == "length")
    return carry_by_edge_length(run);
  if (options.cost == "memoryless")
    return carry_by_memoryless_quadric(run);
  if (options.cost == "thin-features")
    return carry_by_thin_feature_quadric(run);
  if (options.cost == "quadric")
    return carry_by_quadric(run);
  return simplify_dimensions(run);
}

} // namespace quadrille_examples
