#ifndef QUADRILLE_FILE_H
#define QUADRILLE_FILE_H

#include <quadrille/internal/core/base/compiler.h> // first, since it tells what compiler this needs

#include <quadrille/file_report.h>
#include <quadrille/internal/file/job_estimate.h>
#include <quadrille/internal/file/job_key.h>
#include <quadrille/internal/file/job_lock.h>
#include <quadrille/internal/file/job_watch.h>
#include <quadrille/internal/file/limit_search.h>
#include <quadrille/internal/file/part_limit.h>
#include <quadrille/internal/file/part_runner.h>
#include <quadrille/internal/file/parted_job.h>
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
/// Surfaces that do not fit into memory: from a file to a file, by parts.
///
/// The file is cut into parts by a kd-tree. Each part is simplified by itself, up to the same cost
/// limit in all of them, while vertices that parts share stay. What is left is cut elsewhere, so
/// that old borders lie inside of new parts, and simplified up to the limit of a lower count; and
/// so on, until the whole fits into memory, which then is simplified to the target itself; or each
/// part gives its share of the last few faces. For POSIX systems.

namespace quadrille {

/// The steps of simplify_file one by one, so that any driver may run parts: threads, processes of
/// one computer, or of several that see the same folder.
///
/// ```cpp
/// PartitionedSimplifier<Quadric, OptimalPlacement> job("in.ply", FaceCount{1000000}, options);
/// job.partition();
/// do
///   for (std::size_t part = 0; part < job.parts(); ++part)
///     job.simplify(part); // in any order, by any process
/// while (job.close());
/// FileReport report = job.sew("out.ply");
/// ```
///
/// A process that runs parts only makes the same object, and calls join(), which takes up the phase
/// that is at work. Each step writes its files as a whole or not at all, and is left out if they
/// are there: so a job that was stopped anywhere goes on.
///
/// partition(), close() and sew() drive the job, the last two when all parts are simplified. The
/// object that has called one of them holds a lock in the scratch folder until it is destroyed or
/// has sewn: no other object may drive the job meanwhile, of whatever process. The lock of a
/// process that has ended counts for nothing.
///
/// All functions throw std::runtime_error, with the name of the file, for one that can't be read or
/// written, is not what it should be or has changed, and what `simplify` throws. What is done stays
/// in the scratch folder then; but if partition() throws, the job leaves nothing behind. All that a
/// job has there is in a folder of its own, quadrille-job; nothing else is read, written or
/// removed.
template <class Cost = Quadric, class Placement = OptimalPlacement, class... Policies>
class PartitionedSimplifier {
public:
  /// `stop` is a FaceCount or a FaceRatio; `policies` are what `simplify` takes beside, as it is
  /// told to each part: filters, a Topology, an order. And, among them, an DistanceLimit, a
  /// HausdorffLimit or a ToleranceLimit, which the whole keeps: without a target of faces besides,
  /// that is FaceCount{0}. Throws std::invalid_argument for options that make no sense.
  template <class Stop>
  PartitionedSimplifier(const SurfaceFiles& input, const Stop& stop, const OutOfCore& options,
                        Cost cost, Placement placement, Policies... policies)
      : options_(options), source_(input.paths, {options.positions_only, options.tolerance},
                                   options.keeps_tiles, options.welds),
        runner_(options.locks_boundary, std::move(cost), std::move(placement), policies...),
        watch_(options.proceed), job_(made_job(internal::FileTarget(stop, runner_.is_limited()))) {
    if (options.scratch.empty())
      throw std::invalid_argument("quadrille::OutOfCore: no scratch folder is given");
    if (!(options.attribute_importance > 0 && options.attribute_importance < 1e30))
      throw std::invalid_argument("quadrille::OutOfCore: attribute_importance has to be above 0");
    if (runner_.is_limited_by_tolerance() && options.tolerance.empty())
      throw std::invalid_argument("quadrille::OutOfCore: ToleranceLimit needs tolerances: name the "
                                  "number of vertices that is theirs");
    if (!runner_.is_limited_by_tolerance() && !options.tolerance.empty())
      throw std::invalid_argument("quadrille::OutOfCore: nothing holds the tolerances of '" +
                                  options.tolerance + "': pass ToleranceLimit as stop policy");
  }
  /// The same with policies that need not be told.
  template <class Stop>
  PartitionedSimplifier(const SurfaceFiles& input, const Stop& stop, const OutOfCore& options)
      : PartitionedSimplifier(input, stop, options, Cost(), Placement(), Policies()...) {}

  /// Cuts the file into the parts of the first phase; or, with OutOfCore::restart, takes up the
  /// phase that is at work.
  void partition() {
    cut();
    try {
      find_limit();
    } catch (const std::invalid_argument&) { // what policies refuse
      if (phase() == 1)
        remove_job();
      throw;
    }
  }

  /// partition() and close() look for the cost at which parts of the phase end, by samples of some
  /// parts. Those who share that out as well call cut() and regroup() instead of them, and then, in
  /// each phase, sample(i) for i < samples(), in any order, by any process, and settle().
  void cut() {
    lock();
    if (job_.folder().phase_at_work() > 0 && !options_.restart)
      internal::fail_file(job_.folder().path(),
                          "has a job in it: restart it, or remove this folder");
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

  /// What the job will take, about, as far as the sizes of its files tell.
  const FileEstimate& estimate() const { return job_.estimate(); }
  /// Throws std::runtime_error if the output could not be written, or there is no space for it, as
  /// far as is known now: at the end of hours is too late. cut() looks for space in the scratch
  /// folder; both may lie together, since that has less at the end, by more than the output has.
  void require_output(const std::filesystem::path& output) const {
    if (!options_.keeps_tiles)
      internal::require_writable(output);
    internal::require_space(output, estimate().output, "what is left of the surface");
  }

  /// How many are to be taken in this phase; none if it needs none, or is settled.
  std::size_t samples() const {
    return job_.plan().is_settled ? 0 : internal::LimitSearch(job_).size();
  }
  /// Takes a sample. False, with nothing done, if `is_cancelled`, which is asked now and then, says
  /// so.
  template <class IsCancelled>
  bool sample(std::size_t i, const IsCancelled& is_cancelled) const {
    return internal::LimitSearch(job_).sample(i, runner_, is_cancelled);
  }
  /// The same to its end.
  void sample(std::size_t i) const {
    sample(i, [] { return false; });
  }
  /// When all are taken. Throws std::logic_error if some are missing.
  void settle() {
    lock();
    if (!job_.plan().is_settled)
      job_.settle(internal::LimitSearch(job_).limit());
  }

  /// Takes up the phase that is at work, to simplify parts of it.
  void join() {
    if (!job_.take_up())
      internal::fail_file(job_.folder().scratch(), "has no job in it whose parts are cut");
  }

  unsigned phase() const { return job_.plan().phase; }                   ///< at work, from 1 on
  std::size_t parts() const { return job_.plan().parts.size(); }         ///< of this phase
  unsigned parts_in_flight() const { return job_.budget().in_flight(); } ///< that fit, as asked
  /// Where a driver may have files of its own; it is gone with the phase.
  std::filesystem::path phase_folder() const { return job_.folder().phase(phase()); }

  /// Simplifies a part of the phase; nothing to do if that is done. Several threads may do so at a
  /// time. False, with nothing done, if `is_cancelled`, which is asked now and then, says so.
  template <class IsCancelled>
  bool simplify(std::size_t part, const IsCancelled& is_cancelled) const {
    if (!job_.plan().is_settled)
      throw std::logic_error("quadrille::PartitionedSimplifier: phase " + std::to_string(phase()) +
                             " is not settled");
    return job_.is_done(part) || runner_.simplify(job_, part, is_cancelled);
  }
  /// The same to its end.
  void simplify(std::size_t part) const {
    simplify(part, [] { return false; });
  }

  /// Tells OutOfCore::proceed that so many parts, or samples, of the phase are done; false if it
  /// says that the job shall end.
  bool proceeds(std::size_t done) const {
    try {
      const bool is_settled = job_.plan().is_settled;
      const std::size_t all = is_settled ? parts() : samples();
      watch_.tell(job_, is_settled ? FileStage::simplify : FileStage::sample,
                  static_cast<double>(done) / static_cast<double>(all), done, all);
      return true;
    } catch (const internal::JobCancelled&) {
      return false;
    }
  }

  /// Ends the phase, and begins the next one; false if it was the last, and what is left can be
  /// sewn. Throws std::logic_error if parts are missing.
  bool close() {
    const bool goes_on = regroup();
    if (goes_on)
      find_limit();
    return goes_on;
  }
  /// The same without settling the next one: see cut().
  bool regroup() {
    lock();
    watch_.tell(job_, FileStage::regroup, 0);
    return job_.end_phase(internal::PieceOfPart<Cost>::add_memory());
  }

  /// Writes what is left to a binary PLY file, with floats or doubles as the input has, and empties
  /// the scratch folder. The file is there as a whole or not at all.
  FileReport sew(const std::filesystem::path& output) {
    lock();
    watch_.tell(job_, FileStage::sew, 0);
    FileReport report = this->report();
    job_.add_last_phase(report);
    if (options_.keeps_tiles)
      sew_tiles(output, report);
    else
      job_.sew(output, report);
    remove_job();
    report.peak_memory = internal::MemoryBudget::peak();
    return report;
  }

  /// All of it. If OutOfCore::proceed says so, it ends before: StopReason::cancelled.
  FileReport operator()(const std::filesystem::path& output) {
    const auto begin = std::chrono::steady_clock::now();
    require_output(output);
    try {
      partition();
      do
        watch_.run(job_, FileStage::simplify, parts(), [&](std::size_t part, const auto& ask) {
          if (!simplify(part, ask))
            throw internal::JobCancelled();
        });
      while (close());
      FileReport report = sew(output);
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
  internal::PartedJob made_job(const internal::FileTarget& target) const {
    const internal::VertexScalars scalars = source_.scalars();
    const internal::MemoryBudget budget(options_, internal::PieceOfPart<Cost>::memory_size,
                                        scalars.size(), target.is_limited());
    internal::JobKey key;
    key.add_number(source_.key());
    key.add_number(options_.attribute_importance);
    target.tell(key);
    runner_.tell(key);
    budget.tell(key);
    return {options_.scratch,
            budget,
            target,
            scalars,
            options_.attribute_importance,
            key.value(),
            internal::JobEstimate::of(source_.size(), target, budget,
                                      internal::PieceOfPart<Cost>::memory_size)};
  }

  void lock() {
    if (!lock_)
      lock_.emplace(job_.folder());
  }

  void remove_job() {
    lock_->remove_job();
    lock_.reset();
  }

  void sew_tiles(const std::filesystem::path& output, FileReport& report) const {
    const std::vector<std::filesystem::path> tiles = source_.tiles_in(output);
    const std::filesystem::path whole = job_.folder().welded(0);
    std::filesystem::create_directories(output);
    job_.sew(whole, report);
    report.bytes_written +=
        internal::TileSplit::run(whole, tiles, job_.folder().welding(), options_.memory / 8);
  }

  void cut_file() {
    const auto tell = [&](FileStage stage, double part) { watch_.tell(job_, stage, part); };
    const std::uint64_t made = source_.is_made(job_.folder()) ? source_.size().made : 0;
    internal::require_space(options_.scratch, estimate().scratch - made, "the job");
    const auto ask = [&] { tell(FileStage::weld, 0); };
    if (source_.size().making > 0)
      ask();
    job_.cut_file(source_.surface(job_.folder(), options_.memory / 2, ask), tell);
  }

  void find_limit() {
    watch_.run(job_, FileStage::sample, samples(), [&](std::size_t i, const auto& ask) {
      if (!sample(i, ask))
        throw internal::JobCancelled();
    });
    settle();
  }

  FileReport report() const {
    FileReport report = job_.report();
    report.dropped = source_.dropped();
    return report;
  }

  OutOfCore options_;
  internal::SurfaceSource source_;
  internal::PartRunner<Cost, Placement, Policies...> runner_;
  internal::JobWatch watch_;
  internal::PartedJob job_;
  std::optional<internal::JobLock> lock_; // while this drives the job
};

/// Simplifies a surface from a file to another one, by parts, in no more memory than is told.
///
/// ```cpp
/// FileReport report = simplify_file<MemorylessQuadric, OptimalPlacement>(
///     "in.ply", "out.ply", FaceCount{10'000'000}, OutOfCore{.scratch = "/scratch/a"});
/// ```
///
/// - input: one file, or several that are tiles of one surface: see SurfaceFiles
/// - what it is: PLY, of float or double; best binary and of triangles, since text, polygons and
///   loose faces become that first; or binary STL, of which corners at exactly the same place
///   become one vertex
/// - output: binary PLY, little endian, float or double as the input; vertices in the order of the
///   input
/// - colours, normals and other numbers of vertices go along as channels, and integers of faces as
///   labels, with their names and types, and in the range that they had
/// - stop: a FaceCount or a FaceRatio. The count is met exactly, as far as faces allow, if what is
///   left of some phase fits into memory, or no phase takes too many (FileReport::is_count_exact);
///   else it is near. Or an DistanceLimit, a HausdorffLimit, or a ToleranceLimit with
///   OutOfCore::tolerance; or AnyOf one of these and a count: what each face has used of the limit
///   goes along from phase to phase, so that the whole keeps it, as Report::distance_bound,
///   Report::hausdorff_bound and Report::used_tolerance tell; 12 bytes a face more on disk
/// - policies: what `simplify` takes beside, as it is told to each part
///
/// The result depends on OutOfCore::memory (or part_faces), but not on how many parts are in
/// flight, nor on interruptions. Topology is kept as `simplify` keeps it. What else the file has,
/// lists and other elements, is refused, but with OutOfCore::positions_only.
///
/// Time O(n log n) for n faces, reading its faces twice and its vertices four times; memory as
/// told, with two bytes for each vertex at least; on disk about 60 bytes for each face. Throws as
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
