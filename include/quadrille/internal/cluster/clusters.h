#ifndef QUADRILLE_INTERNAL_CLUSTER_CLUSTERS_H
#define QUADRILLE_INTERNAL_CLUSTER_CLUSTERS_H

#include <quadrille/internal/cluster/cell_grid.h>
#include <quadrille/internal/core/base/index.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace quadrille::internal {

/// All bits of the result depend on all bits of x (the finalizer of SplitMix64 by Steele, Lea and
/// Flood, 2014).
constexpr std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EB;
  return x ^ (x >> 31);
}
constexpr std::uint64_t mixed(const std::array<Index, 3>& key) {
  return mixed(mixed(std::uint64_t{key[0]} << 32 | key[1]) ^ key[2]);
}

/// Numbers keys 0, 1, … in the order of their first occurrence, by a hash table that is at most
/// half full. The expected time is O(1) per key; each key takes 8 to 16 bytes in addition to the
/// key itself.
template <class Key>
class DistinctKeys {
public:
  std::size_t size() const { return keys_.size(); }

  /// Returns the number of the key, which is the value of size() before the call if the key is new.
  Index number(const Key& key) {
    if (2 * (keys_.size() + 1) > slots_.size())
      grow();
    Index& slot = slot_of(key);
    if (slot == none) {
      keys_.push_back(key);
      slot = static_cast<Index>(keys_.size() - 1);
    }
    return slot;
  }

  void clear() {
    keys_.clear();
    slots_.clear();
  }

private:
  // Returns the slot of the key, or the empty slot in which it belongs.
  Index& slot_of(const Key& key) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = static_cast<std::size_t>(mixed(key)) & mask;
    while (slots_[at] != none && keys_[slots_[at]] != key)
      at = (at + 1) & mask;
    return slots_[at];
  }

  void grow() {
    slots_.assign(slots_.empty() ? 64 : 2 * slots_.size(), none);
    for (Index i = 0; i < keys_.size(); ++i)
      slot_of(keys_[i]) = i;
  }

  std::vector<Key> keys_;
  std::vector<Index> slots_; // their number is a power of two
};

/// The cells in which a soup has points, and its triangles between three of them. If several
/// triangles have the same three cells, in any order, the first one is kept.
class Clusters {
public:
  /// Ends early as soon as there are more than `most_faces` triangles.
  template <class Soup>
  void assign(const Soup& soup, const CellGrid& grid,
              std::size_t most_faces = (std::numeric_limits<std::size_t>::max)()) {
    assign_cells(soup, grid);
    assign_faces(soup, most_faces);
  }

  std::size_t cell_count() const { return cells_.size(); }
  /// The cell of a point, numbered by the order of the first points of cells; `none` if the point
  /// is not used.
  Index cell(Index point) const { return cell_of_[point]; }

  /// The triangles that are left, by their numbers in the soup.
  const std::vector<Index>& faces() const { return inputs_; }
  /// The number of triangles that were left out because one between the same cells is kept.
  std::size_t doubled_faces() const { return doubled_faces_; }
  /// The number of triangles of the soup that were examined until it ended.
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
        continue; // it vanishes, or had only two different points
      if (triples_.number(triple) == inputs_.size())
        inputs_.push_back(static_cast<Index>(face));
      else
        ++doubled_faces_;
    }
  }

  DistinctKeys<std::uint64_t> cells_;
  std::vector<Index> cell_of_; // for each point
  DistinctKeys<std::array<Index, 3>> triples_;
  std::vector<Index> inputs_;
  std::size_t faces_seen_ = 0, doubled_faces_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CLUSTER_CLUSTERS_H
