#ifndef QUADRILLE_INTERNAL_FILE_LIMIT_SEARCH_H
#define QUADRILLE_INTERNAL_FILE_LIMIT_SEARCH_H

#include <quadrille/internal/file/chunked_job.h>
#include <quadrille/internal/file/cost_samples.h>
#include <quadrille/internal/file/sample_file.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace quadrille::internal {

/// Finds the cost limit at which a phase leaves the intended number of faces, from samples of 32
/// chunks of the phase, or of several regions of each chunk if there are fewer. Samples are files
/// of the phase, which any process may make.
class LimitSearch {
public:
  explicit LimitSearch(const ChunkedJob& job) : job_(job) {
    const std::size_t step = (job.plan().chunks.size() + 31) / 32;
    for (std::size_t p = 0; p < job.plan().chunks.size(); p += step)
      chunks_.push_back(p);
  }

  /// The number of chunks that are sampled.
  std::size_t size() const { return chunks_.size(); }

  /// Takes the samples of the i-th of these chunks, unless they exist. Returns false if it is
  /// cancelled.
  template <class Runner, class IsCancelled>
  bool sample(std::size_t i, const Runner& runner, const IsCancelled& is_cancelled) const {
    if (read(i))
      return true;
    const std::size_t sample_count = std::bit_floor(std::max<std::size_t>(32 / chunks_.size(), 1));
    bool is_whole = true; // a sample that was cut short would count too few faces
    const auto samples = runner.samples(job_, chunks_[i], sample_count, [&] {
      is_whole = is_whole && !is_cancelled();
      return !is_whole;
    });
    if (is_whole)
      SampleFile::write(path(i), job_.key(), samples);
    return is_whole;
  }

  /// Returns the limit in the engine's unit. Throws std::logic_error if samples are missing.
  float limit() const {
    const std::vector<ChunkFiles>& chunks = job_.plan().chunks;
    std::uint64_t faces = 0;
    for (const ChunkFiles& p : chunks)
      faces += p.face_count();
    CostSamples all(faces);
    for (std::size_t i = 0; i < chunks_.size(); ++i) {
      const std::optional<std::vector<CostSample>> samples = read(i);
      if (!samples)
        throw std::logic_error("quadrille::PartitionedSimplifier: sample " + std::to_string(i) +
                               " of phase " + std::to_string(job_.plan().phase) +
                               " has not been taken");
      for (const CostSample& sample : *samples)
        all.add(chunks[chunks_[i]].face_count() / samples->size(), sample.free_faces, sample.costs);
    }
    return all.limit(job_.plan().faces_wanted);
  }

private:
  std::filesystem::path path(std::size_t i) const {
    return job_.folder().samples(job_.plan().phase, chunks_[i]);
  }
  std::optional<std::vector<CostSample>> read(std::size_t i) const {
    return SampleFile::read(path(i), job_.key());
  }

  const ChunkedJob& job_;
  std::vector<std::size_t> chunks_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_LIMIT_SEARCH_H
