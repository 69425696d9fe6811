#ifndef QUADRILLE_PAIRS_H
#define QUADRILLE_PAIRS_H

namespace quadrille {

/// The edges of the surface: those that it has at the beginning and those that contractions make.
/// Disjoint parts are never joined.
struct EdgePairs {
  /// Every edge is a pair at any time, so there is nothing to select.
  static constexpr bool includes_edges = true;

  void operator()(const auto& /*surface*/, const auto& /*emit*/) const {}
};

} // namespace quadrille

#endif // QUADRILLE_PAIRS_H
