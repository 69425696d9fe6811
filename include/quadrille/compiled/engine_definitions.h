#ifndef QUADRILLE_COMPILED_ENGINE_DEFINITIONS_H
#define QUADRILLE_COMPILED_ENGINE_DEFINITIONS_H

#include <quadrille/channels.h>
#include <quadrille/distance_limits.h>
#include <quadrille/internal/core/call/compiled_engines.h>
#include <quadrille/internal/core/order/relaxed_passes.h>
#include <quadrille/internal/core/recording/record_writer.h>

/// \file
/// All that an engine of quadrille::compiled is made of, for the sources that define one.

#endif // QUADRILLE_COMPILED_ENGINE_DEFINITIONS_H
