#ifndef QUADRILLE_INTERNAL_FILE_TRUE_BOUNDARIES_H
#define QUADRILLE_INTERNAL_FILE_TRUE_BOUNDARIES_H

#include <quadrille/internal/file/appended_files.h>
#include <quadrille/internal/file/byte_stream.h>
#include <quadrille/internal/file/id_set.h>
#include <quadrille/internal/file/job_folder.h>
#include <quadrille/internal/file/rows.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace quadrille::internal {

/// Edges of one face with both ends shared by chunks. No chunk can distinguish them from edges
/// where it meets another chunk; of every other edge a chunk has all faces.
class TrueBoundaries {
public:
  /// Reads the faces of all chunks of a phase, and writes the edges to its file.
  static FileContent write(const JobFolder& folder, unsigned phase, std::size_t chunks,
                           const IdSet& shared) {
    TrueBoundaries boundaries(shared);
    for (std::size_t p = 0; p < chunks; ++p)
      boundaries.read(folder.faces(phase, p));
    boundaries.leave_single();
    AppendedFiles file({folder.boundaries(phase)}, 1 << 20);
    for (const std::uint64_t edge : boundaries.edges_)
      file.add(0, &edge, sizeof(edge));
    return file.finish().front();
  }

private:
  explicit TrueBoundaries(const IdSet& shared) : shared_(shared) {}

  void read(const std::filesystem::path& path) {
    const InputFile file(path);
    ByteStream stream(file, 0);
    while (const char* const bytes = stream.next(sizeof(FaceRow))) {
      FaceRow face;
      std::memcpy(face.data(), bytes, sizeof(face));
      const std::array is_shared{shared_.has(face[0]), shared_.has(face[1]), shared_.has(face[2])};
      for (std::size_t i = 0; i < 3; ++i)
        if (is_shared[i] && is_shared[(i + 1) % 3])
          add(face[i], face[(i + 1) % 3]);
    }
  }

  void add(VertexId a, VertexId b) {
    edges_.push_back(std::uint64_t{(std::min)(a, b)} << 32 | (std::max)(a, b));
  }

  // An edge that occurs twice has two faces, in whatever chunks these are.
  void leave_single() {
    std::sort(edges_.begin(), edges_.end());
    std::size_t kept = 0;
    for (std::size_t i = 0; i < edges_.size();) {
      std::size_t end = i + 1;
      while (end < edges_.size() && edges_[end] == edges_[i])
        ++end;
      if (end == i + 1)
        edges_[kept++] = edges_[i];
      i = end;
    }
    edges_.resize(kept);
  }

  const IdSet& shared_;
  std::vector<std::uint64_t> edges_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_TRUE_BOUNDARIES_H
