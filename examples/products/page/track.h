#ifndef QUADRILLE_EXAMPLES_PAGE_TRACK_H
#define QUADRILLE_EXAMPLES_PAGE_TRACK_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// Items at the corners of faces (vertices, or texture coordinates) and what contractions do to
/// them, as a page holds it: see levels.js. Contractions are numbered from 0, as are items, by when
/// they go, the last to go first.
struct Track {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::size_t width = 0;                             ///< how many numbers an item has
  std::vector<std::array<std::uint32_t, 3>> corners; ///< the items of each face at the beginning
  std::vector<float> values;                         ///< of each item at the beginning
  std::vector<std::uint32_t> parents;                ///< of each item: what it becomes, or none
  std::vector<std::uint32_t> ends; ///< after how many contractions it is gone; none: never
  /// Of each contraction: where its changes end. A change is an item and its numbers afterwards.
  std::vector<std::uint32_t> change_ends;
  std::vector<std::uint32_t> changed;
  std::vector<float> changed_values;

  std::size_t items() const { return parents.size(); }

  /// Adds items that nothing becomes of yet.
  void add_items(std::size_t count) {
    parents.resize(items() + count, none);
    ends.resize(items(), none);
  }
  /// The item is gone after a contraction.
  void end_item(std::size_t item, std::size_t contraction, std::uint32_t parent) {
    parents[item] = parent;
    ends[item] = static_cast<std::uint32_t>(contraction + 1);
  }
  void end_contraction() { change_ends.push_back(static_cast<std::uint32_t>(changed.size())); }

  /// Gives items that were added in any order their numbers.
  void number_by_end() {
    std::vector<std::uint32_t> order(items()), number(items());
    std::iota(order.begin(), order.end(), std::uint32_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return ends[a] > ends[b]; });
    for (std::size_t i = 0; i < order.size(); ++i)
      number[order[i]] = static_cast<std::uint32_t>(i);
    const Track old = std::exchange(*this, {});
    width = old.width;
    for (const std::uint32_t i : order) {
      const auto value = old.values.begin() + static_cast<std::ptrdiff_t>(i * width);
      values.insert(values.end(), value, value + static_cast<std::ptrdiff_t>(width));
      parents.push_back(old.parents[i] == none ? none : number[old.parents[i]]);
      ends.push_back(old.ends[i]);
    }
    corners = old.corners;
    for (auto& face : corners)
      for (std::uint32_t& item : face)
        item = number[item];
    change_ends = old.change_ends;
    for (const std::uint32_t item : old.changed)
      changed.push_back(number[item]);
    changed_values = old.changed_values;
  }

  /// Lets it begin after so many contractions, when so many faces are left.
  void begin_after(std::size_t contractions, std::size_t faces) {
    if (contractions == 0)
      return;
    const std::vector<std::uint32_t> images = vertex_map_after(contractions);
    corners.resize(faces);
    for (auto& face : corners)
      for (std::uint32_t& item : face)
        item = images[item];
    const std::size_t past = change_ends[contractions - 1];
    for (std::size_t change = 0; change < past; ++change)
      std::copy_n(&changed_values[change * width], width, &values[changed[change] * width]);
    erase_first(changed, past);
    erase_first(changed_values, past * width);
    erase_first(change_ends, contractions);
    for (std::uint32_t& end : change_ends)
      end -= static_cast<std::uint32_t>(past);
    keep_items_of(static_cast<std::uint32_t>(contractions));
  }

  /// What each item has become after so many contractions.
  std::vector<std::uint32_t> vertex_map_after(std::size_t contractions) const {
    std::vector<std::uint32_t> images(items());
    for (std::size_t i = 0; i < items(); ++i)
      images[i] = ends[i] > contractions ? static_cast<std::uint32_t>(i)
                  : parents[i] == none   ? none
                                         : images[parents[i]];
    return images;
  }

private:
  template <class T>
  static void erase_first(std::vector<T>& values, std::size_t count) {
    values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count));
  }

  /// Of the items, those that are not gone after so many contractions.
  void keep_items_of(std::uint32_t contractions) {
    const auto gone = std::find_if(ends.begin(), ends.end(),
                                   [&](std::uint32_t end) { return end <= contractions; });
    const auto left = static_cast<std::size_t>(gone - ends.begin());
    ends.resize(left);
    parents.resize(left);
    values.resize(left * width);
    for (std::uint32_t& end : ends)
      if (end != none)
        end -= contractions;
  }
};

} // namespace quadrille_examples

#endif
