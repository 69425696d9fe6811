// A stop predicate of CGAL's.
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_ratio_stop_predicate.h>

#include "surfaces.h"

int main() {
  using namespace quadrille;
  const CGAL::Surface_mesh_simplification::Count_ratio_stop_predicate<CGAL::Surface_mesh<Point>>
      stop(0.1);
#ifdef REMEDY
  simplify(mesh, CgalStop(stop));
#else
  simplify(mesh, stop); // mistake
#endif
}
