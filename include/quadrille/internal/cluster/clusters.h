#ifndef QUADRILLE_INTERNAL_CLUSTER_CLUSTERS_H
#define QUADRILLE_INTERNAL_CLUSTER_CLUSTERS_H

#include <quadrille/internal/cluster/cell_grid.h>
#include <quadrille/internal/cluster/distinct_keys.h>
#include <quadrille/internal/core/base/index.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace quadrille::internal {

/// The cells in which a soup has points, and its triangles between three of them: of those with the
/// same three, in any order, the first.
class Clusters {
public:
  /// Ends early once there are more than `most_faces` triangles.
  template <class Soup>
  void assign(const Soup& soup, const CellGrid& grid,
              std::size_t most_faces = (std::numeric_limits<std::size_t>::max)()) {
    assign_cells(soup, grid);
    assign_faces(soup, most_faces);
  }

  std::size_t cell_count() const { return cells_.size(); }
  /// Of a point, by the order of the first points of cells; `none` if the point is not used.
  Index cell(Index point) const { return cell_of_[point]; }

  /// The triangles that are left, by their numbers in the soup.
  const std::vector<Index>& faces() const { return inputs_; }
  /// How many were left out because one between the same cells is left.
  std::size_t doubled_faces() const { return doubled_faces_; }
  /// How many triangles of the soup were looked at until it ended.
  std::size_t faces_seen() const { return faces_seen_; }

private:
  template <class Soup>
  void assign_cells(const Soup& soup, const CellGrid& grid) {
    cells_.clear();
    cell_of_.assign(soup.point_count(), none);
    for (std::size_t v = 0; v < soup.point_count(); ++v)
      if (soup.is_used(v))
        cell_of_[v] = cells_.number(grid.number(soup.position(v)));
  }

  template <class Soup>
  void assign_faces(const Soup& soup, std::size_t most) {
    triples_.clear();
    inputs_.clear();
    faces_seen_ = doubled_faces_ = 0;
    while (faces_seen_ < soup.triangle_count() && inputs_.size() <= most) {
      const std::size_t face = faces_seen_++;
      auto triple = soup.corners(face);
      for (Index& corner : triple)
        corner = cell_of_[corner];
      std::sort(triple.begin(), triple.end());
      if (triple[0] == triple[1] || triple[1] == triple[2] || triple[2] == none)
        continue; // it vanishes, or has been a triangle of two points
      if (triples_.number(triple) == inputs_.size())
        inputs_.push_back(static_cast<Index>(face));
      else
        ++doubled_faces_;
    }
  }

  DistinctKeys<std::uint64_t> cells_;
  std::vector<Index> cell_of_; // of each point
  DistinctKeys<std::array<Index, 3>> triples_;
  std::vector<Index> inputs_;
  std::size_t faces_seen_ = 0, doubled_faces_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CLUSTER_CLUSTERS_H
