#ifndef QUADRILLE_EXAMPLES_PYTHON_CALIBRATION_H
#define QUADRILLE_EXAMPLES_PYTHON_CALIBRATION_H

/// \file
/// As far as a limit allows that is measured and not added up: calibrated=True.

#include <quadrille/compiled.h>

namespace quadrille_examples {

/// Simplifies with multiples of SoupOptions::error or SoupOptions::relative_error, of which one is
/// given beside both_ways, and returns the coarsest result that is proved to be within it. If
/// SoupOptions::proceed says no, it is the coarsest until then.
quadrille::SoupResult calibrated_soup(const quadrille::SoupView& soup,
                                      const quadrille::SoupOptions& options);

} // namespace quadrille_examples

#endif
