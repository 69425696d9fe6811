// Asks for two threads: with QUADRILLE_WITH_TBB, and without.
#include <array>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>
#include <stdexcept>
#include <vector>

#ifdef QUADRILLE_WITH_TBB
#define takes_threads takes_threads_with_tbb
#else
#define takes_threads takes_threads_without_tbb
#endif

// Does simplify take so many?
bool takes_threads(unsigned threads) {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<unsigned, 3>> triangles;
  constexpr unsigned n = 100;
  for (unsigned i = 0; i <= n; ++i)
    for (unsigned j = 0; j <= n; ++j) {
      points.push_back({1.0 * i, 1.0 * j, 0.01 * (i * j % 7)});
      const unsigned v = i * (n + 1) + j;
      if (i < n && j < n) {
        triangles.push_back({v, v + n + 1, v + n + 2});
        triangles.push_back({v, v + n + 2, v + 1});
      }
    }
  try {
    quadrille::simplify(points, triangles, quadrille::RelaxedOrder{.threads = threads});
    return triangles.size() <= n * n;
  } catch (const std::invalid_argument&) {
    return false;
  }
}
