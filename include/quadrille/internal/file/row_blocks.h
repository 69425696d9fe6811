#ifndef QUADRILLE_INTERNAL_FILE_ROW_BLOCKS_H
#define QUADRILLE_INTERNAL_FILE_ROW_BLOCKS_H

#include <quadrille/internal/file/disk_file.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace quadrille::internal {

/// Gives access to rows of a file, all of the same size, by their numbers, in any order: blocks of
/// rows stay in memory until another block takes their place. Neighbours mostly have close numbers.
class RowBlocks {
public:
  /// The first row begins at that byte.
  RowBlocks(const std::filesystem::path& path, std::uint64_t begin, std::size_t row_size,
            std::uint64_t memory)
      : file_(path), begin_(begin), row_size_(row_size),
        blocks_(static_cast<std::size_t>(
            std::clamp<std::uint64_t>(memory / (rows_of_block * row_size), 16, 1 << 20))) {}

  /// Returns the bytes of a row, which stay valid until the next call.
  const char* row(std::uint64_t number) {
    Block& block = blocks_[number / rows_of_block % blocks_.size()];
    if (block.number != number / rows_of_block || block.bytes.empty())
      load(block, number / rows_of_block);
    return block.bytes.data() + number % rows_of_block * row_size_;
  }

private:
  static constexpr std::size_t rows_of_block = 1024;
  struct Block {
    std::uint64_t number = 0;
    std::vector<char> bytes;
  };

  // The last block is shorter.
  void load(Block& block, std::uint64_t number) const {
    block.number = number;
    block.bytes.resize(rows_of_block * row_size_);
    file_.read_some(begin_ + number * block.bytes.size(), block.bytes.data(), block.bytes.size());
  }

  InputFile file_;
  std::uint64_t begin_;
  std::size_t row_size_;
  std::vector<Block> blocks_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_ROW_BLOCKS_H
