// Incidence: the corner lists against plain sets, and the numbers that are forgotten at once.

#include "arrays.h"
#include "soups.h"

#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/complex/vertex_labels.h>
#include <quadrille/internal/core/pairs/pair_lists.h>
#include <quadrille/internal/core/surface/numbering.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

using quadrille::internal::Index;
using quadrille::internal::InputIndices;
using quadrille::internal::none;
using quadrille::internal::Numbering;
using quadrille::internal::PairLists;
using quadrille::internal::TriangleComplex;
using quadrille::internal::VertexLabels;
using test::Random;
using test::Triangle;

using Corners = std::set<std::pair<Index, Index>>; // face and place

Corners corners_at(TriangleComplex& complex, Index v) {
  Corners corners;
  complex.prune_corners(v, [&](Index face, Index i) {
    CHECK(complex.vertices(face)[i] == v);
    CHECK(corners.insert({face, i}).second); // each once
  });
  return corners;
}

// The same triangles as a map.
using Model = std::map<Index, Triangle>;

Corners corners_at(const Model& model, Index v) {
  Corners corners;
  for (const auto& [face, t] : model)
    for (Index i = 0; i < 3; ++i)
      if (t[i] == v)
        corners.insert({face, i});
  return corners;
}

Triangle random_triangle(Random& random, std::size_t vertices) {
  return {random.below(vertices), random.below(vertices), random.below(vertices)};
}

std::vector<Triangle> random_triangles(Random& random, std::size_t vertices) {
  std::vector<Triangle> triangles;
  for (int i = 0; i < 40; ++i)
    triangles.push_back(random_triangle(random, vertices));
  return triangles;
}

// Without the triangles that have two equal vertices.
Model model_of(const std::vector<Triangle>& triangles) {
  Model model;
  for (Index f = 0; f < triangles.size(); ++f)
    if (const auto [a, b, c] = triangles[f]; a != b && b != c && c != a)
      model[f] = triangles[f];
  return model;
}

} // namespace

TEST_CASE("A complex lists the corners at each vertex") {
  const auto soup = test::tetrahedron();
  TriangleComplex complex(6, test::array_of(soup.triangles)); // with two isolated vertices
  CHECK(complex.count_faces() == 4);
  for (Index v = 0; v < 4; ++v)
    CHECK(corners_at(complex, v).size() == 3);
  CHECK_FALSE(complex.has_faces(4));
  CHECK(corners_at(complex, 5).empty());
}

TEST_CASE("A triangle with two equal vertices is dead from the beginning") {
  TriangleComplex complex(3, {{0, 1, 1}, {0, 1, 2}, {2, 2, 2}, {0, 1, 0}});
  CHECK(complex.count_faces() == 1);
  CHECK(complex.is_removed(0));
  CHECK(corners_at(complex, 0) == Corners{{1, 0}});
  CHECK(corners_at(complex, 1) == Corners{{1, 1}});
  CHECK(corners_at(complex, 2) == Corners{{1, 2}});
}

TEST_CASE("Merging takes all corners along, from and to vertices without any") {
  TriangleComplex complex(8, {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}});
  complex.merge(0, 4); // no common face
  CHECK(corners_at(complex, 0) == Corners{{0, 0}, {1, 0}, {2, 0}});
  CHECK_FALSE(complex.has_faces(4));
  complex.merge(7, 0); // to a vertex without faces
  CHECK(corners_at(complex, 7) == Corners{{0, 0}, {1, 0}, {2, 0}});
  complex.merge(7, 4); // from one
  CHECK(corners_at(complex, 7).size() == 3);
  complex.merge(0, 4); // from one to another
  CHECK_FALSE(complex.has_faces(0));
}

TEST_CASE("A vertex of which all faces have died has none after the next walk") {
  TriangleComplex complex(4, {{0, 1, 2}, {0, 2, 3}});
  complex.remove_face(0);
  complex.remove_face(1);
  CHECK(complex.count_faces() == 0);
  for (Index v = 0; v < 4; ++v) {
    CHECK(corners_at(complex, v).empty());
    CHECK_FALSE(complex.has_faces(v));
  }
}

TEST_CASE("Random merges and deaths leave the same corners as in plain sets") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 20));
  Random random(seed);
  const Index vertices = 12;
  const std::vector<Triangle> triangles = random_triangles(random, vertices);
  TriangleComplex complex(vertices, test::array_of(triangles));
  Model model = model_of(triangles);
  const auto remove_face = [&](Index face) {
    complex.remove_face(face);
    model.erase(face);
  };
  while (!model.empty()) {
    if (random.below(3) == 0)
      remove_face(std::next(model.begin(), random.below(model.size()))->first);
    const Index kept = random.below(vertices), gone = random.below(vertices);
    if (kept != gone) {
      for (const auto& [face, place] : corners_at(complex, gone))
        if (const auto& t = complex.vertices(face); std::find(t.begin(), t.end(), kept) != t.end())
          remove_face(face);
      complex.merge(kept, gone);
      for (auto& [face, t] : model)
        std::replace(t.begin(), t.end(), gone, kept);
    }
    REQUIRE(complex.count_faces() == model.size());
    // Some lists are left unwalked for a while, with their dead faces.
    for (Index v = random.below(2); v < vertices; v += 1 + random.below(2)) {
      REQUIRE(corners_at(complex, v) == corners_at(model, v));
      REQUIRE(complex.has_faces(v) == !corners_at(model, v).empty());
    }
  }
}

TEST_CASE("What is left gets new numbers in the same order, and its origins are known") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 20));
  Random random(seed);
  const Index vertices = 50;
  const std::vector<Triangle> triangles = random_triangles(random, vertices);
  TriangleComplex complex(vertices, test::array_of(triangles));
  Model model = model_of(triangles); // by first numbers
  InputIndices input_vertices(vertices, {}), input_faces(complex.face_capacity(), {});
  for (int round = 0; round < 3; ++round) {
    for (Index f = 0; f < complex.face_capacity(); ++f)
      if (!complex.is_removed(f) && random.below(3) == 0) {
        complex.remove_face(f);
        model.erase(input_faces[f]);
      }
    for (Index v = 0; v < complex.vertex_capacity(); ++v)
      complex.prune_corners(v);
    const auto left_vertices = complex.left_vertices();
    input_faces.pack_if([&](Index face) { return !complex.is_removed(face); });
    complex.pack(left_vertices);
    complex.fill_lists();
    input_vertices.pack(left_vertices);
    REQUIRE(complex.face_capacity() == model.size());
    std::set<Index> named;
    Index number = 0;
    for (const auto& [face, t] : model) {
      REQUIRE(input_faces[number] == face);
      for (Index i = 0; i < 3; ++i)
        REQUIRE(input_vertices[complex.vertices(number)[i]] == t[i]);
      named.insert(t.begin(), t.end());
      ++number;
    }
    REQUIRE(complex.vertex_capacity() == named.size());
    const InputIndices numbers = input_vertices.inverse();
    REQUIRE(numbers.input_count() == vertices);
    for (Index v = 0; v < vertices; ++v)
      REQUIRE((numbers[v] == none) == (named.count(v) == 0));
    for (Index v = 0; v < complex.vertex_capacity(); ++v) {
      REQUIRE(numbers[input_vertices[v]] == v);
      REQUIRE(corners_at(complex, v).size() == corners_at(model, input_vertices[v]).size());
    }
  }
}

TEST_CASE("Where nothing has been left out, origins are those that were given, or the numbers") {
  const InputIndices none_given(20, {});
  CHECK(none_given[17] == 17);
  CHECK(none_given.inverse()[17] == 17);
  const InputIndices given(3, {2, 0, 1});
  CHECK(given[0] == 2);
  const InputIndices numbers = given.inverse();
  for (Index i = 0; i < 3; ++i)
    CHECK(numbers[given[i]] == i);
  CHECK(numbers[0] == 1);
}

TEST_CASE("Images are told by origins, whether merges were or not") {
  const bool by_input = GENERATE(false, true);
  Numbering numbering({4, {3, 1, 0, 2}}, {0, {}}, by_input);
  numbering.merge(1, 0); // by origins, 3 into 1
  numbering.merge(2, 1); // 1 into 0
  numbering.use_input_indices();
  CHECK(numbering.merged_vertex(3) == 0);
  CHECK(numbering.merged_vertex(1) == 0);
  CHECK(numbering.merged_vertex(0) == 0);
  CHECK(numbering.merged_vertex(2) == 2);
  numbering.vertices.pack({2, 3}); // 0 and 2
  numbering.merge(1, 0);           // 0 into 2
  CHECK(numbering.merged_vertex(3) == 2);
}

TEST_CASE("More faces or vertices than 32 bits can number are refused with their numbers") {
  TriangleComplex::check_size(TriangleComplex::max_vertices - 1, TriangleComplex::max_faces - 1);
  CHECK_THROWS_AS(TriangleComplex::check_size(TriangleComplex::max_vertices, 0), std::length_error);
  CHECK_THROWS_AS(TriangleComplex::check_size(0, TriangleComplex::max_faces), std::length_error);
  CHECK_THROWS_WITH(TriangleComplex::check_size(0, TriangleComplex::max_faces),
                    Catch::Contains("1073741824 faces") && Catch::Contains("32-bit"));
  // The greatest corner number is that of the last face's last corner.
  CHECK(4 * (TriangleComplex::max_faces - 1) + 2 < quadrille::internal::none);
}

TEST_CASE("VertexLabels are forgotten at once, also when their numbers run out") {
  VertexLabels labels(3);
  CHECK_FALSE(labels.is_labelled(0));
  const Index large = quadrille::internal::none / 4; // the numbers run out after a few rounds
  for (int round = 0; round < 20; ++round) {
    labels.clear(large + 1);
    for (Index v = 0; v < 3; ++v)
      REQUIRE_FALSE(labels.is_labelled(v));
    labels.set(0);
    labels.set(1, round % 2 == 0 ? large : 7);
    REQUIRE(labels.has_label(0, 0));
    REQUIRE(labels.has_label(1, round % 2 == 0 ? large : 7));
    REQUIRE(labels[1] == (round % 2 == 0 ? large : 7));
    REQUIRE_FALSE(labels.is_labelled(2));
    labels.set(1, 3); // again, with a lower number
    REQUIRE(labels[1] == 3);
  }
}

TEST_CASE("The pairs at a vertex are the union of those of the vertices that went into it") {
  Random random(11);
  const Index vertices = 30;
  PairLists lists(vertices);
  std::set<std::set<Index>> expected;
  for (int i = 0; i < 60; ++i) {
    const Index v = random.below(vertices), w = random.below(vertices);
    if (v != w && expected.insert({v, w}).second)
      lists.add(v, w);
  }
  CHECK(lists.size() == expected.size());
  for (int i = 0; i < 25; ++i) {
    const Index kept = random.below(vertices), gone = random.below(vertices);
    if (kept == gone)
      continue;
    lists.merge(kept, gone);
    std::set<std::set<Index>> merged;
    for (std::set<Index> pair : expected) {
      if (pair.erase(gone) > 0)
        pair.insert(kept);
      if (pair.size() == 2)
        merged.insert(pair);
    }
    expected = merged;
    std::set<std::set<Index>> found;
    for (Index v = 0; v < vertices; ++v) {
      std::set<Index> partners;
      lists.prune_partners(v, [&](Index w) {
        CHECK(w != v);
        found.insert({v, w});
        return partners.insert(w).second; // a pair that has become the same as another is dropped
      });
    }
    REQUIRE(found == expected);
  }
}
