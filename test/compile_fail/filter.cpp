// A filter with a name of its own for what the engine asks.
#include "surfaces.h"

struct Nothing {
#ifdef REMEDY
  bool allows(const auto&) const {
    return false;
  }
#else
  bool is_allowed(const auto&) const {
    return false;
  }
#endif
};

int main() {
  using namespace quadrille;
  simplify(mesh, Nothing(), HighestDegree()); // mistake
  simplify(points, triangles, Nothing());     // mistake
}
