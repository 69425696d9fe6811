// A stop policy that says what it needs this time, and not what its type may need.
#include "surfaces.h"

struct Listens {
#ifdef REMEDY
  static constexpr quadrille::Needs needs = {.cost = true};
#endif
  quadrille::Needs needs_now() const {
    return {.cost = true};
  }
  bool operator()(const quadrille::Status& status) const {
    return status.next_cost > 1;
  }
};

int main() {
  using namespace quadrille;
  simplify(mesh, Listens{}); // mistake
}
