// A mesh that cannot be changed.
#include "surfaces.h"

int main() {
  using namespace quadrille;
#ifdef REMEDY
  auto& surface = mesh;
#else
  const auto& surface = mesh;
#endif
  simplify(surface, FaceCount{10}); // mistake
}
