#ifndef QUADRILLE_INTERNAL_CORE_CONTRACTION_ENCLOSED_VOLUME_H
#define QUADRILLE_INTERNAL_CORE_CONTRACTION_ENCLOSED_VOLUME_H

#include <quadrille/internal/core/base/threads.h>
#include <quadrille/internal/core/complex/edge_balance.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/contraction/working_surface.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/surface/box.h>
#include <quadrille/internal/core/surface/scale.h>
#include <quadrille/pairs.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace quadrille::internal {

/// A sum whose error does not grow with the number of its terms. Source: Neumaier,
/// Rundungsfehleranalyse einiger Verfahren zur Summation endlicher Summen, 1974.
class CompensatedSum {
public:
  void add(double x) {
    const double sum = sum_ + x;
    rest_ += std::abs(sum_) >= std::abs(x) ? (sum_ - sum) + x : (x - sum) + sum_;
    sum_ = sum;
  }
  double value() const { return sum_ + rest_; }

private:
  double sum_ = 0, rest_ = 0;
};

/// The volume that a surface encloses, where it is known to enclose one and the placement asks, or
/// a guard: the sum of the tetrahedra of its faces and the middle of a box. In linear time.
template <class Policies>
class EnclosedVolume {
public:
  using Placement = typename Policies::Placement;
  using Surface = WorkingSurface<Policies>;
  using Box = internal::Box<Policies::Cost::dimension>;

  /// Measures the volume of a surface before the first contraction. Throws std::invalid_argument if
  /// the placement needs a closed surface that is oriented outwards, and it is not.
  EnclosedVolume(Surface& surface, const Box& box)
      : scale_(surface.state().scale),
        middle_(space(scale_.position_from_mesh(0.5 * box.low + 0.5 * box.high))) {
    if (surface.policies().guards.asks_for_volume())
      is_known_ = true; // once it has been checked
    if (!asks_for_volume<Placement> || surface.progress().is_cancelled())
      return;
    is_known_ |= surface.state().link_condition.is_oriented();
    if constexpr (needs_closed_surface<Placement>)
      require_closed(surface);
  }

  /// In the mesh's units.
  std::optional<double> operator()(const Surface& surface) const {
    if (!is_known_)
      return std::nullopt;
    const double volume = sum_up(surface) / 6;
    return scale_.length_of_mesh(scale_.length_of_mesh(scale_.length_of_mesh(volume)));
  }

private:
  static constexpr std::size_t block_size = 4096; // faces, whatever the number of threads

  void require_closed(Surface& surface) {
    if (!surface.state().is_topology_kept ||
        surface.policies().topology == Topology::components_may_vanish)
      throw std::invalid_argument(
          "quadrille::simplify: a hull keeps the topology: pass no "
          "Topology::free or components_may_vanish, and no pairs but edges");
    const std::size_t edges = count_unbalanced_edges(surface.complex());
    if (edges > 0)
      throw std::invalid_argument(
          "quadrille::simplify: a hull needs a closed surface with consistently oriented "
          "faces, but " +
          std::to_string(edges) +
          " edges have different numbers of faces on both sides; CGAL::Polygon_mesh_processing "
          "has stitch_borders, triangulate_hole and orient_polygon_soup");
    is_known_ = true;
    if (sum_up(surface) < 0)
      throw std::invalid_argument(
          "quadrille::simplify: a hull needs a surface that is oriented outwards, and this one "
          "is oriented inwards; CGAL::Polygon_mesh_processing::orient_to_bound_a_volume "
          "changes that");
  }

  // Six times the volume, in the engine's units.
  double sum_up(const Surface& surface) const {
    const TriangleComplex& complex = surface.complex();
    const auto& positions = surface.state().geometry.positions();
    const std::size_t faces = complex.face_capacity();
    std::vector<double> sums((faces + block_size - 1) / block_size);
    parallel_for(surface.policies().threads, sums.size(), [&](std::size_t block, std::size_t) {
      CompensatedSum sum;
      const std::size_t end = (std::min)(faces, (block + 1) * block_size);
      for (auto face = static_cast<Index>(block * block_size); face < end; ++face)
        if (!complex.is_removed(face)) {
          const auto [a, b, c] = complex.vertices(face);
          const Vector<3> p = space(positions[a]) - middle_;
          sum.add(dot(p, cross(space(positions[b]) - middle_, space(positions[c]) - middle_)));
        }
      sums[block] = sum.value();
    });
    CompensatedSum sum;
    for (double x : sums)
      sum.add(x);
    return sum.value();
  }

  const Scale<Policies::Cost::dimension>& scale_;
  Vector<3> middle_;
  bool is_known_ = false;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_CONTRACTION_ENCLOSED_VOLUME_H
