#ifndef QUADRILLE_TEST_SAME_CONTRACTIONS_H
#define QUADRILLE_TEST_SAME_CONTRACTIONS_H

#include "meshes.h"
#include "reference.h"

#include <quadrille/report.h>
#include <quadrille/stop.h>

#include <catch2/catch.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>

namespace test {

/// Where the engine's mesh and the reference differ first, or nothing.
inline std::string difference(const Mesh& mesh, const Reference& reference, double tolerance) {
  std::ostringstream out;
  for (std::uint32_t v = 0; v < mesh.number_of_vertices() + mesh.number_of_removed_vertices();
       ++v) {
    const Mesh::Vertex_index vertex(v);
    if (mesh.is_removed(vertex) == reference.has_faces(v))
      out << "vertex " << v << (mesh.is_removed(vertex) ? " is gone" : " is left");
    else if (!mesh.is_removed(vertex) &&
             squared_distance(to_position(mesh.point(vertex)), reference.position(v)) >
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
      Triangle t{};
      std::size_t i = 0;
      for (const auto v : mesh.vertices_around_face(mesh.halfedge(face)))
        t.at(i++) = v;
      if (canonical(t) != canonical(expected->second))
        out << "face " << f << " has other vertices";
    }
    if (!out.str().empty())
      return out.str();
  }
  return {};
}

/// Stops after a number of contractions, and where the end is out of reach: there parts would be
/// spared, see StopReason.
struct AfterContractions {
  std::size_t count;

  bool operator()(const quadrille::Status& status) const {
    const bool is_imagined = status.next_error > (std::numeric_limits<double>::max)();
    return status.contractions == count || is_imagined;
  }
};

/// Runs the engine once for each number of contractions there is: run(mesh, stop) simplifies, and
/// other_difference(mesh) tells where the two differ beside their surfaces, or nothing.
template <class Run, class OtherDifference>
void require_same_contractions(const Soup& soup, Reference& reference, Run run,
                               OtherDifference other_difference) {
  using quadrille::Rejection;
  using quadrille::StopReason;
  const double tolerance = 1e-7 * diagonal(soup);
  const Mesh input = make_mesh(soup);
  for (std::size_t contractions = 0;; ++contractions) {
    const bool is_done = contractions > 0 && !reference.contract_next();
    Mesh mesh = input;
    const quadrille::Report report = run(mesh, AfterContractions{contractions});
    INFO("after " << contractions << " contractions: " << report);
    if (report.rejected(Rejection::destruction) > 0)
      return; // the reference goes on where most of a surface is held
    if (is_done) {
      REQUIRE(report.contractions == contractions - 1);
      // How often pairs between corners of seams are refused depends on the value that is held.
      if (reference.seam_rejections == 0)
        REQUIRE(report.rejected(Rejection::topology) == reference.topology_rejections);
      REQUIRE(report.rejected(Rejection::normal_flip) == reference.flip_rejections);
      REQUIRE(report.rejected(Rejection::texture) == reference.texture_rejections);
      REQUIRE(report.stop == (reference.faces().empty() ? StopReason::no_pair_left
                                                        : StopReason::all_pairs_rejected));
      return;
    }
    REQUIRE(difference(mesh, reference, tolerance) == "");
    REQUIRE(other_difference(mesh) == "");
    REQUIRE(report.contractions == contractions);
    // Where the surface is thin, the way by which it recedes may be more: see test_flat.cpp.
    REQUIRE(report.error >= reference.error * (1 - 1e-5) - 1e-8 * diagonal(soup));
  }
}

} // namespace test

#endif // QUADRILLE_TEST_SAME_CONTRACTIONS_H
