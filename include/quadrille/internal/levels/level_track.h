#ifndef QUADRILLE_INTERNAL_LEVELS_LEVEL_TRACK_H
#define QUADRILLE_INTERNAL_LEVELS_LEVEL_TRACK_H

#include <quadrille/internal/core/base/index.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace quadrille::internal {

/// Items at the corners of faces (vertices, or wedges of a channel) over a segment of a recording.
/// They are numbered by removal, the last removed first, so that the items that exist at any time
/// are 0, 1, … up to their number. Faces are numbered in the same way.
struct LevelTrack {
  std::size_t width = 0; ///< the number of values of an item
  /// The items at the corners of each face, and their values, at the beginning of the segment.
  std::vector<std::array<Index, 3>> corners;
  std::vector<double> values;
  /// For each item that is removed in the segment, in ascending order, the item that it becomes,
  /// which has a lower number, or none.
  std::vector<Index> parents;
  std::vector<Index> items_after; ///< for each contraction, the number of remaining items
  /// For each contraction, the end of its changes. A change is an item and its values after the
  /// contraction.
  std::vector<Index> change_ends;
  std::vector<Index> changed;
  std::vector<double> changed_values;

  std::size_t items() const { return values.size() / width; }
  /// Returns the number of items after the given contractions of the segment.
  std::size_t items_at(std::size_t contractions) const {
    return contractions == 0 ? items() : items_after[contractions - 1];
  }

  /// Returns the item that each item has become after the given contractions of the segment.
  std::vector<Index> item_map(std::size_t contractions) const {
    const std::size_t left = items_at(contractions);
    std::vector<Index> item_map(items());
    std::iota(item_map.begin(), item_map.begin() + static_cast<std::ptrdiff_t>(left), Index{0});
    find_map(left, items(), item_map);
    return item_map;
  }
  /// Finds the items that the removed items from `begin` to `end` become. All before them are
  /// known.
  void find_map(std::size_t begin, std::size_t end, std::vector<Index>& item_map) const {
    const std::size_t first_to_go = items() - parents.size();
    for (std::size_t i = (std::max)(begin, first_to_go); i < (std::min)(end, items()); ++i) {
      const Index parent = parents[i - first_to_go];
      item_map[i] = parent == none ? none : item_map[parent];
    }
  }

  /// Calls visit(item, values) for the changes of items that still exist after the given
  /// contractions of the segment, in their order.
  template <class Visit>
  void for_each_change(std::size_t contractions, Visit visit) const {
    const std::size_t left = items_at(contractions);
    const std::size_t end = contractions == 0 ? 0 : change_ends[contractions - 1];
    for (std::size_t i = 0; i < end; ++i)
      if (changed[i] < left)
        visit(changed[i], changed_values.data() + i * width);
  }

  /// Returns the values of all items that exist after the given contractions of the segment.
  std::vector<double> values_at(std::size_t contractions) const {
    std::vector<double> left(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(
                                                                  items_at(contractions) * width));
    for_each_change(contractions, [&](Index item, const double* numbers) {
      std::copy_n(numbers, width, left.data() + item * width);
    });
    return left;
  }
  /// Returns the corners of the first faces at that time.
  std::vector<std::array<Index, 3>> corners_at(std::size_t contractions, std::size_t faces) const {
    const std::vector<Index> item_map = this->item_map(contractions);
    std::vector<std::array<Index, 3>> left(faces);
    for (std::size_t face = 0; face < faces; ++face)
      for (std::size_t i = 0; i < 3; ++i)
        left[face][i] = item_map[corners[face][i]];
    return left;
  }
};

/// Consecutive contractions of a recording, and the surface before the first of them: all data for
/// any level between.
struct LevelSegment {
  std::vector<Index> faces_after; ///< for each contraction, the number of remaining faces
  std::vector<float> errors;      ///< for each contraction, the greatest error so far
  std::vector<float> bounds;      ///< for each contraction, the greatest distance so far; empty if
                                  ///< distances are not known
  bool are_bounds_both_ways = false;
  float error_before = 0, bound_before = 0;
  std::vector<LevelTrack> tracks; ///< the vertices, then the wedges of each channel with seams

  std::size_t contractions() const { return faces_after.size(); }
  std::size_t faces() const { return tracks.front().corners.size(); }
  std::size_t faces_at(std::size_t contractions) const {
    return contractions == 0 ? faces() : faces_after[contractions - 1];
  }
  double error_at(std::size_t contractions) const {
    return static_cast<double>(contractions == 0 ? error_before : errors[contractions - 1]);
  }
  double bound_at(std::size_t contractions) const {
    return static_cast<double>(contractions == 0 ? bound_before : bounds[contractions - 1]);
  }
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_LEVELS_LEVEL_TRACK_H
