#ifndef QUADRILLE_INTERNAL_FILE_NEXT_PARTS_H
#define QUADRILLE_INTERNAL_FILE_NEXT_PARTS_H

#include <quadrille/internal/file/cell_counts.h>
#include <quadrille/internal/file/id_index.h>
#include <quadrille/internal/file/part_scatter.h>
#include <quadrille/internal/file/part_tree.h>
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

  std::size_t size() const { return size_; } ///< of a state, in bytes

  /// Adds the chunks in ascending order.
  void add(const Survivors& part) {
    if (size_ == 0)
      return;
    std::size_t given = 0;
    for (std::size_t v = 0; v < part.vertices.size(); ++v) {
      while (given < part.given.size() && part.given[given] < v)
        ++given;
      if (part.vertices[v].is_shared == 0)
        continue;
      const bool is_given = given < part.given.size() && part.given[given] == v;
      entries_.push_back({part.vertices[v].id, entries_.size(), is_given});
      append(part.states.data() + v * size_);
      append(is_given ? part.given_states.data() + given * size_ : zeros_.data());
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
class NextParts {
public:
  NextParts(const JobFolder& folder, unsigned phase, std::vector<SurvivorsHeader> old_parts,
            AddState add)
      : folder_(folder), phase_(phase), old_(std::move(old_parts)), states_(state_size(old_), add) {
  }

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
  PartScatter write(const FileBox& box, std::uint64_t ids, std::uint64_t part_vertices,
                    double fraction, std::uint64_t buffers) {
    const PartTree cut(box, vertices(), part_vertices, fraction, [&](auto take) {
      for_survivors([&](const Survivors& part) {
        for (const VertexRow& v : part.vertices)
          take(v.position);
      });
    });
    if (states_.size() > 0)
      for_survivors([&](const Survivors& part) { states_.add(part); });
    states_.sum_up();
    PartScatter scatter(folder_, phase_ + 1, cut.size(), ids, buffers,
                        has(&SurvivorsHeader::labels), has(&SurvivorsHeader::bounds));
    for_survivors([&](const Survivors& part) { give_faces(scatter, part, cut); });
    scatter.end_faces();
    for_survivors([&](const Survivors& part) { give_vertices(scatter, part, cut); });
    scatter.end_vertices();
    return scatter;
  }

private:
  bool has(std::uint64_t SurvivorsHeader::*count) const {
    return std::any_of(old_.begin(), old_.end(),
                       [&](const SurvivorsHeader& h) { return h.*count > 0; });
  }

  static std::size_t state_size(const std::vector<SurvivorsHeader>& parts) {
    std::uint64_t size = 0;
    for (const SurvivorsHeader& h : parts)
      size = (std::max)(size, h.state_size);
    return static_cast<std::size_t>(size);
  }

  // Calls take(corners, their positions, the chunks in which they lie).
  template <class Take>
  static void for_faces(const Survivors& part, const PartTree& cut, Take take) {
    std::vector<VertexId> ids;
    std::vector<PartNumber> homes;
    for (const VertexRow& v : part.vertices) {
      ids.push_back(v.id);
      homes.push_back(cut.part_of(v.position));
    }
    const IdIndex index(ids);
    for (const FaceRow& corners : part.faces) {
      std::array<std::size_t, 3> places;
      std::array<PartNumber, 3> of_corners;
      for (std::size_t i = 0; i < 3; ++i) {
        places[i] = index.find(corners[i]);
        of_corners[i] = homes[places[i]];
      }
      take(corners, places, of_corners);
    }
  }

  static void give_faces(PartScatter& scatter, const Survivors& part, const PartTree& cut) {
    std::size_t face = 0;
    for_faces(part, cut, [&](const FaceRow& corners, const auto&, const auto& homes) {
      const std::uint32_t label = part.labels.empty() ? 0 : part.labels[face];
      const FaceBound bound = part.bounds.empty() ? FaceBound{} : part.bounds[face];
      scatter.add_face(corners, homes, label, bound, [](std::size_t, PartNumber) {});
      ++face;
    });
  }

  void give_vertices(PartScatter& scatter, const Survivors& part, const PartTree& cut) const {
    Requests requests;
    for_faces(part, cut, [&](const FaceRow&, const auto& places, const auto& homes) {
      const PartNumber to = (std::min)({homes[0], homes[1], homes[2]});
      for (std::size_t i = 0; i < 3; ++i)
        requests.add({static_cast<VertexId>(places[i]), to});
    });
    requests.sort();
    const std::size_t size = states_.size();
    for (std::size_t v = 0; v < part.vertices.size(); ++v) {
      const VertexRow& row = part.vertices[v];
      const char* const state = size == 0            ? nullptr
                                : row.is_shared != 0 ? states_.total(row.id)
                                                     : part.states.data() + v * size;
      requests.for_parts(static_cast<VertexId>(v), [&](PartNumber to) {
        scatter.add_vertex(to, row, part.scalars_of(v), {state, size});
      });
    }
  }

  const JobFolder& folder_;
  unsigned phase_; // the phase that has ended
  std::vector<SurvivorsHeader> old_;
  SharedStates states_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_NEXT_PARTS_H
