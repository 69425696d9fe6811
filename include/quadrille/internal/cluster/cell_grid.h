#ifndef QUADRILLE_INTERNAL_CLUSTER_CELL_GRID_H
#define QUADRILLE_INTERNAL_CLUSTER_CELL_GRID_H

#include <quadrille/internal/core/surface/box.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace quadrille::internal {

/// A box that is cut into equal cells along its axes. A cell includes its lower sides but not its
/// upper ones, except for the last cell along an axis, which includes both.
class CellGrid {
public:
  using Counts = std::array<double, 3>; ///< the numbers of cells along each axis, whole numbers
                                        ///< from 1

  /// Fills the box with that many cells.
  CellGrid(const Box<3>& box, const Counts& counts) : low_(box.low), counts_(counts) {
    for (std::size_t i = 0; i < 3; ++i)
      width_[i] = (box.high[i] - box.low[i]) / counts_[i];
  }

  /// Returns a grid of cubes that begins at the lower corner; the last cubes may reach beyond the
  /// box.
  static CellGrid of_cubes(const Box<3>& box, double edge) {
    edge = (std::min)(edge, 0x1p60); // which holds any box in the engine's unit
    Counts counts;
    for (std::size_t i = 0; i < 3; ++i)
      counts[i] = (std::max)(1.0, std::ceil((box.high[i] - box.low[i]) / edge));
    CellGrid grid(box, counts);
    grid.width_.coordinates.fill(edge);
    return grid;
  }

  /// Can all cells be numbered?
  bool is_numbered() const {
    return std::all_of(counts_.begin(), counts_.end(), [](double n) { return n <= 0x1p52; }) &&
           counts_[0] * counts_[1] * counts_[2] <= 0x1p63;
  }

  /// Returns the number of the cell in which a point of the box lies.
  std::uint64_t number(const Vector<3>& p) const {
    std::uint64_t number = 0;
    for (std::size_t i = 3; i-- > 0;)
      number =
          number * static_cast<std::uint64_t>(counts_[i]) + static_cast<std::uint64_t>(along(i, p));
    return number;
  }

  /// Returns the fraction, from 0 to 1, of the segment from `begin`, in the cell of p, to `end`
  /// that is in that cell.
  double fraction_in_cell_of(const Vector<3>& p, const Vector<3>& begin,
                             const Vector<3>& end) const {
    double fraction = 1;
    for (std::size_t i = 0; i < 3; ++i) {
      const double low = low_[i] + along(i, p) * width_[i];
      const double last = std::clamp(end[i], low, low + width_[i]);
      if (last != end[i])
        fraction = (std::min)(fraction, (last - begin[i]) / (end[i] - begin[i]));
    }
    return (std::max)(fraction, 0.0);
  }

  const Counts& counts() const { return counts_; }
  const Vector<3>& width() const { return width_; } ///< the size of a cell; 0 where the box is flat

private:
  double along(std::size_t i, const Vector<3>& p) const {
    if (!(width_[i] > 0))
      return 0;
    return std::clamp(std::floor((p[i] - low_[i]) / width_[i]), 0.0, counts_[i] - 1);
  }

  Vector<3> low_, width_;
  Counts counts_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CLUSTER_CELL_GRID_H
