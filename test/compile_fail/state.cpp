// A cost that does not say what a vertex remembers.
#include "surfaces.h"

struct Distance {
  static constexpr std::size_t dimension = 3;
#ifdef REMEDY
  struct State {
    State& operator+=(const State&) { return *this; }
  };
  State face(auto&&, auto&&, auto&&) const {
    return {};
  }
#endif
  double operator()(const auto& pair, const auto& x) const {
    return squared_distance(pair.first, x) + squared_distance(pair.second, x);
  }
};

int main() {
  using namespace quadrille;
  simplify<Distance, MidpointPlacement>(mesh);                  // mistake
  simplify(points, triangles, MidpointPlacement(), Distance()); // mistake
}
