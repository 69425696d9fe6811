// A visitor without a member proceed.
#include "surfaces.h"

struct Watcher {
#ifdef REMEDY
  bool proceed(const quadrille::Status&) {
    return true;
  }
#endif
};

int main() {
  using namespace quadrille;
  simplify(mesh, CGAL::parameters::visitor(Watcher())); // mistake
}
