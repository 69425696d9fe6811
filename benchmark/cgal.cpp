// SPDX-License-Identifier: MIT
//
// CGAL's own simplification: the four Garland-Heckbert policies of 5.5, and Lindstrom-Turk.

#include "contender.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_policies.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_probabilistic_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_probabilistic_triangle_policies.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_triangle_policies.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Polyhedral_envelope_filter.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <cmath>

namespace bench {
namespace {

namespace SMS = CGAL::Surface_mesh_simplification;
using Polyhedron = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;

std::size_t face_count(const Mesh& mesh) {
  return mesh.number_of_faces();
}
std::size_t face_count(const Polyhedron& mesh) {
  return mesh.size_of_facets();
}

/// CGAL 5.5 can only stop at a number of edges; this stops at a number of faces.
struct FaceCountStop {
  std::size_t faces;

  template <class Cost, class Profile>
  bool operator()(const Cost&, const Profile& profile, std::size_t, std::size_t) const {
    return face_count(profile.surface_mesh()) <= faces;
  }
};

template <class Graph, class Cost, class Placement>
void collapse(Graph& mesh, std::size_t faces, const Cost& cost, const Placement& placement) {
  SMS::edge_collapse(mesh, FaceCountStop{faces},
                     CGAL::parameters::get_cost(cost).get_placement(placement).filter(
                         SMS::Bounded_normal_change_filter<>()));
}

template <class Policies, class Graph>
void garland_heckbert(Graph& mesh, std::size_t faces) {
  const Policies policies(mesh);
  collapse(mesh, faces, policies.get_cost(), policies.get_placement());
}

Answer lindstrom_turk(Mesh& mesh, std::size_t faces) {
  collapse(mesh, faces, SMS::LindstromTurk_cost<Mesh>(), SMS::LindstromTurk_placement<Mesh>());
  return {};
}

Answer lindstrom_turk_unfiltered(Mesh& mesh, std::size_t faces) {
  SMS::edge_collapse(mesh, FaceCountStop{faces},
                     CGAL::parameters::get_cost(SMS::LindstromTurk_cost<Mesh>())
                         .get_placement(SMS::LindstromTurk_placement<Mesh>()));
  return {};
}

/// Within a hundredth of the diagonal, which a tenth of the faces does not need.
Answer lindstrom_turk_in_envelope(Mesh& mesh, std::size_t faces) {
  CGAL::Bbox_3 box;
  for (const auto v : mesh.vertices())
    box += mesh.point(v).bbox();
  const double diagonal =
      std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
  SMS::edge_collapse(
      mesh, FaceCountStop{faces},
      CGAL::parameters::get_cost(SMS::LindstromTurk_cost<Mesh>())
          .get_placement(SMS::LindstromTurk_placement<Mesh>())
          .filter(SMS::Polyhedral_envelope_filter<Kernel, SMS::Bounded_normal_change_filter<>>(
              0.01 * diagonal, SMS::Bounded_normal_change_filter<>())));
  return {};
}

Answer plane_on_polyhedron(Mesh& mesh, std::size_t faces) {
  Polyhedron polyhedron;
  CGAL::copy_face_graph(mesh, polyhedron);
  CGAL::set_halfedgeds_items_id(polyhedron); // doubles its speed
  const Stopwatch stopwatch;
  garland_heckbert<SMS::GarlandHeckbert_plane_policies<Polyhedron, Kernel>>(polyhedron, faces);
  const double seconds = stopwatch.seconds();
  mesh.clear();
  CGAL::copy_face_graph(polyhedron, mesh);
  return {.own_seconds = seconds, .soup = {}};
}

template <class Policies>
Contender garland_heckbert_contender(std::string name, std::string policies) {
  return {std::move(name), std::move(policies) + ", Bounded_normal_change_filter, Surface_mesh",
          [](Mesh& mesh, std::size_t faces) {
            garland_heckbert<Policies>(mesh, faces);
            return Answer{};
          }};
}

} // namespace

std::vector<Contender> cgal_contenders() {
  return {
      garland_heckbert_contender<SMS::GarlandHeckbert_plane_policies<Mesh, Kernel>>(
          "CGAL GH plane", "GarlandHeckbert_plane_policies"),
      garland_heckbert_contender<SMS::GarlandHeckbert_triangle_policies<Mesh, Kernel>>(
          "CGAL GH triangle", "GarlandHeckbert_triangle_policies"),
      garland_heckbert_contender<SMS::GarlandHeckbert_probabilistic_plane_policies<Mesh, Kernel>>(
          "CGAL GH probabilistic plane", "GarlandHeckbert_probabilistic_plane_policies"),
      garland_heckbert_contender<
          SMS::GarlandHeckbert_probabilistic_triangle_policies<Mesh, Kernel>>(
          "CGAL GH probabilistic triangle", "GarlandHeckbert_probabilistic_triangle_policies"),
      {"CGAL Lindstrom-Turk",
       "LindstromTurk_cost and _placement, Bounded_normal_change_filter, Surface_mesh",
       lindstrom_turk},
      {"CGAL Lindstrom-Turk unfiltered", "LindstromTurk_cost and _placement, Surface_mesh",
       lindstrom_turk_unfiltered},
      {"CGAL Lindstrom-Turk in envelope",
       "the same with Bounded_normal_change_filter and Polyhedral_envelope_filter of 1 % of the "
       "diagonal",
       lindstrom_turk_in_envelope, true},
      {"CGAL GH plane on Polyhedron_3",
       "GarlandHeckbert_plane_policies, Bounded_normal_change_filter, Polyhedron_3 with ids",
       plane_on_polyhedron},
  };
}

} // namespace bench
