// A mesh that cannot be changed, and no argument more: CGAL has a function of this name, too.
#include "surfaces.h"

int main() {
  using namespace quadrille;
#ifdef REMEDY
  auto& surface = mesh;
#else
  const CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3> surface;
#endif
  simplify(surface); // mistake
}
