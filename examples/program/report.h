#ifndef QUADRILLE_EXAMPLES_PROGRAM_REPORT_H
#define QUADRILLE_EXAMPLES_PROGRAM_REPORT_H

#include "../mesh_io.h"
#include "options.h"

#include <quadrille/report.h>
#include <quadrille/topology.h>

#include <iostream>
#include <string>

namespace quadrille_examples {

/// What might help where topology has kept a target from being reached; else nothing.
inline std::string hint(const Options& options, const quadrille::Report& report) {
  using quadrille::Topology;
  if (report.stop == quadrille::StopReason::cancelled)
    return "";
  const bool has_parts = report.components_after > 1;
  if (topology(options) == Topology::free)
    return has_parts && !(options.pairs_closer_than > 0)
               ? std::to_string(report.components_after) + " parts are left: " +
                     "--pairs-closer-than joins those that are closer than a distance"
               : "";
  const std::string free = "--topology free lets holes close and thin parts become sheets";
  if (has_parts && topology(options) == Topology::kept)
    return std::to_string(report.components_after) +
           " parts are left, and each keeps some faces: --drop-parts lets small ones vanish, " +
           free + ", and --pairs-closer-than also joins parts";
  return report.rejected(quadrille::Rejection::topology) > 0 ? "topology is kept: " + free : "";
}

/// Of the result `name`, on standard output, unless that is the mesh. False if the target was not
/// reached.
inline bool tell(const Options& options, const quadrille::Report& report, const std::string& name) {
  if (!options.is_quiet)
    (is_standard_output(options.output) ? std::cerr : std::cout) << report << std::endl;
  if (options.target.is_met(report.stop))
    return true;
  std::cerr << name << ": the target was not reached: " << to_string(report.stop) << '\n';
  if (const std::string help = hint(options, report); !help.empty() && !options.is_quiet)
    std::cerr << name << ": " << help << '\n';
  return false;
}
inline bool tell(const Options& options, const quadrille::Report& report) {
  return tell(options, report, options.output);
}

} // namespace quadrille_examples

#endif
