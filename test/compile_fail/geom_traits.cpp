// A kernel that is not the one of the points.
#include "surfaces.h"

int main() {
  using namespace quadrille;
#ifdef REMEDY
  using Kernel = CGAL::Simple_cartesian<double>;
#else
  using Kernel = CGAL::Simple_cartesian<float>;
#endif
  simplify(mesh, CGAL::parameters::geom_traits(Kernel())); // mistake
}
