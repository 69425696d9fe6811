// SPDX-License-Identifier: MIT
//
// The Hausdorff distance of two triangle meshes, up to a given error.
//
// Licence: this file is MIT, but it includes CGAL's Polygon Mesh Processing and Surface_mesh, which
// are GPL-3.0-or-later (or commercial). A program that includes it is bound by their terms.

#ifndef QUADRILLE_BOUNDED_HAUSDORFF_H
#define QUADRILLE_BOUNDED_HAUSDORFF_H

#include <quadrille/internal/verify/distance_surface.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <algorithm>
#include <stdexcept>

namespace quadrille {

namespace internal {

using DistanceMesh = CGAL::Surface_mesh<DistancePoint>;

/// Returns the box of the vertices that faces use. Throws if the mesh cannot be measured.
template <class Mesh>
CGAL::Bbox_3 measured_box(const char* caller, const Mesh& mesh) {
  return bounding_box(measured_surface(caller, mesh).vertices);
}

template <class Mesh>
DistanceMesh distance_mesh(const Mesh& mesh, const DistanceFrame& frame) {
  DistanceMesh copy;
  CGAL::copy_face_graph(mesh, copy);
  for (const auto v : vertices(copy))
    copy.point(v) = frame.to(copy.point(v));
  return copy;
}

} // namespace internal

/// The Hausdorff distance between two triangle meshes, the larger of both directions, in the unit
/// of their coordinates and wrong by at most `error`, which is in the same unit.
///
/// This function computes a bound where surface_distance() samples: CGAL subdivides the triangles
/// that may still contain the largest distance (Tang, Lee and Kim, "Interactive Hausdorff distance
/// computation for general polygonal models", 2009). An error of 1e-4 of the bounding-box diagonal
/// costs seconds on 100,000 faces; the time grows as the error falls, fastest where both surfaces
/// are equally far apart over whole faces. A result below `error` only says that the distance is
/// below `error`. An error below 2^-40 of the size of both surfaces together is raised to this
/// value.
///
/// Mesh types, scaled copies and exceptions are as for surface_distance(); std::invalid_argument
/// also when `error` is not positive.
template <internal::ReadableGraph MeshA, internal::ReadableGraph MeshB>
double bounded_hausdorff(const MeshA& a, const MeshB& b, double error) {
  if (!(error > 0))
    throw std::invalid_argument("quadrille::bounded_hausdorff: the error must be positive");
  const CGAL::Bbox_3 box = internal::measured_box("quadrille::bounded_hausdorff: surface a", a) +
                           internal::measured_box("quadrille::bounded_hausdorff: surface b", b);
  const double farthest = internal::diagonal(box);
  if (farthest == 0)
    return 0; // both surfaces are one point, which CGAL cannot measure
  const internal::DistanceFrame frame(box);
  // CGAL squares the error, and does not terminate if an error is lost in rounding.
  const double error_in_frame = std::clamp(frame.to(error), 0x1p-40, 0x1p500);
  const double distance = CGAL::Polygon_mesh_processing::bounded_error_symmetric_Hausdorff_distance<
      CGAL::Sequential_tag>(internal::distance_mesh(a, frame), internal::distance_mesh(b, frame),
                            error_in_frame);
  // CGAL returns the error itself where the distance is far below a large error.
  return (std::min)(frame.from(distance), farthest);
}

} // namespace quadrille

#endif
