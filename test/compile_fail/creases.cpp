// Creases for a cost that knows none.
#include "surfaces.h"

#include <boost/property_map/property_map.hpp>
#include <quadrille/memoryless_quadric.h>

template <class Key>
using All = boost::static_property_map<bool, Key>;

int main() {
  using namespace quadrille;
  const auto creases = quadrille::parameters::edge_is_crease_map(All<CGAL::SM_Edge_index>(true));
#ifdef REMEDY
  simplify<Quadric>(mesh, creases);
#else
  simplify<MemorylessQuadric>(mesh, creases); // mistake
#endif
}
