#include <quadrille/compiled/run_soup.h>

quadrille::Report quadrille::internal::simplify_by_quadric(SoupRun& run) {
  return simplify_by_cost(run, Quadric{});
}
