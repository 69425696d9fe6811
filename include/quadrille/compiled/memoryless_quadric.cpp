#include <quadrille/compiled/engines.h>
#include <quadrille/compiled/run_soup.h>

namespace quadrille::internal {
QUADRILLE_ENGINES(template, MemorylessQuadric);
}

quadrille::Report quadrille::internal::simplify_by_memoryless_quadric(SoupRun& run) {
  return simplify_by_cost(run, MemorylessQuadric{});
}
