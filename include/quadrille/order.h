#ifndef QUADRILLE_ORDER_H
#define QUADRILLE_ORDER_H

#include <quadrille/internal/base/text.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <variant>

namespace quadrille {

/// The cheapest pair first: the order of the 1997 paper, and the default. Costs are compared as
/// floats; equal ones by the indices of the vertices, which the engine chooses by itself where a
/// large surface is in no spatial order. Of a vertex of more than 64 faces only the cheapest pairs
/// take part at first, the others when these are done, so that it does not take the square of its
/// faces at every contraction.
struct GreedyOrder {
  /// For costs that look at the surface as it is now (MemorylessQuadric, ThinFeatureQuadric): after
  /// each contraction, cost the pairs of the neighbouring vertices anew as well, since the faces
  /// around them have changed; but not where the vertex or its neighbour has more than 64 faces.
  /// Without it, a pair that has become more costly goes back when its turn comes, and one that has
  /// become cheaper may wait for too long: only where the unevenness of the faces around a vertex
  /// has fallen to 0.7 of what it was are its pairs costed anew. Takes two to three times the time,
  /// for an error that is lower by half a percent.
  ///
  /// Source: as Lindstrom and Turk do, Fast and Memory Efficient Polygonal Simplification, 1998.
  bool eager = false;
};

/// Passes over the surface instead of a queue: all pairs are costed, and the cheapest of them
/// contracted where neither end has been contracted in this pass. Parallel, and close to the error
/// of GreedyOrder.
///
/// Passes end where the target comes near, or where they find little to contract; the rest is done
/// in greedy order. So targets are met as exactly, and all policies, filters and constraints hold
/// as well. A pair that the stop policy would stop at is left to the greedy order.
///
/// A pass works on blocks of neighbouring vertices, each by itself, and on the pairs between blocks
/// at its end. The blocks do not depend on the number of threads, so neither does the result.
struct RelaxedOrder {
  /// The part of the pairs, the cheapest, that a pass looks at: in (0, 1]. Less is slower and
  /// closer to greedy order; with `refresh`, 0.2 comes close to MemorylessQuadric in greedy order.
  double share = 0.5;

  /// After each pass, let vertices remember the surface as it is then, instead of all planes that
  /// have gone into them: a lower error, except at the lowest counts, where thin parts are lost.
  bool refresh = false;

  /// From 1 to 1024. More than one needs oneTBB: link quadrille::parallel, or define
  /// QUADRILLE_WITH_TBB, in each translation unit that asks for it; `simplify` throws
  /// std::invalid_argument in others. Policies are then called from several threads at a time.
  unsigned threads = 1;

  /// Throws std::invalid_argument for a share outside of (0, 1] and for a number of threads that
  /// is none from 1 to 1024.
  void validate() const {
    if (!(share > 0 && share <= 1))
      throw std::invalid_argument("quadrille::RelaxedOrder: the share " + internal::text_of(share) +
                                  " is not in (0, 1]");
    if (threads == 0 || threads > 1024)
      throw std::invalid_argument("quadrille::RelaxedOrder: " + std::to_string(threads) +
                                  " threads are not from 1 to 1024");
  }
};

/// Which of both, with its options, told at run time: one engine is compiled for both, with results
/// to the same bits. To make passes or not, a std::optional<RelaxedOrder> is enough.
using AnyOrder = std::variant<GreedyOrder, RelaxedOrder>;

} // namespace quadrille

#endif // QUADRILLE_ORDER_H
