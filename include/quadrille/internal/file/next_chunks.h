#ifndef QUADRILLE_INTERNAL_FILE_NEXT_CHUNKS_H
#define QUADRILLE_INTERNAL_FILE_NEXT_CHUNKS_H

#include <quadrille/internal/file/cell_counts.h>
#include <quadrille/internal/file/chunk_scatter.h>
#include <quadrille/internal/file/chunk_tree.h>
#include <quadrille/internal/file/id_index.h>
#include <quadrille/internal/file/survivors.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Adds one state of a vertex, as bytes, to another.
using AddState = void (*)(void* total, const void* gained);

/// The states of vertices that several chunks have had: the state that they were given, and what
/// was added to it in each chunk, in ascending order of chunks, so that the sum has the same bits
/// in whatever order the chunks ran.
class SharedStates {
public:
  SharedStates(std::size_t size, AddState add_state) : size_(size), add_(add_state) {}

  std::size_t size() const { return size_; } ///< the size of a state, in bytes

  /// Adds the chunks in ascending order.
  void add(const Survivors& chunk) {
    if (size_ == 0)
      return;
    std::size_t given = 0;
    for (std::size_t v = 0; v < chunk.vertices.size(); ++v) {
      while (given < chunk.given.size() && chunk.given[given] < v)
        ++given;
      if (chunk.vertices[v].is_shared == 0)
        continue;
      const bool is_given = given < chunk.given.size() && chunk.given[given] == v;
      entries_.push_back({chunk.vertices[v].id, entries_.size(), is_given});
      append(chunk.states.data() + v * size_);
      append(is_given ? chunk.given_states.data() + given * size_ : zeros_.data());
    }
  }

  void sum_up() {
    std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
      return std::pair(a.id, a.place) < std::pair(b.id, b.place);
    });
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      if (ids_.empty() || ids_.back() != entries_[i].id)
        begin_total(entries_[i]);
      else
        add_(totals_.data() + totals_.size() - size_, gained(entries_[i]));
    }
    index_.emplace_back(ids_);
    entries_ = {};
    bytes_ = {};
  }

  /// Returns the state of one of these vertices.
  const char* total(VertexId id) const { return totals_.data() + index_.front().find(id) * size_; }

private:
  struct Entry {
    VertexId id;
    std::size_t place;
    bool is_given;
  };

  void append(const char* state) { bytes_.insert(bytes_.end(), state, state + size_); }
  const char* gained(const Entry& e) const { return bytes_.data() + 2 * e.place * size_; }

  // All chunks were given the same state, so the first one's is taken.
  void begin_total(const Entry& e) {
    ids_.push_back(e.id);
    const char* const first = e.is_given ? gained(e) + size_ : gained(e);
    totals_.insert(totals_.end(), first, first + size_);
    if (e.is_given)
      add_(totals_.data() + totals_.size() - size_, gained(e));
  }

  std::size_t size_;
  AddState add_;
  std::vector<Entry> entries_;
  std::vector<char> bytes_; // for each entry, what was added to the state, and the state that was
                            // given
  std::vector<char> zeros_ = std::vector<char>(size_);
  std::vector<VertexId> ids_;
  std::vector<char> totals_;
  std::vector<IdIndex> index_; // one, once there are ids
};

/// Turns the remaining chunks of a phase into the chunks of the next one. Each file is read three
/// times, one file after another, and once more if vertices have a state.
class NextChunks {
public:
  NextChunks(const JobFolder& folder, unsigned phase, std::vector<SurvivorsHeader> old_chunks,
             AddState add)
      : folder_(folder), phase_(phase), old_(std::move(old_chunks)),
        states_(state_size(old_), add) {}

  /// Calls take(Survivors) for each chunk, in ascending order.
  template <class Take>
  void for_survivors(Take take) const {
    for (std::size_t i = 0; i < old_.size(); ++i)
      take(Survivors::read(folder_.left(phase_, i), old_[i]));
  }

  std::uint64_t faces() const {
    std::uint64_t sum = 0;
    for (const SurvivorsHeader& h : old_)
      sum += h.faces;
    return sum;
  }
  std::uint64_t vertices() const {
    std::uint64_t sum = 0;
    for (const SurvivorsHeader& h : old_)
      sum += h.vertices;
    return sum;
  }

  /// Writes the chunks of the next phase, cut at `fraction`.
  ChunkScatter write(const FileBox& box, std::uint64_t ids, std::uint64_t chunk_vertices,
                     double fraction, std::uint64_t buffers) {
    const ChunkTree cut(box, vertices(), chunk_vertices, fraction, [&](auto take) {
      for_survivors([&](const Survivors& chunk) {
        for (const VertexRow& v : chunk.vertices)
          take(v.position);
      });
    });
    if (states_.size() > 0)
      for_survivors([&](const Survivors& chunk) { states_.add(chunk); });
    states_.sum_up();
    ChunkScatter scatter(folder_, phase_ + 1, cut.size(), ids, buffers,
                         has(&SurvivorsHeader::labels), has(&SurvivorsHeader::bounds));
    for_survivors([&](const Survivors& chunk) { give_faces(scatter, chunk, cut); });
    scatter.end_faces();
    for_survivors([&](const Survivors& chunk) { give_vertices(scatter, chunk, cut); });
    scatter.end_vertices();
    return scatter;
  }

private:
  bool has(std::uint64_t SurvivorsHeader::*count) const {
    return std::any_of(old_.begin(), old_.end(),
                       [&](const SurvivorsHeader& h) { return h.*count > 0; });
  }

  static std::size_t state_size(const std::vector<SurvivorsHeader>& chunks) {
    std::uint64_t size = 0;
    for (const SurvivorsHeader& h : chunks)
      size = (std::max)(size, h.state_size);
    return static_cast<std::size_t>(size);
  }

  // Calls take(corners, their positions, the chunks in which they lie).
  template <class Take>
  static void for_faces(const Survivors& chunk, const ChunkTree& cut, Take take) {
    std::vector<VertexId> ids;
    std::vector<ChunkNumber> homes;
    for (const VertexRow& v : chunk.vertices) {
      ids.push_back(v.id);
      homes.push_back(cut.chunk_of(v.position));
    }
    const IdIndex index(ids);
    for (const FaceRow& corners : chunk.faces) {
      std::array<std::size_t, 3> places;
      std::array<ChunkNumber, 3> of_corners;
      for (std::size_t i = 0; i < 3; ++i) {
        places[i] = index.find(corners[i]);
        of_corners[i] = homes[places[i]];
      }
      take(corners, places, of_corners);
    }
  }

  static void give_faces(ChunkScatter& scatter, const Survivors& chunk, const ChunkTree& cut) {
    std::size_t face = 0;
    for_faces(chunk, cut, [&](const FaceRow& corners, const auto&, const auto& homes) {
      const std::uint32_t label = chunk.labels.empty() ? 0 : chunk.labels[face];
      const FaceBound bound = chunk.bounds.empty() ? FaceBound{} : chunk.bounds[face];
      scatter.add_face(corners, homes, label, bound, [](std::size_t, ChunkNumber) {});
      ++face;
    });
  }

  void give_vertices(ChunkScatter& scatter, const Survivors& chunk, const ChunkTree& cut) const {
    Requests requests;
    for_faces(chunk, cut, [&](const FaceRow&, const auto& places, const auto& homes) {
      const ChunkNumber to = (std::min)({homes[0], homes[1], homes[2]});
      for (std::size_t i = 0; i < 3; ++i)
        requests.add({static_cast<VertexId>(places[i]), to});
    });
    requests.sort();
    const std::size_t size = states_.size();
    for (std::size_t v = 0; v < chunk.vertices.size(); ++v) {
      const VertexRow& row = chunk.vertices[v];
      const char* const state = size == 0            ? nullptr
                                : row.is_shared != 0 ? states_.total(row.id)
                                                     : chunk.states.data() + v * size;
      requests.for_chunks(static_cast<VertexId>(v), [&](ChunkNumber to) {
        scatter.add_vertex(to, row, chunk.scalars_of(v), {state, size});
      });
    }
  }

  const JobFolder& folder_;
  unsigned phase_; // the phase that has ended
  std::vector<SurvivorsHeader> old_;
  SharedStates states_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_NEXT_CHUNKS_H
