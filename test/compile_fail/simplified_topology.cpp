// Simplified topology of a mesh, which has no room for further faces.
#include <quadrille/simplified_topology.h>

#include "surfaces.h"

int main() {
  using namespace quadrille;
#ifdef REMEDY
  simplify(points, triangles, FaceCount{4}, SimplifiedTopology{1});
#else
  simplify(mesh, FaceCount{4}, SimplifiedTopology{1}); // mistake
#endif
}
