#include "engine.h"

#include <quadrille/memoryless_quadric.h>

namespace quadrille_examples {

quadrille::Report carry_by_memoryless_quadric(const AttributeRun& run) {
  return carry(run, quadrille::MemorylessQuadric{});
}

} // namespace quadrille_examples
