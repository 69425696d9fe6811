#ifndef QUADRILLE_COMPILED_ENGINE_DEFINITIONS_H
#define QUADRILLE_COMPILED_ENGINE_DEFINITIONS_H

#include <quadrille/channels.h>
#include <quadrille/compiled/engines.h>
#include <quadrille/distance_limits.h>
#include <quadrille/internal/contraction/recorder_teller.h>
#include <quadrille/internal/order/relaxed_passes.h>

/// \file
/// All that an engine of quadrille::compiled is made of, for the sources that define one.

#endif // QUADRILLE_COMPILED_ENGINE_DEFINITIONS_H
