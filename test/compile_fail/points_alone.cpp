// Points without triangles.
#include "surfaces.h"

int main() {
  using namespace quadrille;
#ifdef REMEDY
  simplify(points, triangles, FaceCount{4});
#else
  simplify(points, FaceCount{4}); // mistake
#endif
}
