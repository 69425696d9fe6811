#ifndef QUADRILLE_EXAMPLES_VALUE_SEAMS_H
#define QUADRILLE_EXAMPLES_VALUE_SEAMS_H

#include "../mesh/indexed_mesh.h"
#include "nearest_vertices.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// The parts of a surface that seams of its values divide (IndexedMesh::value_triangles): faces
/// that hang together by vertices with one value.
class SeamPatches {
public:
  explicit SeamPatches(const IndexedMesh& mesh)
      : values_(value_triangles(mesh)), places_(points_of_values(mesh)), points_(places_.size()),
        patches_(places_.size()) {
    std::iota(patches_.begin(), patches_.end(), std::uint32_t{0});
    std::iota(points_.begin(), points_.end(), std::uint32_t{0});
    for (std::size_t face = 0; face < values_.size(); ++face)
      for (std::size_t i = 0; i < 3; ++i) {
        points_[values_[face][i]] = mesh.triangles[face][i];
        join(values_[face][0], values_[face][i]);
      }
  }

  /// For each corner of what a simplification has left, the nearest of the old values of its patch
  /// that have become it. `images` tells what became of each point, `faces` which ones are left.
  std::vector<std::array<std::uint32_t, 3>> nearest(const IndexedMesh& left,
                                                    const std::vector<std::size_t>& images,
                                                    const std::vector<std::uint32_t>& faces) {
    std::map<std::pair<std::size_t, std::uint32_t>, std::uint32_t> numbers; // points, patches
    std::vector<Point> places;
    std::vector<std::uint32_t> fallbacks; // of places that no old value has become
    std::vector<std::array<std::uint32_t, 3>> result;
    for (std::size_t face = 0; face < left.triangles.size(); ++face) {
      result.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t point = left.triangles[face][i];
        const auto next = static_cast<std::uint32_t>(places.size());
        const auto [place, is_new] =
            numbers.try_emplace({point, patch(values_[faces[face]][i])}, next);
        if (is_new) {
          places.push_back(left.points[point]);
          fallbacks.push_back(values_[faces[face]][i]);
        }
        result.back()[i] = place->second;
      }
    }
    std::vector<std::size_t> image_of_values;
    for (std::uint32_t value = 0; value < places_.size(); ++value) {
      const auto found = numbers.find({images[points_[value]], patch(value)});
      image_of_values.push_back(found == numbers.end() ? places.size() : found->second);
    }
    const std::vector<std::uint32_t> nearest =
        nearest_vertices(places_, image_of_values, places, fallbacks);
    for (auto& corners : result)
      for (std::uint32_t& corner : corners)
        corner = nearest[corner];
    return result;
  }

  /// A texture in which each patch is a chart at a place of its own, and of no size. As a channel
  /// it holds the borders of patches where they are.
  CornerValues<2>& charts() {
    if (charts_.triples.empty()) {
      for (std::uint32_t value = 0; value < places_.size();
           ++value) { // evenly spread over a square
        const double number = patch(value);
        charts_.values.push_back(
            {std::fmod(number * 0.7548776662466927, 1), std::fmod(number * 0.5698402909980532, 1)});
      }
      charts_.triples = values_;
    }
    return charts_;
  }

private:
  std::uint32_t patch(std::uint32_t value) {
    while (patches_[value] != value)
      value = patches_[value] = patches_[patches_[value]];
    return value;
  }
  void join(std::uint32_t a, std::uint32_t b) { patches_[patch(b)] = patch(a); }

  std::vector<std::array<std::uint32_t, 3>> values_; // of the corners of the faces
  std::vector<Point> places_;                        // of the values, as all below
  std::vector<std::uint32_t> points_;
  std::vector<std::uint32_t> patches_;
  CornerValues<2> charts_; // once they have been asked for
};

/// Gives the values of corners numbers, as IndexedMesh::value_triangles has them: each point has
/// one for each row of values that differs from its others, and the first of them is its own.
class ValueNumbers {
public:
  explicit ValueNumbers(std::size_t points) : rows_(points) {}

  std::uint32_t number(std::uint32_t point, const std::vector<double>& row) {
    std::vector<std::uint64_t> key = {point};
    for (const double value : row) // what is no number has no order by itself
      key.push_back(std::bit_cast<std::uint64_t>(value));
    const auto next = rows_[point].empty() ? point : static_cast<std::uint32_t>(rows_.size());
    const auto [place, is_new] = numbers_.try_emplace(std::move(key), next);
    if (is_new && next == point)
      rows_[point] = row;
    else if (is_new)
      rows_.push_back(row);
    return place->second;
  }

  /// The rows, by their numbers; empty for points without faces.
  const std::vector<std::vector<double>>& rows() const { return rows_; }

private:
  std::vector<std::vector<double>> rows_;
  std::map<std::vector<std::uint64_t>, std::uint32_t> numbers_; // of points with rows
};

} // namespace quadrille_examples

#endif
