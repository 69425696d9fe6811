#ifndef QUADRILLE_COMPILED_COSTS_H
#define QUADRILLE_COMPILED_COSTS_H

#include <quadrille/compiled.h>

#include <cstddef>
#include <vector>

/// \file
/// One function for each cost, each compiled in a source of its own.

namespace quadrille::internal {

Report simplify_by_quadric(SoupPoints&, SoupTriangles&, const SoupOptions&,
                           std::vector<std::size_t>* image);
Report simplify_by_memoryless_quadric(SoupPoints&, SoupTriangles&, const SoupOptions&,
                                      std::vector<std::size_t>* image);
Report simplify_by_thin_feature_quadric(SoupPoints&, SoupTriangles&, const SoupOptions&,
                                        std::vector<std::size_t>* image);
Report simplify_by_edge_length(SoupPoints&, SoupTriangles&, const SoupOptions&,
                               std::vector<std::size_t>* image);

} // namespace quadrille::internal

#endif // QUADRILLE_COMPILED_COSTS_H
