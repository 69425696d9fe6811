#include <catch2/catch.hpp>

#include <quadrille/internal/core/memory/array.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace {

using quadrille::internal::Arena;
using quadrille::internal::Array;
using quadrille::internal::large_page;
using quadrille::internal::MemoryNeeds;
using quadrille::internal::page;
using quadrille::internal::SparseArray;
using quadrille::internal::take_pages;
using quadrille::internal::UninitializedArray;

constexpr MemoryNeeds some_needs{2 * large_page, 4 * large_page};

// Under the address sanitizer there is no block.
bool has_block() {
  Arena arena(some_needs);
  void* const part = arena.allocate(1);
  const bool has_one = part != nullptr;
  if (has_one)
    arena.deallocate(part, 1);
  return has_one;
}

TEST_CASE("Parts of a workspace are its own, apart and aligned") {
  if (!has_block())
    return;
  Arena arena(some_needs);
  auto* const first = static_cast<std::byte*>(arena.allocate(100));
  auto* const second = static_cast<std::byte*>(arena.allocate(1));
  REQUIRE(first);
  REQUIRE(second);
  CHECK(reinterpret_cast<std::uintptr_t>(first) % large_page == 0);
  CHECK(second == first + 128); // two lines of 64 bytes
  CHECK(arena.owns(first));
  CHECK(arena.owns(second));
  int elsewhere = 0;
  CHECK(!arena.owns(&elsewhere));
  CHECK(!arena.owns(first + some_needs.most));
  CHECK(!arena.owns(nullptr));
}

TEST_CASE("The smallest gap that fits is taken, and gaps that touch become one") {
  if (!has_block())
    return;
  Arena arena(some_needs);
  std::vector<void*> parts;
  for (std::size_t size : {640u, 64u, 320u, 64u, 448u, 64u})
    parts.push_back(arena.allocate(size));
  arena.deallocate(parts[0], 640);
  arena.deallocate(parts[2], 320);
  arena.deallocate(parts[4], 448);
  CHECK(arena.allocate(300) == parts[2]);
  CHECK(arena.allocate(330) == parts[4]);
  CHECK(arena.allocate(330) == parts[0]);
  // Left are 256 behind the first and 64 behind the fifth: room for 640 comes with its other parts.
  arena.deallocate(parts[1], 64);
  arena.deallocate(parts[0], 330);
  CHECK(arena.allocate(704) == parts[0]); // joined with what is before, and behind
}

TEST_CASE("A workspace that is full, or that was given back, says so") {
  if (!has_block())
    return;
  Arena arena(some_needs);
  void* const all = arena.allocate(some_needs.most);
  REQUIRE(all);
  CHECK(!arena.allocate(1));
  arena.deallocate(all, some_needs.most);
  CHECK(arena.allocate(some_needs.most) == all);
}

TEST_CASE("A small surface, or one beyond all memory, has no block") {
  Arena small({large_page - 1, 4 * large_page});
  CHECK(!small.allocate(1));
  Arena huge({large_page, std::size_t{1} << 62});
  CHECK(!huge.allocate(1));
  Array<int> array(1000, 7, &huge); // by itself
  CHECK(array == Array<int>(1000, 7));
}

TEST_CASE("Random parts of a workspace keep what was written to them") {
  if (!has_block())
    return;
  Arena arena(some_needs);
  std::mt19937 random(1);
  std::map<unsigned char*, std::pair<std::size_t, unsigned char>> parts;
  for (int i = 0; i < 20'000; ++i) {
    if (random() % 2 == 0 || parts.empty()) {
      const std::size_t size = 1 + random() % (random() % 8 == 0 ? 400'000 : 2'000);
      if (auto* const part = static_cast<unsigned char*>(arena.allocate(size))) {
        const auto value = static_cast<unsigned char>(random());
        std::memset(part, value, size);
        REQUIRE(parts.emplace(part, std::pair(size, value)).second);
      }
    } else {
      auto it = parts.begin();
      std::advance(it, static_cast<std::ptrdiff_t>(random() % parts.size()));
      const auto [size, value] = it->second;
      REQUIRE(static_cast<std::size_t>(std::count(it->first, it->first + size, value)) == size);
      arena.deallocate(it->first, size);
      parts.erase(it);
    }
  }
  for (const auto& [part, filling] : parts)
    arena.deallocate(part, filling.first);
  CHECK(arena.allocate(some_needs.most)); // one gap again
}

TEMPLATE_TEST_CASE_SIG("Arrays align their values as these ask", "", ((std::size_t a), a), 32, 64,
                       128) {
  struct alignas(a) Value {
    char byte;
  };
  Arena arena(some_needs);
  std::vector<Array<Value>> arrays;
  for (std::size_t size = 1; size < 20; ++size) {
    arrays.emplace_back(size);
    arrays.emplace_back(size, &arena);
  }
  for (const Array<Value>& array : arrays)
    CHECK(reinterpret_cast<std::uintptr_t>(array.data()) % a == 0);
}

TEST_CASE("Arrays take their workspace along") {
  Arena arena(some_needs);
  Array<int> a(100, 3, &arena), b;
  const int* const place = a.data();
  b = std::move(a);
  CHECK(b.data() == place);
  CHECK(b.get_allocator().arena() == &arena);
  Array<int> c(10, 1);
  c.swap(b);
  CHECK(c.data() == place);
  CHECK(b.get_allocator().arena() == nullptr);
  b = c; // a copy, in the same workspace
  CHECK(b.get_allocator().arena() == &arena);
  CHECK(b == Array<int>(100, 3));
  const Array<double> d(5, 2.5, b.get_allocator()); // of another type
  CHECK(d.get_allocator().arena() == &arena);
  if (has_block()) {
    CHECK(arena.owns(b.data()));
    CHECK(arena.owns(d.data()));
  }
  SparseArray<int> sparse(&arena);
  sparse.reserve(1000);
  sparse.push_back(1);
  UninitializedArray<int> uninitialized(&arena);
  uninitialized.resize(3);
  uninitialized[2] = 4;
  CHECK(uninitialized[2] == 4);
}

TEST_CASE("To take pages leaves what is written in them") {
  std::vector<unsigned char> bytes(40 * page, 5);
  take_pages(bytes.data() + 1, bytes.size() - 2);
  CHECK(static_cast<std::size_t>(std::count(bytes.begin(), bytes.end(), 5)) == bytes.size());
}

} // namespace
