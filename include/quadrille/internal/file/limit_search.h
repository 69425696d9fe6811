#ifndef QUADRILLE_INTERNAL_FILE_LIMIT_SEARCH_H
#define QUADRILLE_INTERNAL_FILE_LIMIT_SEARCH_H

#include <quadrille/internal/file/cost_samples.h>
#include <quadrille/internal/file/job_watch.h>
#include <quadrille/internal/file/parted_job.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace quadrille::internal {

/// The cost limit at which a phase is to leave the faces that it aims at, in the engine's unit:
/// from samples of 32 parts, or of several pieces of each if there are fewer.
template <class Runner>
float find_limit(const PartedJob& job, const Runner& runner, const JobWatch& watch) {
  const std::vector<PartFiles>& parts = job.plan().parts;
  const auto faces_of = [](const PartFiles& p) { return p.faces.size / sizeof(FaceRow); };
  std::vector<std::size_t> sampled;
  std::uint64_t faces = 0;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    if (p % ((parts.size() + 31) / 32) == 0)
      sampled.push_back(p);
    faces += faces_of(parts[p]);
  }
  const std::size_t pieces = std::bit_floor(std::max<std::size_t>(32 / sampled.size(), 1));
  std::vector<std::vector<typename Runner::Sample>> samples(sampled.size());
  watch.run(job, FileStage::sample, sampled.size(), [&](std::size_t i, const auto& is_cancelled) {
    samples[i] = runner.samples(job, sampled[i], pieces, is_cancelled);
  });
  CostSamples all(faces);
  for (std::size_t i = 0; i < samples.size(); ++i)
    for (const auto& sample : samples[i])
      all.add(faces_of(parts[sampled[i]]) / samples[i].size(), sample.counts, sample.costs);
  return all.limit(job.plan().faces_wanted);
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_LIMIT_SEARCH_H
