#ifndef QUADRILLE_INTERNAL_CORE_ORDER_VANISHING_COMPONENTS_H
#define QUADRILLE_INTERNAL_CORE_ORDER_VANISHING_COMPONENTS_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/contraction/working_surface.h>
#include <quadrille/internal/core/evaluation/component_price.h>
#include <quadrille/internal/core/order/cost_stop.h>
#include <quadrille/internal/core/order/deferred_pairs.h>
#include <quadrille/internal/core/order/distance_stop.h>
#include <quadrille/internal/core/order/end_of_run.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/state/component_event.h>
#include <quadrille/internal/core/state/components.h>
#include <quadrille/pairs.h>
#include <quadrille/report.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The vertices of each component of a surface.
class ComponentLists {
public:
  ComponentLists() = default;
  /// In linear time.
  template <std::size_t N>
  ComponentLists(const TriangleComplex& complex, const Components<N>& components)
      : begin_(components.size() + 1, 0), size_(components.size(), 0) {
    for (Index v = 0; v < complex.vertex_capacity(); ++v)
      if (complex.has_faces(v))
        ++size_[components.of(v)];
    std::partial_sum(size_.begin(), size_.end(), begin_.begin() + 1);
    left_ = static_cast<std::size_t>(
        std::count_if(size_.begin(), size_.end(), [](Index size) { return size > 0; }));
    vertices_.resize(begin_.back());
    std::fill(size_.begin(), size_.end(), 0);
    for (Index v = 0; v < complex.vertex_capacity(); ++v)
      if (complex.has_faces(v))
        vertices_[begin_[components.of(v)] + size_[components.of(v)]++] = v;
  }

  /// How many have not vanished.
  std::size_t left() const { return left_; }
  /// Returns the remaining vertices of a component. Later calls for the same component make the
  /// list shorter.
  std::span<const Index> vertices(const TriangleComplex& complex, Index component) {
    const auto first = vertices_.begin() + begin_[component];
    const auto last = std::remove_if(first, first + size_[component],
                                     [&](Index v) { return !complex.has_faces(v); });
    size_[component] = static_cast<Index>(last - first);
    return {vertices_.data() + begin_[component], size_[component]};
  }
  void count_vanished() { --left_; }

private:
  std::vector<Index> vertices_;     // component after component
  std::vector<Index> begin_, size_; // of each component
  std::size_t left_ = 0;            // components
};

/// The components of a surface that may vanish, the cheapest first: see
/// Topology::components_may_vanish. It is empty if they may not.
///
/// The state of a component is the same after its contractions as before, so its cost stays the
/// same, except with costs that look at the current surface, by which it becomes more costly while
/// its faces become larger. Such a component goes back.
template <class Policies>
class VanishingComponents {
public:
  /// In linear time.
  explicit VanishingComponents(WorkingSurface<Policies>& surface)
      : surface_(surface), price_(surface.evaluator()), distance_stop_(surface),
        cost_stop_(surface) {
    if (surface.policies().topology != Topology::components_may_vanish || components().size() < 2)
      return;
    has_count_ = stops_at_a_count(surface);
    lists_ = ComponentLists(surface.complex(), components());
    for (Index component = 0; component < components().size(); ++component)
      if (!components().stays(components()[component]) && !vertices(component).empty())
        heap_.push_back({price(component), component});
    std::make_heap(heap_.begin(), heap_.end(), std::greater<>());
  }

  /// Does the cheapest cost less than `limit`, and leave the surface at the target or before it? If
  /// it would go beyond, it has to wait, with all that are more costly, for the last resort. Pairs
  /// come first even then, as they go beyond it by less, if they do not cost too much more.
  bool has_below(double limit, bool is_last_resort) {
    return !heap_.empty() && has_cheap(static_cast<float>(limit), is_last_resort);
  }
  /// Is that more than meeting the target exactly is worth, if a component has to wait?
  bool is_too_costly(double cost) const {
    return waiting_price_ &&
           cost > DeferredPairs::costliest_exact * static_cast<double>(*waiting_price_);
  }

  /// Removes the component that has_below() has found, unless it is rejected, and calls gone(v) for
  /// each of its vertices. It is rejected, too, if it spoils the shape of the whole and is_end().
  /// Returns false if the stop policy is satisfied without.
  template <class Gone, class IsEnd>
  bool vanish_next(Gone gone, IsEnd is_end) {
    cost_stop_.announce(static_cast<double>(heap_.front().first));
    const Index component = take();
    waiting_price_.reset();
    surface_.progress().announce(components()[component].radius);
    if (distance_stop_.is_too_far(2 * components()[component].radius)) {
      reject(Rejection::distance);
      return true;
    }
    if (surface_.progress().is_enough())
      return false;
    if (strain(components()[component]) > 1 && is_end()) {
      reject(Rejection::destruction);
      return true;
    }
    const std::span<const Index> vertices = this->vertices(component);
    surface_.remove_component(component, vertices);
    std::for_each(vertices.begin(), vertices.end(), gone);
    lists_.count_vanished();
    surface_.progress().count(surface_.scratch().counters);
    return true;
  }

  bool has_met_distance() const { return has_met_distance_; }
  bool has_met_destruction() const { return has_met_destruction_; }

private:
  using Cost = typename Policies::Cost;
  using Entry = std::pair<float, Index>; // price and component

  const Components<Cost::dimension>& components() const { return surface_.state().components; }
  std::span<const Index> vertices(Index component) {
    return lists_.vertices(surface_.complex(), component);
  }
  float price(Index component) {
    const Component<Cost::dimension>& shape = components()[component];
    const double distance = shape.isolation * shape.isolation * shape.squared_radius;
    const float price = price_(vertices(component), shape.centre, distance);
    const double strain = this->strain(shape);
    return strain > 1 ? ShapeCheck<Policies>::costlier(static_cast<double>(price), strain) : price;
  }
  double strain(const Component<Cost::dimension>& shape) const {
    return has_count_ ? surface_.shape_check().strain(shape) : 0;
  }

  bool has_cheap(float limit, bool is_last_resort) {
    while (!heap_.empty() && heap_.front().first < limit) {
      const Index component = heap_.front().second;
      if (lists_.left() < 2)
        take(); // for good
      else if (!has_become_costlier())
        return !has_to_wait(component) ||
               (is_last_resort && is_too_costly(static_cast<double>(limit)));
    }
    return false;
  }

  // The cheapest, which goes back if it has.
  bool has_become_costlier() {
    if constexpr (has_local_terms<Cost>) {
      const Entry cheapest = heap_.front();
      if (const float now = price(cheapest.second); now > tolerated_rise * cheapest.first) {
        take();
        heap_.push_back({now, cheapest.second});
        std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
        return true;
      }
    }
    return false;
  }

  bool has_to_wait(Index component) {
    if (!waiting_price_) {
      const std::span<const Index> vertices = this->vertices(component);
      const Loss loss{faces_of(surface_.complex(), vertices).size(), vertices.size()};
      if (surface_.run().target_rules().is_passed_without(loss, surface_.status()))
        waiting_price_ = heap_.front().first;
    }
    return waiting_price_.has_value();
  }

  // The cheapest, which is no longer here then.
  Index take() {
    std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
    const Index component = heap_.back().second;
    heap_.pop_back();
    return component;
  }

  void reject(Rejection cause) {
    surface_.run().reject({none, none}, cause);
    has_met_distance_ |= cause == Rejection::distance;
    has_met_destruction_ |= cause == Rejection::destruction;
  }

  static constexpr float tolerated_rise = 1.1f; // a component is looked at a few times only

  WorkingSurface<Policies>& surface_;
  ComponentPrice<Policies> price_;
  DistanceStop<Policies> distance_stop_;
  CostStop<Policies> cost_stop_;
  bool has_count_ = false;
  ComponentLists lists_;
  std::vector<Entry> heap_;
  std::optional<float> waiting_price_; // of a component that would go beyond the target
  bool has_met_distance_ = false, has_met_destruction_ = false;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ORDER_VANISHING_COMPONENTS_H
