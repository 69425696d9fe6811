#ifndef QUADRILLE_EXAMPLES_VERTEX_VALUES_H
#define QUADRILLE_EXAMPLES_VERTEX_VALUES_H

#include "../mesh/indexed_mesh.h"
#include "../mesh/named_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// Values of vertices on their way through `simplify`, as values of corners. Values that no weight
/// makes comparable with lengths are multiplied by a power of two meanwhile, which keeps their
/// bits.
template <std::size_t N>
struct VertexValues {
  VertexValues() = default;
  VertexValues(std::vector<std::array<double, N>> of_points, const IndexedMesh& mesh) {
    if (of_points.empty())
      return;
    corners.values = std::move(of_points);
    corners.triples = value_triangles(mesh);
    const double largest = largest_value();
    if (largest > 0x1p64 || (largest > 0 && largest < 0x1p-64))
      exponent_ = -std::ilogb(largest);
    for (std::array<double, N>& value : corners.values)
      value = scaled(value, exponent_);
  }

  bool empty() const { return corners.empty(); }

  /// Returns the value of a corner.
  std::array<double, N> at(std::size_t face, std::size_t i) const {
    return scaled(corners.values[corners.triples[face][i]], -exponent_);
  }

  /// Appends those of a corner.
  void append_corner(std::size_t face, std::size_t i, std::vector<double>& row) const {
    if (!empty()) {
      const std::array<double, N> value = at(face, i);
      row.insert(row.end(), value.begin(), value.end());
    }
  }

  /// One for each point of the mesh that is left.
  std::vector<std::array<double, N>> of_points(const IndexedMesh& mesh) const {
    std::vector<std::array<double, N>> result(empty() ? 0 : mesh.points.size());
    for (std::size_t face = 0; face < corners.triples.size(); ++face)
      for (std::size_t i = 0; i < 3; ++i)
        result[mesh.triangles[face][i]] = at(face, i);
    return result;
  }

  /// Returns the values of the points that these numbers name, if `corners` is as it was.
  std::vector<std::array<double, N>> of_inputs(const std::vector<std::uint32_t>& points) const {
    std::vector<std::array<double, N>> result;
    for (std::size_t i = 0; i < points.size() && !empty(); ++i)
      result.push_back(scaled(corners.values[points[i]], -exponent_));
    return result;
  }

  CornerValues<N> corners;

private:
  static std::array<double, N> scaled(std::array<double, N> value, int exponent) {
    for (double& x : value)
      x = std::ldexp(x, exponent);
    return value;
  }

  double largest_value() const {
    double largest = 0;
    for (const std::array<double, N>& value : corners.values)
      for (const double x : value)
        largest = std::max(largest, std::abs(x));
    return largest;
  }

  int exponent_ = 0;
};

/// The named numbers of vertices on their way through `simplify`. The first few that differ and are
/// not of integers are channels. Of all others a vertex has those of the nearest of the vertices
/// that have become it: there is nothing between two labels, or between a number and what is none.
class VertexNumbers {
public:
  explicit VertexNumbers(const IndexedMesh& mesh)
      : old_(mesh.vertex_numbers), channel_of_(old_.size()) {
    for (std::size_t i = 0; i < old_.size() && channels_.size() < most_channels; ++i)
      if (is_smooth(old_[i])) {
        channel_of_[i] = channels_.size();
        channels_.emplace_back(components(old_[i].values), mesh);
        ranges_.push_back(channels_.back().corners.triples.empty()
                              ? std::pair(0., 0.)
                              : range_of(old_[i].values, channels_.back().corners.triples));
      }
  }

  std::vector<VertexValues<1>>& channels() { return channels_; }

  /// Gives the points of a mesh that are left their numbers; `nearest` is the old point of each
  /// that those get which are no channels.
  void restore(IndexedMesh& mesh, const std::vector<std::uint32_t>& nearest) const {
    for (std::size_t k = 0; k < old_.size(); ++k) {
      std::vector<double>& values = mesh.vertex_numbers[k].values;
      values.clear();
      if (channel_of_[k])
        for (const auto& [value] : channels_[*channel_of_[k]].of_points(mesh))
          values.push_back(restored(k, value));
      else
        for (const std::uint32_t v : nearest)
          values.push_back(old_[k].values[v]);
    }
  }

  /// Appends what a corner has of each: of those that are no channels what `nearest` had.
  void append_corner(std::size_t face, std::size_t i, std::uint32_t nearest,
                     std::vector<double>& row) const {
    for (std::size_t k = 0; k < old_.size(); ++k)
      if (channel_of_[k]) {
        row.push_back(restored(k, channels_[*channel_of_[k]].at(face, i)[0]));
      } else {
        row.push_back(old_[k].values[nearest]);
      }
  }

private:
  static constexpr std::size_t most_channels = 8; // each takes time and memory

  /// No value is without an order, or beyond what weighs anything beside a length.
  static bool is_smooth(const NamedNumbers& numbers) {
    return !numbers.type.is_integer && std::all_of(numbers.values.begin(), numbers.values.end(),
                                                   [](double x) { return std::abs(x) < 0x1p170; });
  }

  /// Of the values that faces have: vertices without a face say nothing.
  static std::pair<double, double>
  range_of(const std::vector<double>& values,
           const std::vector<std::array<std::uint32_t, 3>>& triples) {
    const double first = values[triples[0][0]];
    std::pair range(first, first);
    for (const auto& triple : triples)
      for (const std::uint32_t v : triple) {
        range.first = std::min(range.first, values[v]);
        range.second = std::max(range.second, values[v]);
      }
    return range;
  }

  static std::vector<std::array<double, 1>> components(const std::vector<double>& values) {
    std::vector<std::array<double, 1>> result;
    for (const double value : values)
      result.push_back({value});
    return result;
  }

  /// A value of a channel in the range that there was, and of its type.
  double restored(std::size_t k, double value) const {
    const auto [low, high] = ranges_[*channel_of_[k]];
    return nearest_of(old_[k].type, std::clamp(value, low, high));
  }

  std::vector<NamedNumbers> old_;
  std::vector<VertexValues<1>> channels_;
  std::vector<std::pair<double, double>> ranges_;      // of these
  std::vector<std::optional<std::size_t>> channel_of_; // those that are channels
};

} // namespace quadrille_examples

#endif
