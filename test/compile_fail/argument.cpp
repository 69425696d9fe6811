// A number where the target is meant.
#include "surfaces.h"

int main() {
  using namespace quadrille;
#ifdef REMEDY
  const FaceCount target{10};
#else
  const int target = 10;
#endif
  simplify(mesh, target);                      // mistake
  simplify(mesh, EndpointPlacement{}, target); // mistake
  simplify(points, triangles, target);         // mistake
}
