#ifndef QUADRILLE_EXAMPLES_MESH_IO_WELD_H
#define QUADRILLE_EXAMPLES_MESH_IO_WELD_H

#include "indexed_mesh.h"
#include "mesh_values.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace quadrille_examples {

template <class Value>
void keep_values(std::vector<Value>& values, const std::vector<bool>& kept) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (kept[i])
      values[count++] = values[i];
  values.resize(count);
}

/// Removes the points that are not `kept`; no triangle uses them.
inline void keep_points(IndexedMesh& mesh, const std::vector<bool>& kept) {
  keep_values(mesh.points, kept);
  for_each_values_of_points(mesh, [&](auto& values) { keep_values(values, kept); });
  std::vector<std::uint32_t> new_index(kept.size());
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    new_index[i] = count;
    count += kept[i];
  }
  for (auto& triangle : mesh.triangles)
    for (std::uint32_t& corner : triangle)
      corner = new_index[corner];
}

/// Removes the triangles that are not `kept`, with what belongs to them. Returns how many went.
inline std::size_t keep_triangles(IndexedMesh& mesh, const std::vector<bool>& kept) {
  const auto gone = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), false));
  if (gone == 0)
    return 0;
  keep_values(mesh.triangles, kept);
  for_each_values_of_triangles(mesh, [&](auto& values) {
    if (!values.empty())
      keep_values(values, kept);
  });
  return gone;
}

/// The order of vertices by what they have beside their place.
class AttributeOrder {
public:
  explicit AttributeOrder(const IndexedMesh& mesh) : mesh_(mesh) {}

  bool operator()(std::uint32_t a, std::uint32_t b) const {
    const auto of_a = of(a), of_b = of(b);
    if (of_a != of_b)
      return of_a < of_b;
    for (const NamedNumbers& numbers : mesh_.vertex_numbers)
      if (const auto bits_a = bits_of(numbers.values[a]), bits_b = bits_of(numbers.values[b]);
          bits_a != bits_b)
        return bits_a < bits_b;
    return false;
  }

private:
  /// Unlike numbers these have an order even where one is none.
  static std::uint64_t bits_of(double x) { return std::bit_cast<std::uint64_t>(x); }

  std::pair<Color, std::array<double, 2>> of(std::uint32_t v) const {
    return {mesh_.colors.empty() ? Color{} : mesh_.colors[v], mesh_.texture_coordinates.empty()
                                                                  ? std::array<double, 2>{}
                                                                  : mesh_.texture_coordinates[v]};
  }

  const IndexedMesh& mesh_;
};

/// The first of the vertices at exactly the same place as each.
inline std::vector<std::uint32_t> first_at_places(const std::vector<Point>& points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return points[a] < points[b]; });
  std::vector<std::uint32_t> firsts(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_same = i > 0 && points[order[i]] == points[order[i - 1]];
    firsts[order[i]] = is_same ? firsts[order[i - 1]] : order[i];
  }
  return firsts;
}

/// Makes vertices one with the first that `firsts` names for each. Where they differ by what they
/// have beside their place, their faces keep it: see IndexedMesh::value_triangles.
class VertexJoining {
public:
  /// Returns how many vertices went.
  static std::size_t join(IndexedMesh& mesh, const std::vector<std::uint32_t>& firsts) {
    VertexJoining joining(mesh, firsts);
    joining.number_values();
    const std::size_t count = joining.count_joined();
    if (count > 0)
      joining.apply();
    return count;
  }

private:
  VertexJoining(IndexedMesh& mesh, const std::vector<std::uint32_t>& firsts)
      : mesh_(mesh), firsts_(firsts), alike_(firsts.size()) {}

  std::size_t count_joined() const {
    std::size_t count = 0;
    for (std::uint32_t v = 0; v < firsts_.size(); ++v)
      count += firsts_[v] != v;
    return count;
  }

  /// Finds the first vertex of each with its values.
  void number_values() {
    const AttributeOrder attributes_before(mesh_);
    std::vector<std::uint32_t> order(firsts_.size());
    std::iota(order.begin(), order.end(), std::uint32_t{0});
    const auto is_before = [&](std::uint32_t a, std::uint32_t b) {
      return firsts_[a] != firsts_[b] ? firsts_[a] < firsts_[b] : attributes_before(a, b);
    };
    std::stable_sort(order.begin(), order.end(), is_before);
    for (std::size_t i = 0; i < order.size(); ++i) {
      const bool is_alike = i > 0 && !is_before(order[i - 1], order[i]);
      alike_[order[i]] = is_alike ? alike_[order[i - 1]] : order[i];
    }
  }

  void apply() {
    std::vector<bool> are_points, are_further; // values of points, and further ones
    for (std::uint32_t v = 0; v < firsts_.size(); ++v) {
      are_points.push_back(firsts_[v] == v);
      are_further.push_back(alike_[v] == v && !are_points[v]);
    }
    const std::vector<std::uint32_t> numbers = numbers_of_values(are_points, are_further);
    const bool has_further =
        std::find(are_further.begin(), are_further.end(), true) != are_further.end();
    if (has_further)
      mesh_.value_triangles = mesh_.triangles;
    for (auto& triangle : mesh_.value_triangles)
      for (std::uint32_t& corner : triangle)
        corner = numbers[alike_[corner]];
    for (auto& triangle : mesh_.triangles)
      for (std::uint32_t& corner : triangle)
        corner = numbers[firsts_[corner]];
    keep_values(mesh_.points, are_points);
    keep(mesh_.colors, are_points, are_further);
    keep(mesh_.texture_coordinates, are_points, are_further);
    for (NamedNumbers& column : mesh_.vertex_numbers)
      keep(column.values, are_points, are_further);
  }

  /// Those of points come first.
  static std::vector<std::uint32_t> numbers_of_values(const std::vector<bool>& are_points,
                                                      const std::vector<bool>& are_further) {
    std::vector<std::uint32_t> numbers(are_points.size());
    std::uint32_t count = 0;
    for (const std::vector<bool>* const kept : {&are_points, &are_further})
      for (std::size_t v = 0; v < numbers.size(); ++v)
        if ((*kept)[v])
          numbers[v] = count++;
    return numbers;
  }

  template <class Value>
  static void keep(std::vector<Value>& values, const std::vector<bool>& are_points,
                   const std::vector<bool>& are_further) {
    std::vector<Value> further = values;
    keep_values(values, are_points);
    keep_values(further, are_further);
    values.insert(values.end(), further.begin(), further.end());
  }

  IndexedMesh& mesh_;
  const std::vector<std::uint32_t>& firsts_;
  std::vector<std::uint32_t> alike_; // of each vertex, the first that is one with it and like it
};

} // namespace quadrille_examples

#endif
