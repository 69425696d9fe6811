// A placement without a default constructor, named as a template argument only.
#include "surfaces.h"

struct Between {
  explicit Between(double ratio_) : ratio(ratio_) {}
  auto operator()(const auto&, const auto& pair) const {
    return pair.first + ratio * (pair.second - pair.first);
  }
  double ratio;
};

int main() {
  using namespace quadrille;
#ifdef REMEDY
  simplify(mesh, Between(0.25));
#else
  simplify<Quadric, Between>(mesh); // mistake
#endif
}
