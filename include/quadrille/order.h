#ifndef QUADRILLE_ORDER_H
#define QUADRILLE_ORDER_H

namespace quadrille {

/// The cheapest pair first: the order of the 1997 paper, and the default. Costs are compared as
/// floats; equal ones are ordered by the indices of the vertices, which the engine renumbers if a
/// large surface is in no spatial order. For a vertex of more than 64 faces only the cheapest pairs
/// are in the queue at first, and the others follow when these are done, so that its contractions
/// do not take quadratic time.
///
/// Costs that depend on the current surface (MemorylessQuadric, ThinFeatureQuadric) change next to
/// each contraction. A pair that has become more costly goes back into the queue when its turn
/// comes. If the unevenness of the faces around a vertex has fallen to 0.7 of its old value, the
/// pairs of the vertex are costed again.
struct GreedyOrder {};

struct RelaxedOrder; // is in <quadrille/relaxed_order.h>: include that to use it

} // namespace quadrille

#endif // QUADRILLE_ORDER_H
