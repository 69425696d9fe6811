#ifndef QUADRILLE_EXAMPLES_PYTHON_ENGINES_H
#define QUADRILLE_EXAMPLES_PYTHON_ENGINES_H

/// \file
/// Calls by policies that the compiled library has no engine for. Each is compiled in a source of
/// its own.

#include <quadrille/compiled.h>

#include <array>
#include <cstddef>
#include <functional>

namespace quadrille_examples {

/// A pair as a cost function sees it: places in the unit of the points, indices of the input.
struct CostedPair {
  std::size_t first_index, second_index;       ///< of the ends
  std::array<double, 3> first, second, target; ///< where the ends are, and where they would go
  double quadric;                              ///< what Quadric says that this costs
};

using CostFunction = std::function<double(const CostedPair&)>;

/// By a function, at least 0, in place of what Quadric says. Vertices go to where that is least;
/// channels add their own cost.
quadrille::SoupResult soup_by_cost(const quadrille::SoupView& soup,
                                   const quadrille::SoupOptions& options,
                                   const CostFunction& function);

/// By MemorylessQuadric and in greedy order, an outer or an inner hull: see Hull.
quadrille::SoupResult hull_of_soup(const quadrille::SoupView& soup,
                                   const quadrille::SoupOptions& options, bool is_outer);

/// By MemorylessQuadric and in greedy order, with VolumeKeeping.
quadrille::SoupResult soup_of_same_volume(const quadrille::SoupView& soup,
                                          const quadrille::SoupOptions& options);

} // namespace quadrille_examples

#endif
