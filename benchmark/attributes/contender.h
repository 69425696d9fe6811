// SPDX-License-Identifier: MIT
//
// What takes part where surfaces have colours or texture coordinates.

#ifndef QUADRILLE_BENCHMARK_ATTRIBUTES_CONTENDER_H
#define QUADRILLE_BENCHMARK_ATTRIBUTES_CONTENDER_H

#include "../contender.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace bench {

enum class Kind { color, texture };

/// What a contender is asked for.
struct AttributeTask {
  Kind kind;
  std::size_t faces;
  double factor; ///< by which attributes count more than channels let them by default
  double weight; ///< the length in the mesh's unit that a step of 1 in a component then counts as
};

/// One way to simplify a surface with attributes.
struct AttributeContender {
  std::string name;
  std::string options; ///< the settings it runs with, to be shown beside the table
  /// Of these the best one is taken, model by model.
  std::vector<double> factors = {1};
  /// Brings a soup, in place, to a number of faces or as near as it can. The whole call is timed.
  /// Returns processor time without conversions.
  std::function<std::optional<double>(Soup& soup, const AttributeTask& task)> simplify;
};

std::vector<AttributeContender> our_attribute_contenders();
// The following are empty where the library was not found.
std::vector<AttributeContender> meshoptimizer_attribute_contenders();
std::vector<AttributeContender> vtk_attribute_contenders();

/// What peers try.
inline const std::vector<double> peer_factors = {0.1, 0.3, 1, 3, 10};

} // namespace bench

#endif
