#include <quadrille/compiled/run_soup.h>

quadrille::Report quadrille::internal::simplify_by_thin_feature_quadric(SoupRun& run) {
  return simplify_by_cost(run, ThinFeatureQuadric{});
}
