// Pairs of which the header has been forgotten.
#include "surfaces.h"

#ifdef REMEDY
#include <quadrille/threshold_pairs.h>
#endif

int main() {
  using namespace quadrille;
  simplify(mesh, ThresholdPairs(0.1)); // mistake
}
