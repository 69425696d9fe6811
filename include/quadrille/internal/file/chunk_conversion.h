#ifndef QUADRILLE_INTERNAL_FILE_CHUNK_CONVERSION_H
#define QUADRILLE_INTERNAL_FILE_CHUNK_CONVERSION_H

#include <quadrille/internal/file/cell_counts.h>
#include <quadrille/internal/file/chunk.h>
#include <quadrille/internal/file/loaded_chunk.h>
#include <quadrille/internal/file/next_chunks.h>
#include <quadrille/internal/file/survivors.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Returns which vertices of a chunk are at an edge that has one face in the whole surface: see
/// TrueBoundaries.
inline std::vector<bool> boundary_vertices(const LoadedChunk& loaded) {
  std::vector<std::array<Index, 2>> edges; // edges that no other chunk has
  edges.reserve(3 * loaded.triangles.size());
  for (const std::array<Index, 3>& t : loaded.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = (std::min)(t[i], t[(i + 1) % 3]), b = (std::max)(t[i], t[(i + 1) % 3]);
      if (!loaded.is_shared[a] || !loaded.is_shared[b])
        edges.push_back({a, b});
    }
  std::sort(edges.begin(), edges.end());
  std::vector<bool> result(loaded.positions.size());
  const auto mark = [&](const std::array<Index, 2>& edge) {
    result[edge[0]] = result[edge[1]] = true;
  };
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    for (end = i + 1; end < edges.size() && edges[end] == edges[i];)
      ++end;
    if (end == i + 1)
      mark(edges[i]);
  }
  for (const std::array<Index, 2>& edge : loaded.boundaries)
    mark(edge);
  return result;
}

/// Converts between chunks as files have them and chunks as the engine has them.
template <class Cost>
struct ChunkConversion {
  using State = typename Cost::State;
  static constexpr bool has_state = !std::is_empty_v<State>;
  static constexpr std::size_t state_size = has_state ? sizeof(State) : 0;
  static_assert(Cost::dimension == 3,
                "quadrille: a file is simplified with a cost of positions only");
  static_assert(std::is_trivially_copyable_v<State>,
                "quadrille: the state of a vertex is written to files, so it has to be trivially "
                "copyable");
  static_assert(!asks_for_indices<Cost> && !AccumulatesByIndex<Cost>,
                "quadrille: each chunk of a file numbers its vertices again: a cost that asks for "
                "indices in the input works only for surfaces in memory");

  /// Returns the box of the surface, with room for vertices that move out of it.
  static Box<3> box(const FileBox& box) {
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i)
      longest = (std::max)(longest, box.high[i] - box.low[i]);
    Box<3> result(box.low, box.high);
    for (std::size_t i = 0; i < 3; ++i) {
      result.low[i] -= longest / 16;
      result.high[i] += longest / 16;
    }
    return result;
  }

  static Chunk<Cost> chunk(LoadedChunk loaded, const FileBox& of_file, bool locks_boundary) {
    Chunk<Cost> chunk;
    if (locks_boundary)
      chunk.is_fixed = boundary_vertices(loaded);
    chunk.positions = std::move(loaded.positions);
    chunk.triangles = std::move(loaded.triangles);
    chunk.is_shared = std::move(loaded.is_shared);
    chunk.boundaries = std::move(loaded.boundaries);
    chunk.labels = std::move(loaded.labels);
    chunk.bounds = std::move(loaded.bounds);
    chunk.box = box(of_file);
    if constexpr (has_state) {
      chunk.states.resize(loaded.states.size() / state_size);
      std::copy(loaded.states.begin(), loaded.states.end(),
                reinterpret_cast<char*>(chunk.states.data()));
    }
    return chunk;
  }

  /// Uses the numbers of the input. `given` are states of the chunk, if it had any.
  static Survivors survivors(ChunkResult<Cost>& result, const std::vector<VertexId>& ids,
                             const std::vector<bool>& is_shared, const std::vector<char>& given,
                             const std::vector<std::uint32_t>& labels) {
    Survivors s;
    s.vertices.reserve(result.positions.size());
    for (std::size_t i = 0; i < result.positions.size(); ++i) {
      const Index v = result.vertices[i];
      s.vertices.push_back({ids[v], is_shared[v] ? 1U : 0U, result.positions[i]});
      if (has_state && is_shared[v] && !given.empty()) {
        s.given.push_back(i);
        const auto from = given.begin() + static_cast<std::ptrdiff_t>(v * state_size);
        s.given_states.insert(s.given_states.end(), from,
                              from + static_cast<std::ptrdiff_t>(state_size));
      }
    }
    s.faces.reserve(result.triangles.size());
    for (const std::array<Index, 3>& t : result.triangles)
      s.faces.push_back({s.vertices[t[0]].id, s.vertices[t[1]].id, s.vertices[t[2]].id});
    if (!labels.empty())
      for (const Index face : result.faces)
        s.labels.push_back(labels[face]);
    s.bounds = std::move(result.bounds);
    if constexpr (has_state) {
      s.states.resize(result.states.size() * state_size);
      const char* const bytes = reinterpret_cast<const char*>(result.states.data());
      std::copy(bytes, bytes + s.states.size(), s.states.begin());
    }
    return s;
  }

  static AddState add_state() {
    if constexpr (has_state)
      return [](void* total, const void* gained) {
        State sum, more;
        std::memcpy(&sum, total, sizeof(State));
        std::memcpy(&more, gained, sizeof(State));
        sum += more;
        std::memcpy(total, &sum, sizeof(State));
      };
    else
      return nullptr;
  }
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_CHUNK_CONVERSION_H
