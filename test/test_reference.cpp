// The engine picks the same contractions as a simplifier that looks at every edge at every step.

#include "meshes.h"
#include "reference.h"

#include <quadrille/simplify.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>

namespace {

using namespace quadrille;
using test::Mesh;
using test::Soup;

// Where the engine's mesh and the reference differ first, or nothing.
std::string difference(const Mesh& mesh, const test::Reference& reference, double tolerance) {
  std::ostringstream out;
  for (std::uint32_t v = 0; v < mesh.number_of_vertices() + mesh.number_of_removed_vertices();
       ++v) {
    const Mesh::Vertex_index vertex(v);
    if (mesh.is_removed(vertex) == reference.has_faces(v))
      out << "vertex " << v << (mesh.is_removed(vertex) ? " is gone" : " is left");
    else if (!mesh.is_removed(vertex) &&
             squared_distance(test::to_position(mesh.point(vertex)), reference.position(v)) >
                 tolerance * tolerance)
      out << "vertex " << v << " lies elsewhere";
    if (!out.str().empty())
      return out.str();
  }
  for (std::uint32_t f = 0; f < mesh.number_of_faces() + mesh.number_of_removed_faces(); ++f) {
    const Mesh::Face_index face(f);
    const auto expected = reference.faces().find(f);
    if (mesh.is_removed(face) != (expected == reference.faces().end()))
      out << "face " << f << (mesh.is_removed(face) ? " is gone" : " is left");
    if (!mesh.is_removed(face) && out.str().empty()) {
      test::Triangle t{};
      std::size_t i = 0;
      for (const auto v : mesh.vertices_around_face(mesh.halfedge(face)))
        t.at(i++) = v;
      if (test::canonical(t) != test::canonical(expected->second))
        out << "face " << f << " has other vertices";
    }
    if (!out.str().empty())
      return out.str();
  }
  return {};
}

// Runs the engine once for each number of contractions there is.
void require_same_contractions(const Soup& soup, double boundary_weight) {
  const double tolerance = 1e-7 * test::diagonal(soup);
  const Mesh input = test::make_mesh(soup);
  test::Reference reference(soup, boundary_weight);
  for (std::size_t contractions = 0;; ++contractions) {
    const bool is_done = contractions > 0 && !reference.contract_next();
    Mesh mesh = input;
    const Report report =
        simplify(mesh, Quadric{.boundary_weight = boundary_weight}, [&](const Status& status) {
          // Where the end is out of reach, parts would be spared: see StopReason.
          const bool is_imagined = status.next_error > std::numeric_limits<double>::max();
          return status.contractions == contractions || is_imagined;
        });
    INFO("after " << contractions << " contractions: " << report);
    if (is_done) {
      REQUIRE(report.contractions == contractions - 1);
      REQUIRE(report.rejected(Rejection::topology) == reference.topology_rejections);
      REQUIRE(report.rejected(Rejection::normal_flip) == reference.flip_rejections);
      REQUIRE(report.stop == (reference.faces().empty() ? StopReason::no_pair_left
                                                        : StopReason::all_pairs_rejected));
      return;
    }
    REQUIRE(difference(mesh, reference, tolerance) == "");
    REQUIRE(report.contractions == contractions);
    REQUIRE(report.error ==
            Approx(reference.error).epsilon(1e-5).margin(1e-8 * test::diagonal(soup)));
  }
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
  require_same_contractions(test::random_with_borders(seed), boundary_weight);
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
