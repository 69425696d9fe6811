#ifndef QUADRILLE_INTERNAL_CORE_POLICY_PAIR_SOURCE_H
#define QUADRILLE_INTERNAL_CORE_POLICY_PAIR_SOURCE_H

#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/pairs.h>

#include <concepts>
#include <functional>
#include <utility>

namespace quadrille::internal {

/// A type-erased pair policy.
class PairSource {
public:
  template <class Pairs>
  static PairSource of(Pairs pairs) {
    PairSource source;
    source.includes_edges_ = internal::includes_edges<Pairs>;
    source.ignores_indices_ = internal::ignores_indices<Pairs>;
    if constexpr (!std::same_as<Pairs, EdgePairs>)
      source.select_ = std::move(pairs);
    return source;
  }

  /// Is every edge a pair at any time?
  bool includes_edges() const { return includes_edges_; }
  /// Does it look at points and not at their indices?
  bool ignores_indices() const { return ignores_indices_; }
  /// Does it select pairs of its own, so that it has to see the surface?
  bool selects() const { return static_cast<bool>(select_); }
  void operator()(const SurfaceView& surface, const EmitPair& emit) const {
    select_(surface, emit);
  }

private:
  PairSource() = default;

  std::function<void(const SurfaceView&, const EmitPair&)> select_;
  bool includes_edges_ = true, ignores_indices_ = true;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_POLICY_PAIR_SOURCE_H
