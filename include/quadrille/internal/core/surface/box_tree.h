#ifndef QUADRILLE_INTERNAL_CORE_SURFACE_BOX_TREE_H
#define QUADRILLE_INTERNAL_CORE_SURFACE_BOX_TREE_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// A box in space, of floats. If these are coordinates that have been rounded, boxes that meet
/// still do: rounding keeps the order.
struct FloatBox {
  std::array<float, 3> low, high;

  /// Returns a box that contains no point.
  static FloatBox empty() {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    return {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  }
  void add(const std::array<float, 3>& point) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = (std::min)(low[i], point[i]);
      high[i] = (std::max)(high[i], point[i]);
    }
  }
  void add(const FloatBox& other) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = (std::min)(low[i], other.low[i]);
      high[i] = (std::max)(high[i], other.high[i]);
    }
  }
  bool meets(const FloatBox& other) const {
    return low[0] <= other.high[0] && other.low[0] <= high[0] && low[1] <= other.high[1] &&
           other.low[1] <= high[1] && low[2] <= other.high[2] && other.low[2] <= high[2];
  }
  bool contains(const FloatBox& other) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (other.low[i] < low[i] || other.high[i] > high[i])
        return false;
    return true;
  }
  friend bool operator==(const FloatBox&, const FloatBox&) = default;
};

/// Eight boxes, coordinate by coordinate, so that a compiler may compare several at once.
struct EightBoxes {
  static constexpr std::size_t width = 8;
  std::array<std::array<float, width>, 3> low, high;

  /// Empty ones.
  EightBoxes() {
    for (std::size_t lane = 0; lane < width; ++lane)
      set(lane, FloatBox::empty());
  }
  void set(std::size_t lane, const FloatBox& box) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i][lane] = box.low[i];
      high[i][lane] = box.high[i];
    }
  }
  FloatBox box(std::size_t lane) const {
    return {{low[0][lane], low[1][lane], low[2][lane]},
            {high[0][lane], high[1][lane], high[2][lane]}};
  }
  FloatBox around() const {
    FloatBox box;
    for (std::size_t i = 0; i < 3; ++i) {
      box.low[i] = *std::min_element(low[i].begin(), low[i].end());
      box.high[i] = *std::max_element(high[i].begin(), high[i].end());
    }
    return box;
  }
  /// Not zero for those that meet a box.
  std::array<std::int32_t, width> meets(const FloatBox& box) const {
    const auto at_most = [](float a, float b) { return std::int32_t{a <= b}; }; // as wide
    std::array<std::int32_t, width> does;
    for (std::size_t lane = 0; lane < width; ++lane)
      does[lane] = at_most(low[0][lane], box.high[0]) & at_most(box.low[0], high[0][lane]) &
                   at_most(low[1][lane], box.high[1]) & at_most(box.low[1], high[1][lane]) &
                   at_most(low[2][lane], box.high[2]) & at_most(box.low[2], high[2][lane]);
    return does;
  }
};

/// Boxes in a tree: eight neighbours have a box around them, eight of those another one, and so on.
/// They may move, and the boxes around them follow. The tree is about an eighth as large as its
/// leaves, and needs no pointers: box s of a level is in box s/8 of the next one.
class BoxTree {
public:
  static constexpr std::size_t width = EightBoxes::width;

  /// Makes a tree of `size` boxes, which are empty until they are put().
  explicit BoxTree(std::size_t size = 0) {
    while (size > 0) {
      const std::size_t blocks = (size + width - 1) / width;
      levels_.emplace_back(blocks);
      size = blocks > 1 ? blocks : 0;
    }
  }

  FloatBox operator[](std::size_t slot) const {
    return levels_.front()[slot / width].box(slot % width);
  }

  /// Before all boxes have been put, those around them are not kept up to date.
  void put(std::size_t slot, const FloatBox& box) {
    levels_.front()[slot / width].set(slot % width, box);
  }
  void fit() {
    for (std::size_t level = 1; level < levels_.size(); ++level)
      for (std::size_t block = 0; block < levels_[level - 1].size(); ++block)
        levels_[level][block / width].set(block % width, levels_[level - 1][block].around());
  }

  /// In about as many steps as there are levels, or fewer.
  void move(std::size_t slot, const FloatBox& box) {
    put(slot, box);
    for (std::size_t level = 1; level < levels_.size(); ++level) {
      slot /= width;
      const FloatBox around = levels_[level - 1][slot].around();
      EightBoxes& parent = levels_[level][slot / width];
      if (parent.box(slot % width) == around)
        return;
      parent.set(slot % width, around);
    }
  }

  /// The box around those of slots 8b to 8b + 7.
  FloatBox around(std::size_t block) const { return levels_.front()[block].around(); }

  /// Calls visit(slot, box) for each box that meets another one, by slots.
  template <class Visit>
  void for_each_meeting(const FloatBox& box, Visit visit) const {
    any_meeting(box, [&](std::size_t slot, const FloatBox& other) {
      visit(slot, other);
      return false;
    });
  }

  /// Visits boxes until a call returns true; did one?
  template <class Visit>
  bool any_meeting(const FloatBox& box, Visit visit) const {
    return !levels_.empty() && descend(levels_.size() - 1, 0, box, visit);
  }

private:
  template <class Visit>
  bool descend(std::size_t level, std::size_t block, const FloatBox& box, Visit& visit) const {
    const EightBoxes& boxes = levels_[level][block];
    const std::array<std::int32_t, width> meets = boxes.meets(box);
    for (std::size_t lane = 0; lane < width; ++lane) {
      if (!meets[lane])
        continue;
      const std::size_t slot = block * width + lane;
      if (level == 0 ? visit(slot, boxes.box(lane)) : descend(level - 1, slot, box, visit))
        return true;
    }
    return false;
  }

  std::vector<std::vector<EightBoxes>> levels_; // from the boxes themselves to one around them all
};

/// Sorts items so that neighbours come together, where BoxTree wants them: each half of a power of
/// two from the end is on one side of a plane. centre(item) is an array of three numbers.
template <class Item, class Centre>
void sort_for_box_tree(Item* begin, Item* end, Centre centre) {
  while (static_cast<std::size_t>(end - begin) > BoxTree::width) {
    FloatBox box = FloatBox::empty();
    std::for_each(begin, end, [&](const Item& item) { box.add(centre(item)); });
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (box.high[i] - box.low[i] > box.high[axis] - box.low[axis])
        axis = i;
    std::size_t half = BoxTree::width;
    while (2 * half < static_cast<std::size_t>(end - begin))
      half *= 2;
    std::nth_element(begin, begin + half, end, [&](const Item& a, const Item& b) {
      return std::pair(centre(a)[axis], a) < std::pair(centre(b)[axis], b);
    });
    sort_for_box_tree(begin + half, end, centre);
    end = begin + half;
  }
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_SURFACE_BOX_TREE_H
