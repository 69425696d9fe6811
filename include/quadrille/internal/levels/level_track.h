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
/// They are numbered by when they go, the last to go first, so that those that are there at any
/// time are 0, 1, … up to their number; and so are faces.
struct LevelTrack {
  std::size_t width = 0; ///< how many numbers an item has
  /// At the beginning of the segment: the items at the corners of each face, and their numbers.
  std::vector<std::array<Index, 3>> corners;
  std::vector<double> values;
  /// Of each item that goes in the segment, from the lowest up: the item that it becomes, which has
  /// a lower number, or none.
  std::vector<Index> parents;
  std::vector<Index> items_after; ///< of each contraction: how many are left
  /// Of each contraction: where its changes end. A change is an item and its numbers afterwards.
  std::vector<Index> change_ends;
  std::vector<Index> changed;
  std::vector<double> changed_values;

  std::size_t items() const { return values.size() / width; }
  /// After that many contractions of the segment.
  std::size_t items_at(std::size_t contractions) const {
    return contractions == 0 ? items() : items_after[contractions - 1];
  }

  /// What has become of each item after that many contractions of the segment.
  std::vector<Index> images(std::size_t contractions) const {
    const std::size_t left = items_at(contractions);
    std::vector<Index> images(items());
    std::iota(images.begin(), images.begin() + static_cast<std::ptrdiff_t>(left), Index{0});
    find_images(left, items(), images);
    return images;
  }
  /// The same of the items that go in the segment, as far as they are among those from `begin` to
  /// `end`. All before them are known.
  void find_images(std::size_t begin, std::size_t end, std::vector<Index>& images) const {
    const std::size_t first_to_go = items() - parents.size();
    for (std::size_t i = (std::max)(begin, first_to_go); i < (std::min)(end, items()); ++i) {
      const Index parent = parents[i - first_to_go];
      images[i] = parent == none ? none : images[parent];
    }
  }

  /// Calls visit(item, numbers) for what has changed of items that are still there after that many
  /// contractions of the segment, in their order.
  template <class Visit>
  void for_each_change(std::size_t contractions, Visit visit) const {
    const std::size_t left = items_at(contractions);
    const std::size_t end = contractions == 0 ? 0 : change_ends[contractions - 1];
    for (std::size_t i = 0; i < end; ++i)
      if (changed[i] < left)
        visit(changed[i], changed_values.data() + i * width);
  }

  /// The numbers of all items that are there after that many contractions of the segment.
  std::vector<double> values_at(std::size_t contractions) const {
    std::vector<double> left(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(
                                                                  items_at(contractions) * width));
    for_each_change(contractions, [&](Index item, const double* numbers) {
      std::copy_n(numbers, width, left.data() + item * width);
    });
    return left;
  }
  /// The corners of the first faces then.
  std::vector<std::array<Index, 3>> corners_at(std::size_t contractions, std::size_t faces) const {
    const std::vector<Index> images = this->images(contractions);
    std::vector<std::array<Index, 3>> left(faces);
    for (std::size_t face = 0; face < faces; ++face)
      for (std::size_t i = 0; i < 3; ++i)
        left[face][i] = images[corners[face][i]];
    return left;
  }
};

/// Some contractions of a recording that follow each other, and the surface before the first of
/// them: enough for any level between.
struct LevelSegment {
  std::vector<Index> faces_after; ///< of each contraction: how many are left
  std::vector<float> errors;      ///< of each contraction: the greatest until then
  std::vector<float> bounds;      ///< the same of distances; empty if they are not known
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
