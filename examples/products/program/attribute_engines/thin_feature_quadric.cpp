#include "engine.h"

#include <quadrille/memoryless_quadric.h>

namespace quadrille_examples {

quadrille::Report carry_by_thin_feature_quadric(const AttributeRun& run) {
  return carry(run, quadrille::ThinFeatureQuadric{});
}

} // namespace quadrille_examples
