#ifndef QUADRILLE_INTERNAL_FILE_LOADED_CHUNK_H
#define QUADRILLE_INTERNAL_FILE_LOADED_CHUNK_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/surface/face_bound.h>
#include <quadrille/internal/file/appended_files.h>
#include <quadrille/internal/file/doubled_rows.h>
#include <quadrille/internal/file/id_index.h>
#include <quadrille/internal/file/job_folder.h>
#include <quadrille/internal/file/phase_plan.h>
#include <quadrille/internal/file/rows.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <vector>

namespace quadrille::internal {

/// A chunk in memory: its vertices in ascending order of their numbers, each once, and its faces,
/// which refer to their positions in that list.
struct LoadedChunk {
  std::vector<VertexId> ids;
  std::vector<Vector<3>> positions;
  std::vector<bool> is_shared;
  std::vector<double> scalars; ///< the scalars of the vertices, one row after another, or empty
  std::vector<char> states;    ///< `state_size` bytes each; empty in the first phase
  std::vector<std::array<Index, 3>> triangles;
  std::vector<std::uint32_t> labels;            ///< the labels of the triangles, or empty
  std::vector<FaceBound> bounds;                ///< the bounds of the triangles, or empty
  std::vector<std::array<Index, 2>> boundaries; ///< see TrueBoundaries

  /// Reads chunk `chunk` of a phase. Throws for files that are not the ones that were written.
  static LoadedChunk read(const JobFolder& folder, const PhasePlan& plan, std::size_t chunk,
                          std::size_t state_size) {
    LoadedChunk loaded;
    const ChunkFiles& files = plan.chunks[chunk];
    loaded.take_vertices(read_rows<char>(folder.vertices(plan.phase, chunk), files.vertices),
                         plan.input.ranges.low.size(), plan.phase > 1 ? state_size : 0);
    const IdIndex index(loaded.ids);
    const auto path = folder.faces(plan.phase, chunk);
    loaded.triangles = read_rows<FaceRow>(path, files.faces);
    for (std::array<Index, 3>& corners : loaded.triangles)
      for (Index& corner : corners) {
        corner = static_cast<Index>(index.find(corner));
        if (corner == loaded.ids.size())
          fail_file(path, "has a corner that is not in its chunk");
      }
    if (files.labels.size > 0)
      loaded.labels = read_rows<std::uint32_t>(folder.labels(plan.phase, chunk), files.labels);
    if (files.bounds.size > 0)
      loaded.bounds = read_rows<FaceBound>(folder.bounds(plan.phase, chunk), files.bounds);
    if (files.doubled > 0)
      remove_doubled(loaded.triangles, loaded.labels);
    loaded.take_boundaries(read_rows<std::uint64_t>(folder.boundaries(plan.phase), plan.boundaries),
                           index);
    return loaded;
  }

private:
  // A vertex that came from several chunks occurs once for each of them, with the same content.
  void take_vertices(const std::vector<char>& rows, std::size_t scalar_count,
                     std::size_t state_size) {
    const std::size_t scalars_size = scalar_count * sizeof(double);
    const std::size_t row_size = sizeof(VertexRow) + scalars_size + state_size;
    const std::size_t count = rows.size() / row_size;
    const auto row = [&](std::size_t i) {
      VertexRow result;
      std::memcpy(&result, rows.data() + i * row_size, sizeof(result));
      return result;
    };
    std::vector<std::uint64_t> order(count); // the number, and the index
    for (std::size_t i = 0; i < count; ++i)
      order[i] = std::uint64_t{row(i).id} << 32 | i;
    if (!std::is_sorted(order.begin(), order.end()))
      std::sort(order.begin(), order.end());
    for (const std::uint64_t o : order) {
      const std::size_t i = static_cast<std::size_t>(o & 0xFFFFFFFFU);
      const VertexRow v = row(i);
      if (!ids.empty() && ids.back() == v.id)
        continue;
      ids.push_back(v.id);
      positions.push_back(v.position);
      is_shared.push_back(v.is_shared != 0);
      const char* const rest = rows.data() + i * row_size + sizeof(VertexRow);
      scalars.resize(scalars.size() + scalar_count);
      if (scalar_count > 0)
        std::memcpy(scalars.data() + scalars.size() - scalar_count, rest, scalars_size);
      const char* const state = rest + scalars_size;
      states.insert(states.end(), state, state + state_size);
    }
  }

  void take_boundaries(const std::vector<std::uint64_t>& edges, const IdIndex& index) {
    for (const std::uint64_t edge : edges) {
      const std::size_t a = index.find(static_cast<VertexId>(edge >> 32));
      const std::size_t b = index.find(static_cast<VertexId>(edge & 0xFFFFFFFFU));
      if (a < ids.size() && b < ids.size())
        boundaries.push_back({static_cast<Index>(a), static_cast<Index>(b)});
    }
  }
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_LOADED_CHUNK_H
