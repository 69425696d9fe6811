#include <quadrille/compiled/run_soup.h>

quadrille::Report
quadrille::internal::simplify_by_thin_feature_quadric(SoupPoints& points, SoupTriangles& triangles,
                                                      const SoupOptions& options,
                                                      std::vector<std::size_t>* image) {
  return simplify_by(points, triangles, options, image, ThinFeatureQuadric{});
}
