#ifndef QUADRILLE_INTERNAL_FILE_MEMORY_BUDGET_H
#define QUADRILLE_INTERNAL_FILE_MEMORY_BUDGET_H

#include <quadrille/file_report.h>
#include <quadrille/internal/file/job_key.h>

#include <sys/resource.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <thread>

namespace quadrille::internal {

/// Decides what fits into the memory that a run may take. The size of a chunk depends on the memory
/// alone, and never on how many chunks are simplified at a time.
class MemoryBudget {
public:
  /// `per_vertex` is the size of a vertex's state in bytes, `scalars` the number of its scalars.
  /// Are distances limited?
  MemoryBudget(const OutOfCore& options, std::size_t per_vertex, std::size_t scalars,
               bool is_limited)
      : memory_(options.memory), per_face_(bytes_of_engine + (is_limited ? bytes_of_bounds : 0) +
                                           (per_vertex + scalars * bytes_of_scalar) / 2) {
    if (memory_ < 2 * base)
      throw std::invalid_argument("quadrille::OutOfCore: a memory of " + std::to_string(memory_) +
                                  " bytes is too small; it has to be at least " +
                                  std::to_string(2 * base));
    chunk_faces_ = options.chunk_faces > 0
                       ? options.chunk_faces
                       : std::clamp<std::uint64_t>(most_faces() / 4, 1, most_chunk_faces);
    chunk_faces_ = (std::min)(chunk_faces_, most_faces());
    whole_faces_ =
        options.whole_faces > 0 ? (std::min)(options.whole_faces, most_faces()) : most_faces();
    const unsigned wanted = options.chunks_in_flight > 0
                                ? options.chunks_in_flight
                                : (std::max)(1U, std::thread::hardware_concurrency());
    // Chunks of later phases may have half as many faces again, because a remaining vertex does not
    // always stand for two faces.
    in_flight_ =
        static_cast<unsigned>(std::clamp<std::uint64_t>(most_faces() / chunk_faces_, 1, wanted));
  }

  /// The number of faces that can be simplified at the same time.
  std::uint64_t most_faces() const { return (memory_ - base) / per_face_; }
  /// The number of faces of the whole surface, when it is simplified to the target itself.
  std::uint64_t whole_faces() const { return whole_faces_; }
  std::uint64_t chunk_faces() const { return chunk_faces_; }
  std::uint64_t chunk_vertices() const { return std::max<std::uint64_t>(chunk_faces_ / 2, 1); }
  unsigned in_flight() const { return in_flight_; }
  /// The memory for the buffers of the files of all chunks.
  std::uint64_t buffers() const { return memory_ / 16; }

  /// Returns about the peak memory of a run on a surface that is simplified to `target` faces.
  std::uint64_t expected(std::uint64_t faces, std::uint64_t vertices, std::uint64_t target) const {
    const std::uint64_t chunks = in_flight_ * (std::min)(chunk_faces_, faces);
    const std::uint64_t whole =
        (std::min)({whole_faces_, faces, target + target + target / 5}); // before the last phase
    const std::uint64_t tables = 2 * vertices + vertices / 4 + (std::min)(buffers(), 30 * faces);
    return (std::min)(memory_,
                      base / 2 + (std::max)(tables, per_face_ * (std::max)(chunks, whole)));
  }

  /// Adds to the key what affects the result.
  void add_to(JobKey& key) const {
    key.add_number(chunk_faces_);
    key.add_number(whole_faces_);
  }

  /// Throws if tables of all vertices do not fit.
  void require_tables(std::uint64_t vertices) const {
    const std::uint64_t needed = 2 * vertices + vertices / 4 + base + buffers();
    if (needed > memory_)
      throw std::invalid_argument("quadrille::OutOfCore: to cut a surface of " +
                                  std::to_string(vertices) + " vertices needs a memory of " +
                                  std::to_string(needed * 16 / 15) + " bytes");
  }

  /// Returns the peak memory of the process in bytes, as the system counts it.
  static std::uint64_t peak() {
    struct ::rusage usage = {};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
  }

private:
  // the program, the cells, and small data
  static constexpr std::uint64_t base = 64'000'000;
  static constexpr std::uint64_t bytes_of_engine = 200;       // including the chunk as it is read
  static constexpr std::uint64_t bytes_of_bounds = 36;        // in the engine, and as they are read
  static constexpr std::uint64_t bytes_of_scalar = 96;        // per vertex, including its map
  static constexpr std::uint64_t most_chunk_faces = 4'000'000; // more faces gain nothing

  std::uint64_t memory_, per_face_, chunk_faces_, whole_faces_;
  unsigned in_flight_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_MEMORY_BUDGET_H
