#include <quadrille/compiled/run_soup.h>

quadrille::Report quadrille::internal::simplify_carrying_by_thin_feature_quadric(SoupRun& run) {
  return simplify_carrying_by_cost(run, ThinFeatureQuadric{});
}
