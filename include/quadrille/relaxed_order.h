#ifndef QUADRILLE_RELAXED_ORDER_H
#define QUADRILLE_RELAXED_ORDER_H

#include <quadrille/internal/core/base/text.h>
#include <quadrille/internal/core/order/relaxed_passes.h>
#include <quadrille/order.h>

#include <stdexcept>
#include <string>
#include <variant>

namespace quadrille {

/// Passes over the surface instead of a queue: all pairs are costed, and the cheapest of them are
/// contracted if neither end has been contracted in this pass. It is parallel, and its error is
/// close to that of GreedyOrder.
///
/// Passes end near the target, or when they find little to contract; the rest is done in greedy
/// order. So targets are met as exactly as in GreedyOrder, and all policies, filters and
/// constraints apply. A pair at which the stop policy would stop is left to the greedy order.
///
/// A pass works on blocks of neighbouring vertices, each by itself, and on the pairs between blocks
/// at its end. The blocks do not depend on the number of threads, so neither does the result.
struct RelaxedOrder {
  /// The fraction of the pairs, the cheapest ones, that a pass considers: in (0, 1]. A smaller one
  /// is slower and closer to greedy order; with `refresh`, 0.2 comes close to MemorylessQuadric in
  /// greedy order.
  double share = 0.5;

  /// Recomputes the states of vertices from the current surface after each pass, instead of
  /// accumulating all planes: this lowers the error, except at the lowest counts, where thin
  /// features are lost.
  bool refresh = false;

  /// From 1 to 1024. More than one needs oneTBB: link quadrille::parallel, or define
  /// QUADRILLE_WITH_TBB, in each translation unit that uses it; `simplify` throws
  /// std::invalid_argument in others. Policies are then called from several threads at a time.
  unsigned threads = 1;

  /// Throws std::invalid_argument for a share outside of (0, 1] and for a number of threads outside
  /// of [1, 1024].
  void validate() const {
    if (!(share > 0 && share <= 1))
      throw std::invalid_argument("quadrille::RelaxedOrder: the share " + internal::text_of(share) +
                                  " is not in (0, 1]");
    if (threads == 0 || threads > 1024)
      throw std::invalid_argument("quadrille::RelaxedOrder: " + std::to_string(threads) +
                                  " threads are not from 1 to 1024");
  }
};

/// Either order, with its options, chosen at run time: one engine is compiled for both, with
/// bit-identical results. To choose passes or not, a std::optional<RelaxedOrder> is enough.
using AnyOrder = std::variant<GreedyOrder, RelaxedOrder>;

} // namespace quadrille

#endif // QUADRILLE_RELAXED_ORDER_H
