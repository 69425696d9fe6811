#ifndef QUADRILLE_ORDER_H
#define QUADRILLE_ORDER_H

namespace quadrille {

/// The cheapest pair first: the order of the 1997 paper, and the default. Costs are compared as
/// floats; equal ones by the indices of the vertices, which the engine chooses by itself where a
/// large surface is in no spatial order. Of a vertex of more than 64 faces only the cheapest pairs
/// take part at first, the others when these are done, so that it does not take the square of its
/// faces at every contraction.
///
/// Costs that look at the surface as it is now (MemorylessQuadric, ThinFeatureQuadric) change beside
/// each contraction. A pair that has become more costly goes back when its turn comes; where the
/// unevenness of the faces around a vertex has fallen to 0.7 of what it was, its pairs are costed
/// anew.
struct GreedyOrder {};

struct RelaxedOrder; // is in <quadrille/relaxed_order.h>: include that to use it

} // namespace quadrille

#endif // QUADRILLE_ORDER_H
