// Where vertices come from, and what has become of them.
#include "soups.h"

#include <quadrille/internal/core/surface/numbering.h>

#include <catch2/catch.hpp>

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

using namespace quadrille::internal;

namespace {

Numbering numbering(Index vertices, bool by_input) {
  Array<Index> origins(vertices);
  std::iota(origins.rbegin(), origins.rend(), Index{0}); // v comes from vertices - 1 - v
  return {{vertices, std::move(origins)}, {0, {}}, by_input};
}

} // namespace

TEST_CASE("The image of an origin is where its merges end, in whatever order one asks") {
  constexpr Index vertices = 500;
  for (bool by_input : {false, true}) {
    Numbering numbers = numbering(vertices, by_input);
    std::vector<Index> left(vertices), ends(vertices); // ends: of each number
    std::iota(left.begin(), left.end(), Index{0});
    std::iota(ends.begin(), ends.end(), Index{0});
    test::Random random(1);
    while (left.size() > 10) {
      std::swap(left[random.below(left.size())], left.back());
      const Index gone = left.back();
      left.pop_back();
      const Index kept = left[random.below(left.size())];
      numbers.merge(kept, gone);
      for (Index& end : ends)
        if (end == gone)
          end = kept;
    }
    numbers.use_input_indices();
    for (std::size_t question = 0; question < 5000; ++question) {
      const auto v = static_cast<Index>(random.below(vertices));
      REQUIRE(numbers.merged_vertex(vertices - 1 - v) == vertices - 1 - ends[v]);
    }
  }
}

// Else a long border takes hours to write.
TEST_CASE("All images of a long chain of merges take about linear time") {
  constexpr Index vertices = 2'000'000;
  Numbering numbers = numbering(vertices, true);
  for (Index v = 0; v + 1 < vertices; ++v)
    numbers.merge(v + 1, v);
  bool is_right = true;
  for (Index origin = vertices; origin-- > 0;)
    is_right &= numbers.merged_vertex(origin) == 0;
  CHECK(is_right);
}
