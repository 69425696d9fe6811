// A policy of CGAL's.
#include "surfaces.h"

#include <quadrille/edge_length.h>

int main() {
  using namespace quadrille;
#ifdef REMEDY
  simplify(mesh, EdgeLength{}, MidpointPlacement{});
#else
  simplify(mesh, CGAL::parameters::get_cost(EdgeLength{})); // mistake
#endif
}
