#include <quadrille/compiled.h>
#include <quadrille/compiled/costs.h>

#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadrille {

Report simplify_soup(SoupPoints& points, SoupTriangles& triangles, const SoupOptions& options,
                     std::vector<std::size_t>* image) {
  if (!options.fixed.empty() && options.fixed.size() != points.size())
    throw std::invalid_argument("quadrille::simplify_soup: fixed has " +
                                std::to_string(options.fixed.size()) + " values for " +
                                std::to_string(points.size()) + " points");
  std::vector<std::size_t> images(image ? points.size() : 0);
  std::iota(images.begin(), images.end(), 0); // where it is cancelled at once, nothing has changed
  const auto run = [&](auto simplify) {
    const Report report = simplify(points, triangles, options, image ? &images : nullptr);
    if (image)
      *image = std::move(images);
    return report;
  };
  using Cost = SoupOptions::Cost;
  switch (options.cost) {
  case Cost::quadric:
    return run(internal::simplify_by_quadric);
  case Cost::memoryless_quadric:
    return run(internal::simplify_by_memoryless_quadric);
  case Cost::thin_feature_quadric:
    return run(internal::simplify_by_thin_feature_quadric);
  case Cost::edge_length:
    return run(internal::simplify_by_edge_length);
  }
  throw std::invalid_argument("quadrille::simplify_soup: there is no such cost");
}

} // namespace quadrille
