// The queue gives the order of a plain priority queue, in bounded memory; the refused pairs come
// back.

#include "soups.h"

#include <quadrille/internal/core/order/pair_queue.h>
#include <quadrille/internal/core/order/waiting_pairs.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <map>
#include <new>
#include <optional>
#include <queue>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace {
std::size_t allocated_bytes = 0; // by this program so far
} // namespace

// Not inlined: g++ would take the pairs of new and free, malloc and delete for mistakes.
[[gnu::noinline]] void* operator new(std::size_t size) {
  allocated_bytes += size;
  if (void* p = std::malloc(size))
    return p;
  throw std::bad_alloc();
}
// Sanitizers bring a form of their own, which must not meet the delete below.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  allocated_bytes += size;
  return std::malloc(size);
}
[[gnu::noinline]] void operator delete(void* p) noexcept {
  std::free(p);
}
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept {
  std::free(p);
}

namespace {

using quadrille::internal::PairQueue;
using quadrille::internal::QueuedPair;
using quadrille::internal::RejectedPairs;
constexpr std::size_t all = ~std::size_t{0};
using test::Random;

struct IsLater {
  bool operator()(const QueuedPair& a, const QueuedPair& b) const { return b < a; }
};

// Both queues and the versions by which pairs are outdated.
class QueueUnderTest {
  auto outdated() const {
    return [this](const QueuedPair& p) {
      return p.version < versions_[p.first] || p.version < versions_[p.second];
    };
  }

public:
  QueueUnderTest(std::size_t vertices, std::size_t expected)
      : versions_(vertices), queue_(expected) {}

  void push(QueuedPair pair) {
    pair.version = time_;
    queue_.push(pair, outdated());
    expected_.push(pair);
  }
  void outdate(std::uint32_t vertex) { versions_[vertex] = ++time_; }
  void require_same_pop() {
    const std::optional<QueuedPair> pair = queue_.pop(outdated());
    while (!expected_.empty() && outdated()(expected_.top()))
      expected_.pop();
    REQUIRE(pair.has_value() == !expected_.empty());
    if (!pair)
      return;
    const QueuedPair expected = expected_.top();
    expected_.pop();
    REQUIRE(std::tie(pair->cost, pair->first, pair->second) ==
            std::tie(expected.cost, expected.first, expected.second));
  }
  bool is_empty() const { return expected_.empty(); }

private:
  std::vector<std::uint32_t> versions_;
  std::uint32_t time_ = 1;
  PairQueue queue_;
  std::priority_queue<QueuedPair, std::vector<QueuedPair>, IsLater> expected_;
};

// Costs of every kind: many equal ones, the least and the greatest, near and far from each other.
float random_cost(Random& random) {
  switch (random.below(8)) {
  case 0:
    return 0;
  case 1:
    return std::numeric_limits<float>::denorm_min() * static_cast<float>(random.below(5));
  case 2:
    return std::numeric_limits<float>::max();
  case 3:
    return std::numeric_limits<float>::infinity();
  case 4:
    return static_cast<float>(random.below(4));
  case 5:
    return static_cast<float>(random(1, 1.0001));
  default:
    return static_cast<float>(std::exp(random(-60, 60)));
  }
}

QueuedPair random_pair(Random& random, std::size_t vertices) {
  const std::uint32_t v = random.below(vertices), w = random.below(vertices);
  return {random_cost(random), std::min(v, w), std::max(v, w), 0};
}

} // namespace

TEST_CASE("The pair queue gives the order of a priority queue") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 5));
  Random random(seed);
  const std::size_t vertices = 200;
  QueueUnderTest queue(vertices, 4000);
  for (int i = 0; i < 2000; ++i)
    queue.push(random_pair(random, vertices));
  for (int i = 0; i < 20000; ++i) {
    const std::uint32_t what = random.below(10);
    if (what < 5)
      queue.push(random_pair(random, vertices));
    else if (what < 9)
      queue.require_same_pop();
    else
      queue.outdate(random.below(vertices));
  }
  while (!queue.is_empty())
    queue.require_same_pop();
  queue.require_same_pop(); // nothing, and again nothing
  queue.require_same_pop();
}

TEST_CASE("The pair queue takes pairs again after it was empty") {
  QueueUnderTest queue(10, 10);
  queue.require_same_pop();
  queue.push({2, 0, 1, 0});
  queue.require_same_pop();
  queue.require_same_pop();
  queue.push({1, 2, 3, 0}); // below all that was there
  queue.push({3, 4, 5, 0}); // above
  queue.require_same_pop();
  queue.require_same_pop();
  queue.require_same_pop();
}

TEST_CASE("Pairs of one cost come by their indices") {
  QueueUnderTest queue(100, 1000);
  Random random(7);
  for (int i = 0; i < 500; ++i) {
    QueuedPair pair = random_pair(random, 100);
    pair.cost = 1;
    queue.push(pair);
    if (i == 250)
      queue.require_same_pop(); // from now on they go to the heap
  }
  while (!queue.is_empty())
    queue.require_same_pop();
}

TEST_CASE("Outdated pairs never make the queue grow") {
  // A hundred pairs are up to date at any time, and each is pushed anew thirty thousand times.
  const std::size_t pairs = 100, rounds = 30'000;
  std::vector<std::uint32_t> version(pairs, 0);
  const auto is_outdated = [&](const QueuedPair& p) { return p.version < version[p.first]; };
  PairQueue queue(pairs);
  Random random(8);
  std::vector<float> cost(pairs);
  const std::size_t before = allocated_bytes;
  for (std::uint32_t round = 1; round <= rounds; ++round)
    for (std::uint32_t v = 0; v < pairs; ++v) {
      cost[v] = static_cast<float>(std::exp(random(-60, 60)));
      version[v] = round;
      queue.push({cost[v], v, v, round}, is_outdated);
    }
  CHECK(allocated_bytes == before);

  std::set<std::pair<float, std::uint32_t>> expected;
  for (std::uint32_t v = 0; v < pairs; ++v)
    expected.insert({cost[v], v});
  for (const auto& [c, v] : expected) {
    const std::optional<QueuedPair> pair = queue.pop(is_outdated);
    REQUIRE(pair);
    CHECK(pair->cost == c);
    CHECK(pair->first == v);
  }
  CHECK_FALSE(queue.pop(is_outdated));
}

TEST_CASE("A look ahead shows pairs of the open bucket in order") {
  PairQueue queue(10);
  const auto never = [](const QueuedPair&) { return false; };
  CHECK(queue.peek(0) == nullptr);
  for (std::uint32_t v = 0; v < 4; ++v)
    queue.push({1, v, v, 0}, never);
  CHECK(queue.pop(never)->first == 0);
  REQUIRE(queue.peek(0) != nullptr);
  CHECK(queue.peek(0)->first == 1);
  CHECK(queue.peek(2)->first == 3);
  CHECK(queue.peek(3) == nullptr);
}

TEST_CASE("A refused pair comes back once, from whichever end is released first") {
  RejectedPairs rejected(4);
  std::vector<QueuedPair> released;
  const auto keep = [&](const QueuedPair& p) { released.push_back(p); };
  rejected.add({1, 0, 1, 5});
  rejected.add({2, 1, 2, 6});
  CHECK(rejected.size() == 2);
  rejected.release(3, all, keep);
  CHECK(released.empty());
  rejected.release(2, all, keep);
  REQUIRE(released.size() == 1);
  CHECK(released[0].cost == 2);
  CHECK(released[0].version == 6);
  rejected.release(1, all, keep);
  REQUIRE(released.size() == 2);
  CHECK(released[1].cost == 1);
  rejected.release(0, all, keep);
  rejected.release(1, all, keep);
  CHECK(released.size() == 2);
  CHECK(rejected.size() == 0);
}

TEST_CASE("A pair that was refused for a face in its way comes back once, when that changes or an "
          "end does") {
  RejectedPairs rejected(4);
  std::vector<float> released;
  const auto keep = [&](const QueuedPair& p) { released.push_back(p.cost); };
  rejected.add({1, 0, 1, 0});
  CHECK_FALSE(rejected.has_obstructed());
  rejected.add({2, 1, 2, 0}, false, 7);
  rejected.add({3, 2, 3, 0}, false, 7);
  rejected.add({4, 0, 3, 0}, false, 9);
  CHECK(rejected.has_obstructed());
  rejected.release_obstructed(8, keep);
  rejected.release_obstructed(100, keep);
  CHECK(released.empty());
  rejected.release(1, all, keep);
  CHECK(released == std::vector<float>{1, 2});
  rejected.add({5, 0, 1, 0}, false, 7); // the one before it makes room
  rejected.release_obstructed(7, keep);
  CHECK(released == std::vector<float>{1, 2, 3, 5});
  rejected.release_obstructed(7, keep);
  for (std::uint32_t v = 0; v < 4; ++v)
    rejected.release(v, all, keep);
  CHECK(released == std::vector<float>{1, 2, 3, 5, 4});
  rejected.release_obstructed(9, keep);
  CHECK(released.size() == 5);
  CHECK(rejected.size() == 0);
}

TEST_CASE("Refused pairs come back in their order, and no more than are asked for") {
  RejectedPairs rejected(7);
  std::vector<std::uint32_t> partners;
  const auto keep = [&](const QueuedPair& p) { partners.push_back(p.second); };
  for (std::uint32_t w = 1; w < 7; ++w)
    rejected.add({1, 0, w, 0});
  rejected.release(2, all, [](const QueuedPair&) {}); // forgotten at 0 when its turn comes
  CHECK_FALSE(rejected.release(0, 3, keep));
  CHECK(partners == std::vector<std::uint32_t>{1, 3, 4});
  CHECK(rejected.size() == 2);
  rejected.add({1, 0, 1, 0});
  CHECK_FALSE(rejected.release(0, 2, keep));
  CHECK(partners == std::vector<std::uint32_t>{1, 3, 4, 5, 6});
  CHECK(rejected.release(0, 1, keep));
  CHECK(partners == std::vector<std::uint32_t>{1, 3, 4, 5, 6, 1});
  CHECK(rejected.release(0, 1, keep));
}

TEST_CASE("Refused pairs are those of a plain set") {
  Random random(9);
  const std::uint32_t vertices = 12;
  RejectedPairs rejected(vertices);
  std::map<std::pair<std::uint32_t, std::uint32_t>, float> expected;
  for (int i = 0; i < 5000; ++i) {
    const std::uint32_t v = random.below(vertices), w = random.below(vertices);
    if (random.below(4) > 0) {
      if (v < w && expected.insert({{v, w}, static_cast<float>(i)}).second)
        rejected.add({static_cast<float>(i), v, w, 0});
      continue;
    }
    std::map<std::pair<std::uint32_t, std::uint32_t>, float> released;
    rejected.release(v, all, [&](const QueuedPair& p) { released[{p.first, p.second}] = p.cost; });
    for (const auto& [pair, cost] : released) {
      const auto found = expected.find(pair);
      REQUIRE(found != expected.end());
      REQUIRE(found->second == cost);
      expected.erase(found);
    }
    for (const auto& [pair, cost] : expected)
      REQUIRE((pair.first != v && pair.second != v));
    REQUIRE(rejected.size() == expected.size());
  }
}
