// A visitor that changes and can't be copied, by value.
#include "surfaces.h"

struct Watcher {
  Watcher() = default;
  Watcher(const Watcher&) = delete;
  bool proceed(const quadrille::Status&) { return ++calls < 10; }
  int calls = 0;
};

int main() {
  using namespace quadrille;
  Watcher watcher;
#ifdef REMEDY
  simplify(mesh, CGAL::parameters::visitor(std::ref(watcher)));
#else
  simplify(mesh, CGAL::parameters::visitor(watcher)); // mistake
#endif
}
