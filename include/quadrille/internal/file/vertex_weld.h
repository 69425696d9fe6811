#ifndef QUADRILLE_INTERNAL_FILE_VERTEX_WELD_H
#define QUADRILLE_INTERNAL_FILE_VERTEX_WELD_H

#include <quadrille/internal/file/appended_files.h>
#include <quadrille/internal/file/disk_file.h>
#include <quadrille/internal/file/place_sort.h>
#include <quadrille/internal/file/ply_input.h>
#include <quadrille/internal/file/ply_output.h>
#include <quadrille/internal/file/ply_rows.h>
#include <quadrille/internal/file/rows.h>
#include <quadrille/internal/file/stl_weld.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Makes vertices of a PLY file of loose faces, each of which has vertices of its own, one where
/// they lie at exactly the same place, as StlWeld does with corners. Vertices are in the order of
/// their coordinates then, and faces in that of the file. Time O(n log n).
class VertexWeld {
public:
  /// On the disk at its greatest.
  static std::uint64_t bytes_of_vertex(const PlyInput& input) {
    return input.has_doubles() ? 48 : 32;
  }

  /// Are there several faces whose corners are vertices one after the other, each of them once?
  static bool is_soup(const PlyInput& input) {
    std::uint64_t next = 0;
    bool is_loose = input.faces() > 1;
    if (is_loose)
      PlyRows(input.file(), input.header())
          .for_items(input.face_element(),
                     [&](std::uint64_t, const PlyRows::Row& row, const auto&) {
                       const std::vector<double>& corners = row[input.corners_property()];
                       is_loose = corners.size() >= 3;
                       for (const double corner : corners)
                         is_loose = is_loose && corner == static_cast<double>(next++);
                       return is_loose;
                     });
    return is_loose;
  }

  /// The input is ready to be read, and its vertices have places only. `folder` is for files that
  /// are gone at the end; `ask()` is called at least once a second or so, and may throw.
  template <class Ask>
  static void run(const PlyInput& input, const std::filesystem::path& output,
                  const std::filesystem::path& folder, std::uint64_t memory, const Ask& ask) {
    StlWeld::remove_files(folder);
    std::filesystem::create_directories(folder);
    VertexWeld weld(input, folder, memory);
    WholeFile file(output);
    if (input.has_doubles())
      weld.write<double>(file, ask);
    else
      weld.write<float>(file, ask);
    file.finish();
    StlWeld::remove_files(folder);
  }

private:
  struct Named {
    std::uint32_t vertex; // of the piece of those that there were
    VertexId becomes;
  };

  VertexWeld(const PlyInput& input, std::filesystem::path folder, std::uint64_t memory)
      : input_(input), folder_(std::move(folder)), memory_(memory) {}

  template <class Number, class Ask>
  void write(WholeFile& file, const Ask& ask) {
    PlaceSort<Number> sort(folder_, memory_, input_.vertices());
    input_.for_vertices([&](VertexId v, const Vector<3>& p) {
      if (v % often == 0)
        ask();
      if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
        fail_file(input_.file().path(), "vertex " + std::to_string(v) + " is not finite");
      sort.add({static_cast<Number>(p[0]), static_cast<Number>(p[1]), static_cast<Number>(p[2])},
               v);
    });
    sort.end();
    PlyBytes bytes(file);
    bytes.put_text(header());
    merge(sort, bytes, ask);
    put_faces(bytes, ask);
    bytes.flush();
    const std::string text = header();
    file.write_at_begin(text.data(), text.size());
  }

  // Of the same length for any number of vertices.
  std::string header() const {
    constexpr std::uint64_t any = most_vertex_ids;
    std::string text = ply_header(any, input_.has_doubles(), {}, input_.faces(), input_.labels());
    const std::string digits = std::to_string(vertices_), place = std::to_string(any);
    text.replace(text.find(place), place.size(),
                 std::string(place.size() - digits.size(), '0') + digits);
    return text;
  }

  std::uint64_t piece() const {
    return std::clamp<std::uint64_t>(memory_ / 4 / 12, 1000, 9'000'000);
  }
  std::filesystem::path piece_path(std::uint64_t i) const {
    return folder_ / ("corners-" + std::to_string(i));
  }

  template <class Number, class Ask>
  void merge(PlaceSort<Number>& sort, PlyBytes& bytes, const Ask& ask) {
    std::vector<std::filesystem::path> paths;
    for (std::uint64_t begin = 0; begin < input_.vertices(); begin += piece())
      paths.push_back(piece_path(paths.size()));
    AppendedFiles pieces(paths, memory_ / 4);
    std::uint64_t done = 0;
    sort.for_sorted([&](const typename PlaceSort<Number>::Item& item, bool is_new) {
      if (done++ % often == 0)
        ask();
      if (is_new) {
        ++vertices_;
        for (const Number x : item.position())
          bytes.put(x);
      }
      const Named named{static_cast<std::uint32_t>(item.number() % piece()),
                        static_cast<VertexId>(vertices_ - 1)};
      pieces.add(static_cast<std::size_t>(item.number() / piece()), &named, sizeof(named));
    });
    contents_ = pieces.finish();
  }

  // Corners of faces are vertices one after the other, so pieces are, too.
  template <class Ask>
  void put_faces(PlyBytes& bytes, const Ask& ask) {
    input_.for_faces([&](std::uint64_t f, const FaceRow& corners, const LabelValues& labels) {
      if (f % often == 0)
        ask();
      bytes.put_corners({became(corners[0]), became(corners[1]), became(corners[2])});
      for (std::size_t i = 0; i < labels.size(); ++i)
        bytes.put_integer(input_.labels()[i].type, labels[i]);
    });
  }

  VertexId became(VertexId v) {
    if (loaded_.empty() || v / piece() != loaded_piece_) {
      loaded_piece_ = v / piece();
      const auto named = read_rows<Named>(piece_path(loaded_piece_),
                                          contents_[static_cast<std::size_t>(loaded_piece_)]);
      loaded_.assign(named.size(), 0);
      for (const Named& n : named)
        loaded_[n.vertex] = n.becomes;
    }
    return loaded_[static_cast<std::size_t>(v % piece())];
  }

  // Items between two calls of `ask`.
  static constexpr std::uint64_t often = 1 << 16;

  const PlyInput& input_;
  std::filesystem::path folder_;
  std::uint64_t memory_, vertices_ = 0, loaded_piece_ = 0;
  std::vector<FileContent> contents_; // of the pieces
  std::vector<VertexId> loaded_;      // what vertices of a piece have become
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_VERTEX_WELD_H
