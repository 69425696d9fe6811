#ifndef QUADRILLE_EXAMPLES_PROGRAM_KIND_HINT_H
#define QUADRILLE_EXAMPLES_PROGRAM_KIND_HINT_H

/// \file
/// Which kind of surface a mesh looks like: a hint to a preset, which changes nothing.

#include "../mesh_io/mesh/indexed_mesh.h"
#include "../mesh_io/mesh/winding.h"
#include "figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>

namespace quadrille_examples {

/// What tells kinds of surfaces apart: lengths of edges, and how faces lie to the axes.
class SurfaceKind {
public:
  SurfaceKind(const IndexedMesh& mesh, const Winding& winding)
      : winding_(winding), faces_(mesh.triangles.size()) {
    for (const auto& triangle : mesh.triangles) {
      std::array<std::array<double, 3>, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) {
        const Point& p = mesh.points[triangle[i]];
        corners[i] = {p.x(), p.y(), p.z()};
      }
      add(corners);
    }
  }

  /// Returns the preset that goes with the surface, and why; an empty text if none stands out.
  std::string hint() const {
    constexpr std::size_t least_faces = 1000; // of fewer, nothing can be said
    if (faces_ < least_faces)
      return "";
    const std::size_t crowded = winding_.crowded_edges(), open = winding_.open_edges();
    const std::string edges = with_commas(crowded) + " edges of more than two faces";
    if (are_voxels())
      return "all faces lie along the axes, with edges of one length: for voxels, --preset voxels";
    if (const auto axis = axis_of_terrain())
      return std::string("it shows one side only along the ") + "xyz"[*axis] +
             " axis: for terrain, --preset terrain";
    if (crowded == 0 || 2 * crowded > faces_) // sheets with both sides have edges of four faces
      return "";
    if (open * 10'000 <= faces_ && crowded * 10'000 >= faces_ && variation() < 0.45)
      return with_commas(winding_.pieces()) + " pieces, " + edges +
             ": for a generated surface, --preset generated";
    if (open > 0 && 100 * crowded <= faces_ && faces_ >= 10 * least_faces && variation() < 0.55)
      return with_commas(open) + " boundary edges, " + edges + ": for a scan, --preset scan";
    return "";
  }

private:
  using Place = std::array<double, 3>;

  void add(const std::array<Place, 3>& corners) {
    Place normal{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
      normal[k] = (corners[1][u] - corners[0][u]) * (corners[2][v] - corners[0][v]) -
                  (corners[1][v] - corners[0][v]) * (corners[2][u] - corners[0][u]);
      low_[k] = std::min({low_[k], corners[0][k], corners[1][k], corners[2][k]});
      high_[k] = std::max({high_[k], corners[0][k], corners[1][k], corners[2][k]});
    }
    const double size = std::hypot(normal[0], normal[1], normal[2]);
    are_along_axes_ = are_along_axes_ && std::max({std::abs(normal[0]), std::abs(normal[1]),
                                                   std::abs(normal[2])}) >= 0.9999 * size;
    for (std::size_t k = 0; k < 3; ++k) {
      (normal[k] > 0 ? up_ : down_)[k] |= std::abs(normal[k]) > 1e-9 * size;
      shadow_[k] += std::abs(normal[k]) / 2;
    }
    for (std::size_t i = 0; i < 3; ++i)
      add_edge(corners[i], corners[(i + 1) % 3]);
  }

  void add_edge(const Place& p, const Place& q) {
    const Place d{std::abs(q[0] - p[0]), std::abs(q[1] - p[1]), std::abs(q[2] - p[2])};
    const double length = std::hypot(d[0], d[1], d[2]);
    sum_ += length;
    squares_ += length * length;
    if (std::max({d[0], d[1], d[2]}) >= (1 - 1e-9) * length) { // along an axis
      shortest_ = std::min(shortest_, length);
      longest_ = std::max(longest_, length);
    }
  }

  bool are_voxels() const { return are_along_axes_ && longest_ <= 1.001 * shortest_; }

  // All faces show one side along an axis, and cover most of the rectangle across it, which is
  // wide.
  std::optional<std::size_t> axis_of_terrain() const {
    for (std::size_t k = 0; k < 3; ++k) {
      const double u = high_[(k + 1) % 3] - low_[(k + 1) % 3],
                   v = high_[(k + 2) % 3] - low_[(k + 2) % 3], height = high_[k] - low_[k];
      if (up_[k] != down_[k] && shadow_[k] > 0.9 * u * v && height > 1e-6 * u &&
          height < 0.6 * std::min(u, v) && winding_.crowded_edges() == 0)
        return k;
    }
    return std::nullopt;
  }

  // The standard deviation of the lengths of edges, as a part of their mean.
  double variation() const {
    const double count = 3 * static_cast<double>(faces_), mean = sum_ / count;
    return mean > 0 ? std::sqrt(std::max(0., squares_ / count - mean * mean)) / mean : 0;
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();

  const Winding& winding_;
  std::size_t faces_;
  Place low_{infinity, infinity, infinity}, high_{-infinity, -infinity, -infinity};
  std::array<bool, 3> up_{}, down_{}; // are there faces that show this side along an axis?
  Place shadow_{};                    // the area of all faces, seen along an axis
  bool are_along_axes_ = true;
  double sum_ = 0, squares_ = 0;             // of the lengths of edges
  double shortest_ = infinity, longest_ = 0; // of those along an axis
};

} // namespace quadrille_examples

#endif
