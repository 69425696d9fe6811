#ifndef QUADRILLE_INTERNAL_FILE_WRITTEN_VERTICES_H
#define QUADRILLE_INTERNAL_FILE_WRITTEN_VERTICES_H

#include <quadrille/internal/file/disk_file.h>
#include <quadrille/internal/file/ply_header.h>
#include <quadrille/internal/file/rows.h>
#include <quadrille/vector.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace quadrille::internal {

/// Places of the vertices of a file, by their numbers, in any order: blocks of them stay in memory
/// until another one takes their place. Neighbours have mostly close numbers.
class WrittenVertices {
public:
  /// Rows are little-endian and begin with three floats or doubles.
  WrittenVertices(const std::filesystem::path& path, std::uint64_t begin, std::size_t row_size,
                  bool has_doubles, std::uint64_t memory)
      : file_(path), begin_(begin),
        row_size_(row_size), type_{has_doubles ? std::size_t{8} : std::size_t{4}, false, true},
        blocks_(static_cast<std::size_t>(
            std::clamp<std::uint64_t>(memory / (rows_of_block * row_size), 16, 1 << 20))) {}

  Vector<3> position(VertexId v) {
    Block& block = blocks_[v / rows_of_block % blocks_.size()];
    if (block.number != v / rows_of_block || block.bytes.empty())
      load(block, v / rows_of_block);
    const char* const row = block.bytes.data() + v % rows_of_block * row_size_;
    Vector<3> position;
    for (std::size_t i = 0; i < 3; ++i)
      position[i] = number(row + i * type_.size);
    return position;
  }

private:
  static constexpr std::size_t rows_of_block = 1024;
  struct Block {
    std::uint64_t number = 0;
    std::vector<char> bytes;
  };

  double number(const char* bytes) const {
    return std::endian::native == std::endian::big ? ply_number<true>(type_, bytes)
                                                   : ply_number<false>(type_, bytes);
  }

  // The last one is shorter.
  void load(Block& block, std::uint64_t number) const {
    block.number = number;
    block.bytes.resize(rows_of_block * row_size_);
    file_.read_some(begin_ + number * block.bytes.size(), block.bytes.data(), block.bytes.size());
  }

  InputFile file_;
  std::uint64_t begin_;
  std::size_t row_size_;
  PlyType type_;
  std::vector<Block> blocks_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_WRITTEN_VERTICES_H
