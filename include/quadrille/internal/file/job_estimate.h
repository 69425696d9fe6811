#ifndef QUADRILLE_INTERNAL_FILE_JOB_ESTIMATE_H
#define QUADRILLE_INTERNAL_FILE_JOB_ESTIMATE_H

#include <quadrille/file_report.h>
#include <quadrille/internal/core/base/cost_histogram.h>
#include <quadrille/internal/core/surface/face_bound.h>
#include <quadrille/internal/file/disk_file.h>
#include <quadrille/internal/file/file_target.h>
#include <quadrille/internal/file/memory_budget.h>
#include <quadrille/internal/file/rows.h>
#include <quadrille/internal/file/schedule.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>

namespace quadrille::internal {

/// The size of an input, according to its header and its file size.
struct InputSize {
  std::uint64_t vertices = 0, faces = 0;
  std::size_t scalars = 0; ///< the scalars of each vertex
  bool has_labels = false;
  std::uint64_t row = 12;   ///< bytes of a vertex in the output
  std::uint64_t making = 0; ///< bytes on the disk while a surface is made from a soup or from tiles
  std::uint64_t made = 0;   ///< bytes of that surface, which exists until it is cut
  bool keeps_tiles = false; ///< is the output also in the scratch folder?
};

/// Estimates what a job will take, from sizes alone.
class JobEstimate {
public:
  /// `state_size` is the size of a vertex's state in bytes.
  static FileEstimate of(const InputSize& input, const FileTarget& target,
                         const MemoryBudget& budget, std::size_t state_size) {
    const JobEstimate job(input, target, budget, state_size);
    FileEstimate result;
    result.faces = input.faces;
    result.output = target.is_limited() ? 0 : job.output_bytes();
    result.scratch = job.scratch_bytes();
    result.memory = budget.expected(input.faces, input.vertices, job.target_);
    result.seconds = static_cast<double>(input.faces) *
                     (serial_seconds + job.parallel_seconds() / budget.in_flight() +
                      (input.making > 0 ? making_seconds : 0));
    return result;
  }

private:
  // These are times per face, measured on one core of about 2 GHz with a busy disk.
  static constexpr double serial_seconds = 0.9e-6, making_seconds = 1.5e-6,
                          seconds_of_scalar = 0.35e-6, seconds_of_limit = 6e-6;
  // Returns the time to read a chunk, which grows with the fraction of it that is removed.
  double parallel_seconds() const {
    const double gone = 1 - static_cast<double>((std::min)(target_, input_.faces)) /
                                static_cast<double>((std::max<std::uint64_t>)(input_.faces, 1));
    return 0.9e-6 + 1.3e-6 * gone + (is_limited_ ? seconds_of_limit : 0) +
           static_cast<double>(input_.scalars) * seconds_of_scalar;
  }

  JobEstimate(const InputSize& input, const FileTarget& target, const MemoryBudget& budget,
              std::size_t state_size)
      : input_(input), schedule_(input.faces, target.faces(input.faces), budget.chunk_vertices()),
        chunk_faces_(budget.chunk_faces()), chunk_vertices_(budget.chunk_vertices()),
        is_limited_(target.is_limited()), target_(target.faces(input.faces)),
        state_size_(state_size) {}

  double vertices_of(double faces) const {
    return input_.faces == 0
               ? 0
               : faces * static_cast<double>(input_.vertices) / static_cast<double>(input_.faces);
  }

  // A compact patch of V vertices has 4 √V vertices on its boundary, which other chunks have, too.
  double bytes_of(double faces, std::size_t state_size) const {
    const double vertex =
        static_cast<double>(sizeof(VertexRow) + input_.scalars * sizeof(double) + state_size);
    const double face = static_cast<double>(sizeof(FaceRow)) + (input_.has_labels ? 4 : 0) +
                        (is_limited_ ? sizeof(FaceBound) : 0);
    return (vertices_of(faces) * vertex + faces * face) *
           (1.05 + 5 / std::sqrt(static_cast<double>(chunk_vertices_)));
  }

  std::uint64_t output_bytes() const {
    const double faces = static_cast<double>((std::min)(target_, input_.faces));
    return static_cast<std::uint64_t>(vertices_of(faces) * static_cast<double>(input_.row) +
                                      faces * (input_.has_labels ? 17 : 13));
  }

  // At most 32 chunks of a phase are sampled; a small chunk has a single sample.
  double bytes_of_samples() const {
    const std::uint64_t chunks = std::bit_ceil(input_.faces / chunk_faces_ + 1);
    const std::uint64_t sampled = (std::min<std::uint64_t>)(chunks, 32);
    const std::uint64_t sample_count = chunk_faces_ > 4 * 8000 * 32 / sampled ? 32 / sampled : 1;
    return chunks == 1 ? 0
                       : static_cast<double>(sampled * sample_count * CostHistogram::size *
                                             sizeof(std::uint64_t));
  }

  // Each phase has its chunks and their results at the same time, then the results and the chunks
  // of the next phase. It is unknown how many faces a distance limit leaves; half of them are
  // assumed.
  std::uint64_t scratch_bytes() const {
    const auto all = static_cast<double>(input_.faces);
    const double samples = bytes_of_samples();
    double chunks = bytes_of(all, 0), most = chunks + static_cast<double>(input_.made);
    for (std::size_t step = 0; step <= schedule_.size(); ++step) {
      double left = (std::min)(all, static_cast<double>(schedule_.wanted(step, target_)));
      if (is_limited_)
        left = (std::max)(left, all / 2);
      const double bytes = bytes_of(left, state_size_);
      most = (std::max)({most, chunks + samples + bytes, 2 * bytes});
      chunks = bytes;
    }
    most = (std::max)(most, static_cast<double>(input_.making));
    if (input_.keeps_tiles)
      most = (std::max)(most, chunks + static_cast<double>(output_bytes()));
    return static_cast<std::uint64_t>(most);
  }

  const InputSize& input_;
  Schedule schedule_;
  std::uint64_t chunk_faces_, chunk_vertices_;
  bool is_limited_;
  std::uint64_t target_;
  std::size_t state_size_;
};

/// Returns the free space of the file system in which a path is or will be; nothing if it is
/// unknown.
inline std::optional<std::uint64_t> free_space(std::filesystem::path path) {
  std::error_code error;
  path = std::filesystem::absolute(path, error);
  while (path.has_relative_path() && !std::filesystem::exists(path, error))
    path = path.parent_path();
  const std::filesystem::space_info space = std::filesystem::space(path, error);
  return error ? std::nullopt : std::optional<std::uint64_t>(space.available);
}

/// Throws, with the name of the path, if fewer bytes are free there.
inline void require_space(const std::filesystem::path& path, std::uint64_t bytes,
                          const std::string& what) {
  const std::optional<std::uint64_t> space = free_space(path);
  if (!space || *space >= bytes)
    return;
  const auto text = [](std::uint64_t n) {
    std::ostringstream out;
    out.precision(3);
    out << static_cast<double>(n) / 1e9 << " GB";
    return out.str();
  };
  fail_file(path, "only " + text(*space) + " are free there, and " + what + " needs about " +
                      text(bytes));
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_JOB_ESTIMATE_H
