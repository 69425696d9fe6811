#ifndef QUADRILLE_INTERNAL_FILE_CHUNK_CUT_H
#define QUADRILLE_INTERNAL_FILE_CHUNK_CUT_H

#include <quadrille/internal/file/cell_counts.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The number of a chunk, at most 65,535.
using ChunkNumber = std::uint16_t;
inline constexpr std::size_t most_chunks = 0xFFFF;

/// Space that is cut into chunks with about equal numbers of vertices, by a kd-tree (Bentley 1975)
/// over a histogram: integers decide everything, so the result is the same on any machine.
///
/// A box of cells is cut across its longest side, where the number of vertices on one side is
/// closest to `fraction` of all, and its halves are cut again until each has at most `most`
/// vertices. If the next cut uses another fraction, the boundaries of the last one lie inside
/// chunks, except where both cross.
class ChunkCut {
public:
  ChunkCut(const CellCounts& cells, std::uint64_t most, double fraction)
      : grid_(cells.grid), chunks_(cells.counts.size()) {
    Cut cut{cells, most, fraction, chunks_};
    cut.run({{0, 0, 0}, cells.grid.cells()});
    sizes_ = std::move(cut.sizes);
  }

  std::size_t size() const { return sizes_.size(); }
  /// The number of vertices of each chunk.
  const std::vector<std::uint64_t>& sizes() const { return sizes_; }
  ChunkNumber chunk_of(const Vector<3>& p) const { return chunks_[grid_.index_of(p)]; }

private:
  using Cell = std::array<std::uint32_t, 3>;
  struct Cells {
    Cell begin, end;
  };

  struct Cut {
    const CellCounts& cells;
    std::uint64_t most;
    double fraction;
    std::vector<ChunkNumber>& chunks;
    std::vector<std::uint64_t> sizes = {};

    // The lower side and the upper one have the fraction in turn, so that the small chunks are not
    // all at the corners of the box.
    void run(const Cells& box, bool is_mirrored = false) {
      const std::size_t axis = longest(box);
      const std::vector<std::uint64_t> counts = counts_along(box, axis);
      std::uint64_t all = 0;
      for (const std::uint64_t n : counts)
        all += n;
      if (all <= most || counts.size() < 2)
        return give_number(box, all);
      const std::uint32_t at = place(counts, all, is_mirrored ? 1 - fraction : fraction);
      Cells lower = box, upper = box;
      lower.end[axis] = upper.begin[axis] = box.begin[axis] + at;
      run(lower, !is_mirrored);
      run(upper, !is_mirrored);
    }

    static std::size_t longest(const Cells& box) {
      std::size_t axis = 0;
      for (std::size_t i = 1; i < 3; ++i)
        if (box.end[i] - box.begin[i] > box.end[axis] - box.begin[axis])
          axis = i;
      return axis;
    }

    template <class Visit>
    void for_cells(const Cells& box, Visit visit) const {
      Cell c;
      for (c[2] = box.begin[2]; c[2] < box.end[2]; ++c[2])
        for (c[1] = box.begin[1]; c[1] < box.end[1]; ++c[1])
          for (c[0] = box.begin[0]; c[0] < box.end[0]; ++c[0])
            visit(c, cells.grid.index(c));
    }

    std::vector<std::uint64_t> counts_along(const Cells& box, std::size_t axis) const {
      std::vector<std::uint64_t> counts(box.end[axis] - box.begin[axis]);
      for_cells(box, [&](const Cell& c, std::size_t i) {
        counts[c[axis] - box.begin[axis]] += cells.counts[i];
      });
      return counts;
    }

    // Returns the number of layers before the cut.
    static std::uint32_t place(const std::vector<std::uint64_t>& counts, std::uint64_t all,
                               double fraction) {
      const auto wanted = static_cast<std::uint64_t>(fraction * static_cast<double>(all));
      std::uint64_t below = 0;
      std::uint32_t at = 0;
      while (at + 2 < counts.size() && below + counts[at] / 2 < wanted)
        below += counts[at++];
      return (std::max)(at, 1U);
    }

    void give_number(const Cells& box, std::uint64_t all) {
      if (all == 0)
        return; // only points that have moved lie in its cells, and chunk 0 takes them
      for_cells(box, [&](const Cell&, std::size_t i) {
        chunks[i] = static_cast<ChunkNumber>(sizes.size());
      });
      sizes.push_back(all);
      if (sizes.size() > most_chunks)
        throw std::invalid_argument("quadrille::OutOfCore: there would be more than " +
                                    std::to_string(most_chunks) +
                                    " chunks: they have to be larger, which needs more memory");
    }
  };

  CellGridOfBox grid_;
  std::vector<ChunkNumber> chunks_; // of each cell
  std::vector<std::uint64_t> sizes_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_CHUNK_CUT_H
