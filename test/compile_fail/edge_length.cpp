// EdgeLength with the default placement: every position costs the same.
#include "surfaces.h"

#include <quadrille/edge_length.h>

int main() {
  using namespace quadrille;
#ifdef REMEDY
  simplify<EdgeLength, MidpointPlacement>(mesh);
#else
  simplify<EdgeLength>(mesh); // mistake
#endif
}
