// Which contractions keep the topology.

#include "arrays.h"
#include "soups.h"

#include <quadrille/internal/core/complex/link_condition.h>
#include <quadrille/internal/core/complex/star.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/complex/vertex_labels.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

namespace {

using quadrille::internal::Index;
using quadrille::internal::LinkCondition;
using quadrille::internal::PairStar;
using quadrille::internal::TriangleComplex;
using quadrille::internal::VertexClassifier;
using quadrille::internal::VertexKind;
using quadrille::internal::VertexLabels;
using test::Soup;
using test::Triangle;

std::size_t vertex_count(const std::vector<Triangle>& triangles) {
  Index last = 0;
  for (const Triangle& t : triangles)
    last = std::max(last, *std::max_element(t.begin(), t.end()));
  return last + 1;
}

bool holds(const std::vector<Triangle>& triangles, Index a, Index b) {
  TriangleComplex complex(vertex_count(triangles), test::array_of(triangles));
  VertexLabels labels(complex.vertex_capacity());
  const LinkCondition condition(complex, [&](std::size_t) -> VertexLabels& { return labels; });
  PairStar star;
  star.gather(complex, a, b);
  const bool result = condition.holds(star, a, b, labels);
  star.gather(complex, b, a);
  CHECK(condition.holds(star, b, a, labels) == result); // whichever end comes first
  return result;
}

VertexKind kind(const std::vector<Triangle>& triangles, Index v) {
  TriangleComplex complex(vertex_count(triangles), test::array_of(triangles));
  VertexLabels labels(complex.vertex_capacity());
  return VertexClassifier()(complex, v, labels);
}

} // namespace

TEST_CASE("An edge inside a surface may be contracted, and one along its border") {
  //   6---7---8
  //   | / | / |
  //   3---4---5
  //   | / | / |
  //   0---1---2
  const std::vector<Triangle> grid{{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4},
                                   {3, 4, 7}, {3, 7, 6}, {4, 5, 8}, {4, 8, 7}};
  CHECK(holds(grid, 4, 5)); // from the inside to the border
  CHECK(holds(grid, 4, 0));
  CHECK(holds(grid, 0, 1)); // along the border
  CHECK(holds(grid, 6, 7));
  CHECK_FALSE(holds(grid, 3, 7)); // across, from border to border: it would pinch 3 = 7
  CHECK_FALSE(holds(grid, 0, 8)); // not an edge
  CHECK_FALSE(holds(grid, 0, 2));
}

TEST_CASE("The ends of an edge have no neighbours in common but those opposite to it") {
  // An octahedron of which the faces 0 2 4 and 1 2 4 have tents 6 and 7 on them: 2 and 4 are both
  // neighbours of 6 and of 7, and 2 4 is still an edge of two faces.
  //       4
  //     / | \        0 4 6, 4 2 6 and 2 0 6 in place of 0 2 4
  //    0 6|7 1
  //     \ | /
  //       2
  const std::vector<Triangle> surface{{0, 6, 4}, {4, 6, 2}, {2, 6, 0}, {2, 7, 4},
                                      {4, 7, 1}, {1, 7, 2}, {1, 3, 4}, {3, 0, 4},
                                      {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  REQUIRE(test::topology_of({std::vector<test::Position>(8), surface}).is_closed());
  CHECK_FALSE(holds(surface, 2, 4)); // 0 and 1 are neighbours of both ends as well
  CHECK(holds(surface, 2, 6));       // into the corner of its own tent
  CHECK(holds(surface, 3, 5));
  CHECK_FALSE(holds(surface, 0, 4)); // 2 is a neighbour of both, and 0 4 2 is no face
}

TEST_CASE("A tetrahedron is as small as a closed surface can be") {
  const auto triangles = test::tetrahedron().triangles;
  for (Index a = 0; a < 4; ++a)
    for (Index b = a + 1; b < 4; ++b)
      CHECK_FALSE(holds(triangles, a, b)); // the link edge of a and b is the same one
}

TEST_CASE("A triangle is as small as a surface with a border can be") {
  const std::vector<Triangle> one{{0, 1, 2}};
  CHECK_FALSE(holds(one, 0, 1));
  CHECK_FALSE(holds(one, 1, 2));
  CHECK_FALSE(holds(one, 2, 0));
  // 3---2
  // | \ |
  // 0---1
  const std::vector<Triangle> two{{0, 1, 3}, {1, 2, 3}};
  CHECK(holds(two, 0, 1));
  CHECK(holds(two, 0, 3));
  CHECK(holds(two, 1, 2));
  CHECK(holds(two, 2, 3));
  CHECK_FALSE(holds(two, 1, 3)); // both faces would vanish
}

TEST_CASE("A hole of three edges stays open") {
  // The face 0 2 4 of an octahedron is missing.
  const auto [points, all] = test::octahedron();
  const std::vector<Triangle> open(all.begin() + 1, all.end()); // without 0 2 4
  CHECK_FALSE(holds(open, 0, 2));
  CHECK_FALSE(holds(open, 2, 4));
  CHECK_FALSE(holds(open, 4, 0));
  CHECK(holds(open, 1, 5));
  CHECK(holds(open, 1, 2)); // from the inside to the border
}

TEST_CASE("A tube of three faces around does not close") {
  // Three vertices around, four rings; 3 4 5 is a cycle of edges that bounds no face.
  const Soup tube = test::open_cylinder(3, 3);
  CHECK_FALSE(holds(tube.triangles, 3, 4));
  CHECK_FALSE(holds(tube.triangles, 0, 1)); // nor does its border
  CHECK(holds(tube.triangles, 3, 6));       // along the tube
}

TEST_CASE("A spine of three pages is contracted along itself, and in no other way") {
  // Three strips that share the line 0 1 2 3; the strip of page k has 4k + 4 … 4k + 7 beyond it.
  std::vector<Triangle> book;
  for (Index page = 0; page < 3; ++page)
    for (Index i = 0; i < 3; ++i) {
      const Index outer = 4 * page + 4 + i;
      book.push_back({i, i + 1, outer});
      book.push_back({i + 1, outer + 1, outer});
    }
  CHECK(kind(book, 1) == VertexKind::spine);
  CHECK(kind(book, 2) == VertexKind::spine);
  CHECK(kind(book, 0) == VertexKind::singular); // where the pages' borders meet
  CHECK(holds(book, 1, 2));
  CHECK(holds(book, 0, 1)); // along it, to where it ends
  CHECK(holds(book, 3, 2));
  CHECK_FALSE(holds(book, 1, 4)); // from its inside to a border

  // A triangle of spines: three pages along each side of 0 1 2.
  std::vector<Triangle> ring;
  for (Index i = 0; i < 3; ++i)
    for (Index page = 0; page < 3; ++page) {
      const Index j = (i + 1) % 3, outer = 3 + 3 * page;
      ring.push_back({i, j, outer + i});
      ring.push_back({j, outer + j, outer + i});
    }
  CHECK(kind(ring, 0) == VertexKind::spine);
  CHECK_FALSE(holds(ring, 0, 1)); // the third vertex joins them behind

  // The same with the face 0 1 2 for one of the pages: the third vertex is opposite to each side.
  std::vector<Triangle> drum;
  for (const Triangle& t : ring)
    if (*std::max_element(t.begin(), t.end()) < 9)
      drum.push_back(t);
  drum.push_back({0, 1, 2});
  CHECK(kind(drum, 0) == VertexKind::spine);
  CHECK_FALSE(holds(drum, 0, 1));
}

TEST_CASE("Vertices are inside, on the border, or singular") {
  CHECK(kind(test::tetrahedron().triangles, 0) == VertexKind::interior);
  std::vector<Triangle> turned = test::tetrahedron().triangles;
  std::swap(turned[0][0], turned[0][1]);
  for (Index v = 0; v < 4; ++v)
    CHECK((kind(turned, v) == VertexKind::unoriented) ==
          (std::count(turned[0].begin(), turned[0].end(), v) == 1));
  CHECK(kind(test::triangle().triangles, 0) == VertexKind::boundary);
  //  1---2
  //   \ /
  //    0     two faces that only meet in a vertex
  //   / \    .
  //  3---4
  const std::vector<Triangle> bow_tie{{0, 2, 1}, {0, 3, 4}};
  CHECK(kind(bow_tie, 0) == VertexKind::singular);
  CHECK(kind(bow_tie, 1) == VertexKind::boundary);
  // Three faces at the edge 0 1.
  const std::vector<Triangle> book{{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  CHECK(kind(book, 0) == VertexKind::singular);
  CHECK(kind(book, 2) == VertexKind::boundary);
  // Two tetrahedra with one vertex in common.
  std::vector<Triangle> touching = test::tetrahedron().triangles;
  for (Triangle t : test::tetrahedron().triangles) {
    for (Index& v : t)
      v = v == 0 ? 0 : v + 3;
    touching.push_back(t);
  }
  CHECK(kind(touching, 0) == VertexKind::singular);
  CHECK(kind(touching, 1) == VertexKind::interior);
}

TEST_CASE("Two singular vertices are never contracted") {
  // Three pages at 0 1; each page ends in a border.
  CHECK_FALSE(holds({{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}, 0, 1));
  // A face between the pinched vertices of two bow-ties.
  //  2---3       4---5
  //   \ /         \ /
  //    0-----------1
  //     \    6    /
  CHECK_FALSE(holds({{0, 3, 2}, {1, 5, 4}, {0, 6, 1}}, 0, 1));
  CHECK(holds({{0, 3, 2}, {0, 6, 1}, {1, 6, 7}}, 6, 7)); // far from the pinched vertex
}

TEST_CASE("A duplicate face is not contracted") {
  CHECK_FALSE(holds({{0, 1, 2}, {0, 2, 1}}, 0, 1));
  CHECK_FALSE(holds({{0, 1, 2}, {0, 1, 2}, {0, 2, 3}}, 0, 1));
}

TEST_CASE(
    "The condition holds for exactly those edges of which the contraction keeps the topology") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 12));
  CAPTURE(seed);
  const Soup soup = seed < 4 ? test::random_closed(seed) : test::random_with_boundaries(seed);
  const test::SoupTopology before = test::topology_of(soup);
  TriangleComplex complex(soup.points.size(), test::array_of(soup.triangles));
  VertexLabels labels(complex.vertex_capacity());
  const LinkCondition condition(complex, [&](std::size_t) -> VertexLabels& { return labels; });
  CHECK(condition.is_closed() == before.is_closed());
  std::set<std::pair<Index, Index>> edges;
  for (const Triangle& t : soup.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      edges.insert(std::minmax({t[i], t[(i + 1) % 3]}));
  PairStar star;
  std::size_t refused = 0;
  for (const auto& [a, b] : edges) {
    Soup contracted{soup.points, {}};
    for (Triangle t : soup.triangles) {
      std::replace(t.begin(), t.end(), b, a);
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
        contracted.triangles.push_back(t);
    }
    const test::SoupTopology after = test::topology_of(contracted);
    // One vertex less, not two: the interior edge that cuts off the only face of a vertex takes
    // that vertex with it. The border would lose an edge and the surface an ear, but it stays a
    // disc.
    const bool is_kept = is_same_topology(before, after) && !after.has_duplicate_faces &&
                         after.vertices + 1 == before.vertices;
    star.gather(complex, a, b);
    CAPTURE(a, b);
    REQUIRE(condition.holds(star, a, b, labels) == is_kept);
    refused += !is_kept;
  }
  CHECK(refused > 0); // or nothing was tried
}
