#include <quadrille/compiled/run_soup.h>

quadrille::Report quadrille::internal::simplify_by_edge_length(SoupRun& run) {
  return simplify_by_cost(run, EdgeLength{});
}
