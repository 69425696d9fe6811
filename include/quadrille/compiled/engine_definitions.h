#ifndef QUADRILLE_COMPILED_ENGINE_DEFINITIONS_H
#define QUADRILLE_COMPILED_ENGINE_DEFINITIONS_H

#include <quadrille/channels.h>
#include <quadrille/distance_limits.h>
#include <quadrille/internal/core/call/compiled_engines.h>
#include <quadrille/internal/core/order/relaxed_passes.h>
#include <quadrille/internal/core/recording/record_writer.h>

/// \file
/// The includes of an engine of quadrille::compiled, for the sources that define one.

#endif // QUADRILLE_COMPILED_ENGINE_DEFINITIONS_H
