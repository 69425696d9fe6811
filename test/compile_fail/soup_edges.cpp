// Constrained edges of a soup.
#include "surfaces.h"

#include <boost/property_map/property_map.hpp>

template <class Key>
using All = boost::static_property_map<bool, Key>;

int main() {
  using namespace quadrille;
  const All<std::size_t> all(true);
#ifdef REMEDY
  simplify<Quadric>(points, triangles, CGAL::parameters::vertex_is_constrained_map(all));
#else
  simplify<Quadric>(points, triangles, CGAL::parameters::edge_is_constrained_map(all)); // mistake
#endif
}
