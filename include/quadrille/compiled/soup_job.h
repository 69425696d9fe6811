#ifndef QUADRILLE_COMPILED_SOUP_JOB_H
#define QUADRILLE_COMPILED_SOUP_JOB_H

#include <quadrille/compiled.h>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>

namespace quadrille::internal {

/// A pair as a cost function sees it. Positions are in the unit of the points, and indices are
/// those of the input.
struct SoupPair {
  std::size_t first_index;      ///< an end
  std::size_t second_index;     ///< the other end
  std::array<double, 3> first;  ///< the position of an end
  std::array<double, 3> second; ///< the position of the other end
  std::array<double, 3> target; ///< the position of the new vertex
  double quadric;               ///< the cost of Quadric
};

using SoupCostFunction = std::function<double(const SoupPair&)>;

/// The options of a call by any engine, those of SoupOptions and others: see options.def.
struct SoupJob : SoupOptions {
  enum class Hull { outer, inner };

  std::optional<Hull> hull = {};       ///< see OuterHull and InnerHull
  bool keep_volume = false;            ///< see VolumeKeeping
  bool calibrated = false;             ///< see calibrated()
  bool maps = false;                   ///< see old_to_new() and new_to_old()
  SoupCostFunction cost_function = {}; ///< replaces the cost, if there is one
};

/// Simplifies by a function, with values of at least 0, instead of the cost of Quadric. Vertices go
/// where the cost of Quadric is least; channels add their own cost.
SoupResult soup_by_cost(const SoupView& soup, const SoupOptions& options,
                        const SoupCostFunction& function);

/// Makes an outer or an inner hull with MemorylessQuadric in greedy order.
SoupResult hull_of_soup(const SoupView& soup, const SoupOptions& options, bool is_outer);

/// Simplifies with VolumeKeeping and MemorylessQuadric in greedy order.
SoupResult soup_of_same_volume(const SoupView& soup, const SoupOptions& options);

/// Simplifies with multiples of a limit in both directions, of which one is given, and returns the
/// coarsest result that is proved to be within it: see calibrated(). If options.proceed says no,
/// the coarsest until then. Throws std::invalid_argument for options that do not go with it.
SoupResult calibrated_soup(const SoupView& soup, const SoupJob& job);

/// Checks which options go together, and simplifies by the engine that they need. Throws
/// std::invalid_argument for options that do not go together.
SoupResult simplified_by_job(const SoupView& soup, const SoupJob& job);

} // namespace quadrille::internal

#endif // QUADRILLE_COMPILED_SOUP_JOB_H
