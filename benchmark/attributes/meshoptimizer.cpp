// SPDX-License-Identifier: MIT
//
// meshoptimizer takes vertices that are split at seams, and works on floats. The version decides
// which of its functions there are: attributes count from 0.21 on.

#include "contender.h"

#ifndef BENCH_WITH_MESHOPTIMIZER
std::vector<bench::AttributeContender> bench::meshoptimizer_attribute_contenders() {
  return {};
}
#else

#include "model.h"

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <meshoptimizer.h>

#include <cstddef>

namespace bench {
namespace {

constexpr float any_error = 1e6f;

/// Positions relative to the centre of the box, so that no digit goes into where the model lies.
struct Arrays {
  std::vector<float> positions, attributes;
  std::vector<unsigned int> indices;

  explicit Arrays(const Soup& soup)
      : attributes(soup.attributes.values.begin(), soup.attributes.values.end()) {
    const CGAL::Bbox_3 box = CGAL::bbox_3(soup.points.begin(), soup.points.end());
    for (const Point& p : soup.points)
      for (int i = 0; i < 3; ++i)
        positions.push_back(static_cast<float>(p[i] - (box.min(i) + box.max(i)) / 2));
    for (const auto& t : soup.triangles)
      indices.insert(indices.end(), t.begin(), t.end());
  }
  std::size_t size() const { return positions.size() / 3; }
};

/// Leaves the triangles of a list of indices.
void take_triangles(const std::vector<unsigned int>& indices, Soup& soup) {
  soup.triangles.resize(indices.size() / 3);
  for (std::size_t i = 0; i < indices.size(); ++i)
    soup.triangles[i / 3][i % 3] = indices[i];
  drop_unused_points(soup);
}

std::optional<double> simplify(Soup& soup, const AttributeTask& task) {
  split_points(soup);
  const Arrays arrays(soup);
  std::vector<unsigned int> result(arrays.indices.size());
  const Stopwatch stopwatch;
  result.resize(meshopt_simplify(result.data(), arrays.indices.data(), arrays.indices.size(),
                                 arrays.positions.data(), arrays.size(), 3 * sizeof(float),
                                 task.faces * 3, any_error, 0, nullptr));
  const double seconds = stopwatch.seconds();
  take_triangles(result, soup);
  return seconds;
}

#if MESHOPTIMIZER_VERSION >= 210
/// Its positions are in units of their extent.
std::vector<float> weights(const Arrays& arrays, std::size_t components, double weight) {
  const float extent =
      meshopt_simplifyScale(arrays.positions.data(), arrays.size(), 3 * sizeof(float));
  return std::vector<float>(components, static_cast<float>(weight) / extent);
}

std::optional<double> simplify_with_attributes(Soup& soup, const AttributeTask& task) {
  split_points(soup);
  const Arrays arrays(soup);
  const std::size_t m = soup.attributes.components;
  std::vector<unsigned int> result(arrays.indices.size());
  const Stopwatch stopwatch;
  const std::vector<float> weight = weights(arrays, m, task.weight);
  result.resize(meshopt_simplifyWithAttributes(
      result.data(), arrays.indices.data(), arrays.indices.size(), arrays.positions.data(),
      arrays.size(), 3 * sizeof(float), arrays.attributes.data(), m * sizeof(float), weight.data(),
      m, nullptr, task.faces * 3, any_error, 0, nullptr));
  const double seconds = stopwatch.seconds();
  take_triangles(result, soup);
  return seconds;
}
#endif

} // namespace

std::vector<AttributeContender> meshoptimizer_attribute_contenders() {
  std::vector<AttributeContender> contenders{
      {"meshoptimizer",
       "meshopt_simplify, attributes do not count; float, input positions",
       {1},
       simplify}};
#if MESHOPTIMIZER_VERSION >= 210
  contenders.push_back({"meshoptimizer attributes",
                        "meshopt_simplifyWithAttributes, options 0, no error limit, version " +
                            std::to_string(MESHOPTIMIZER_VERSION) + "; float, input positions",
                        peer_factors, simplify_with_attributes});
#endif
  return contenders;
}

} // namespace bench

#endif
