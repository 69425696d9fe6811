// A mesh that cannot be changed, and no argument more: CGAL has a function of this name, too.
#include "surfaces.h"

int main() {
  using namespace quadrille;
#ifdef REMEDY
  auto& surface = mesh;
#else
  const auto& surface = mesh;
#endif
  simplify(surface); // mistake
}
