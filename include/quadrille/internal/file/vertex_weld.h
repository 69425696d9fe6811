#ifndef QUADRILLE_INTERNAL_FILE_VERTEX_WELD_H
#define QUADRILLE_INTERNAL_FILE_VERTEX_WELD_H

#include <quadrille/internal/core/base/checksum.h>
#include <quadrille/internal/file/appended_files.h>
#include <quadrille/internal/file/disk_file.h>
#include <quadrille/internal/file/id_set.h>
#include <quadrille/internal/file/place_sort.h>
#include <quadrille/internal/file/ply_header.h>
#include <quadrille/internal/file/ply_input.h>
#include <quadrille/internal/file/ply_output.h>
#include <quadrille/internal/file/ply_rows.h>
#include <quadrille/internal/file/row_blocks.h>
#include <quadrille/internal/file/rows.h>
#include <quadrille/internal/file/stl_weld.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Merges vertices of a PLY file that lie at exactly the same position: the first one in the file
/// stays, with its numbers in addition to the position, which must be equal in the others. Nothing
/// else changes its order. Vertices that no face uses stay as they are. It takes O(n log n) and
/// three bits of memory for each vertex, in addition to the given memory.
class VertexWeld {
public:
  /// The greatest size on the disk per vertex.
  static constexpr std::uint64_t bytes_of_vertex(bool has_doubles) { return has_doubles ? 48 : 32; }

  /// Are there several faces whose corners are consecutive vertices, each of them once?
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

  /// The input must be ready to be read. `folder` is for files that are removed at the end; `ask()`
  /// is called about once a second or more often, and may throw.
  template <class Ask>
  static void run(const PlyInput& input, const std::filesystem::path& output,
                  const std::filesystem::path& folder, std::uint64_t memory, const Ask& ask) {
    if (input.vertices() == 0)
      fail_file(input.file().path(), "nothing to simplify: it has no faces");
    StlWeld::remove_files(folder);
    std::filesystem::create_directories(folder);
    VertexWeld weld(input, folder, memory);
    if (input.has_doubles())
      weld.find_firsts<double>(ask);
    else
      weld.find_firsts<float>(ask);
    weld.number_vertices(ask);
    WholeFile file(output);
    weld.write(file, ask);
    file.finish();
    StlWeld::remove_files(folder);
  }

private:
  struct Welded {
    std::uint32_t vertex; // in the section
    VertexId first;       // at its position
  };

  VertexWeld(const PlyInput& input, std::filesystem::path folder, std::uint64_t memory)
      : input_(input), folder_(std::move(folder)), memory_(memory), welded_(input.vertices()) {}

  // Finds the first of the vertices at each position.
  template <class Number, class Ask>
  void find_firsts(const Ask& ask) {
    PlaceSort<Number> sort(folder_, memory_, input_.vertices());
    sort_used(sort, ask);
    std::vector<std::filesystem::path> paths;
    for (std::uint64_t begin = 0; begin < input_.vertices(); begin += batch_size())
      paths.push_back(batch_path(paths.size()));
    AppendedFiles batches(paths, memory_ / 4);
    std::uint64_t done = 0, first = 0;
    sort.for_sorted([&](const typename PlaceSort<Number>::Item& item, bool is_new) {
      if (done++ % often == 0)
        ask();
      if (is_new)
        first = item.number();
      else
        weld(vertex_of(item.number()), first, item.number(), batches);
    });
    contents_ = batches.finish();
  }

  template <class Number, class Ask>
  void sort_used(PlaceSort<Number>& sort, const Ask& ask) const {
    const IdSet used = used_vertices(ask);
    input_.for_vertices([&](VertexId v, const Vector<3>& p, const std::vector<double>& scalars) {
      if (v % often == 0)
        ask();
      if (!used.has(v))
        return;
      if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
        fail_file(input_.file().path(), "vertex " + std::to_string(v) + " is not finite");
      sort.add({static_cast<Number>(p[0]), static_cast<Number>(p[1]), static_cast<Number>(p[2])},
               std::uint64_t{v} << 32 | digest(scalars));
    });
    sort.end();
  }

  template <class Ask>
  IdSet used_vertices(const Ask& ask) const {
    IdSet used(input_.vertices());
    input_.for_faces([&](std::uint64_t f, const FaceRow& corners, const LabelValues&) {
      if (f % often == 0)
        ask();
      if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
        for (const VertexId v : corners)
          used.add(v);
    });
    return used;
  }

  // A vertex is sorted as its number, followed by a digest of its numbers other than the position.
  // Two different sets have the same digest once in 2^32: then the first one's numbers stay.
  static VertexId vertex_of(std::uint64_t sorted) { return static_cast<VertexId>(sorted >> 32); }
  static std::uint32_t digest(const std::vector<double>& scalars) {
    Checksum checksum;
    for (const double x : scalars) {
      const double value = x + 0.0; // turns -0 into 0
      checksum.add(&value, sizeof(value));
    }
    return static_cast<std::uint32_t>(checksum.value());
  }

  void weld(VertexId v, std::uint64_t first, std::uint64_t sorted, AppendedFiles& batches) {
    if (static_cast<std::uint32_t>(first) != static_cast<std::uint32_t>(sorted))
      fail_seam(vertex_of(first), v);
    welded_.add(v);
    const Welded welded{static_cast<std::uint32_t>(v % batch_size()), vertex_of(first)};
    batches.add(static_cast<std::size_t>(v / batch_size()), &welded, sizeof(welded));
  }
  [[noreturn]] void fail_seam(VertexId first, VertexId v) const {
    std::string names;
    for (const PlyProperty& p : input_.scalars().properties())
      names += (names.empty() ? "" : ", ") + p.name;
    fail_file(input_.file().path(),
              "vertices " + std::to_string(first) + " and " + std::to_string(v) +
                  " lie at the same place and differ in " + names +
                  ", so they cannot be merged out of core; 'positions only' leaves it out");
  }

  std::uint64_t batch_size() const {
    return std::clamp<std::uint64_t>(memory_ / 4 / 12, 1000, 9'000'000);
  }
  std::filesystem::path batch_path(std::uint64_t i) const {
    return folder_ / ("corners-" + std::to_string(i));
  }
  std::filesystem::path numbers_path() const { return batch_path(contents_.size()); }

  // Writes the number that each vertex has in the output, one after another.
  template <class Ask>
  void number_vertices(const Ask& ask) {
    const IdRanks welded_before(welded_);
    vertices_ = input_.vertices() - welded_before.size();
    for (std::size_t i = 0; i < contents_.size(); ++i) {
      ask();
      const std::uint64_t begin = i * batch_size();
      std::vector<VertexId> numbers(
          static_cast<std::size_t>((std::min)(batch_size(), input_.vertices() - begin)));
      std::iota(numbers.begin(), numbers.end(), static_cast<VertexId>(begin));
      for (const Welded& w : read_rows<Welded>(batch_path(i), contents_[i]))
        numbers[w.vertex] = w.first;
      for (VertexId& number : numbers)
        number -= static_cast<VertexId>(welded_before(number));
      append_to_file(numbers_path(), numbers.data(), numbers.size() * sizeof(VertexId));
      std::filesystem::remove(batch_path(i));
    }
  }

  template <class Ask>
  void write(WholeFile& file, const Ask& ask) const {
    PlyBytes bytes(file);
    MadeCounts made = input_.header().made;
    made.welded += input_.vertices() - vertices_;
    bytes.put_text(ply_header(vertices_, input_.has_doubles(), input_.scalars().properties(),
                              input_.faces(), input_.labels(), made.comment()));
    put_vertices(bytes, ask);
    put_faces(bytes, ask);
    bytes.flush();
  }

  template <class Ask>
  void put_vertices(PlyBytes& bytes, const Ask& ask) const {
    const PlyType type{input_.has_doubles() ? std::size_t{8} : std::size_t{4}, false, true};
    const std::vector<PlyProperty>& properties = input_.scalars().properties();
    input_.for_vertices([&](VertexId v, const Vector<3>& p, const std::vector<double>& scalars) {
      if (v % often == 0)
        ask();
      if (welded_.has(v))
        return;
      for (std::size_t i = 0; i < 3; ++i)
        bytes.put_as(type, p[i]);
      for (std::size_t i = 0; i < scalars.size(); ++i)
        bytes.put_as(properties[i].type, scalars[i]);
    });
  }

  template <class Ask>
  void put_faces(PlyBytes& bytes, const Ask& ask) const {
    RowBlocks numbers(numbers_path(), 0, sizeof(VertexId), memory_ / 4);
    const auto number = [&](VertexId v) {
      VertexId result = 0;
      std::memcpy(&result, numbers.row(v), sizeof(result));
      return result;
    };
    input_.for_faces([&](std::uint64_t f, const FaceRow& corners, const LabelValues& labels) {
      if (f % often == 0)
        ask();
      bytes.put_corners({number(corners[0]), number(corners[1]), number(corners[2])});
      for (std::size_t i = 0; i < labels.size(); ++i)
        bytes.put_integer(input_.labels()[i].type, labels[i]);
    });
  }

  // The number of items between two calls of `ask`.
  static constexpr std::uint64_t often = 1 << 16;

  const PlyInput& input_;
  std::filesystem::path folder_;
  std::uint64_t memory_, vertices_ = 0; // of the output
  IdSet welded_;                        // merged into another one, and removed
  std::vector<FileContent> contents_;   // of the sections
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_VERTEX_WELD_H
