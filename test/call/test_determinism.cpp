// The same call on the same input gives the same bytes each time, whatever the heap holds.
#include "on_all.h"

#include <quadrille/attribute_quadric.h>
#include <quadrille/memoryless_quadric.h>
#include <quadrille/relaxed_order.h>
#include <quadrille/simplify.h>
#include <quadrille/threshold_pairs.h>

#include <catch2/catch.hpp>

#include <cstddef>
#include <span>
#include <tuple>
#include <vector>

namespace {

using namespace quadrille;
using namespace test;

// Allocates and frees blocks of any size, and leaves odd bytes in all of them.
class HeapNoise {
public:
  void operator()() {
    for (std::vector<char>& block : blocks_) {
      const std::size_t largest = random_.below(10) == 0 ? 4'000'000 : 4000;
      block = std::vector<char>(random_.below(largest), static_cast<char>(random_.below(256)));
      if (random_.below(2) == 0)
        block = {};
    }
  }

private:
  Random random_{1};
  std::vector<std::vector<char>> blocks_{200};
};

template <class T>
void append(std::vector<std::byte>& bytes, const std::vector<T>& values) {
  const auto more = std::as_bytes(std::span(values));
  bytes.insert(bytes.end(), more.begin(), more.end());
}

std::vector<std::byte> bytes_of(const Result& result) {
  std::vector<std::byte> bytes;
  append(bytes, result.soup.points);
  append(bytes, result.soup.triangles);
  for (const std::vector<double>& values : result.attributes)
    append(bytes, values);
  return bytes;
}

template <class Kind, class... Policies>
void check(const Soup& soup, const Policies&... policies) {
  HeapNoise shake;
  const std::vector<std::byte> first = bytes_of(Kind::run(soup, policies...));
  for (int run = 2; run <= 3; ++run) {
    CAPTURE(run);
    shake();
    const bool is_same = bytes_of(Kind::run(soup, policies...)) == first;
    REQUIRE(is_same);
  }
}

} // namespace

TEMPLATE_TEST_CASE("Three runs give the same bytes", "", (std::tuple<Quadric, GreedyOrder>),
                   (std::tuple<Quadric, RelaxedOrder>),
                   (std::tuple<MemorylessQuadric, GreedyOrder>),
                   (std::tuple<MemorylessQuadric, RelaxedOrder>),
                   (std::tuple<ThinFeatureQuadric, GreedyOrder>),
                   (std::tuple<ThinFeatureQuadric, RelaxedOrder>),
                   (std::tuple<ColorQuadric, GreedyOrder>),
                   (std::tuple<ColorQuadric, RelaxedOrder>)) {
  const auto& [cost, order] = TestType();
  const FaceRatio stop{0.1};
  SECTION("of a mesh") {
    check<OnMesh<Mesh>>(to_soup(read_model("camel")), cost, order, stop);
  }
  SECTION("of a soup, by edges") {
    check<OnSoup>(to_soup(read_model("cow")), cost, order, stop);
  }
  SECTION("of a soup, by pairs") {
    check<OnSoup>(to_soup(read_model("cow")), cost, order, stop, ThresholdPairs::relative(0.02));
  }
}
