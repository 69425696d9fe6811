#ifndef QUADRILLE_INTERNAL_FILE_STL_WELD_H
#define QUADRILLE_INTERNAL_FILE_STL_WELD_H

#include <quadrille/internal/file/appended_files.h>
#include <quadrille/internal/file/byte_stream.h>
#include <quadrille/internal/file/disk_file.h>
#include <quadrille/internal/file/job_folder.h>
#include <quadrille/internal/file/place_sort.h>
#include <quadrille/internal/file/ply_header.h>
#include <quadrille/internal/file/rows.h>
#include <quadrille/internal/file/stl_facets.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Merges the corners of a binary STL file that lie at exactly the same position into one vertex,
/// and writes the surface as binary PLY: faces in the order of the file, vertices sorted by their
/// coordinates. It uses an external merge sort (Knuth, The Art of Computer Programming, volume 3,
/// section 5.4): corners are sorted in runs that fit into memory, the runs are merged, and the
/// number of each corner's vertex is written to the section of the file that contains the corner.
/// It takes O(n log n), and five times the size of the file on the disk.
class StlWeld {
public:
  /// `folder` is for files that are removed at the end; `memory` is in bytes. Colours of faces, in
  /// the bytes after each, are rejected unless only positions are requested. `ask()` is called
  /// about once a second or more often, and may throw.
  template <class Ask>
  static void run(const std::filesystem::path& input, const std::filesystem::path& output,
                  const std::filesystem::path& folder, std::uint64_t memory, bool positions_only,
                  const Ask& ask) {
    remove_files(folder);
    std::filesystem::create_directories(folder);
    StlWeld weld(input, folder, memory);
    weld.sort_corners(positions_only, ask);
    WholeFile file(output);
    weld.merge_runs(file, ask);
    weld.write_faces(file, ask);
    file.finish();
    remove_files(folder);
  }
  /// Removes the files, including those of a killed run, and the folder if nothing else is in it.
  static void remove_files(const std::filesystem::path& folder) {
    remove_job_files(folder, {"run", "corners"});
  }

  /// The greatest size on the disk per face: corners in runs, then in sections.
  static constexpr std::uint64_t bytes_of_face = 90;

  /// The number of faces according to the header.
  static std::uint64_t faces(const std::filesystem::path& input) {
    return count_faces(InputFile(input));
  }

  /// Throws std::runtime_error if the size of a file does not match its face count, or if its
  /// header names a colour, unless only positions are requested.
  static void require_readable(const std::filesystem::path& input, bool positions_only) {
    const InputFile file(input);
    if (count_faces(file) == 0)
      fail_file(input, "nothing to simplify: it has no faces");
    std::string header(stl_header_size, '\0');
    file.read(0, header.data(), header.size());
    if (!positions_only && names_stl_color(header))
      fail_colors(input);
  }

private:
  struct Named {
    std::uint32_t corner; // in the section
    VertexId vertex;
  };

  StlWeld(const std::filesystem::path& input, std::filesystem::path folder, std::uint64_t memory)
      : file_(input), folder_(std::move(folder)), memory_(memory), faces_(count_faces(file_)),
        corners_(folder_, memory, 3 * faces_) {}

  static std::uint64_t count_faces(const InputFile& file) {
    std::string header(stl_header_size, '\0');
    const std::size_t got = file.read_some(0, header.data(), header.size());
    const std::uint64_t faces = stl_facet_count(header);
    const std::uint64_t size = stl_header_size + stl_facet_size * faces;
    if (got == header.size() && file.size() == size)
      return faces;
    if (header.starts_with("solid"))
      fail_file(file.path(), "is a text file; out of core, only binary STL is read");
    fail_file(file.path(), got < header.size()
                               ? "ends within the 84 bytes that a binary STL file begins with"
                               : "has " + std::to_string(file.size()) + " bytes; with " +
                                     std::to_string(faces) + " faces it would have " +
                                     std::to_string(size));
  }

  [[noreturn]] static void fail_colors(const std::filesystem::path& path) {
    fail_file(path,
              "has colours of faces, which cannot be kept out of core; 'positions only' leaves "
              "them out");
  }

  // The number of steps between two calls of `ask`.
  static constexpr std::uint64_t often = 1 << 16;

  template <class Ask>
  void sort_corners(bool positions_only, const Ask& ask) {
    ByteStream stream(file_, stl_header_size);
    for (std::uint64_t face = 0; face < faces_; ++face) {
      const char* const row = stream.next(stl_facet_size);
      if (!row)
        fail_file(file_.path(), "ends within face " + std::to_string(face));
      if (face % often == 0)
        ask();
      const StlFacet facet({row, stl_facet_size});
      if (!positions_only && is_stl_color(facet.attribute, false)) // the header names none
        fail_colors(file_.path());
      for (std::uint64_t i = 0; i < 3; ++i) {
        require_finite(facet.points[i], face);
        corners_.add(facet.points[i], 3 * face + i);
      }
    }
    corners_.end();
  }

  void require_finite(const std::array<float, 3>& point, std::uint64_t face) const {
    for (const float x : point)
      if (!std::isfinite(x))
        fail_file(file_.path(),
                  "face " + std::to_string(face) + " has a corner that is not finite");
  }

  // The number of corners in a section of the file, a multiple of three.
  std::uint64_t batch_size() const {
    return std::clamp<std::uint64_t>(memory_ / 4 / 12, 100, most_sorted / 3) * 3;
  }
  std::filesystem::path batch_path(std::size_t i) const {
    return folder_ / ("corners-" + std::to_string(i));
  }

  template <class Ask>
  void merge_runs(WholeFile& file, const Ask& ask) {
    std::vector<std::filesystem::path> paths;
    for (std::uint64_t begin = 0; begin < 3 * faces_; begin += batch_size())
      paths.push_back(batch_path(paths.size()));
    AppendedFiles batches(paths, memory_ / 4);
    std::string text = header(0);
    file.write(text.data(), text.size());
    std::vector<char> buffer;
    std::uint64_t corners = 0;
    corners_.for_sorted([&](const PlaceSort<float>::Item& c, bool is_new) {
      if (corners++ % often == 0)
        ask();
      if (is_new)
        put_vertex(buffer, c.position());
      const Named named{static_cast<std::uint32_t>(c.number() % batch_size()),
                        static_cast<VertexId>(vertices_ - 1)};
      batches.add(static_cast<std::size_t>(c.number() / batch_size()), &named, sizeof(named));
      if (buffer.size() >= (1 << 20))
        flush(buffer, file);
    });
    flush(buffer, file);
    contents_ = batches.finish();
    text = header(vertices_);
    file.write_at_begin(text.data(), text.size());
  }

  void put_vertex(std::vector<char>& buffer, const std::array<float, 3>& position) {
    if (vertices_++ == most_vertex_ids)
      fail_file(file_.path(), "has more vertices than the indices of faces can express");
    for (const float x : position) {
      const auto bytes = std::bit_cast<std::array<char, 4>>(x);
      buffer.insert(buffer.end(), bytes.begin(), bytes.end());
    }
  }

  static void flush(std::vector<char>& buffer, WholeFile& file) {
    file.write(buffer.data(), buffer.size());
    buffer.clear();
  }

  // The header has the same length for any number of vertices, and the byte order of this machine.
  std::string header(std::uint64_t vertices) const {
    const std::string digits = std::to_string(vertices);
    const bool is_big = std::endian::native == std::endian::big;
    return std::string("ply\nformat binary_") + (is_big ? "big" : "little") + "_endian 1.0\n" +
           MadeCounts{.welded = 3 * faces_ - vertices}.comment() + "element vertex " +
           std::string(12 - digits.size(), '0') + digits +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
           std::to_string(faces_) + "\nproperty list uchar uint vertex_indices\nend_header\n";
  }

  template <class Ask>
  void write_faces(WholeFile& file, const Ask& ask) const {
    std::vector<char> buffer;
    for (std::size_t i = 0; i < contents_.size(); ++i) {
      ask();
      const auto named = read_rows<Named>(batch_path(i), contents_[i]);
      std::vector<VertexId> vertices(named.size());
      for (const Named& n : named)
        vertices[n.corner] = n.vertex;
      for (std::size_t c = 0; c < vertices.size(); c += 3) {
        buffer.push_back(3);
        const char* const corners = reinterpret_cast<const char*>(&vertices[c]);
        buffer.insert(buffer.end(), corners, corners + 12);
        if (buffer.size() >= (1 << 20))
          flush(buffer, file);
      }
      std::filesystem::remove(batch_path(i));
    }
    flush(buffer, file);
  }

  static constexpr std::uint64_t most_sorted = 9'000'000; // corners

  InputFile file_;
  std::filesystem::path folder_;
  std::uint64_t memory_, faces_, vertices_ = 0;
  PlaceSort<float> corners_;
  std::vector<FileContent> contents_; // of the sections
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_STL_WELD_H
