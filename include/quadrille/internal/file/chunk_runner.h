#ifndef QUADRILLE_INTERNAL_FILE_CHUNK_RUNNER_H
#define QUADRILLE_INTERNAL_FILE_CHUNK_RUNNER_H

#include <quadrille/internal/core/policy/guard_set.h>
#include <quadrille/internal/file/chunk_conversion.h>
#include <quadrille/internal/file/chunk_limit.h>
#include <quadrille/internal/file/chunked_job.h>
#include <quadrille/internal/file/cost_samples.h>
#include <quadrille/internal/file/job_key.h>
#include <quadrille/internal/file/loaded_chunk.h>
#include <quadrille/internal/file/sample_file.h>
#include <quadrille/simplify.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Simplifies chunks of a job: the engine with its policies.
template <class Cost, class Placement, class... Policies>
class ChunkRunner {
public:
  using Conversion = ChunkConversion<Cost>;

  static_assert(!asks_for_indices<Placement>,
                "quadrille: each chunk of a file numbers its vertices again: a placement that asks "
                "for indices in the input works only for surfaces in memory");
  static_assert(((!is_guard<Policies> || works_in_chunks<Policies>)&&...),
                "quadrille: chunks of a file are simplified one by one, in several phases, so this "
                "guard works only for surfaces in memory: NoSelfIntersection, KeepSolid{}, "
                "NormalDeviation, or one without works_in_chunks");
  static_assert(!(is_recorder<Contained<Policies>> || ...),
                "quadrille: each chunk of a file numbers its vertices again: a recorder works only "
                "for surfaces in memory");
  static_assert(
      !needs_closed_surface<Placement>,
      "quadrille: a chunk of a file is not a closed surface: hulls work only for surfaces "
      "in memory");

  /// Do boundary vertices stay?
  ChunkRunner(bool locks_boundary, Cost cost, Placement placement, const Policies&... policies)
      : locks_boundary_(locks_boundary), cost_(std::move(cost)), placement_(std::move(placement)),
        limits_(std::tuple_cat(limit_as_tuple(policies)...)),
        others_(std::tuple_cat(other_as_tuple(policies)...)) {
    std::apply([](const auto&... limit) { (validate(limit), ...); }, limits_);
  }

  void add_to(JobKey& key) const {
    key.add_number(std::uint64_t{locks_boundary_});
    key.add_policy(cost_);
    key.add_policy(placement_);
    const auto add = [&](const auto&... policy) { (key.add_policy(policy), ...); };
    std::apply(add, others_);
    std::apply(add, limits_);
  }
  /// Are distances limited?
  bool is_limited() const { return needs_of_limits().distance; }
  /// Are distances limited by tolerances?
  bool is_limited_by_tolerance() const { return needs_of_limits().tolerance; }

  /// Simplifies a chunk and writes the result; returns false, and writes nothing, if it is
  /// cancelled.
  template <class IsCancelled>
  bool simplify(const ChunkedJob& job, std::size_t chunk, const IsCancelled& is_cancelled) const {
    const PhasePlan& plan = job.plan();
    auto loaded = LoadedChunk::read(job.folder(), plan, chunk, Conversion::state_size);
    const std::vector<VertexId> ids = std::move(loaded.ids);
    const std::vector<bool> is_shared = loaded.is_shared;
    const std::vector<std::uint32_t> labels = loaded.labels;
    const std::vector<double> scalars = std::move(loaded.scalars);
    const std::vector<char> given = plan.is_last ? std::vector<char>() : loaded.states;
    auto surface = Conversion::chunk(std::move(loaded), plan.input.box, locks_boundary_);
    const double greatest_tolerance = take_tolerances(surface, job, scalars);
    const ChunkChannels channels = job.channels(scalars);
    auto result =
        plan.is_last || plan.is_exact || plan.is_by_count
            ? run(std::move(surface), job, channels, job.count(chunk), is_cancelled)
            : run(std::move(surface), job, channels, limit(plan, plan.limit), is_cancelled);
    if (result.report.stop == StopReason::cancelled)
      return false;
    Survivors survivors = Conversion::survivors(result, ids, is_shared, given, labels);
    survivors.scalars =
        job.scalars().rows(result.channels, result.vertices, scalars, plan.input.ranges);
    job.write(chunk, survivors, ChunkCounters::of(result.report, greatest_tolerance));
    return true;
  }

  /// Takes samples of some regions of a chunk, about a sixteenth of it together, or all of a small
  /// chunk.
  template <class IsCancelled>
  std::vector<CostSample> samples(const ChunkedJob& job, std::size_t chunk,
                                  std::size_t sample_count, const IsCancelled& is_cancelled) const {
    const PhasePlan& plan = job.plan();
    auto loaded = LoadedChunk::read(job.folder(), plan, chunk, Conversion::state_size);
    const std::size_t vertices =
        std::max<std::size_t>(loaded.ids.size() / 16 / sample_count, least_sample);
    if (vertices * sample_count >= loaded.ids.size() / 2)
      return {sample(std::move(loaded), job, is_cancelled)};
    std::vector<CostSample> result;
    for (std::size_t i = 0; i < sample_count; ++i)
      result.push_back(
          sample(ChunkSample::of(loaded, vertices, i + chunk * 0x9E3779B1U, Conversion::state_size),
                 job, is_cancelled));
    return result;
  }

private:
  static constexpr std::size_t least_sample = 8000; // the least number of vertices in a sample

  CostLimit limit(const PhasePlan& plan, double engine_cost) const {
    return cost_limit(cost_, Conversion::box(plan.input.box), engine_cost);
  }

  template <class IsCancelled>
  CostSample sample(LoadedChunk chunk, const ChunkedJob& job,
                    const IsCancelled& is_cancelled) const {
    const SampleCounts counts(chunk);
    const std::vector<double> scalars = std::move(chunk.scalars);
    const ChunkChannels channels = job.channels(scalars);
    auto surface = Conversion::chunk(std::move(chunk), job.plan().input.box, locks_boundary_);
    take_tolerances(surface, job, scalars);
    const CostLimit unlimited = limit(job.plan(), std::numeric_limits<double>::infinity());
    return {counts.free_faces,
            run(std::move(surface), job, channels, unlimited, is_cancelled).costs};
  }

  // First the vertices have tolerances, and afterwards the faces do. Returns the greatest tolerance
  // of the input's faces, as far as the chunk knows it.
  static double take_tolerances(Chunk<Cost>& surface, const ChunkedJob& job,
                                const std::vector<double>& scalars) {
    const std::optional<std::size_t> place = job.scalars().tolerance();
    if (!place)
      return 0;
    surface.greatest_tolerance = job.plan().greatest_tolerance;
    if (job.plan().phase > 1)
      return surface.greatest_tolerance;
    for (std::size_t i = *place; i < scalars.size(); i += job.scalars().size())
      surface.tolerances.push_back(scalars[i]);
    double greatest = 0;
    for (const auto& [a, b, c] : surface.triangles)
      greatest = (std::max)(greatest, (std::min)({surface.tolerances[a], surface.tolerances[b],
                                                  surface.tolerances[c]}));
    return (std::min)(greatest, 2 * surface.box.diagonal()); // a greater tolerance limits nothing
  }

  template <class IsCancelled>
  struct Watch {
    const IsCancelled* is_cancelled;
    bool proceed(const Status&) const { return !(*is_cancelled)(); }
  };

  Needs needs_of_limits() const {
    return std::apply([](const auto&... limit) { return (needs_now(limit) | ... | Needs{}); },
                      limits_);
  }

  // Ends the chunk with the phase and at the distance limit, if there is one.
  template <class Stop>
  auto limited(const Stop& stop, const ChunkedJob& job) const {
    if constexpr (has_limit)
      return AnyOf{stop, limit_in_chunk(std::get<0>(limits_), job.diagonal())};
    else
      return stop;
  }

  // A chunk without channels uses the engine without channels, and so does not pay for them.
  template <class Stop, class IsCancelled>
  ChunkResult<Cost> run(Chunk<Cost> surface, const ChunkedJob& job, const ChunkChannels& channels,
                        const Stop& stop, const IsCancelled& is_cancelled) const {
    const auto run_with = [&](const auto&... arguments) {
      return simplify_chunk<Cost, Placement>(
          std::move(surface), cost_, placement_, limited(stop, job), arguments...,
          CGAL::parameters::visitor(Watch<IsCancelled>{&is_cancelled}));
    };
    return std::apply(
        [&](const auto&... policies) {
          return channels.channels.empty() ? run_with(policies...)
                                           : run_with(policies..., channels);
        },
        others_);
  }

  using Limits = decltype(std::tuple_cat(limit_as_tuple(std::declval<const Policies&>())...));
  using Others = decltype(std::tuple_cat(other_as_tuple(std::declval<const Policies&>())...));
  static constexpr bool has_limit = std::tuple_size_v<Limits> > 0;
  static_assert(std::tuple_size_v<Limits> <= 1, "quadrille: there are two distance limits");

  bool locks_boundary_;
  Cost cost_;
  Placement placement_;
  Limits limits_; // one or none
  Others others_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_CHUNK_RUNNER_H
