// An order of which the header has been forgotten.
#include "surfaces.h"

#ifdef REMEDY
#include <quadrille/relaxed_order.h>
#endif

int main() {
  using namespace quadrille;
  simplify(mesh, RelaxedOrder{}); // mistake
}
