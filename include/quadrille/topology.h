#ifndef QUADRILLE_TOPOLOGY_H
#define QUADRILLE_TOPOLOGY_H

namespace quadrille {

/// Whether contractions may change the topology of the surface.
enum class Topology {
  kept, ///< the link condition is asked: a manifold stays one, with its genus, borders and parts
  free  ///< as in the 1997 paper: parts join, holes close, edges of three faces may arise
};

} // namespace quadrille

#endif // QUADRILLE_TOPOLOGY_H
