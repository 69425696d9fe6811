#ifndef QUADRILLE_INTERNAL_FILE_CHUNKED_JOB_H
#define QUADRILLE_INTERNAL_FILE_CHUNKED_JOB_H

#include <quadrille/file_report.h>
#include <quadrille/internal/core/surface/box.h>
#include <quadrille/internal/file/chunk_merge.h>
#include <quadrille/internal/file/file_target.h>
#include <quadrille/internal/file/first_chunks.h>
#include <quadrille/internal/file/job_folder.h>
#include <quadrille/internal/file/memory_budget.h>
#include <quadrille/internal/file/next_chunks.h>
#include <quadrille/internal/file/phase_plan.h>
#include <quadrille/internal/file/schedule.h>
#include <quadrille/internal/file/survivors.h>
#include <quadrille/internal/file/true_boundaries.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The files of a job and its phases: everything except the simplification of a chunk.
class ChunkedJob {
public:
  /// `importance` is the weight of the vertices' scalars.
  ChunkedJob(const std::filesystem::path& scratch, const MemoryBudget& budget,
             const FileTarget& target, VertexScalars scalars, double importance, std::uint64_t key,
             const FileEstimate& estimate)
      : folder_(scratch), budget_(budget), target_(target), scalars_(std::move(scalars)),
        importance_(importance), key_(key), estimate_(estimate) {}

  const JobFolder& folder() const { return folder_; }
  const MemoryBudget& budget() const { return budget_; }
  const PhasePlan& plan() const { return plan_; }
  std::uint64_t key() const { return key_; }
  const FileEstimate& estimate() const { return estimate_; }
  const VertexScalars& scalars() const { return scalars_; }
  /// Returns the channels for rows of these scalars.
  ChunkChannels channels(const std::vector<double>& rows) const {
    return scalars_.channels(rows, plan_.input.ranges, diagonal(), importance_);
  }
  /// The diagonal of the input's box.
  double diagonal() const { return Box<3>(plan_.input.box.low, plan_.input.box.high).diagonal(); }
  std::uint64_t target() const { return target_.faces(plan_.input.counted_faces); }
  /// Returns the target of a chunk if the phase ends at a count and not at a limit.
  FaceCount count(std::size_t chunk) const {
    if (plan_.is_last)
      return FaceCount{static_cast<std::size_t>(target())};
    std::uint64_t all = 0, begin = 0;
    for (std::size_t p = 0; p < plan_.chunks.size(); ++p) {
      const std::uint64_t faces = plan_.chunks[p].face_count();
      begin += p < chunk ? faces : 0;
      all += faces;
    }
    const std::uint64_t own = plan_.chunks[chunk].face_count();
    const std::uint64_t aim = plan_.is_exact ? target() : plan_.faces_wanted;
    const std::uint64_t share =
        Schedule::share(all - (std::min)(all, aim), begin, begin + own, all);
    return FaceCount{static_cast<std::size_t>(own - share)};
  }
  Schedule schedule() const {
    return {plan_.input.counted_faces, target(), budget_.chunk_vertices()};
  }

  /// Resumes the current phase in the folder. Returns false if there is none. Throws
  /// std::runtime_error if it belongs to another job.
  bool take_up() {
    const unsigned phase = folder_.phase_at_work();
    if (phase == 0)
      return false;
    plan_ = PhasePlan::read(folder_.plan(phase));
    if (plan_.key != key_)
      fail_file(folder_.path(),
                "has chunks of another file, or for another target, cost or chunk size; remove it, "
                "or choose another folder");
    return true;
  }
  /// Removes the files of the previous phase, which has ended, even if a run was killed before it
  /// could do so.
  void remove_phase_before() const {
    if (plan_.phase > 1)
      folder_.remove_phase(plan_.phase - 1);
  }

  /// Cuts a file into the chunks of the first phase. `notify(stage, fraction)` is called with the
  /// fraction of the stage that is done, and may throw.
  template <class Notify>
  void cut_file(const PlyInput& input, Notify notify) {
    budget_.require_tables(input.vertices());
    if (input.faces() == 0 || input.vertices() == 0)
      fail_file(input.file().path(), "nothing to simplify: it has no faces");
    const InputSurvey survey(input, scalars_.tolerance(),
                             [&](double fraction) { notify(FileStage::survey, fraction); });
    folder_.remove_phases(); // left by a killed run
    folder_.begin_phase(1);
    PhasePlan plan;
    plan.key = key_;
    plan.phase = 1;
    plan.input = survey.facts();
    const bool is_whole = input.faces() <= (std::min)(budget_.chunk_faces(), budget_.whole_faces());
    FirstChunks chunks(input, survey);
    ChunkScatter scatter = chunks.write(
        folder_, 1, is_whole ? plan.input.used_vertices : chunk_vertices(plan.input),
        budget_.buffers(), [&](double fraction) { notify(FileStage::partition, fraction); });
    plan.input.doubled_faces = scatter.count_doubled();
    plan.input.counted_faces -= plan.input.doubled_faces;
    plan.is_last = is_whole || plan.input.counted_faces <= target_.faces(plan.input.counted_faces);
    plan.label_table = chunks.label_table();
    plan.bytes_read = 3 * 24 * plan.input.vertices + 2 * input.file().size();
    begin(std::move(plan), scatter);
  }

  /// Sets the cost, in the engine's unit, at which the chunks of the phase end.
  void resolve(float limit) {
    plan_.limit = static_cast<double>(limit);
    plan_.is_by_count = !is_limit(plan_.limit);
    plan_.is_resolved = true;
    plan_.write(folder_.plan(plan_.phase));
  }

  /// Has that chunk been simplified? Its file is read completely, to be certain.
  bool is_done(std::size_t chunk) const {
    const auto path = folder_.left(plan_.phase, chunk);
    const auto header = Survivors::header(path, chunk_key(), plan_.phase, chunk);
    if (!header)
      return false;
    try {
      Survivors::read(path, *header);
      return true;
    } catch (const std::runtime_error&) {
      return false; // the chunk is simplified again
    }
  }

  void write(std::size_t chunk, const Survivors& survivors, const ChunkCounters& counters) const {
    SurvivorsHeader header;
    header.key = chunk_key();
    header.phase = plan_.phase;
    header.chunk = chunk;
    header.counters = counters;
    survivors.write(folder_.left(plan_.phase, chunk), header);
  }

  /// Ends a phase whose chunks are all done, and begins the next one; or, if the phase has left far
  /// too few faces, begins it again so that it leaves more. Returns false if it was the last phase.
  bool end_phase(AddState add) {
    NextChunks next(folder_, plan_.phase, headers(), add);
    if (has_taken_too_much(next.faces()))
      return take_back(next.faces()), true;
    PhasePlan plan = plan_;
    ++plan.phase;
    ++plan.step;
    plan.attempt = 0;
    plan.is_by_count = false;
    plan.faces_after_phases.push_back(next.faces());
    count_up(plan);
    const bool fits = next.faces() <= budget_.whole_faces();
    const std::vector<std::uint64_t>& left = plan_.faces_after_phases;
    const std::uint64_t before = left.empty() ? plan_.input.counted_faces : left.back();
    const bool is_enough = schedule().is_enough(plan_.step, before, next.faces(), target());
    const bool is_met = target_.is_limited() && Schedule::is_met(next.faces(), plan_.faces_wanted);
    if (plan_.is_last || plan_.is_exact ||
        (!fits && is_enough && !Schedule::can_share(next.faces(), target())) ||
        (!fits && is_met && Schedule::is_still(before, next.faces())))
      return false;
    plan.is_exact = !fits && is_enough;
    plan.is_last = fits && (plan.step >= schedule().size() || next.faces() <= target() || is_met ||
                            (target_.is_limited() && next.faces() <= budget_.chunk_faces()));
    folder_.remove_chunks(plan_.phase); // their results exist
    folder_.begin_phase(plan.phase);
    const std::uint64_t most = plan.is_last ? next.vertices() : budget_.chunk_vertices();
    const ChunkScatter scatter = next.write(plan.input.box, plan.input.vertices, most,
                                            Schedule::fraction(plan.phase), budget_.buffers());
    begin(std::move(plan), scatter);
    remove_phase_before();
    return true;
  }

  /// Returns a report of the phases that have ended.
  FileReport report() const {
    FileReport report;
    report.doubled_faces = static_cast<std::size_t>(plan_.input.doubled_faces);
    report.unused_not_finite = plan_.input.unused_not_finite;
    report.welded_vertices = plan_.input.made.welded;
    report.fans = plan_.input.made.fans;
    report.short_faces = plan_.input.made.short_faces + plan_.input.faces -
                         plan_.input.counted_faces - plan_.input.doubled_faces;
    report.faces_before = static_cast<std::size_t>(plan_.input.faces);
    report.counted_faces = static_cast<std::size_t>(plan_.input.counted_faces);
    report.vertices_before = static_cast<std::size_t>(plan_.input.vertices);
    report.phases = plan_.phase;
    report.chunks = static_cast<std::size_t>(plan_.first_chunks);
    report.shared_vertices = plan_.first_shared;
    report.faces_of_phases = plan_.faces_after_phases;
    report.diagonal = diagonal();
    report.peak_memory = MemoryBudget::peak();
    add_counters(plan_, report);
    return report;
  }

  /// Adds the counts of the current phase, which has ended.
  void add_last_phase(FileReport& report) const {
    PhasePlan plan = plan_;
    count_up(plan);
    add_counters(plan, report);
    const std::vector<SurvivorsHeader> chunks = headers();
    const std::uint64_t left = add_distances(chunks, report);
    report.faces_of_phases.push_back(left);
    report.is_count_exact = plan_.is_last || left == target();
    report.stop =
        plan_.is_last ? static_cast<StopReason>(chunks.front().counters.stop)
        : left == target() || (left > target() && target_.is_limited()) ? StopReason::target_met
        : left < target() && target() - left <= chunks.size()           ? StopReason::target_passed
                                                              : StopReason::target_unreachable;
  }

  /// Merges the remaining chunks into one file.
  void merge(const std::filesystem::path& output, FileReport& report) const {
    const std::vector<SurvivorsHeader> chunks = headers();
    const ChunkMerge merger(folder_, plan_, scalars_, chunks);
    report.bytes_written += merger.write(output, plan_.input.has_doubles);
    report.faces_after = static_cast<std::size_t>(merger.faces());
    report.vertices_after = static_cast<std::size_t>(merger.vertices());
  }

  /// Returns the headers of the phase's chunks. Throws std::logic_error if one is not done.
  std::vector<SurvivorsHeader> headers() const {
    std::vector<SurvivorsHeader> result;
    for (std::size_t p = 0; p < plan_.chunks.size(); ++p) {
      const auto header =
          Survivors::header(folder_.left(plan_.phase, p), chunk_key(), plan_.phase, p);
      if (!header)
        throw std::logic_error("quadrille::PartitionedSimplifier: chunk " + std::to_string(p) +
                               " of phase " + std::to_string(plan_.phase) +
                               " has not been simplified");
      result.push_back(*header);
    }
    return result;
  }

private:
  // Adds the distances of the chunks from the input. Returns the number of their faces.
  static std::uint64_t add_distances(const std::vector<SurvivorsHeader>& chunks,
                                     FileReport& report) {
    std::uint64_t left = 0;
    Report::UsedTolerance used{-1, {}};
    report.distance_bound = report.hausdorff_bound = 0;
    for (const SurvivorsHeader& h : chunks) {
      left += h.faces;
      report.distance_bound = (std::max)(report.distance_bound, h.counters.distance_bound);
      report.hausdorff_bound = (std::max)(report.hausdorff_bound, h.counters.hausdorff_bound);
      if (h.counters.used_tolerance > used.fraction)
        used = {h.counters.used_tolerance, h.counters.place_of_used};
    }
    if (used.fraction >= 0 &&
        std::isfinite(report.hausdorff_bound)) // otherwise points have been lost
      report.used_tolerance = used;
    return left;
  }

  static void add_counters(const PhasePlan& plan, FileReport& report) {
    report.contractions = static_cast<std::size_t>(plan.contractions);
    report.error = plan.error;
    for (std::size_t i = 0; i < rejection_causes; ++i)
      report.rejections[i] = static_cast<std::size_t>(plan.rejections[i]);
    report.bytes_read = plan.bytes_read;
    report.bytes_written = plan.bytes_written;
  }

  // Returns as many vertices as belong to the number of faces that fit.
  std::uint64_t chunk_vertices(const InputFacts& input) const {
    const double per_face =
        static_cast<double>(input.used_vertices) / static_cast<double>(input.counted_faces);
    const double count = static_cast<double>(budget_.chunk_faces()) * (std::min)(per_face, 1.0);
    return std::max<std::uint64_t>(static_cast<std::uint64_t>(count), 1);
  }

  // The remaining chunks belong to one attempt.
  std::uint64_t chunk_key() const { return key_ + plan_.attempt; }

  // A limit is found from samples, which may have shown fewer removable faces than there were.
  bool has_taken_too_much(std::uint64_t left) const {
    if (plan_.is_last || plan_.is_exact || plan_.is_by_count)
      return false;
    std::uint64_t before = 0;
    for (const ChunkFiles& p : plan_.chunks)
      before += p.face_count();
    const std::uint64_t aim = (std::min)(plan_.faces_wanted, before);
    return left < (std::min)(target(), before) || left < aim - aim / 3;
  }

  // Costs are areas times squared distances, so they grow about as the face count to the power of
  // -3. If a lower limit did not help, or if costs are too small to be distinguished, each chunk
  // contributes its share of a count.
  void take_back(std::uint64_t left) {
    const double ratio = static_cast<double>(left) / static_cast<double>(plan_.faces_wanted);
    plan_.limit *= ratio * ratio * ratio;
    plan_.is_by_count = plan_.attempt > 0 || !is_limit(plan_.limit);
    ++plan_.attempt;
    plan_.write(folder_.plan(plan_.phase));
  }
  static bool is_limit(double limit) { return limit > 0x1p-120 && limit < 0x1p120; }

  // Adds the counts of the phase that has ended.
  void count_up(PhasePlan& plan) const {
    for (const SurvivorsHeader& h : headers()) {
      plan.contractions += h.counters.contractions;
      plan.error = (std::max)(plan.error, h.counters.error);
      plan.greatest_tolerance = (std::max)(plan.greatest_tolerance, h.counters.greatest_tolerance);
      for (std::size_t i = 0; i < rejection_causes; ++i)
        plan.rejections[i] += h.counters.rejections[i];
      plan.bytes_written += h.content_size();
    }
    for (const ChunkFiles& p : plan_.chunks)
      plan.bytes_read += p.vertices.size + p.faces.size;
  }

  void begin(PhasePlan plan, const ChunkScatter& scatter) {
    plan.chunks = scatter.chunks();
    if (plan.phase == 1) {
      plan.first_chunks = plan.chunks.size();
      plan.first_shared = scatter.shared_count();
    }
    plan.boundaries =
        TrueBoundaries::write(folder_, plan.phase, plan.chunks.size(), scatter.shared());
    for (const ChunkFiles& p : plan.chunks) {
      plan.bytes_written += p.vertices.size + p.faces.size;
      plan.bytes_read += p.faces.size;
    }
    plan_ = plan;
    plan_.faces_wanted = schedule().wanted(plan.step, target());
    plan_.is_resolved = plan.is_last || plan.is_exact;
    plan_.is_by_count = false;
    plan_.write(folder_.plan(plan.phase));
    folder_.remove_welded();
  }

  JobFolder folder_;
  MemoryBudget budget_;
  FileTarget target_;
  VertexScalars scalars_;
  double importance_;
  std::uint64_t key_;
  FileEstimate estimate_;
  PhasePlan plan_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_CHUNKED_JOB_H
