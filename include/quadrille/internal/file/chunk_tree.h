#ifndef QUADRILLE_INTERNAL_FILE_CHUNK_TREE_H
#define QUADRILLE_INTERNAL_FILE_CHUNK_TREE_H

#include <quadrille/internal/file/cell_counts.h>
#include <quadrille/internal/file/chunk_cut.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Returns the cells of a box for the given number of vertices, fine enough for even chunks of up
/// to `most` vertices: with 2^bits cells along its longest side, a surface meets about the square
/// of that. Their number is limited to a few bytes for each vertex of a chunk; if that is too
/// coarse, see ChunkTree.
inline CellGridOfBox grid_for_chunks(const FileBox& box, std::uint64_t vertices,
                                     std::uint64_t most) {
  const std::uint64_t chunks = vertices / most + 1;
  unsigned bits = 5;
  while (bits < 8 && (std::uint64_t{1} << (2 * bits)) < 256 * chunks &&
         CellGridOfBox(box, bits + 1).size() <= std::max<std::uint64_t>(1U << 21U, 64 * most))
    ++bits;
  return {box, bits};
}

/// Space that is cut into chunks with about equal numbers of vertices, however crowded they are: if
/// a single cell holds more than twice as many vertices as a chunk may have, the box of these
/// vertices has cells of its own, and is cut by itself.
class ChunkTree {
public:
  /// for_points(take) must call take(position) for each vertex; it is called once, and twice for
  /// each level of nested cells.
  template <class ForPoints>
  ChunkTree(const FileBox& box, std::uint64_t vertices, std::uint64_t most, double fraction,
            ForPoints for_points)
      : most_(most), fraction_(fraction) {
    CellCounts cells(grid_for_chunks(box, vertices, most));
    for_points([&](const Vector<3>& p) { cells.add(p); });
    add_node(cells);
    for (unsigned level = 0; level < most_levels && refine(for_points); ++level) {
    }
    number(0);
  }

  std::size_t size() const { return sizes_.size(); }
  /// The number of vertices of each chunk. If more than twice as many vertices as a chunk may have
  /// lie at one position, they are in one chunk nevertheless.
  const std::vector<std::uint64_t>& sizes() const { return sizes_; }
  ChunkNumber chunk_of(const Vector<3>& p) const {
    const Leaf leaf = leaf_of(p);
    return nodes_[leaf.first].numbers[leaf.second];
  }

private:
  static constexpr unsigned most_levels = 12;
  static constexpr std::size_t no_node = static_cast<std::size_t>(-1);

  using Leaf = std::pair<std::size_t, ChunkNumber>; // a node, and a chunk of its cut

  struct Node {
    ChunkCut cut;
    std::vector<std::size_t> finer;   // for each chunk, the node that cuts it, or no_node
    std::vector<ChunkNumber> numbers; // for each chunk that is not cut further
  };

  struct Crowd {
    FileBox box;
    std::vector<CellCounts> cells; // one, once the box is known
  };

  std::size_t add_node(const CellCounts& cells) {
    ChunkCut cut(cells, most_, fraction_);
    const std::size_t size = cut.size();
    nodes_.push_back({std::move(cut), std::vector<std::size_t>(size, no_node), {}});
    return nodes_.size() - 1;
  }

  Leaf leaf_of(const Vector<3>& p) const {
    std::size_t node = 0;
    while (true) {
      const ChunkNumber chunk = nodes_[node].cut.chunk_of(p);
      if (nodes_[node].finer[chunk] == no_node)
        return {node, chunk};
      node = nodes_[node].finer[chunk];
    }
  }

  // Returns false if no leaf is crowded, or if none can be cut.
  template <class ForPoints>
  bool refine(ForPoints for_points) {
    std::map<Leaf, Crowd> crowds;
    for (std::size_t n = 0; n < nodes_.size(); ++n)
      for (std::size_t chunk = 0; chunk < nodes_[n].finer.size(); ++chunk)
        if (nodes_[n].finer[chunk] == no_node && nodes_[n].cut.sizes()[chunk] > 2 * most_)
          crowds[{n, static_cast<ChunkNumber>(chunk)}];
    if (crowds.empty())
      return false;
    const auto for_crowds = [&](auto take) {
      for_points([&](const Vector<3>& p) {
        if (const auto found = crowds.find(leaf_of(p)); found != crowds.end())
          take(found->second, p);
      });
    };
    for_crowds([](Crowd& crowd, const Vector<3>& p) { crowd.box.add(p); });
    for (auto& [leaf, crowd] : crowds)
      crowd.cells.emplace_back(
          grid_for_chunks(crowd.box, nodes_[leaf.first].cut.sizes()[leaf.second], most_));
    for_crowds([](Crowd& crowd, const Vector<3>& p) { crowd.cells.front().add(p); });
    bool is_cut = false;
    for (auto& [leaf, crowd] : crowds)
      if (crowd.cells.front().counts.size() > 1) { // otherwise they lie at one position
        nodes_[leaf.first].finer[leaf.second] = add_node(crowd.cells.front());
        is_cut = true;
      }
    return is_cut;
  }

  void number(std::size_t node) {
    nodes_[node].numbers.resize(nodes_[node].finer.size());
    for (std::size_t chunk = 0; chunk < nodes_[node].finer.size(); ++chunk)
      if (nodes_[node].finer[chunk] != no_node) {
        number(nodes_[node].finer[chunk]);
      } else {
        if (sizes_.size() >= most_chunks)
          throw std::invalid_argument("quadrille::OutOfCore: there would be more than " +
                                      std::to_string(most_chunks) +
                                      " chunks: they have to be larger, which needs more memory");
        nodes_[node].numbers[chunk] = static_cast<ChunkNumber>(sizes_.size());
        sizes_.push_back(nodes_[node].cut.sizes()[chunk]);
      }
  }

  std::uint64_t most_;
  double fraction_;
  std::vector<Node> nodes_; // the first is the whole box
  std::vector<std::uint64_t> sizes_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_CHUNK_TREE_H
