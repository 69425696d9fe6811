#ifndef QUADRILLE_FILE_H
#define QUADRILLE_FILE_H

#include <quadrille/internal/core/base/compiler.h> // first, since it reports which compiler this needs

#include <quadrille/file_report.h>
#include <quadrille/internal/file/chunk_limit.h>
#include <quadrille/internal/file/chunk_runner.h>
#include <quadrille/internal/file/chunked_job.h>
#include <quadrille/internal/file/job_estimate.h>
#include <quadrille/internal/file/job_key.h>
#include <quadrille/internal/file/job_lock.h>
#include <quadrille/internal/file/job_watch.h>
#include <quadrille/internal/file/limit_search.h>
#include <quadrille/internal/file/surface_source.h>
#include <quadrille/internal/file/tile_split.h>
#include <quadrille/placement.h>
#include <quadrille/quadric.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

/// \file
/// Simplification from file to file, for surfaces that do not fit into memory.
///
/// A kd-tree cuts the file into chunks. Each chunk is simplified by itself, up to a cost limit that
/// is the same for all of them, while the vertices shared by several chunks stay. The result is cut
/// elsewhere, so that the old chunk boundaries lie inside new chunks, and simplified up to the
/// limit of a lower count. This is repeated until the whole surface fits into memory and is
/// simplified to the target, or until each chunk contributes its share of the last few faces. It
/// needs a POSIX system.

namespace quadrille {

/// The single steps of simplify_file, so that any driver can run the chunks: threads, processes of
/// one computer, or processes of several computers that share a folder.
///
/// ```cpp
/// PartitionedSimplifier<Quadric, OptimalPlacement> job("in.ply", FaceCount{1000000}, options);
/// job.partition();
/// do
///   for (std::size_t chunk = 0; chunk < job.chunks(); ++chunk)
///     job.simplify(chunk); // in any order, by any process
/// while (job.close());
/// FileReport report = job.merge("out.ply");
/// ```
///
/// A process that only runs chunks makes the same object and calls join(), which joins the current
/// phase. Each step writes its files completely or not at all, and is skipped if they exist. So a
/// job can be continued wherever it was stopped.
///
/// partition(), close() and merge() drive the job; close() and merge() need all chunks to be
/// simplified. The object that has called one of them owns a lock in the scratch folder until it is
/// destroyed or merge() has ended: no other object of any process may drive the job meanwhile. The
/// lock of a process that has ended is ignored.
///
/// All functions throw std::runtime_error, with the name of the file, for a file that cannot be
/// read or written, is invalid or has changed, and whatever `simplify` throws. The finished work
/// then stays in the scratch folder; but if partition() throws, the job removes its files. All
/// files of a job are in its own subfolder, quadrille-job; nothing else is read, written or
/// removed.
template <class Cost = Quadric, class Placement = OptimalPlacement, class... Policies>
class PartitionedSimplifier {
public:
  /// `stop` is a FaceCount or a FaceRatio; `policies` are further arguments of `simplify`, which
  /// are passed on for each chunk: filters, a Topology, an order. They may include an
  /// DistanceLimit, a HausdorffLimit or a ToleranceLimit, which applies to the whole surface;
  /// without a target of faces in addition, the target is FaceCount{0}. Throws
  /// std::invalid_argument for invalid options.
  template <class Stop>
  PartitionedSimplifier(const SurfaceFiles& input, const Stop& stop, const OutOfCore& options,
                        Cost cost, Placement placement, Policies... policies)
      : options_(options), source_(input.paths, {options.positions_only, options.tolerance},
                                   options.keeps_tiles, options.welds),
        runner_(options.locks_boundary, std::move(cost), std::move(placement), policies...),
        watch_(options.proceed), job_(made_job(internal::FileTarget(stop, runner_.is_limited()))) {
    if (options.scratch.empty())
      throw std::invalid_argument("quadrille::OutOfCore: the scratch folder is missing");
    if (!(options.attribute_importance > 0 && options.attribute_importance < 1e30))
      throw std::invalid_argument("quadrille::OutOfCore: attribute_importance has to be above 0");
    if (runner_.is_limited_by_tolerance() && options.tolerance.empty())
      throw std::invalid_argument(
          "quadrille::OutOfCore: ToleranceLimit needs tolerances: set OutOfCore::tolerance to "
          "the name of a scalar property of vertices");
    if (!runner_.is_limited_by_tolerance() && !options.tolerance.empty())
      throw std::invalid_argument("quadrille::OutOfCore: nothing enforces the tolerances of '" +
                                  options.tolerance + "': pass ToleranceLimit as a stop policy");
  }
  /// Takes default-constructed policies.
  template <class Stop>
  PartitionedSimplifier(const SurfaceFiles& input, const Stop& stop, const OutOfCore& options)
      : PartitionedSimplifier(input, stop, options, Cost(), Placement(), Policies()...) {}

  /// Cuts the file into the chunks of the first phase; with OutOfCore::restart, resumes the current
  /// phase.
  void partition() {
    cut();
    try {
      find_limit();
    } catch (const std::invalid_argument&) { // policies reject their arguments
      if (phase() == 1)
        remove_job();
      throw;
    }
  }

  /// partition() and close() sample some chunks to estimate the cost at which the chunks of the
  /// phase stop. A driver that distributes the sampling too calls cut() and regroup() instead of
  /// them. In each phase it then calls sample(i) for i < samples(), in any order, by any process,
  /// and resolve().
  void cut() {
    lock();
    if (job_.folder().phase_at_work() > 0 && !options_.restart)
      internal::fail_file(job_.folder().path(),
                          "has a job in it: restart the job, or remove this folder");
    if (job_.take_up())
      return job_.remove_phase_before();
    try {
      cut_file();
    } catch (const internal::JobCancelled&) {
      job_.folder().remove_phases();
      if (!source_.is_made(job_.folder()))
        remove_job();
      throw;
    } catch (...) {
      remove_job();
      throw;
    }
  }

  /// Returns an estimate of the job's resources, from the sizes of its files.
  const FileEstimate& estimate() const { return job_.estimate(); }
  /// Throws std::runtime_error if the output cannot be written or the disk has too little space for
  /// it, as far as this is known now, since at the end of a long job it would be too late. cut()
  /// checks the space in the scratch folder. Both may be on one disk, since the scratch folder
  /// shrinks at the end by more than the size of the output.
  void require_output(const std::filesystem::path& output) const {
    if (!options_.keeps_tiles)
      internal::require_writable(output);
    internal::require_space(output, estimate().output, "the rest of the surface");
  }

  /// Returns the number of samples to take in this phase: 0 if it needs none, or if resolve() was
  /// called.
  std::size_t samples() const {
    return job_.plan().is_resolved ? 0 : internal::LimitSearch(job_).size();
  }
  /// Takes a sample. Returns false, without having done anything, if `is_cancelled`, which is
  /// called from time to time, returns true.
  template <class IsCancelled>
  bool sample(std::size_t i, const IsCancelled& is_cancelled) const {
    return internal::LimitSearch(job_).sample(i, runner_, is_cancelled);
  }
  /// Takes a sample and cannot be cancelled.
  void sample(std::size_t i) const {
    sample(i, [] { return false; });
  }
  /// Computes the cost limit of the phase once all samples are taken. Throws std::logic_error if
  /// some are missing.
  void resolve() {
    lock();
    if (!job_.plan().is_resolved)
      job_.resolve(internal::LimitSearch(job_).limit());
  }

  /// Joins the current phase, to simplify chunks of it.
  void join() {
    if (!job_.take_up())
      internal::fail_file(job_.folder().scratch(), "has no job in it whose chunks are cut");
  }

  /// the current phase, from 1 on
  unsigned phase() const { return job_.plan().phase; }
  /// the number of chunks of this phase
  std::size_t chunks() const { return job_.plan().chunks.size(); }
  /// the number of chunks that fit into memory at a time, as requested
  unsigned chunks_in_flight() const { return job_.budget().in_flight(); }
  /// Returns a folder in which a driver may have its own files; it is removed at the end of the
  /// phase.
  std::filesystem::path phase_folder() const { return job_.folder().phase(phase()); }

  /// Simplifies a chunk of the phase, unless it is done already. Several threads may call it at a
  /// time. Returns false, without having done anything, if `is_cancelled`, which is called from
  /// time to time, returns true.
  template <class IsCancelled>
  bool simplify(std::size_t chunk, const IsCancelled& is_cancelled) const {
    if (!job_.plan().is_resolved)
      throw std::logic_error("quadrille::PartitionedSimplifier: phase " + std::to_string(phase()) +
                             " is not resolved");
    return job_.is_done(chunk) || runner_.simplify(job_, chunk, is_cancelled);
  }
  /// Simplifies a chunk and cannot be cancelled.
  void simplify(std::size_t chunk) const {
    simplify(chunk, [] { return false; });
  }

  /// Reports to OutOfCore::proceed how many chunks, or samples, of the phase are done; returns
  /// false if the job should end.
  bool proceeds(std::size_t done) const {
    try {
      const bool is_resolved = job_.plan().is_resolved;
      const std::size_t all = is_resolved ? chunks() : samples();
      watch_.report(job_, is_resolved ? FileStage::simplify : FileStage::sample,
                    static_cast<double>(done) / static_cast<double>(all), done, all);
      return true;
    } catch (const internal::JobCancelled&) {
      return false;
    }
  }

  /// Ends the phase and begins the next one. Returns false if it was the last one and merge() can
  /// write the result. Throws std::logic_error if some chunks are missing.
  bool close() {
    const bool goes_on = regroup();
    if (goes_on)
      find_limit();
    return goes_on;
  }
  /// Does the same as close(), but does not prepare the next phase: see cut().
  bool regroup() {
    lock();
    watch_.report(job_, FileStage::regroup, 0);
    return job_.end_phase(internal::ChunkConversion<Cost>::add_state());
  }

  /// Writes the result to a binary PLY file, with floats or doubles as in the input, and empties
  /// the scratch folder. The file is written completely or not at all.
  FileReport merge(const std::filesystem::path& output) {
    lock();
    watch_.report(job_, FileStage::merge, 0);
    FileReport report = this->report();
    job_.add_last_phase(report);
    if (options_.keeps_tiles)
      merge_tiles(output, report);
    else
      job_.merge(output, report);
    remove_job();
    report.peak_memory = internal::MemoryBudget::peak();
    return report;
  }

  /// Runs the whole job. It ends early, with StopReason::cancelled, if OutOfCore::proceed returns
  /// false.
  FileReport operator()(const std::filesystem::path& output) {
    const auto begin = std::chrono::steady_clock::now();
    require_output(output);
    try {
      partition();
      do
        watch_.run(job_, FileStage::simplify, chunks(), [&](std::size_t chunk, const auto& ask) {
          if (!simplify(chunk, ask))
            throw internal::JobCancelled();
        });
      while (close());
      FileReport report = merge(output);
      report.seconds.contract =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      return report;
    } catch (const internal::JobCancelled&) {
      FileReport report = this->report();
      report.stop = StopReason::cancelled;
      return report;
    }
  }

private:
  internal::ChunkedJob made_job(const internal::FileTarget& target) const {
    const internal::VertexScalars scalars = source_.scalars();
    const internal::MemoryBudget budget(options_, internal::ChunkConversion<Cost>::state_size,
                                        scalars.size(), target.is_limited());
    internal::JobKey key;
    key.add_number(source_.key());
    key.add_number(options_.attribute_importance);
    target.add_to(key);
    runner_.add_to(key);
    budget.add_to(key);
    return {options_.scratch,
            budget,
            target,
            scalars,
            options_.attribute_importance,
            key.value(),
            internal::JobEstimate::of(source_.size(), target, budget,
                                      internal::ChunkConversion<Cost>::state_size)};
  }

  void lock() {
    if (!lock_)
      lock_.emplace(job_.folder());
  }

  void remove_job() {
    lock_->remove_job();
    lock_.reset();
  }

  void merge_tiles(const std::filesystem::path& output, FileReport& report) const {
    const std::vector<std::filesystem::path> tiles = source_.tiles_in(output);
    const std::filesystem::path whole = job_.folder().welded(0);
    std::filesystem::create_directories(output);
    job_.merge(whole, report);
    report.bytes_written +=
        internal::TileSplit::run(whole, tiles, job_.folder().welding(), options_.memory / 8);
  }

  void cut_file() {
    const auto notify = [&](FileStage stage, double fraction) {
      watch_.report(job_, stage, fraction);
    };
    const std::uint64_t made = source_.is_made(job_.folder()) ? source_.size().made : 0;
    internal::require_space(options_.scratch, estimate().scratch - made, "the job");
    const auto ask = [&] { notify(FileStage::weld, 0); };
    if (source_.size().making > 0)
      ask();
    job_.cut_file(source_.surface(job_.folder(), options_.memory / 2, ask), notify);
  }

  void find_limit() {
    watch_.run(job_, FileStage::sample, samples(), [&](std::size_t i, const auto& ask) {
      if (!sample(i, ask))
        throw internal::JobCancelled();
    });
    resolve();
  }

  FileReport report() const {
    FileReport report = job_.report();
    report.dropped = source_.dropped();
    return report;
  }

  OutOfCore options_;
  internal::SurfaceSource source_;
  internal::ChunkRunner<Cost, Placement, Policies...> runner_;
  internal::JobWatch watch_;
  internal::ChunkedJob job_;
  std::optional<internal::JobLock> lock_; // while this object drives the job
};

/// Simplifies a surface from one file to another, chunk by chunk, within a limit of memory.
///
/// ```cpp
/// FileReport report = simplify_file<MemorylessQuadric, OptimalPlacement>(
///     "in.ply", "out.ply", FaceCount{10'000'000}, OutOfCore{.scratch = "/scratch/a"});
/// ```
///
/// - input: one file, or several that are tiles of one surface: see SurfaceFiles
/// - format: PLY with floats or doubles, or binary STL, whose corners at exactly the same place
///   become one vertex. Binary PLY with triangles is fastest: text, polygons and faces without
///   shared vertices are converted to it first
/// - output: binary little-endian PLY with floats or doubles as in the input; vertices keep the
///   order of the input
/// - attributes: colours, normals and other scalar properties of vertices are carried as channels,
///   and integers of faces as labels, with their names and types and in their original range
/// - stop: a FaceCount or a FaceRatio. The count is met exactly, as far as faces allow, if the
///   result of some phase fits into memory, or if no phase removes too many faces
///   (FileReport::is_count_exact); otherwise approximately. Or an DistanceLimit, a HausdorffLimit,
///   or a ToleranceLimit with OutOfCore::tolerance; or AnyOf one of these and a count: the
///   accumulated bound of each face is passed from phase to phase, so that the whole surface keeps
///   the limit: see Report::distance_bound, Report::hausdorff_bound and Report::used_tolerance.
///   This takes 12 more bytes per face on disk
/// - policies: further arguments of `simplify`, which are passed on for each chunk
///
/// The result depends on OutOfCore::memory (or chunk_faces), but neither on the number of chunks in
/// flight nor on interruptions. Topology is kept as `simplify` keeps it. Other contents of the
/// file, lists and further elements, are rejected unless OutOfCore::positions_only is set.
///
/// Time O(n log n) for n faces, reading its faces twice and its vertices four times; memory up to
/// the limit, which is at least two bytes per vertex; about 60 bytes per face on disk. Throws as
/// PartitionedSimplifier.
template <class Cost = Quadric, class Placement = OptimalPlacement, class Stop, class... Policies>
FileReport simplify_file(const SurfaceFiles& input, const std::filesystem::path& output,
                         const Stop& stop, const OutOfCore& options, Cost cost = {},
                         Placement placement = {}, Policies... policies) {
  const auto target = internal::faces_and_limit(stop);
  return std::apply(
      [&](const auto&... limits) {
        PartitionedSimplifier<Cost, Placement, Policies..., std::decay_t<decltype(limits)>...> job(
            input, target.first, options, std::move(cost), std::move(placement),
            std::move(policies)..., limits...);
        return job(output);
      },
      target.second);
}

} // namespace quadrille

#endif // QUADRILLE_FILE_H
