#ifndef QUADRILLE_VOXEL_SIZE_H
#define QUADRILLE_VOXEL_SIZE_H

#include <quadrille/internal/core/base/text.h>
#include <quadrille/internal/core/input/stair_smoothing.h>
#include <quadrille/internal/core/input/surface_input.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace quadrille {

/// Staircases become smooth, an argument of `simplify` for surfaces of voxels: blocky ones,
/// marching cubes of a binary image, surfaces of a segmentation with labels.
///
/// Such a surface is known to half a voxel only. It is smoothed within these bounds before the
/// first contraction, so that it has no stairs which faces would have to follow: the result is
/// closer to the surface from which the voxels were made. Terraces that are the height of a voxel
/// bend, walls that are flat for long stay flat, and volumes stay the same to a few tenths of a
/// percent.
///
/// **What is promised.** Each vertex moves by at most half a voxel along each axis, and faces with
/// their vertices. So each point of the smoothed surface is within half a voxel of a point of the
/// input along each axis, and the other way round. Distances that a stop policy limits, and those
/// of the report, are measured from the smoothed surface: with HausdorffLimit{d} the result is
/// within d of a surface that is within half a voxel of the input.
///
/// Vertices where other than two faces meet, or faces of two labels, are smoothed along the line on
/// which they lie. Walls that two labels share stay shared, since no vertex is split. Fixed
/// vertices stay where they are.
///
/// It works with any policies except hulls, which have to contain the input. It takes linear time,
/// about two microseconds per vertex, and 200 bytes per vertex before the simplification.
struct VoxelSize {
  double size; ///< the side of a voxel, in the mesh's unit; above 0 and finite

  /// Throws std::invalid_argument for a size that is not above 0, or not finite.
  void validate() const {
    if (!(size > 0) || !std::isfinite(size))
      throw std::invalid_argument("quadrille::VoxelSize: the size " + internal::text_of(size) +
                                  " is not above 0");
  }

  /// Used by the engine: smooths the surface before it is simplified.
  template <std::size_t N>
  void prepare(internal::SurfaceInput<N>& input) const {
    internal::StairSmoothing<N>(input, size).apply();
  }
};

} // namespace quadrille

#endif // QUADRILLE_VOXEL_SIZE_H
