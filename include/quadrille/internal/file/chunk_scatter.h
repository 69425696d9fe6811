#ifndef QUADRILLE_INTERNAL_FILE_CHUNK_SCATTER_H
#define QUADRILLE_INTERNAL_FILE_CHUNK_SCATTER_H

#include <quadrille/internal/core/surface/face_bound.h>
#include <quadrille/internal/file/appended_files.h>
#include <quadrille/internal/file/chunk_cut.h>
#include <quadrille/internal/file/doubled_rows.h>
#include <quadrille/internal/file/id_set.h>
#include <quadrille/internal/file/job_folder.h>
#include <quadrille/internal/file/phase_plan.h>
#include <quadrille/internal/file/rows.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace quadrille::internal {

/// A vertex, and a chunk that needs it although it lies in another one.
struct Request {
  VertexId vertex; ///< by any numbering
  ChunkNumber chunk;

  friend auto operator<=>(const Request&, const Request&) = default;
};

/// A list of requests, each of them once.
class Requests {
public:
  void add(Request request) {
    if (!requests_.empty() && requests_.back() == request)
      return;
    requests_.push_back(request);
    if (requests_.size() >= limit_) {
      sort();
      limit_ = (std::max)(limit_, 2 * requests_.size());
    }
  }
  /// Calls take(chunk) for each chunk that requests the vertex. Vertices must come in ascending
  /// order, after sort().
  template <class Take>
  void for_chunks(VertexId vertex, Take take) {
    for (; next_ < requests_.size() && requests_[next_].vertex <= vertex; ++next_)
      if (requests_[next_].vertex == vertex)
        take(requests_[next_].chunk);
  }
  void sort() {
    std::sort(requests_.begin(), requests_.end());
    requests_.erase(std::unique(requests_.begin(), requests_.end()), requests_.end());
  }

private:
  std::vector<Request> requests_;
  std::size_t limit_ = 1 << 20, next_ = 0;
};

/// Writes faces and vertices to the files of the chunks of a phase. A face belongs to the lowest of
/// the chunks in which its corners lie; a vertex belongs to the chunk in which it lies, and to the
/// chunks of its faces. It is shared if one of its faces is in another chunk than the vertex.
class ChunkScatter {
public:
  ChunkScatter(const JobFolder& folder, unsigned phase, std::size_t chunks, std::uint64_t ids,
               std::uint64_t memory, bool has_labels, bool has_bounds)
      : folder_(folder), phase_(phase), faces_(paths(chunks, &JobFolder::faces), memory),
        vertices_(paths(chunks, &JobFolder::vertices), memory),
        labels_(paths(has_labels ? chunks : 0, &JobFolder::labels), memory),
        bounds_(paths(has_bounds ? chunks : 0, &JobFolder::bounds), memory), shared_(ids),
        chunks_(chunks), has_labels_(has_labels), has_bounds_(has_bounds) {}

  /// `homes` are the chunks in which the corners lie; request(i, chunk) is called for a corner i
  /// that another chunk must be given.
  template <class Ask>
  void add_face(const FaceRow& corners, const std::array<ChunkNumber, 3>& homes,
                std::uint32_t label, const FaceBound& bound, Ask request) {
    const ChunkNumber chunk = (std::min)({homes[0], homes[1], homes[2]});
    faces_.add(chunk, corners.data(), sizeof(corners));
    if (has_labels_)
      labels_.add(chunk, &label, sizeof(label));
    if (has_bounds_)
      bounds_.add(chunk, &bound, sizeof(bound));
    for (std::size_t i = 0; i < 3; ++i)
      if (homes[i] != chunk) {
        shared_.add(corners[i]);
        request(i, chunk);
      }
  }

  /// Must be called after all faces have been added.
  void end_faces() {
    const std::vector<FileContent> contents = faces_.finish();
    for (std::size_t p = 0; p < chunks_.size(); ++p)
      chunks_[p].faces = contents[p];
    const std::vector<FileContent> labels = labels_.finish();
    for (std::size_t p = 0; p < labels.size(); ++p)
      chunks_[p].labels = labels[p];
    const std::vector<FileContent> bounds = bounds_.finish();
    for (std::size_t p = 0; p < bounds.size(); ++p)
      chunks_[p].bounds = bounds[p];
  }

  /// `scalars` are the vertex's scalars, and `state` is its state in bytes.
  void add_vertex(ChunkNumber chunk, VertexRow row, std::span<const double> scalars,
                  std::span<const char> state) {
    row.is_shared = shared_.has(row.id) ? 1 : 0;
    vertices_.add(chunk, &row, sizeof(row));
    if (!scalars.empty())
      vertices_.add(chunk, scalars.data(), scalars.size_bytes());
    if (!state.empty())
      vertices_.add(chunk, state.data(), state.size());
  }

  void end_vertices() {
    const std::vector<FileContent> contents = vertices_.finish();
    for (std::size_t p = 0; p < chunks_.size(); ++p)
      chunks_[p].vertices = contents[p];
  }

  const IdSet& shared() const { return shared_; }
  std::uint64_t shared_count() const { return IdRanks(shared_).size(); }
  const std::vector<ChunkFiles>& chunks() const { return chunks_; }
  /// Counts in each chunk the faces that occur again. Returns their total number.
  std::uint64_t count_doubled() {
    std::uint64_t sum = 0;
    for (std::size_t p = 0; p < chunks_.size(); ++p)
      sum += chunks_[p].doubled = count_doubled_rows(folder_.faces(phase_, p));
    return sum;
  }

private:
  std::vector<std::filesystem::path>
  paths(std::size_t chunks, std::filesystem::path (JobFolder::*name)(unsigned, std::size_t) const) {
    std::vector<std::filesystem::path> result;
    for (std::size_t p = 0; p < chunks; ++p)
      result.push_back((folder_.*name)(phase_, p));
    return result;
  }

  const JobFolder& folder_;
  unsigned phase_;
  AppendedFiles faces_, vertices_, labels_, bounds_;
  IdSet shared_;
  std::vector<ChunkFiles> chunks_;
  bool has_labels_, has_bounds_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_CHUNK_SCATTER_H
