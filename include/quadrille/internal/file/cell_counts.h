#ifndef QUADRILLE_INTERNAL_FILE_CELL_COUNTS_H
#define QUADRILLE_INTERNAL_FILE_CELL_COUNTS_H

#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace quadrille::internal {

/// The least and the greatest coordinates of the points that were added.
struct FileBox {
  Vector<3> low{{(std::numeric_limits<double>::max)(), (std::numeric_limits<double>::max)(),
                 (std::numeric_limits<double>::max)()}};
  Vector<3> high{{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest(),
                  std::numeric_limits<double>::lowest()}};

  void add(const Vector<3>& p) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = (std::min)(low[i], p[i]);
      high[i] = (std::max)(high[i], p[i]);
    }
  }
};

/// A grid of cubes over a box, with 2^bits of them along its longest side and as many as fit along
/// the others. Points outside belong to the cells nearest to them.
class CellGridOfBox {
public:
  CellGridOfBox(const FileBox& box, unsigned bits) : low_(box.low) {
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i)
      longest = (std::max)(longest, box.high[i] - box.low[i]);
    const auto most = static_cast<double>(std::uint64_t{1} << bits);
    per_length_ = longest > 0 ? most / longest : 0;
    for (std::size_t i = 0; i < 3; ++i)
      cells_[i] = 1 + static_cast<std::uint32_t>(
                          (std::min)(most - 1, (box.high[i] - box.low[i]) * per_length_));
  }

  const std::array<std::uint32_t, 3>& cells() const { return cells_; }
  std::size_t size() const { return std::size_t{cells_[0]} * cells_[1] * cells_[2]; }
  std::size_t index(const std::array<std::uint32_t, 3>& cell) const {
    return (std::size_t{cell[2]} * cells_[1] + cell[1]) * cells_[0] + cell[0];
  }
  std::size_t index_of(const Vector<3>& p) const {
    std::array<std::uint32_t, 3> cell;
    for (std::size_t i = 0; i < 3; ++i) {
      const double at = (p[i] - low_[i]) * per_length_;
      const double last = cells_[i] - 1;
      cell[i] = at > 0 ? static_cast<std::uint32_t>((std::min)(at, last)) : 0;
    }
    return index(cell);
  }

private:
  Vector<3> low_;
  double per_length_ = 0; // cells
  std::array<std::uint32_t, 3> cells_;
};

/// The number of vertices in each cell.
struct CellCounts {
  explicit CellCounts(CellGridOfBox cells) : grid(cells), counts(cells.size()) {}

  void add(const Vector<3>& p) { ++counts[grid.index_of(p)]; }

  CellGridOfBox grid;
  std::vector<std::uint32_t> counts;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_CELL_COUNTS_H
