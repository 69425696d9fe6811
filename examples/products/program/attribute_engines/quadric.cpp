#include "engine.h"

#include <quadrille/quadric.h>

namespace quadrille_examples {

quadrille::Report carry_by_quadric(const AttributeRun& run) {
  return carry(run, quadrille::Quadric{});
}

} // namespace quadrille_examples
