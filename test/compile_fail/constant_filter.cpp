// A filter and a stop policy that change when they are asked.
#include "surfaces.h"

struct Every {
#ifdef REMEDY
  bool allows(const auto&) const {
    return true;
  }
#else
  bool allows(const auto&) {
    return true;
  }
#endif
};

int main() {
  using namespace quadrille;
  std::size_t calls = 0;
#ifdef REMEDY
  const auto stop = [&calls](const Status&) { return ++calls > 9; };
#else
  const auto stop = [calls](const Status&) mutable { return ++calls > 9; };
#endif
  simplify(mesh, Every{}); // mistake
  simplify(mesh, stop);    // mistake
}
