// Levels where their recorder is meant.
#include <quadrille/levels.h>

#include "surfaces.h"

int main() {
  using namespace quadrille;
  Levels levels;
#ifdef REMEDY
  simplify(mesh, FaceCount{4}, record_into(levels));
#else
  simplify(mesh, FaceCount{4}, levels); // mistake
#endif
}
