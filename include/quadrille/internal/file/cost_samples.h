#ifndef QUADRILLE_INTERNAL_FILE_COST_SAMPLES_H
#define QUADRILLE_INTERNAL_FILE_COST_SAMPLES_H

#include <quadrille/internal/core/base/cost_histogram.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/file/cell_counts.h>
#include <quadrille/internal/file/loaded_chunk.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace quadrille::internal {

/// A connected region of a chunk with about the given number of vertices. It is found by repeatedly
/// keeping one half of the vertices, on one side of the median along the longest extent; the bits
/// of `seed` choose the side. The boundary of the region is shared, because it must not move.
class ChunkSample {
public:
  static LoadedChunk of(const LoadedChunk& chunk, std::size_t vertices, std::uint64_t seed,
                        std::size_t state_size) {
    ChunkSample sample(chunk);
    while (sample.order_.size() > vertices) {
      sample.halve((seed & 1U) != 0);
      seed >>= 1U;
    }
    return sample.extracted(state_size);
  }

private:
  explicit ChunkSample(const LoadedChunk& chunk) : chunk_(chunk), order_(chunk.ids.size()) {
    std::iota(order_.begin(), order_.end(), Index{0});
  }

  void halve(bool takes_upper) {
    const std::size_t axis = longest_axis();
    const auto middle = order_.begin() + static_cast<std::ptrdiff_t>(order_.size() / 2);
    std::nth_element(order_.begin(), middle, order_.end(), [&](Index a, Index b) {
      const double x = chunk_.positions[a][axis], y = chunk_.positions[b][axis];
      return x != y ? x < y : a < b;
    });
    if (takes_upper)
      order_.erase(order_.begin(), middle);
    else
      order_.erase(middle, order_.end());
  }

  std::size_t longest_axis() const {
    FileBox box;
    for (const Index v : order_)
      box.add(chunk_.positions[v]);
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (box.high[i] - box.low[i] > box.high[axis] - box.low[axis])
        axis = i;
    return axis;
  }

  LoadedChunk extracted(std::size_t state_size) {
    std::sort(order_.begin(), order_.end());
    std::vector<Index> place(chunk_.ids.size(), none);
    LoadedChunk sample;
    for (const Index v : order_) {
      place[v] = static_cast<Index>(sample.ids.size());
      sample.ids.push_back(chunk_.ids[v]);
      sample.positions.push_back(chunk_.positions[v]);
      sample.is_shared.push_back(chunk_.is_shared[v]);
      const std::size_t scalars = chunk_.scalars.size() / chunk_.ids.size();
      const auto row = chunk_.scalars.begin() + static_cast<std::ptrdiff_t>(v * scalars);
      sample.scalars.insert(sample.scalars.end(), row, row + static_cast<std::ptrdiff_t>(scalars));
      const auto state = chunk_.states.begin() + static_cast<std::ptrdiff_t>(v * state_size);
      if (!chunk_.states.empty())
        sample.states.insert(sample.states.end(), state,
                             state + static_cast<std::ptrdiff_t>(state_size));
    }
    for (std::size_t f = 0; f < chunk_.triangles.size(); ++f) {
      const std::array<Index, 3>& t = chunk_.triangles[f];
      const std::array<Index, 3> corners{place[t[0]], place[t[1]], place[t[2]]};
      const bool is_inside = corners[0] != none && corners[1] != none && corners[2] != none;
      if (is_inside)
        sample.triangles.push_back(corners);
      if (is_inside && !chunk_.labels.empty())
        sample.labels.push_back(chunk_.labels[f]);
      if (is_inside && !chunk_.bounds.empty())
        sample.bounds.push_back(chunk_.bounds[f]);
      for (const Index corner : corners)
        if (!is_inside && corner != none)
          sample.is_shared[corner] = true;
    }
    return sample;
  }

  const LoadedChunk& chunk_;
  std::vector<Index> order_; // the remaining vertices
};

/// The number of faces in a sample that can be removed: the faces for which its vertices that are
/// not shared stand.
struct SampleCounts {
  double free_faces = 0;

  explicit SampleCounts(const LoadedChunk& sample) {
    std::size_t free = 0, used = 0;
    std::vector<bool> has_face(sample.ids.size());
    for (const std::array<Index, 3>& t : sample.triangles)
      for (const Index v : t)
        has_face[v] = true;
    for (std::size_t v = 0; v < sample.ids.size(); ++v) {
      used += has_face[v] ? 1 : 0;
      free += has_face[v] && !sample.is_shared[v] ? 1 : 0;
    }
    if (used > 0)
      free_faces = static_cast<double>(sample.triangles.size()) * static_cast<double>(free) /
                   static_cast<double>(used);
  }
};

/// Extrapolates from samples of a surface to the whole: up to which cost pairs must be contracted
/// so that the given number of faces is left. Each sample was simplified to its end.
class CostSamples {
public:
  explicit CostSamples(std::uint64_t faces) : faces_(faces) {}

  /// Adds a sample that stands for `chunk_faces` faces, of which `free_faces` could be removed,
  /// with the costs of its contractions.
  void add(std::uint64_t chunk_faces, double free_faces, const CostHistogram& costs) {
    if (free_faces > 0)
      samples_.push_back({chunk_faces, free_faces, costs});
  }

  /// Returns the limit in the engine's unit. It is infinite if nothing could be sampled.
  float limit(std::uint64_t faces_left) const {
    double sampled = 0;
    for (const Sample& s : samples_)
      sampled += static_cast<double>(s.chunk_faces);
    CostHistogram all;
    for (const Sample& s : samples_) {
      const double weight = static_cast<double>(s.chunk_faces) / s.free_faces *
                            (static_cast<double>(faces_) / sampled);
      const auto from = s.costs.counters();
      for (std::size_t i = 0; i < CostHistogram::size; ++i)
        all.counters()[i] +=
            static_cast<std::uint64_t>(std::llround(unit * weight * static_cast<double>(from[i])));
    }
    const std::uint64_t wanted = unit * (faces_ - (std::min)(faces_left, faces_));
    return samples_.empty() ? std::numeric_limits<float>::infinity()
                            : all.cost_for((std::min)(wanted, all.total()));
  }

private:
  static constexpr std::uint64_t unit = 256; // a face counts as this many

  struct Sample {
    std::uint64_t chunk_faces;
    double free_faces;
    CostHistogram costs;
  };

  std::uint64_t faces_; // of all chunks
  std::vector<Sample> samples_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_COST_SAMPLES_H
