// Triangles of floating-point indices.
#include "surfaces.h"

int main() {
  using namespace quadrille;
#ifdef REMEDY
  std::vector<std::array<int, 3>> faces;
#else
  std::vector<std::array<double, 3>> faces;
#endif
  simplify(points, faces);                // mistake
  simplify(points, faces, FaceCount{10}); // mistake
}
