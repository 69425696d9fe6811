#include <quadrille/compiled/run_soup.h>

quadrille::Report quadrille::internal::simplify_carrying_by_memoryless_quadric(SoupRun& run) {
  return simplify_carrying_by_cost(run, MemorylessQuadric{});
}
