#ifndef QUADRILLE_INTERNAL_CORE_CONTRACTION_SHAPE_CHECK_H
#define QUADRILLE_INTERNAL_CORE_CONTRACTION_SHAPE_CHECK_H

#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/state/components.h>
#include <quadrille/internal/core/state/contraction.h>
#include <quadrille/internal/core/state/feature_loss.h>
#include <quadrille/internal/core/state/surface_state.h>
#include <quadrille/internal/core/surface/box.h>
#include <quadrille/internal/core/surface/geometry.h>
#include <quadrille/internal/core/surface/scale.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace quadrille::internal {

/// Does a cost report its error as a distance to the surface? Only the error of such a cost shows
/// whether a shape is spoiled.
template <class Cost>
concept knows_errors = requires(const Cost& cost, const PairOf<Cost>& pair) {
  cost.squared_error(pair, 0.0);
};

/// Returns for each face the one that represents its region: faces of one label that vertices
/// connect.
inline std::vector<Index> regions_of(const TriangleComplex& complex, const Array<Index>& labels) {
  std::vector<Index> parent(complex.face_capacity());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](Index face) {
    while (parent[face] != face)
      face = parent[face] = parent[parent[face]];
    return face;
  };
  std::vector<Index> seen; // at a vertex, one face of each label
  for (Index v = 0; v < complex.vertex_capacity(); ++v) {
    seen.clear();
    complex.for_each_corner(v, [&](Index face, Index) {
      const auto like = std::find_if(seen.begin(), seen.end(),
                                     [&](Index other) { return labels[other] == labels[face]; });
      if (like == seen.end())
        seen.push_back(face);
      else
        parent[root(face)] = root(*like);
    });
  }
  for (Index face = 0; face < parent.size(); ++face)
    parent[face] = root(face);
  return parent;
}

/// Measures how contractions of great error affect the shape of large components of a surface, and
/// of large regions of labels: those from a twentieth of its diagonal.
template <class Policies>
class ShapeCheck {
public:
  using Cost = typename Policies::Cost;
  static constexpr std::size_t dimension = Cost::dimension;
  using Contraction = internal::Contraction<Cost>;

  explicit ShapeCheck(const SurfaceState<Policies>& state) : state_(state) {}

  /// Returns the error from which on the check is worthwhile. In components smaller than a fifth of
  /// the diagonal some contractions of smaller errors would be found to spoil the shape if they
  /// were measured.
  double least_error() const {
    return spoiling_fraction * Components<dimension>::least_large * state_.scale.diagonal();
  }

  /// Is there anything that a contraction could spoil? Components must have been measured before.
  bool has_any() const { return state_.components.size() > 1 || !state_.labels().empty(); }

  /// Returns the ratio of the contraction's error to the error that a large component or region
  /// tolerates: more than 1 if it spoils the shape of one. A component is checked if there are
  /// several, by the error and by measurement; a region of labels by the error.
  double strain(const Contraction& contraction) {
    return (std::max)(strain_of_component(contraction), strain_of_region(contraction));
  }
  /// Returns the strain of a component that vanishes, compared with the whole surface. It spoils
  /// the surface if it lies apart.
  double strain(const Component<dimension>& component) const {
    return knows_errors<Cost> && component.isolation > apart
               ? component.isolation * component.radius /
                     (spoiling_fraction * state_.scale.diagonal())
               : 0;
  }
  /// Returns the key of a contraction that spoils a shape: above the keys of all others, which are
  /// at most about 2^80 (see Scale), and in the order of cost and fourth power of the strain.
  static float costlier(double cost, double strain) { return key_after(0x1p85, cost, strain); }
  /// Returns the cost of a contraction with its strain: shrinking a large component comes after all
  /// components that may vanish, too.
  static float costlier(const Contraction& contraction, double strain) {
    return key_after(strain > melting ? 0x1p100 : 0x1p85, contraction.key(), strain);
  }
  bool spoils(const Contraction& contraction) { return strain(contraction) > 1; }
  /// Checks components alone; several threads may ask.
  bool spoils_component(const Contraction& contraction) const {
    return strain_of_component(contraction) > 1;
  }

  /// Returns the ratio of the measured displacement of the surface to the error of a contraction,
  /// measured if the error is great compared with the whole surface; otherwise 1.
  double excess(const Contraction& contraction) const {
    if constexpr (knows_errors<Cost>)
      if (is_measured(contraction, state_.scale)) [[unlikely]]
        return (std::max)(1., deviation(contraction) / contraction.error());
    return 1;
  }

private:
  // An eighth root keeps the order, and floats can represent the result in addition to the factor.
  static float key_after(double factor, double cost, double strain) {
    const double root = std::sqrt(std::sqrt(std::sqrt(cost))) * std::sqrt(strain);
    return static_cast<float>((std::min)(factor * root, 1e37));
  }

  double deviation(const Contraction& contraction) const {
    return state_.scale.length_of_mesh(deviation_of(contraction, state_.geometry));
  }

  double strain_of_component(const Contraction& contraction) const {
    if constexpr (knows_errors<Cost>) {
      const Component<dimension>* const component = large_component(contraction);
      if (!component)
        return 0;
      const double limit = spoiling_fraction * component->size, error = contraction.error();
      return (error > measured * limit ? (std::max)(error, deviation(contraction)) : error) / limit;
    } else {
      return 0;
    }
  }

  double strain_of_region(const Contraction& contraction) {
    if constexpr (knows_errors<Cost>)
      return state_.labels().empty() ? 0 : contraction.error() / limit_of_regions(contraction);
    else
      return 0;
  }

  // Returns the component of both ends; joining components spoils none.
  const Component<dimension>* large_component(const Contraction& contraction) const {
    if (state_.components.size() < 2)
      return nullptr;
    const Index component = state_.components.of(contraction.first());
    return component == state_.components.of(contraction.second()) &&
                   state_.components[component].is_large
               ? &state_.components[component]
               : nullptr;
  }

  double limit_of_regions(const Contraction& contraction) {
    if (regions_.empty())
      measure_regions();
    double size = std::numeric_limits<double>::infinity();
    const PairStar& star = contraction.star();
    for (const auto* faces : {&star.first, &star.second, &star.shared})
      for (const StarFace& f : *faces)
        size = (std::min)(size, sizes_of_regions_[regions_[f.face]]);
    return spoiling_region * size;
  }

  // Once. That of a small region is infinite.
  QUADRILLE_NOINLINE void measure_regions() {
    regions_ = regions_of(state_.complex, state_.labels());
    std::vector<Box<3>> boxes(regions_.size(), Box<3>::none());
    for (Index face = 0; face < state_.complex.face_capacity(); ++face)
      if (!state_.complex.is_removed(face))
        for (Index v : state_.complex.vertices(face))
          boxes[regions_[face]].add(space(state_.geometry.position(v)));
    for (const Box<3>& box : boxes) {
      const double size = state_.scale.length_of_mesh(box.diagonal());
      sizes_of_regions_.push_back(size >= Components<dimension>::least_large *
                                              state_.scale.diagonal()
                                      ? size
                                      : std::numeric_limits<double>::infinity());
    }
  }

  static constexpr double spoiling_fraction = 1. / 100; // of the size of a component
  static constexpr double spoiling_region = 1. / 16; // of that of a region of labels
  static constexpr double melting = 2;               // times as much as spoils
  static constexpr double apart = 2;                 // of its radii away
  static constexpr double measured = 1. / 4;         // of an error that spoils

  const SurfaceState<Policies>& state_;
  std::vector<Index> regions_; // of each face
  std::vector<double> sizes_of_regions_;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_CONTRACTION_SHAPE_CHECK_H
