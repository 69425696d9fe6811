#ifndef QUADRILLE_KEEP_PLANES_H
#define QUADRILLE_KEEP_PLANES_H

#include <quadrille/internal/core/base/text.h>
#include <quadrille/internal/core/input/surface_input.h>
#include <quadrille/internal/planar/plane_regions.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>

namespace quadrille {

/// Flat stays flat, an argument of `simplify`: the plane regions of a surface from a size on stay
/// in their planes, with any cost.
///
/// A region is a set of faces that are connected across edges and lie in one plane, within a
/// tolerance; it is found as remesh_planar_patches() finds its patches. Regions are the water of a
/// terrain, the walls of a building, the face of a part on a print bed, the facets of a machine
/// part. Each vertex at a face of a region is in its plane, from the first contraction to the last,
/// and a vertex at several regions is in all of their planes. In a plane perpendicular to an axis
/// they have the same coordinate, to the bit; in another one they are in the plane within the
/// rounding of coordinates. Vertices of the input that are next to the plane, within the tolerance,
/// are moved into it first. Distances are measured from the surface that results from that.
///
/// Each region is also one of labels: see Labels. Its outline keeps its topology, and corners at
/// which outlines meet stay where they are. What moves an outline costs more, with any cost that
/// knows its degree (see CostPolicy), as all of the library's do; and the vertex of a pair goes
/// nearer to the outline where that costs less. With `outline`, no point of an outline goes further
/// than that: near the floor of what an outline can be made of, counts of faces are not met.
/// Report::kept_planes is the number of regions.
///
/// A component may vanish with its regions, with Topology::components_may_vanish.
///
/// It works with any order, any channels, labels and guards, for meshes and soups. A vertex that is
/// fixed stays where it is: faces of a region at a fixed vertex that is next to the plane, but not
/// in it, do not belong to it. It throws std::invalid_argument with a placement that looks at the
/// faces around a pair (OuterHull, InnerHull, VolumeKeeping). It takes O(n log n) time and about
/// 100 bytes per face for the search. With `outline`, a contraction at an outline takes a time in
/// proportion to the points of the input that its edges stand for.
struct KeepPlanes {
  double area; ///< the least area of a region, in the mesh's unit squared; at least 0
  /// The greatest distance of the vertices of a region from its plane, in the mesh's unit; by
  /// default a millionth of the diagonal of the bounding box. It is at least the rounding of
  /// coordinates.
  std::optional<double> flatness = {};
  /// The greatest distance of outlines from those of the input, and of these from them, in the
  /// mesh's unit; by default there is none. Both are compared after vertices have moved into their
  /// planes, along the lines from end to end (Fréchet distance), up to rounding.
  std::optional<double> outline = {};

  /// Throws std::invalid_argument for a negative number, or one that is not finite.
  void validate() const {
    require("area", area);
    if (flatness)
      require("flatness", *flatness);
    if (outline)
      require("outline", *outline);
  }

  /// Used by the engine: moves regions into their planes, and names the planes of their vertices.
  template <std::size_t N>
  void prepare(internal::SurfaceInput<N>& input) const {
    input.planes.outline_limit = outline;
    if (!input.triangles.empty())
      internal::RegionsInPlanes<N>(input, area, flatness.value_or(1e-6 * input.box().diagonal()))
          .apply();
  }

private:
  static void require(const char* name, double number) {
    if (!(number >= 0) || !std::isfinite(number))
      throw std::invalid_argument(std::string("quadrille::KeepPlanes: ") + name + " " +
                                  internal::text_of(number) + " is negative or not finite");
  }
};

} // namespace quadrille

#endif // QUADRILLE_KEEP_PLANES_H
