#ifndef QUADRILLE_EXAMPLES_PROGRAM_TRIALS_H
#define QUADRILLE_EXAMPLES_PROGRAM_TRIALS_H

/// \file
/// Which options would bring a run nearer to a target that it has not reached: they are tried out
/// before they are named.

#include "options.h"
#include "outcome.h"
#include "progress_line.h"

#include <quadrille/pairs.h>
#include <quadrille/report.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// A run with one option more.
struct AskedTrial {
  std::string option;
  Options options;
};

/// Is anything refused for where vertices would go, which another placement might choose better?
inline bool is_place_an_obstacle(const Options& options, const quadrille::Report& report) {
  using quadrille::Rejection;
  const std::size_t refused =
      report.rejected(Rejection::self_intersection) + report.rejected(Rejection::normal_deviation);
  return options.soup.cost != quadrille::SoupOptions::Cost::edge_length && refused > 0;
}

/// What holds a run of these options more than it has to, unless it was asked for.
inline std::vector<AskedTrial> trials_of(const Options& options, const quadrille::Report& report) {
  using Placement = quadrille::SoupOptions::Placement;
  std::vector<AskedTrial> trials;
  const auto add = [&](const std::string& option, auto change) {
    trials.push_back({option, options});
    change(trials.back().options);
  };
  if (topology(options) == quadrille::Topology::kept && !options.soup.keep_solid &&
      report.components_after > 1)
    add("--drop-parts", [](Options& o) {
      o.drops_components = true;
      o.keeps_components = false;
    });
  if (topology(options) != quadrille::Topology::free && !options.soup.keep_solid)
    add("--topology free", [](Options& o) {
      o.drops_components = o.keeps_components = false;
      o.soup.topology = quadrille::Topology::free;
    });
  if (options.textures.seams == quadrille::Seams::kept &&
      report.rejected(quadrille::Rejection::seam) > 0)
    add("--seams soft", [](Options& o) { o.textures.seams = quadrille::Seams::soft; });
  if (is_place_an_obstacle(options, report))
    for (const auto placement : {Placement::endpoint, Placement::optimal})
      if (placement != options.soup.placement.value_or(Placement::optimal))
        add(placement == Placement::optimal ? "--placement optimal" : "--placement endpoint",
            [placement](Options& o) { o.soup.placement = placement; });
  return trials;
}

/// From so many faces on nothing is tried: each takes as long as the run itself.
inline constexpr std::size_t most_faces_to_try = 500'000;

/// Should options be tried after a run of a surface of so many faces to one target?
inline bool may_be_tried(const Options& options, std::size_t faces) {
  return !options.is_quiet && options.levels.empty() && options.record.empty() &&
         !options.target.is_limited() && faces <= most_faces_to_try;
}

/// Where the target was not reached, tries what run(options) gives, a report, and tells the outcome
/// of those that come nearer to the target, by at least a twentieth of the faces, and do no harm
/// that shows, or hardly more than is done. What cannot be combined with the options is left out.
inline void try_options(const Options& options, Outcome& outcome, ProgressLine& progress,
                        const std::function<quadrille::Report(const Options&)>& run) {
  if (outcome.is_target_met())
    return;
  progress.show_stage("trying other options");
  const quadrille::Report& report = outcome.report;
  const double most_faces = 0.95 * static_cast<double>(report.faces_after);
  const double most_error = (std::max)(1.5 * report.error, 0.02 * outcome.diagonal);
  outcome.trials.emplace();
  for (const AskedTrial& trial : trials_of(options, report)) {
    try {
      const quadrille::Report got = run(trial.options);
      if (got.stop != quadrille::StopReason::cancelled && got.faces_after > 0 &&
          static_cast<double>(got.faces_after) <= most_faces && got.error <= most_error)
        outcome.trials->push_back({trial.option, got});
    } catch (const std::exception&) {
      // It does not go with another option.
    }
  }
  progress.clear();
}

} // namespace quadrille_examples

#endif
