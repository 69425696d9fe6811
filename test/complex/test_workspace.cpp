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

using quadrille::internal::Array;
using quadrille::internal::large_page;
using quadrille::internal::MemoryNeeds;
using quadrille::internal::page;
using quadrille::internal::SparseArray;
using quadrille::internal::take_pages;
using quadrille::internal::UninitializedArray;
using quadrille::internal::Workspace;

constexpr MemoryNeeds some_needs{2 * large_page, 4 * large_page};

// Under the address sanitizer there is no block.
bool has_block() {
  Workspace workspace(some_needs);
  void* const part = workspace.allocate(1);
  const bool has_one = part != nullptr;
  if (has_one)
    workspace.deallocate(part, 1);
  return has_one;
}

TEST_CASE("Parts of a workspace are its own, apart and aligned") {
  if (!has_block())
    return;
  Workspace workspace(some_needs);
  auto* const first = static_cast<std::byte*>(workspace.allocate(100));
  auto* const second = static_cast<std::byte*>(workspace.allocate(1));
  REQUIRE(first);
  REQUIRE(second);
  CHECK(reinterpret_cast<std::uintptr_t>(first) % large_page == 0);
  CHECK(second == first + 128); // two lines of 64 bytes
  CHECK(workspace.owns(first));
  CHECK(workspace.owns(second));
  int elsewhere = 0;
  CHECK(!workspace.owns(&elsewhere));
  CHECK(!workspace.owns(first + some_needs.most));
  CHECK(!workspace.owns(nullptr));
}

TEST_CASE("The smallest gap that fits is taken, and gaps that touch become one") {
  if (!has_block())
    return;
  Workspace workspace(some_needs);
  std::vector<void*> parts;
  for (std::size_t size : {640u, 64u, 320u, 64u, 448u, 64u})
    parts.push_back(workspace.allocate(size));
  workspace.deallocate(parts[0], 640);
  workspace.deallocate(parts[2], 320);
  workspace.deallocate(parts[4], 448);
  CHECK(workspace.allocate(300) == parts[2]);
  CHECK(workspace.allocate(330) == parts[4]);
  CHECK(workspace.allocate(330) == parts[0]);
  // Left are 256 behind the first and 64 behind the fifth: room for 640 comes with its other parts.
  workspace.deallocate(parts[1], 64);
  workspace.deallocate(parts[0], 330);
  CHECK(workspace.allocate(704) == parts[0]); // joined with what is before, and behind
}

TEST_CASE("A workspace that is full, or that was given back, says so") {
  if (!has_block())
    return;
  Workspace workspace(some_needs);
  void* const all = workspace.allocate(some_needs.most);
  REQUIRE(all);
  CHECK(!workspace.allocate(1));
  workspace.deallocate(all, some_needs.most);
  CHECK(workspace.allocate(some_needs.most) == all);
}

TEST_CASE("A small surface, or one beyond all memory, has no block") {
  Workspace small({large_page - 1, 4 * large_page});
  CHECK(!small.allocate(1));
  Workspace huge({large_page, std::size_t{1} << 62});
  CHECK(!huge.allocate(1));
  Array<int> array(1000, 7, &huge); // by itself
  CHECK(array == Array<int>(1000, 7));
}

TEST_CASE("Random parts of a workspace keep what was written to them") {
  if (!has_block())
    return;
  Workspace workspace(some_needs);
  std::mt19937 random(1);
  std::map<unsigned char*, std::pair<std::size_t, unsigned char>> parts;
  for (int i = 0; i < 20'000; ++i) {
    if (random() % 2 == 0 || parts.empty()) {
      const std::size_t size = 1 + random() % (random() % 8 == 0 ? 400'000 : 2'000);
      if (auto* const part = static_cast<unsigned char*>(workspace.allocate(size))) {
        const auto value = static_cast<unsigned char>(random());
        std::memset(part, value, size);
        REQUIRE(parts.emplace(part, std::pair(size, value)).second);
      }
    } else {
      auto it = parts.begin();
      std::advance(it, static_cast<std::ptrdiff_t>(random() % parts.size()));
      const auto [size, value] = it->second;
      REQUIRE(static_cast<std::size_t>(std::count(it->first, it->first + size, value)) == size);
      workspace.deallocate(it->first, size);
      parts.erase(it);
    }
  }
  for (const auto& [part, filling] : parts)
    workspace.deallocate(part, filling.first);
  CHECK(workspace.allocate(some_needs.most)); // one gap again
}

TEMPLATE_TEST_CASE_SIG("Arrays align their values as these ask", "", ((std::size_t a), a), 32, 64,
                       128) {
  struct alignas(a) Value {
    char byte;
  };
  Workspace workspace(some_needs);
  std::vector<Array<Value>> arrays;
  for (std::size_t size = 1; size < 20; ++size) {
    arrays.emplace_back(size);
    arrays.emplace_back(size, &workspace);
  }
  for (const Array<Value>& array : arrays)
    CHECK(reinterpret_cast<std::uintptr_t>(array.data()) % a == 0);
}

TEST_CASE("Arrays take their workspace along") {
  Workspace workspace(some_needs);
  Array<int> a(100, 3, &workspace), b;
  const int* const place = a.data();
  b = std::move(a);
  CHECK(b.data() == place);
  CHECK(b.get_allocator().workspace() == &workspace);
  Array<int> c(10, 1);
  c.swap(b);
  CHECK(c.data() == place);
  CHECK(b.get_allocator().workspace() == nullptr);
  b = c; // a copy, in the same workspace
  CHECK(b.get_allocator().workspace() == &workspace);
  CHECK(b == Array<int>(100, 3));
  const Array<double> d(5, 2.5, b.get_allocator()); // of another type
  CHECK(d.get_allocator().workspace() == &workspace);
  if (has_block()) {
    CHECK(workspace.owns(b.data()));
    CHECK(workspace.owns(d.data()));
  }
  SparseArray<int> sparse(&workspace);
  sparse.reserve(1000);
  sparse.push_back(1);
  UninitializedArray<int> uninitialized(&workspace);
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
