#ifndef QUADRILLE_EXAMPLES_PROGRAM_REPORT_H
#define QUADRILLE_EXAMPLES_PROGRAM_REPORT_H

#include "../mesh_io.h"
#include "options.h"

#include <quadrille/report.h>

#include <iostream>

namespace quadrille_examples {

/// On standard output, unless that is the mesh. False if the target was not reached.
inline bool tell(const Options& options, const quadrille::Report& report) {
  if (!options.is_quiet)
    (is_standard_output(options.output) ? std::cerr : std::cout) << report << std::endl;
  if (options.target.is_met(report.stop))
    return true;
  std::cerr << options.output << ": the target was not reached: " << to_string(report.stop) << '\n';
  return false;
}

} // namespace quadrille_examples

#endif
