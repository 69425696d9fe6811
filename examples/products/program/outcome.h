#ifndef QUADRILLE_EXAMPLES_PROGRAM_OUTCOME_H
#define QUADRILLE_EXAMPLES_PROGRAM_OUTCOME_H

/// \file
/// What the program tells of its results: a line for people, hints, and figures as JSON.

#include "figures.h"
#include "hidden.h"
#include "measure.h"
#include "options.h"

#include <quadrille/file_report.h>
#include <quadrille/report.h>
#include <quadrille/verdict.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace quadrille_examples {

/// What came of a run with one option more.
struct Trial {
  std::string option;
  quadrille::Report report;
};

/// A result of a run.
struct Outcome {
  std::string file; ///< that it is written to, or a name for it
  Target target;
  quadrille::Report report;
  double diagonal = 0; ///< of the input
  std::optional<Measurement> measured = {};
  std::optional<quadrille::Verdict> verdict = {};
  std::optional<quadrille::FileReport> parts = {}; ///< of a run by parts
  bool has_labels = false; ///< has the input regions of several labels, materials say?
  std::optional<HiddenSummary> hidden = {}; ///< of the input, if --hidden asks for it
  /// Those that are better, if any were tried because the target was not reached.
  std::optional<std::vector<Trial>> trials = {};

  bool is_target_met() const { return target.is_met(report.stop); }
};

/// What keeps a surface from being simplified further, and what would help.
std::vector<std::string> hints(const Options& options, const Outcome& outcome);

/// Prints what there is to say, and writes the report that is asked for. False if a target was not
/// reached. Throws BrokenPromise, at the end, if a result does not keep what was promised.
bool tell(const Options& options, const std::vector<Outcome>& outcomes);

} // namespace quadrille_examples

#endif
