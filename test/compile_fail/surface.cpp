// A mesh or a soup that cannot be changed.
#include "surfaces.h"

int main() {
  using namespace quadrille;
#ifdef REMEDY
  auto& surface = mesh;
  auto& corners = triangles;
#else
  const auto& surface = mesh;
  const auto& corners = triangles;
#endif
  simplify(surface, FaceCount{10});             // mistake
  simplify<Quadric, OptimalPlacement>(surface); // mistake
  simplify(points, corners);                    // mistake
}
