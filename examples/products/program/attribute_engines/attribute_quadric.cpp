#include "engine.h"

#include <quadrille/attribute_quadric.h>

namespace quadrille_examples {

namespace {

/// They are lengths already.
template <class Cost>
quadrille::Report simplify_as(const AttributeRun& run) {
  auto cost = quadrille::internal::with_weights(Cost{}, run.options);
  cost.weights.emplace().coordinates.fill(1);
  return simplify<Cost::dimension - 3>(run, cost);
}

} // namespace

quadrille::Report simplify_dimensions(const AttributeRun& run) {
  if (run.attributes.size() <= 2)
    return simplify_as<quadrille::AttributeQuadric<2>>(run);
  if (run.attributes.size() == 3)
    return simplify_as<quadrille::AttributeQuadric<3>>(run);
  return simplify_as<quadrille::AttributeQuadric<6>>(run);
}

} // namespace quadrille_examples
