// Threads by the tag that CGAL has for them since its version 6.0.
#include "surfaces.h"

#include <quadrille/relaxed_order.h>

#include <CGAL/tags.h>

int main() {
  using namespace quadrille;
#ifdef REMEDY
  simplify(mesh, RelaxedOrder{.threads = 2});
#else
  simplify(mesh, CGAL::parameters::concurrency_tag(CGAL::Parallel_tag())); // mistake
#endif
}
