#ifndef QUADRILLE_INTERNAL_FILE_CHUNK_MERGE_H
#define QUADRILLE_INTERNAL_FILE_CHUNK_MERGE_H

#include <quadrille/internal/file/byte_stream.h>
#include <quadrille/internal/file/disk_file.h>
#include <quadrille/internal/file/id_set.h>
#include <quadrille/internal/file/job_folder.h>
#include <quadrille/internal/file/label_table.h>
#include <quadrille/internal/file/phase_plan.h>
#include <quadrille/internal/file/ply_output.h>
#include <quadrille/internal/file/survivors.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <queue>
#include <string>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Merges the remaining chunks of a phase into one surface. All chunks agree on the numbers and on
/// the positions of their vertices, so nothing has to be matched. Vertices are in the order of the
/// input, faces in the order of the chunks. Memory: a bit and an eighth for each vertex of the
/// input.
class ChunkMerge {
public:
  ChunkMerge(const JobFolder& folder, const PhasePlan& plan, const VertexScalars& scalars,
             const std::vector<SurvivorsHeader>& chunks)
      : folder_(folder), phase_(plan.phase), scalars_(scalars), ranges_(plan.input.ranges),
        chunks_(chunks),
        labels_(plan.label_table.size > 0 ? LabelTable::read(folder.label_table(), plan.label_table)
                                          : LabelTable({})),
        ids_(find_ids(plan.input.vertices)), ranks_(ids_) {
    for (const SurvivorsHeader& h : chunks_)
      faces_ += h.faces;
  }

  std::uint64_t vertices() const { return ranks_.size(); }
  std::uint64_t faces() const { return faces_; }

  /// Returns the number of written bytes.
  std::uint64_t write(const std::filesystem::path& path, bool has_doubles) const {
    WholeFile file(path);
    PlyBytes bytes(file);
    bytes.put_text(header(has_doubles));
    if (has_doubles)
      put_vertices<double>(bytes);
    else
      put_vertices<float>(bytes);
    put_faces(bytes);
    bytes.flush();
    file.finish();
    return file.written();
  }

private:
  // The files of some chunks are read at the same time, so a block of each is in memory.
  static constexpr std::size_t block = 1 << 16;

  IdSet find_ids(std::uint64_t ids) const {
    IdSet found(ids);
    for (std::size_t p = 0; p < chunks_.size(); ++p)
      for (const VertexRow& v : Survivors::read(folder_.left(phase_, p), chunks_[p]).vertices)
        found.add(v.id);
    return found;
  }

  std::string header(bool has_doubles) const {
    std::string comments;
    for (const std::string& texture : scalars_.textures())
      comments += "comment " + texture + "\n";
    return ply_header(vertices(), has_doubles, scalars_.properties(), faces_, labels_.properties(),
                      comments);
  }

  // The vertices of a chunk, one after another.
  struct Reader {
    Reader(const std::filesystem::path& path, const SurvivorsHeader& header)
        : file(path), stream(file, sizeof(SurvivorsHeader), block),
          scalar_stream(file, sizeof(SurvivorsHeader) + header.vertices * sizeof(VertexRow), block),
          left(header.vertices), scalars(static_cast<std::size_t>(header.scalars)) {}

    bool next() {
      if (left-- == 0)
        return false;
      take(stream, &row, sizeof(row));
      if (!scalars.empty())
        take(scalar_stream, scalars.data(), scalars.size() * sizeof(double));
      return true;
    }
    void take(ByteStream& from, void* to, std::size_t size) {
      const char* const bytes = from.next(size);
      if (!bytes)
        fail_file(file.path(), "is shorter than what was written");
      std::memcpy(to, bytes, size);
    }

    InputFile file;
    ByteStream stream, scalar_stream;
    std::uint64_t left;
    VertexRow row{};
    std::vector<double> scalars;
  };

  // Merges the chunks by the numbers of vertices; each chunk has its vertices in ascending order.
  template <class Number>
  void put_vertices(PlyBytes& bytes) const {
    std::vector<std::unique_ptr<Reader>> readers;
    using Next = std::pair<VertexId, std::size_t>;
    std::priority_queue<Next, std::vector<Next>, std::greater<>> queue;
    const auto push = [&](std::size_t p) {
      if (readers[p]->next())
        queue.push({readers[p]->row.id, p});
    };
    for (std::size_t p = 0; p < chunks_.size(); ++p) {
      readers.push_back(std::make_unique<Reader>(folder_.left(phase_, p), chunks_[p]));
      push(p);
    }
    std::uint64_t last = most_vertex_ids + 1;
    while (!queue.empty()) {
      const auto [id, chunk] = queue.top();
      queue.pop();
      if (id != last)
        put_vertex<Number>(bytes, *readers[chunk]);
      last = id;
      push(chunk);
    }
  }

  template <class Number>
  void put_vertex(PlyBytes& bytes, const Reader& from) const {
    for (std::size_t i = 0; i < 3; ++i)
      bytes.put(static_cast<Number>(from.row.position[i]));
    for (std::size_t i = 0; i < from.scalars.size(); ++i)
      bytes.put_as(scalars_.properties()[i].type,
                   std::clamp(from.scalars[i], ranges_.low[i], ranges_.high[i]));
  }

  void put_faces(PlyBytes& bytes) const {
    for (std::size_t p = 0; p < chunks_.size(); ++p) {
      const Survivors chunk = Survivors::read(folder_.left(phase_, p), chunks_[p]);
      for (std::size_t f = 0; f < chunk.faces.size(); ++f) {
        const FaceRow& corners = chunk.faces[f];
        bytes.put_corners({ranks_(corners[0]), ranks_(corners[1]), ranks_(corners[2])});
        if (!chunk.labels.empty())
          put_label(bytes, labels_.values(chunk.labels[f]));
      }
    }
  }

  void put_label(PlyBytes& bytes, const LabelValues& values) const {
    for (std::size_t i = 0; i < values.size(); ++i)
      bytes.put_integer(labels_.properties()[i].type, values[i]);
  }

  const JobFolder& folder_;
  unsigned phase_;
  const VertexScalars& scalars_;
  const ScalarRanges& ranges_;
  const std::vector<SurvivorsHeader>& chunks_;
  LabelTable labels_;
  IdSet ids_;
  IdRanks ranks_;
  std::uint64_t faces_ = 0;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_CHUNK_MERGE_H
