#ifndef QUADRILLE_INTERNAL_CORE_ORDER_HANDLE_CUTTER_H
#define QUADRILLE_INTERNAL_CORE_ORDER_HANDLE_CUTTER_H

#include <quadrille/internal/core/base/index.h>

namespace quadrille::internal {

template <class Policies>
class WorkingSurface;
template <class Policies>
class PairUpdates;
template <class Policies>
class VanishingComponents;

/// Cuts handles and tunnels in the greedy order. It is compiled only for calls that ask for it: see
/// HandleCuts, which <quadrille/simplified_topology.h> brings.
template <class Policies>
class HandleCutter {
public:
  virtual ~HandleCutter() = default;

  /// The link condition has rejected an edge: it may lie on handles.
  virtual void look_at(Index first, Index second) = 0;
  /// Does the cheapest cut cost less than `limit`?
  virtual bool has_below(double limit) = 0;
  /// Makes the cut that has_below() has found. Returns false if the stop policy is satisfied
  /// without.
  virtual bool cut_next() = 0;
};

/// The surface that a HandleCutter works on, and those that follow its cuts.
template <class Policies>
struct CutterNeeds {
  WorkingSurface<Policies>& surface;
  PairUpdates<Policies>& updates;
  VanishingComponents<Policies>& components;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ORDER_HANDLE_CUTTER_H
