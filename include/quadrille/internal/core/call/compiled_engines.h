#ifndef QUADRILLE_INTERNAL_CORE_CALL_COMPILED_ENGINES_H
#define QUADRILLE_INTERNAL_CORE_CALL_COMPILED_ENGINES_H

#include <quadrille/internal/core/call/engine.h>
#include <quadrille/internal/core/policy/built_in_placement.h>
#include <quadrille/internal/core/policy/engine_policies.h>

/// \file
/// The engines that quadrille::compiled has: of each cost in space with a placement that is built
/// in, bare and with channels, and of colours and texture coordinates, bare. A program that links
/// it compiles adapters only, and gets the same results to the last bit; calls with other costs and
/// placements compile engines of their own. The header of each cost declares its engines.

namespace quadrille::internal {

template <class Cost, bool has_channels>
using UsualPolicies = Policies<Cost, BuiltInPlacement, has_channels>;

/// Declares or defines the instantiations of an engine: KEYWORDS is `extern template`, or
/// `template` in the one source that defines them.
#define QUADRILLE_ENGINE(KEYWORDS, COST, HAS_CHANNELS)                                             \
  KEYWORDS std::optional<ResultOf<UsualPolicies<COST, HAS_CHANNELS>>>                              \
  simplify_input<UsualPolicies<COST, HAS_CHANNELS>>(InputOf<COST::dimension, HAS_CHANNELS>,        \
                                                    const UsualPolicies<COST, HAS_CHANNELS>&,      \
                                                    bool, Report&, StopWatch&);                    \
  KEYWORDS bool run_passes<UsualPolicies<COST, HAS_CHANNELS>>(                                     \
      WorkingSurface<UsualPolicies<COST, HAS_CHANNELS>>&, const PassSettings&);                    \
  KEYWORDS std::unique_ptr<Recording<UsualPolicies<COST, HAS_CHANNELS>>>                           \
  make_recording<UsualPolicies<COST, HAS_CHANNELS>>(                                               \
      const RecordingNeeds<UsualPolicies<COST, HAS_CHANNELS>>&);                                   \
  KEYWORDS std::unique_ptr<MeasuredDistances<UsualPolicies<COST, HAS_CHANNELS>>>                   \
  make_distances<UsualPolicies<COST, HAS_CHANNELS>, false>(                                        \
      const DistanceNeeds<UsualPolicies<COST, HAS_CHANNELS>>&);                                    \
  KEYWORDS std::unique_ptr<MeasuredDistances<UsualPolicies<COST, HAS_CHANNELS>>>                   \
  make_distances<UsualPolicies<COST, HAS_CHANNELS>, true>(                                         \
      const DistanceNeeds<UsualPolicies<COST, HAS_CHANNELS>>&)

#define QUADRILLE_ENGINES(KEYWORDS, COST)                                                          \
  QUADRILLE_ENGINE(KEYWORDS, COST, false);                                                         \
  QUADRILLE_ENGINE(KEYWORDS, COST, true)

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_CALL_COMPILED_ENGINES_H
