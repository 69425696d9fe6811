#include <quadrille/compiled/run_soup.h>

quadrille::Report quadrille::internal::simplify_carrying_by_edge_length(SoupRun& run) {
  return simplify_carrying_by_cost(run, EdgeLength{});
}
