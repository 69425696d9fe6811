#ifndef QUADRILLE_INTERNAL_FILE_TILE_SPLIT_H
#define QUADRILLE_INTERNAL_FILE_TILE_SPLIT_H

#include <quadrille/internal/file/appended_files.h>
#include <quadrille/internal/file/chunk_scatter.h>
#include <quadrille/internal/file/ply_input.h>
#include <quadrille/internal/file/ply_output.h>
#include <quadrille/internal/file/tile_merge.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

namespace quadrille::internal {

/// Splits a surface into the tiles from which TileMerge made it. Boundary vertices have the same
/// bits in all tiles.
class TileSplit {
public:
  /// `folder` is for files that are removed at the end. Returns the number of written bytes.
  static std::uint64_t run(const std::filesystem::path& surface,
                           const std::vector<std::filesystem::path>& tiles,
                           const std::filesystem::path& folder, std::uint64_t memory) {
    remove_job_files(folder, {"run", "corners"});
    std::filesystem::create_directories(folder);
    const PlyInput input(surface);
    TileSplit split(input, tiles.size(), folder, memory);
    split.give_faces();
    split.give_vertices();
    std::uint64_t written = 0;
    for (std::size_t t = 0; t < tiles.size(); ++t)
      written += split.write(t, tiles[t]);
    remove_job_files(folder, {"run", "corners"});
    return written;
  }

private:
  TileSplit(const PlyInput& input, std::size_t tiles, const std::filesystem::path& folder,
            std::uint64_t memory)
      : input_(input), paths_of_faces_(paths(folder / "corners", tiles)),
        paths_of_vertices_(paths(folder / "run", tiles)), faces_(paths_of_faces_, memory / 2),
        vertices_(paths_of_vertices_, memory / 2) {
    const std::vector<PlyProperty>& labels = input.labels();
    while (labels[tile_].name != tile_property)
      ++tile_;
  }

  static std::vector<std::filesystem::path> paths(const std::filesystem::path& stem,
                                                  std::size_t count) {
    std::vector<std::filesystem::path> result;
    for (std::size_t i = 0; i < count; ++i)
      result.push_back(stem.string() + "-" + std::to_string(i));
    return result;
  }

  void give_faces() {
    input_.for_faces([&](std::uint64_t, const FaceRow& face, const LabelValues& values) {
      const auto tile = static_cast<ChunkNumber>(values[tile_]);
      faces_.add(tile, face.data(), sizeof(face));
      faces_.add(tile, values.data(), values.size() * sizeof(values[0]));
      for (const VertexId corner : face)
        requests_.add({corner, tile});
    });
    requests_.sort();
    contents_of_faces_ = faces_.finish();
  }

  void give_vertices() {
    input_.for_vertices([&](VertexId v, const Vector<3>& p, const std::vector<double>& scalars) {
      const VertexRow row{v, 0, p};
      requests_.for_chunks(v, [&](ChunkNumber tile) {
        vertices_.add(tile, &row, sizeof(row));
        vertices_.add(tile, scalars.data(), scalars.size() * sizeof(double));
      });
    });
    contents_of_vertices_ = vertices_.finish();
  }

  std::uint64_t write(std::size_t tile, const std::filesystem::path& path) const {
    const std::size_t scalars = input_.scalars().size(), labels = input_.labels().size();
    const std::size_t vertex_size = sizeof(VertexRow) + scalars * sizeof(double);
    const std::size_t face_size = sizeof(FaceRow) + labels * sizeof(std::int64_t);
    const auto vertices = read_rows<char>(paths_of_vertices_[tile], contents_of_vertices_[tile]);
    const auto faces = read_rows<char>(paths_of_faces_[tile], contents_of_faces_[tile]);
    WholeFile file(path);
    PlyBytes bytes(file);
    std::vector<PlyProperty> of_faces = input_.labels();
    of_faces.erase(of_faces.begin() + static_cast<std::ptrdiff_t>(tile_));
    bytes.put_text(ply_header(vertices.size() / vertex_size, input_.has_doubles(),
                              input_.scalars().properties(), faces.size() / face_size, of_faces));
    std::vector<VertexId> ids;
    for (const char* at = vertices.data(); at != vertices.data() + vertices.size();
         at += vertex_size)
      ids.push_back(put_vertex(at, bytes));
    for (const char* at = faces.data(); at != faces.data() + faces.size(); at += face_size)
      put_face(at, ids, bytes);
    bytes.flush();
    file.finish();
    return file.written();
  }

  VertexId put_vertex(const char* from, PlyBytes& bytes) const {
    VertexRow row;
    std::memcpy(&row, from, sizeof(row));
    const PlyType number{input_.has_doubles() ? std::size_t{8} : std::size_t{4}, false, true};
    for (std::size_t i = 0; i < 3; ++i)
      bytes.put_as(number, row.position[i]);
    from += sizeof(row);
    for (const PlyProperty& property : input_.scalars().properties()) {
      double value = 0;
      std::memcpy(&value, from, sizeof(value));
      bytes.put_as(property.type, value);
      from += sizeof(value);
    }
    return row.id;
  }

  void put_face(const char* from, const std::vector<VertexId>& ids, PlyBytes& bytes) const {
    FaceRow face;
    std::memcpy(face.data(), from, sizeof(face));
    std::array<std::uint64_t, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = static_cast<std::uint64_t>(std::lower_bound(ids.begin(), ids.end(), face[i]) -
                                              ids.begin());
    bytes.put_corners(corners);
    for (std::size_t i = 0; i < input_.labels().size(); ++i) {
      std::int64_t value = 0;
      std::memcpy(&value, from + sizeof(face) + i * sizeof(value), sizeof(value));
      if (i != tile_)
        bytes.put_integer(input_.labels()[i].type, value);
    }
  }

  const PlyInput& input_;
  std::vector<std::filesystem::path> paths_of_faces_, paths_of_vertices_;
  AppendedFiles faces_, vertices_;
  std::vector<FileContent> contents_of_faces_, contents_of_vertices_;
  std::size_t tile_ = 0; // the index of its property among the labels
  Requests requests_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_TILE_SPLIT_H
