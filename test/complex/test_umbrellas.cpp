// How faces are joined to a halfedge mesh with the fewest duplicated vertices.

#include "soups.h"

#include <quadrille/internal/core/adapter/umbrellas.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace {

using quadrille::internal::Array;
using quadrille::internal::Index;
using quadrille::internal::none;
using quadrille::internal::Side;
using quadrille::internal::Umbrellas;
using test::Triangle;

Array<Side> sides_of(const std::vector<Triangle>& triangles) {
  Array<Side> sides;
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k)
      sides.push_back({t[(k + 2) % 3], t[k]});
  return sides;
}

constexpr auto no_mates = [](Index, Index) { return false; };

Index side_after(Index side) {
  return side % 3 == 2 ? side - 2 : side + 1;
}
Index side_before(Index side) {
  return side % 3 == 0 ? side + 2 : side - 1;
}

// Builds the umbrellas and checks what must hold of any: they can be written to a halfedge mesh.
Umbrellas build(const std::vector<Triangle>& triangles, std::size_t vertices) {
  const Array<Side> sides = sides_of(triangles);
  Umbrellas u;
  u.build(sides, vertices, no_mates);
  const auto original = [&](Index v) { return v < vertices ? v : u.duplicates().at(v - vertices); };

  // Mates are pairs of opposed sides, and where two are left without, they are not opposed.
  std::set<Index> open;
  for (Index s = 0; s < sides.size(); ++s) {
    if (u.mate(s) == none) {
      open.insert(s);
      continue;
    }
    CHECK(u.mate(u.mate(s)) == s);
    CHECK(sides[s].from == sides[u.mate(s)].to);
    CHECK(sides[s].to == sides[u.mate(s)].from);
    CHECK(u.vertex(s) == u.vertex(side_before(u.mate(s)))); // both have the same two vertices
  }
  for (Index s : open)
    for (Index t : open)
      CHECK_FALSE((sides[s].from == sides[t].to && sides[s].to == sides[t].from));

  // Corners at one vertex: one closed umbrella, or open ones only.
  std::map<Index, std::vector<Index>> corners;
  for (Index c = 0; c < sides.size(); ++c) {
    CHECK(original(u.vertex(c)) == sides[c].to);
    corners[u.vertex(c)].push_back(c);
  }
  for (const auto& [v, at_v] : corners) {
    std::size_t open_umbrellas = 0;
    for (Index c : at_v)
      open_umbrellas += u.mate(c) == none; // the last corner of its umbrella
    CHECK(u.is_on_boundary(v) == (open_umbrellas > 0));
    // Turning from the first corner reaches all of them, if there is only one umbrella.
    std::set<Index> reached;
    for (Index c : at_v)
      if (open_umbrellas == 0 ? c == at_v.front() : u.mate(side_after(c)) == none)
        for (Index turned = c; turned != none && reached.insert(turned).second;)
          turned = u.mate(turned) == none ? none : side_before(u.mate(turned));
    CHECK(reached.size() == at_v.size());
  }

  // The border: each open side has one that follows it and one before it, at the same vertex.
  std::set<Index> followed, following;
  for (const auto& [in, out] : u.boundary_links()) {
    CHECK(followed.insert(in).second);
    CHECK(following.insert(out).second);
    CHECK(u.vertex(side_before(in)) == u.vertex(out)); // where the other half of `in` leads to
  }
  CHECK(followed == open);
  CHECK(following == open);
  return u;
}

// Turns round every corner: how many closed umbrellas there are at each vertex, and has it open
// ones?
std::size_t fewest_duplicates(const Umbrellas& u, const std::vector<Triangle>& triangles) {
  const Array<Side> sides = sides_of(triangles);
  std::map<Index, std::size_t> closed;
  std::set<Index> has_open;
  std::set<Index> seen;
  for (Index c = 0; c < sides.size(); ++c) {
    std::set<Index> umbrella;
    Index turned = c;
    while (turned != none && umbrella.insert(turned).second)
      turned = u.mate(turned) == none ? none : side_before(u.mate(turned));
    if (turned == none)
      has_open.insert(sides[c].to);
    else if (!seen.contains(c))
      ++closed[sides[c].to];
    seen.insert(umbrella.begin(), umbrella.end());
  }
  std::size_t duplicates = 0;
  for (const auto& [v, count] : closed)
    duplicates += count + has_open.contains(v) - 1;
  return duplicates;
}

// A tetrahedron of which vertex 0 is `apex` and the others are numbered from `first`.
std::vector<Triangle> tetrahedron_at(Index apex, Index first) {
  std::vector<Triangle> triangles = test::tetrahedron().triangles;
  for (Triangle& t : triangles)
    for (Index& v : t)
      v = v == 0 ? apex : first + v - 1;
  return triangles;
}

std::vector<Triangle> operator+(std::vector<Triangle> a, const std::vector<Triangle>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

} // namespace

TEST_CASE("A closed surface has mates everywhere and no border") {
  const Umbrellas u = build(test::tetrahedron().triangles, 4);
  CHECK(u.duplicates().empty());
  CHECK(u.boundary_links().empty());
}

TEST_CASE("The border of a triangle runs round it") {
  const Umbrellas u = build({{0, 1, 2}}, 3);
  CHECK(u.boundary_links().size() == 3);
  CHECK(u.duplicates().empty());
}

TEST_CASE("Open umbrellas share a vertex, and the border leads from one to the next") {
  //  1---2
  //   \ /
  //    0
  //   / \    .
  //  3---4
  const Umbrellas u = build({{0, 2, 1}, {0, 3, 4}}, 5);
  CHECK(u.duplicates().empty());
  // Both borders are one loop of six sides: 0 → 1 → 2 → 0 → 4 → 3 → 0, or the other way round.
  std::map<Index, Index> follows(u.boundary_links().begin(), u.boundary_links().end());
  std::set<Index> loop;
  for (Index s = 0; loop.insert(s).second;)
    s = follows.at(s);
  CHECK(loop.size() == 6);
}

TEST_CASE("Of two closed umbrellas one gets a duplicate of the vertex") {
  const Umbrellas u = build(tetrahedron_at(0, 1) + tetrahedron_at(0, 4), 7);
  REQUIRE(u.duplicates().size() == 1);
  CHECK(u.duplicates()[0] == 0);
}

TEST_CASE("Open umbrellas and a closed one need one duplicate, in any order") {
  const std::vector<Triangle> fans{{0, 2, 1}, {0, 3, 4}, {0, 5, 6}};
  CHECK(build(fans + tetrahedron_at(0, 7), 10).duplicates() == Array<Index>{0});
  CHECK(build(tetrahedron_at(0, 7) + fans, 10).duplicates() == Array<Index>{0});
}

TEST_CASE("Of three faces at an edge two are joined") {
  const std::vector<Triangle> book{{0, 1, 2}, {1, 0, 3}, {1, 0, 4}};
  const Umbrellas u = build(book, 5);
  CHECK(u.mate(1) == 4); // 0 → 1 of the first, 1 → 0 of the second
  CHECK(u.mate(7) == none);
  CHECK(u.duplicates().empty()); // open umbrellas only
}

TEST_CASE("Sides that were mates before are mated first") {
  const std::vector<Triangle> book{{0, 1, 2}, {1, 0, 3}, {1, 0, 4}};
  Umbrellas u;
  u.build(sides_of(book), 5,
          [](Index i, Index j) { return std::min(i, j) == 1 && std::max(i, j) == 7; });
  CHECK(u.mate(1) == 7);
  CHECK(u.mate(4) == none);
}

TEST_CASE("Faces that run along an edge in the same direction are not joined") {
  const Umbrellas u = build({{0, 1, 2}, {0, 1, 3}}, 4);
  CHECK(u.mate(1) == none);
  CHECK(u.mate(4) == none);
}

TEST_CASE("A Möbius strip is cut once") {
  // 0---1---2---3(=4')      five vertices, five faces, each the next one's neighbour
  std::vector<Triangle> strip;
  for (Index i = 0; i < 5; ++i) {
    Triangle t{i, (i + 1) % 5, (i + 2) % 5};
    if (i % 2 == 1)
      std::swap(t[0], t[1]);
    strip.push_back(t);
  }
  const Umbrellas u = build(strip, 5);
  std::size_t mates = 0;
  for (Index s = 0; s < 15; ++s)
    mates += u.mate(s) != none;
  CHECK(mates == 8); // four of five edges
}

TEST_CASE("Any triangles become a halfedge mesh with the fewest duplicates") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 40));
  test::Random random(seed);
  const Index vertices = 7;
  std::vector<Triangle> triangles;
  while (triangles.size() < 5 + seed) {
    const Triangle t{random.below(vertices), random.below(vertices), random.below(vertices)};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
      triangles.push_back(t);
  }
  const Umbrellas u = build(triangles, vertices);
  CHECK(u.duplicates().size() == fewest_duplicates(u, triangles));
}

TEST_CASE("A side is joined to the first that runs against it, however many there are") {
  const auto faces = GENERATE(10, 60, 200);
  test::Random random(static_cast<std::uint64_t>(faces));
  const Index vertices = 30;
  std::vector<Triangle> triangles;
  for (int i = 0; i < faces; ++i) { // a fan, mostly
    const Index a = 1 + random.below(vertices - 1), b = 1 + random.below(vertices - 1);
    if (a != b)
      triangles.push_back({i % 8 == 0 ? 1 + (a + b) % (vertices - 1) : 0, a, b});
  }
  std::erase_if(triangles, [](const Triangle& t) { return t[0] == t[1] || t[0] == t[2]; });
  const Umbrellas u = build(triangles, vertices);
  const auto sides = sides_of(triangles);
  std::vector<Index> expected(sides.size(), none);
  for (Index i = 0; i < sides.size(); ++i)
    for (Index j = 0; j < i && expected[i] == none; ++j)
      if (expected[j] == none && sides[i].from == sides[j].to && sides[i].to == sides[j].from) {
        expected[i] = j;
        expected[j] = i;
      }
  for (Index i = 0; i < sides.size(); ++i)
    REQUIRE(u.mate(i) == expected[i]);
}

// Where this takes more than a moment, each side at the hub is compared with all others.
TEST_CASE("A fan of 200,000 faces is one umbrella") {
  const Index faces = 200000;
  std::vector<Triangle> triangles;
  for (Index i = 0; i < faces; ++i)
    triangles.push_back({0, 1 + i, 1 + (i + 1) % faces});
  Umbrellas u;
  u.build(sides_of(triangles), faces + 1, [](Index, Index) { return false; });
  CHECK(u.duplicates().empty());
  CHECK_FALSE(u.is_on_boundary(0));
  CHECK(u.boundary_links().size() == faces);
}
