#include "engine.h"

#include <quadrille/edge_length.h>

namespace quadrille_examples {

quadrille::Report carry_by_edge_length(const AttributeRun& run) {
  return carry(run, quadrille::EdgeLength{});
}

} // namespace quadrille_examples
