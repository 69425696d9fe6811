#ifndef QUADRILLE_INTERNAL_CORE_POLICY_MESH_UNITS_H
#define QUADRILLE_INTERNAL_CORE_POLICY_MESH_UNITS_H

#include <quadrille/internal/core/policy/contraction_view.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/surface/scale.h>
#include <quadrille/quadric_form.h>

#include <cstddef>
#include <optional>

/// Policies that are not scale-free see values in the units of the mesh and its attributes.

namespace quadrille::internal {

/// A cost whose lengths, if it has any, are in the engine's unit.
template <class Cost>
decltype(auto) with_engine_lengths(const Cost& cost,
                                   [[maybe_unused]] const Scale<Cost::dimension>& scale) {
  const auto convert = [&](double length) { return scale.length_from_mesh(length); };
  if constexpr (requires(Cost copy) { copy.convert_lengths(convert); }) {
    Cost copy(cost);
    copy.convert_lengths(convert);
    return copy;
  } else {
    return (cost);
  }
}

/// The states and local terms of a pair, as the cost has made them. Those of a scale-free cost are
/// in unknown units, so they are absent.
template <class Cost>
struct StateInMeshUnits {
  explicit StateInMeshUnits(const PairOf<Cost>&) {}
};
template <class Cost>
requires(!is_scale_free<Cost>) struct StateInMeshUnits<Cost> {
  explicit StateInMeshUnits(const PairOf<Cost>& pair) : state(pair.state), current(pair.current) {}

  const typename Cost::State& state;
  const typename PairCurrentOf<Cost>::type& current;
};

/// A pair as a placement sees it.
template <class Cost>
class PairInMeshUnits : public StateInMeshUnits<Cost> {
public:
  using Position = Vector<Cost::dimension>;
  using Scale = internal::Scale<Cost::dimension>;

  Position first, second;
  double squared_ring_radius;

  PairInMeshUnits(const PairOf<Cost>& pair, const Scale& scale)
      : StateInMeshUnits<Cost>(pair), first(scale.position_of_mesh(pair.first)),
        second(scale.position_of_mesh(pair.second)),
        squared_ring_radius(scale.length_of_mesh(scale.length_of_mesh(pair.squared_ring_radius))),
        pair_(pair) {}

  const PairOf<Cost>& in_engine_units() const { return pair_; }

  /// For the engine. An end is that end, however attributes are rounded when they are weighed.
  Position position_from_mesh(const Position& x, const Scale& scale) const {
    if (x == first)
      return pair_.first;
    return x == second ? pair_.second : scale.position_from_mesh(x);
  }

private:
  const PairOf<Cost>& pair_;
};

/// The cost of such a pair, as a placement sees it. Costs have no unit of their own: they can be
/// compared with each other.
template <class Cost>
class CostInMeshUnits {
public:
  static constexpr std::size_t dimension = Cost::dimension;
  using Position = Vector<dimension>;
  using Pair = PairInMeshUnits<Cost>;

  CostInMeshUnits(const Cost& cost, const Scale<dimension>& scale) : cost_(cost), scale_(scale) {}

  double operator()(const Pair& pair, const Position& x) const {
    return cost_(pair.in_engine_units(), pair.position_from_mesh(x, scale_));
  }

  std::optional<Position> minimizer(const Pair& pair) const requires
      requires(const Cost& cost, const PairOf<Cost>& p) {
    *cost.minimizer(p);
  }
  {
    if (const auto x = cost_.minimizer(pair.in_engine_units()))
      return scale_.position_of_mesh(*x);
    return std::nullopt;
  }

private:
  const Cost& cost_;
  const Scale<dimension>& scale_;
};

/// A contraction as a filter sees it.
template <std::size_t N>
class ContractionInMeshUnits {
public:
  ContractionInMeshUnits(const IndexedContraction<N>& contraction, const Scale<N>& scale)
      : contraction_(contraction), scale_(scale) {}

  ChangedFaces<ContractionInMeshUnits> faces() const { return ChangedFaces(*this); }
  std::size_t face_count() const { return contraction_.face_count(); }
  IndexedFace face(std::size_t i) const {
    const IndexedFace f = contraction_.face(i);
    return {{point(f.before), point(f.after), point(f.second), point(f.third)}, f.index};
  }
  RemovedFaces removed_faces() const { return contraction_.removed_faces(); }
  template <class Visit>
  void for_each_gone(Visit visit) const {
    contraction_.for_each_gone([&](GoneFace f) {
      for (Vector<3>& corner : f.corners)
        corner = point(corner);
      visit(f);
    });
  }
  std::size_t first() const { return contraction_.first(); }
  std::size_t second() const { return contraction_.second(); }
  Vector<N> target() const { return scale_.position_of_mesh(contraction_.target()); }
  std::size_t highest_degree() const { return contraction_.highest_degree(); }
  bool makes_fold_over() const { return contraction_.makes_fold_over(); }

private:
  Vector<3> point(Vector<3> p) const {
    for (double& x : p.coordinates)
      x = scale_.length_of_mesh(x);
    return p;
  }

  const IndexedContraction<N>& contraction_;
  const Scale<N>& scale_;
};

/// The argument of a user's policy: a pair and its cost, or a contraction.
template <class Placement, class Cost>
struct SeenByPlacement {
  using Pair = PairFor<Placement, PairInMeshUnits<Cost>>;
  using Costs = CostInMeshUnits<Cost>;
};
template <class Placement, class Cost>
requires is_scale_free<Placement>
struct SeenByPlacement<Placement, Cost> {
  using Pair = PairFor<Placement, PairOf<Cost>>;
  using Costs = Cost;
};

template <class Filter, class Cost>
struct SeenByFilter {
  using Contraction = ContractionInMeshUnits<Cost::dimension>;
};
template <class Filter, class Cost>
requires is_scale_free<Filter>
struct SeenByFilter<Filter, Cost> {
  using Contraction = IndexedContraction<Cost::dimension>;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_POLICY_MESH_UNITS_H
