#ifndef QUADRILLE_INTERNAL_FILE_FIRST_CHUNKS_H
#define QUADRILLE_INTERNAL_FILE_FIRST_CHUNKS_H

#include <quadrille/internal/file/cell_counts.h>
#include <quadrille/internal/file/chunk_scatter.h>
#include <quadrille/internal/file/chunk_tree.h>
#include <quadrille/internal/file/input_survey.h>
#include <quadrille/internal/file/ply_input.h>
#include <quadrille/internal/file/rows.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace quadrille::internal {

/// Turns a surveyed file into the chunks of the first phase. It reads the vertices three times and
/// the faces once, all in the order of the file; it reads the vertices of a crowded surface some
/// more times. Memory: two bytes for each vertex, six for each time that a chunk has a vertex that
/// lies in another one, the cells, and `buffers`.
class FirstChunks {
public:
  FirstChunks(const PlyInput& input, const InputSurvey& survey)
      : input_(input), survey_(survey), facts_(survey.facts()) {}

  /// Writes the chunks to the folder, as the chunks of that phase. `notify(fraction)` is called
  /// with the fraction of the work that is done, from 0 to 1, and may throw.
  template <class Notify>
  ChunkScatter write(const JobFolder& folder, unsigned phase, std::uint64_t chunk_vertices,
                     std::uint64_t buffers, Notify notify) {
    const auto from = [&](double begin, double end, std::uint64_t count) {
      return [=, &notify](std::uint64_t i) {
        if (i % (1 << 18) == 0)
          notify(begin + (end - begin) * static_cast<double>(i) / static_cast<double>(count));
      };
    };
    const ChunkTree cut = count(chunk_vertices, from(0, 0.15, facts_.vertices));
    const std::vector<ChunkNumber> homes = find_homes(cut, from(0.15, 0.3, facts_.vertices));
    LabelTable labels = survey_.labels();
    ChunkScatter scatter(folder, phase, cut.size(), facts_.vertices, buffers, has_labels(), false);
    give_faces(scatter, homes, labels, from(0.3, 0.65, facts_.faces));
    give_vertices(scatter, homes, from(0.65, 1, facts_.vertices));
    if (has_labels())
      label_table_ = labels.write(folder.label_table());
    return scatter;
  }

  /// The file of the labels, after it has been written.
  const FileContent& label_table() const { return label_table_; }

private:
  bool has_labels() const { return !input_.labels().empty(); }

  template <class Notify>
  ChunkTree count(std::uint64_t chunk_vertices, Notify notify) {
    ChunkTree cut(facts_.box, facts_.used_vertices, chunk_vertices, 0.5, [&](auto take) {
      for_vertices([&](VertexId id, const Vector<3>& p) {
        notify(id);
        take(p);
      });
    });
    require_even(cut, chunk_vertices);
    return cut;
  }

  void require_even(const ChunkTree& cut, std::uint64_t chunk_vertices) const {
    for (const std::uint64_t size : cut.sizes())
      if (size > 2 * chunk_vertices)
        fail_file(input_.file().path(),
                  "has " + std::to_string(size) + " vertices at one place, and a chunk may have " +
                      std::to_string(chunk_vertices) + ": more memory is needed");
  }

  template <class Notify>
  std::vector<ChunkNumber> find_homes(const ChunkTree& cut, Notify notify) const {
    std::vector<ChunkNumber> homes(static_cast<std::size_t>(facts_.vertices));
    for_vertices([&](VertexId id, const Vector<3>& p) {
      notify(id);
      homes[id] = cut.chunk_of(p);
    });
    return homes;
  }

  template <class Notify>
  void give_faces(ChunkScatter& scatter, const std::vector<ChunkNumber>& homes, LabelTable& labels,
                  Notify notify) {
    const std::uint64_t checksum = input_.for_faces(
        [&](std::uint64_t face, const FaceRow& corners, const LabelValues& values) {
          notify(face);
          if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
            return;
          scatter.add_face(corners, {homes[corners[0]], homes[corners[1]], homes[corners[2]]},
                           has_labels() ? labels.number(values) : 0, FaceBound{},
                           [&](std::size_t i, ChunkNumber chunk) {
                             requests_.add({corners[i], chunk});
                           });
        });
    require_same(checksum, survey_.checksum_of_faces());
    requests_.sort();
    scatter.end_faces();
  }

  template <class Notify>
  void give_vertices(ChunkScatter& scatter, const std::vector<ChunkNumber>& homes, Notify notify) {
    for_vertices([&](VertexId id, const Vector<3>& p, const std::vector<double>& scalars) {
      notify(id);
      const VertexRow row{id, 0, p};
      scatter.add_vertex(homes[id], row, scalars, {});
      requests_.for_chunks(id,
                           [&](ChunkNumber chunk) { scatter.add_vertex(chunk, row, scalars, {}); });
    });
    scatter.end_vertices();
  }

  // Goes through the used vertices again, and checks that the file has not changed.
  template <class Take>
  void for_vertices(Take take) const {
    const auto take_used = [&](VertexId id, const Vector<3>& p, const auto&... scalars) {
      if (survey_.is_used(id))
        take(id, p, scalars...);
    };
    std::uint64_t checksum = 0;
    if constexpr (std::is_invocable_v<Take, VertexId, const Vector<3>&>)
      checksum = input_.for_vertices([&](VertexId id, const Vector<3>& p) { take_used(id, p); });
    else
      checksum = input_.for_vertices(
          [&](VertexId id, const Vector<3>& p, const std::vector<double>& scalars) {
            take_used(id, p, scalars);
          });
    require_same(checksum, survey_.checksum_of_vertices());
  }
  void require_same(std::uint64_t checksum, std::uint64_t before) const {
    if (checksum != before)
      fail_file(input_.file().path(), "has changed while it was read");
  }

  const PlyInput& input_;
  const InputSurvey& survey_;
  const InputFacts& facts_;
  Requests requests_;
  FileContent label_table_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_FIRST_CHUNKS_H
