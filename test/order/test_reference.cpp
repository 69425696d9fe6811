// The engine picks the same contractions as a simplifier that looks at every edge at every step.

#include "meshes.h"
#include "reference.h"
#include "same_contractions.h"

#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace {

using namespace quadrille;
using test::Mesh;
using test::Soup;

void require_same_contractions(const Soup& soup, double boundary_weight) {
  test::Reference reference(soup, boundary_weight);
  test::require_same_contractions(
      soup, reference,
      [&](Mesh& mesh, const auto& stop) {
        return simplify(mesh, Quadric{.boundary_weight = boundary_weight}, stop);
      },
      [](const Mesh&) { return std::string(); });
}

} // namespace

TEST_CASE("Closed surfaces are simplified as by brute force") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 12));
  CAPTURE(seed);
  require_same_contractions(test::random_closed(seed), 100);
}

TEST_CASE("Surfaces with borders are simplified as by brute force") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 12));
  const double boundary_weight = GENERATE(100.0, 1.0, 0.0);
  CAPTURE(seed, boundary_weight);
  require_same_contractions(test::random_with_boundaries(seed), boundary_weight);
}

TEST_CASE("Flat surfaces are simplified as by brute force") {
  const auto seed = GENERATE(range<std::uint64_t>(0, 6));
  CAPTURE(seed);
  const Soup noisy = test::with_holes(test::with_noise(test::grid(9, 8), seed, 0.03), seed, 12);
  require_same_contractions(test::mapped(noisy,
                                         [](const test::Position& p) {
                                           return test::Position{{p[0], p[1], 0}};
                                         }),
                            100);
}

TEST_CASE("The smallest surfaces are simplified as by brute force") {
  require_same_contractions(test::triangle(), 100);
  require_same_contractions(test::two_triangles(), 100);
  require_same_contractions(test::tetrahedron(), 100);
}

TEST_CASE("Of pairs that cost the same the one of lower indices comes first") {
  // Two copies of one surface, moved by a power of two: every difference of coordinates is exact,
  // so every contraction costs the same in both of them, and the first copy goes ahead.
  const auto on_lattice = [](const test::Position& p) {
    return test::Position{{std::round(p[0] * 0x1p16) * 0x1p-16, std::round(p[1] * 0x1p16) * 0x1p-16,
                           std::round(p[2] * 0x1p16) * 0x1p-16}};
  };
  const Soup one = test::mapped(test::random_closed(0), on_lattice);
  const std::size_t n = one.points.size();
  const test::Position shift{{4, 0, 0}};
  const Mesh input = test::make_mesh(test::joined(one, one, shift));
  for (std::size_t contractions = 0; contractions < n; ++contractions) {
    CAPTURE(contractions);
    Mesh mesh = input;
    simplify(mesh, [&](const Status& status) { return status.contractions == contractions; });
    std::array<std::size_t, 2> gone{};
    for (std::uint32_t v = 0; v < 2 * n; ++v)
      gone.at(v / n) += mesh.is_removed(Mesh::Vertex_index(v));
    REQUIRE(gone[0] == (contractions + 1) / 2);
    REQUIRE(gone[1] == contractions / 2);
    if (gone[0] != gone[1])
      continue;
    for (std::uint32_t v = 0; v < n; ++v) {
      const Mesh::Vertex_index first(v), second(v + static_cast<std::uint32_t>(n));
      REQUIRE(mesh.is_removed(first) == mesh.is_removed(second));
      if (!mesh.is_removed(first))
        REQUIRE(squared_distance(test::to_position(mesh.point(first)) + shift,
                                 test::to_position(mesh.point(second))) < 1e-20);
    }
  }
}
