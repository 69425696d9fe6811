#ifndef QUADRILLE_INTERNAL_CLUSTER_FACE_COUNT_SEARCH_H
#define QUADRILLE_INTERNAL_CLUSTER_FACE_COUNT_SEARCH_H

#include <quadrille/internal/cluster/cell_grid.h>
#include <quadrille/internal/cluster/clusters.h>
#include <quadrille/internal/core/surface/box.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace quadrille::internal {

/// Searches for a fine grid of cubes that leaves at most that many faces.
///
/// The number of faces of a surface grows about as the square of the number of cells along a side.
/// So the next grid is estimated from the previous one, which takes two to four steps; after ten
/// steps the interval is bisected.
class FaceCountSearch {
public:
  /// The contents of `clusters` afterwards are not a result, but memory that can be reused. With
  /// one more cell along the longest side of the box there would be more than `most` faces, or the
  /// grid has 2²⁰ cells, which is the maximum.
  template <class Soup>
  static CellGrid grid(const Soup& soup, std::size_t most, Clusters& clusters) {
    const Box<3> box = soup.box();
    const std::size_t all = soup.triangle_count();
    FaceCountSearch search(all <= most ? finest : std::sqrt(static_cast<double>(most) / 6));
    for (int step = 0; !search.is_done(); ++step) {
      const std::uint64_t cells = step < 10 ? search.estimated() : search.halved();
      clusters.assign(soup, cubes_along(box, cells), most);
      const std::size_t faces = clusters.faces().size();
      const double fraction = static_cast<double>(clusters.faces_seen()) / static_cast<double>(all);
      search.note(cells, faces <= most,
                  static_cast<double>(most) * fraction / static_cast<double>(faces));
    }
    return cubes_along(box, search.fitting_);
  }

private:
  static constexpr std::uint64_t finest = 1 << 20;

  explicit FaceCountSearch(double estimate) : estimate_(estimate) {}

  static CellGrid cubes_along(const Box<3>& box, std::uint64_t cells) {
    const double half = (std::max)({box.half_extent(0), box.half_extent(1), box.half_extent(2)});
    return CellGrid::of_cubes(box, 2 * half / static_cast<double>(cells));
  }

  bool is_done() const { return too_fine_ - fitting_ <= 1; }
  std::uint64_t halved() const { return fitting_ + (too_fine_ - fitting_) / 2; }

  // Returns a count between the known bounds; the coarsest grid if there is no estimate, which is
  // NaN then.
  std::uint64_t estimated() const {
    const auto low = static_cast<double>(fitting_ + 1), high = static_cast<double>(too_fine_ - 1);
    return static_cast<std::uint64_t>(estimate_ >= low ? (std::min)(estimate_, high) : low);
  }

  // `growth` is the ratio by which the number of faces may grow.
  void note(std::uint64_t cells, bool fits, double growth) {
    (fits ? fitting_ : too_fine_) = cells;
    estimate_ = static_cast<double>(cells) * std::sqrt(growth);
  }

  double estimate_;
  std::uint64_t fitting_ = 1, too_fine_ = finest + 1; // cells along the longest side
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CLUSTER_FACE_COUNT_SEARCH_H
