#ifndef QUADRILLE_EXAMPLES_VERTEX_VALUES_H
#define QUADRILLE_EXAMPLES_VERTEX_VALUES_H

#include "mesh_io/indexed_mesh.h"
#include "mesh_io/named_numbers.h"
#include "nearest_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// Values of vertices on their way through `simplify`, as values of corners.
template <std::size_t N>
struct VertexValues {
  VertexValues() = default;
  VertexValues(std::vector<std::array<double, N>> of_points, const IndexedMesh& mesh) {
    if (of_points.empty())
      return;
    corners.values = std::move(of_points);
    corners.triples = mesh.triangles;
  }

  bool empty() const { return corners.empty(); }

  /// One for each point of the mesh that is left.
  std::vector<std::array<double, N>> of_points(const IndexedMesh& mesh) const {
    std::vector<std::array<double, N>> result(empty() ? 0 : mesh.points.size());
    for (std::size_t face = 0; face < corners.triples.size(); ++face)
      for (std::size_t i = 0; i < 3; ++i)
        result[mesh.triangles[face][i]] = corners.values[corners.triples[face][i]];
    return result;
  }

  CornerValues<N> corners;
};

/// The named numbers of vertices on their way through `simplify`. The first few that differ and are
/// not of integers are channels. Of all others a vertex has those of the nearest of the vertices
/// that have become it: there is nothing between two labels, or between a number and what is none.
class VertexNumbers {
public:
  explicit VertexNumbers(const IndexedMesh& mesh)
      : points_(mesh.points), channel_of_(mesh.vertex_numbers.size()) {
    for (std::size_t i = 0; i < channel_of_.size() && channels_.size() < most_channels; ++i)
      if (is_smooth(mesh.vertex_numbers[i])) {
        channel_of_[i] = channels_.size();
        channels_.emplace_back(components(mesh.vertex_numbers[i].values), mesh);
      }
  }

  std::vector<VertexValues<1>>& channels() { return channels_; }

  /// Gives the points of a mesh that are left their numbers; `images` tells which one each has
  /// become.
  void restore(IndexedMesh& mesh, const std::vector<std::size_t>& images) const {
    const std::vector<std::uint32_t> nearest = nearest_vertices(points_, images, mesh.points);
    for (std::size_t i = 0; i < channel_of_.size(); ++i) {
      NamedNumbers& numbers = mesh.vertex_numbers[i];
      if (channel_of_[i])
        restore_channel(mesh, channels_[*channel_of_[i]], numbers);
      else
        numbers.values = taken(numbers.values, nearest);
    }
  }

private:
  static constexpr std::size_t most_channels = 8; // each takes time and memory

  /// No value is without an order, or beyond what weighs anything beside a length.
  static bool is_smooth(const NamedNumbers& numbers) {
    return !numbers.type.is_integer && std::all_of(numbers.values.begin(), numbers.values.end(),
                                                   [](double x) { return std::abs(x) < 0x1p170; });
  }

  static std::vector<std::array<double, 1>> components(const std::vector<double>& values) {
    std::vector<std::array<double, 1>> result;
    for (const double value : values)
      result.push_back({value});
    return result;
  }

  /// In the range that there was, and of their type.
  static void restore_channel(const IndexedMesh& mesh, const VertexValues<1>& channel,
                              NamedNumbers& numbers) {
    if (numbers.values.empty())
      return;
    const auto range = std::minmax_element(numbers.values.begin(), numbers.values.end());
    const double low = *range.first, high = *range.second;
    numbers.values.clear();
    for (const auto& [value] : channel.of_points(mesh))
      numbers.values.push_back(nearest_of(numbers.type, std::clamp(value, low, high)));
  }

  static std::vector<double> taken(const std::vector<double>& values,
                                   const std::vector<std::uint32_t>& from) {
    std::vector<double> result;
    for (const std::uint32_t v : from)
      result.push_back(values[v]);
    return result;
  }

  std::vector<Point> points_; // as they were
  std::vector<VertexValues<1>> channels_;
  std::vector<std::optional<std::size_t>> channel_of_; // those that are channels
};

} // namespace quadrille_examples

#endif
