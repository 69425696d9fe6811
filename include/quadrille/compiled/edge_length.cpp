#include <quadrille/compiled/engines.h>
#include <quadrille/compiled/run_soup.h>

namespace quadrille::internal {
QUADRILLE_ENGINES(template, EdgeLength);
}

quadrille::Report quadrille::internal::simplify_by_edge_length(SoupRun& run) {
  return simplify_by_cost(run, EdgeLength{});
}
