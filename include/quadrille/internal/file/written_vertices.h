#ifndef QUADRILLE_INTERNAL_FILE_WRITTEN_VERTICES_H
#define QUADRILLE_INTERNAL_FILE_WRITTEN_VERTICES_H

#include <quadrille/internal/file/ply_header.h>
#include <quadrille/internal/file/row_blocks.h>
#include <quadrille/internal/file/rows.h>
#include <quadrille/quadric_form.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace quadrille::internal {

/// The positions of the vertices of a file, by their numbers, in any order: see RowBlocks.
class WrittenVertices {
public:
  /// Rows are little-endian and begin with three floats or doubles.
  WrittenVertices(const std::filesystem::path& path, std::uint64_t begin, std::size_t row_size,
                  bool has_doubles, std::uint64_t memory)
      : rows_(path, begin, row_size, memory), type_{has_doubles ? std::size_t{8} : std::size_t{4},
                                                    false, true} {}

  Vector<3> position(VertexId v) {
    const char* const row = rows_.row(v);
    Vector<3> position;
    for (std::size_t i = 0; i < 3; ++i)
      position[i] = number(row + i * type_.size);
    return position;
  }

private:
  double number(const char* bytes) const {
    return std::endian::native == std::endian::big ? ply_number<true>(type_, bytes)
                                                   : ply_number<false>(type_, bytes);
  }

  RowBlocks rows_;
  PlyType type_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_WRITTEN_VERTICES_H
