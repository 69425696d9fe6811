#ifndef QUADRILLE_ORDER_H
#define QUADRILLE_ORDER_H

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

struct RelaxedOrder; // is in <quadrille/relaxed_order.h>: include that to use it

} // namespace quadrille

#endif // QUADRILLE_ORDER_H
