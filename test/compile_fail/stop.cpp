// A stop policy that does not look at the status.
#include "surfaces.h"

int main() {
  using namespace quadrille;
#ifdef REMEDY
  const auto stop = [](const Status& status) { return status.faces < 10; };
#else
  const auto stop = [] { return false; };
#endif
  simplify(mesh, stop);              // mistake
  simplify(points, triangles, stop); // mistake
}
