#ifndef QUADRILLE_EXAMPLES_PROGRAM_PAIRS_OF_FACES_H
#define QUADRILLE_EXAMPLES_PROGRAM_PAIRS_OF_FACES_H

#include <quadrille/compiled.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace quadrille_examples {

/// Whether each triangle belongs to a part of two, which hangs together by its points: a picture on
/// a wall, or a leaf.
std::vector<bool> pairs_of_faces(std::size_t points, const auto& triangles) {
  std::vector<std::uint32_t> parts(points);
  std::iota(parts.begin(), parts.end(), std::uint32_t{0});
  const auto part_of = [&](std::uint32_t point) {
    while (parts[point] != point)
      point = parts[point] = parts[parts[point]];
    return point;
  };
  for (const auto& [a, b, c] : triangles) {
    parts[part_of(b)] = part_of(a);
    parts[part_of(c)] = part_of(a);
  }
  std::vector<std::size_t> faces(points);
  for (const auto& triangle : triangles)
    ++faces[part_of(triangle[0])];
  std::vector<bool> result;
  for (const auto& triangle : triangles)
    result.push_back(faces[part_of(triangle[0])] == 2);
  return result;
}

/// Leaves these as they are, and out of the count: half of their faces would be half of what they
/// are. Where a target is asked for they go as all others.
void leave_pairs_of_faces(std::size_t points, const auto& triangles,
                          quadrille::SoupOptions& options) {
  const std::vector<bool> are_pairs = pairs_of_faces(points, triangles);
  const auto count = std::count(are_pairs.begin(), are_pairs.end(), true);
  if (count == 0)
    return;
  const bool are_all = static_cast<std::size_t>(count) == are_pairs.size();
  if (are_all)
    options.fixed.assign(points, true);
  else if (options.selected.empty())
    options.selected.assign(are_pairs.size(), true);
  for (std::size_t face = 0; face < are_pairs.size() && !are_all; ++face)
    if (are_pairs[face])
      options.selected[face] = false;
}

} // namespace quadrille_examples

#endif
