#ifndef QUADRILLE_INTERNAL_CORE_ORDER_HANDLE_CUTS_H
#define QUADRILLE_INTERNAL_CORE_ORDER_HANDLE_CUTS_H

#include <quadrille/internal/core/complex/edge_cycle.h>
#include <quadrille/internal/core/complex/vertex_labels.h>
#include <quadrille/internal/core/contraction/working_surface.h>
#include <quadrille/internal/core/evaluation/cut_price.h>
#include <quadrille/internal/core/order/cost_stop.h>
#include <quadrille/internal/core/order/handle_cutter.h>
#include <quadrille/internal/core/order/pair_updates.h>
#include <quadrille/internal/core/order/vanishing_components.h>
#include <quadrille/internal/core/policy/policies.h>
#include <quadrille/internal/core/state/cut_region.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The cuts that a surface may get, the cheapest first: along cycles of three edges that bound no
/// face, no wider than it is asked for.
///
/// A tunnel, as all else, is contracted until three edges run round it; the link condition then
/// rejects each of these. So cycles are looked for at rejected edges only, and found when the
/// cheapest edge round a tunnel has its turn. A cycle waits with its price; when that has its turn,
/// all of it is looked at once more, for the surface may have changed.
template <class Policies>
class HandleCuts final : public HandleCutter<Policies> {
public:
  explicit HandleCuts(const CutterNeeds<Policies>& needs)
      : surface_(needs.surface), updates_(needs.updates), components_(needs.components),
        price_(needs.surface.evaluator(), needs.surface.state()), cost_stop_(needs.surface),
        greatest_(
            needs.surface.state().scale.length_from_mesh(*needs.surface.policies().widest_handle)) {
  }

  void look_at(Index first, Index second) override {
    if (!may_be_cut(first) || !may_be_cut(second))
      return;
    std::vector<Index> others; // neighbours of the first end
    surface_.complex().for_each_corner(first, [&](Index face, Index i) {
      others.push_back(star_face_at(surface_.complex(), face, i).second);
    });
    std::sort(others.begin(), others.end());
    surface_.complex().for_each_corner(second, [&](Index face, Index i) {
      const Index third = star_face_at(surface_.complex(), face, i).second;
      if (std::binary_search(others.begin(), others.end(), third))
        propose(first, second, third);
    });
  }

  bool has_below(double limit) override {
    while (!heap_.empty() && static_cast<double>(heap_.front().first) < limit) {
      const auto [price, cycle] = heap_.front();
      if (!is_listed(price, cycle)) {
        take();
      } else if (!is_allowed(cycle)) {
        take();
        prices_.erase(cycle);
      } else if (const float now = price_(cycle); now > price) {
        take();
        list(now, cycle);
      } else {
        return true;
      }
    }
    return false;
  }

  bool cut_next() override {
    const auto [price, cycle] = heap_.front();
    const double error = price_.error(cycle);
    surface_.progress().announce(error);
    cost_stop_.announce(static_cast<double>(price));
    if (surface_.progress().is_enough())
      return false;
    take();
    prices_.erase(cycle);
    const CycleSides sides(surface_.complex(), cycle);
    CutRegion region(surface_.complex(), surface_.state().geometry, cycle, sides,
                     surface_.scratch().labels);
    if (region.is_handle() || (is_round_tunnel(surface_.state().geometry, cycle, sides) &&
                               region.are_wider_than(greatest_)))
      cut(cycle, sides, error, !region.is_handle());
    return true; // a limb stays, and a bump or a dent is contracted sooner or later
  }

private:
  using Entry = std::pair<float, EdgeCycle>;

  void cut(const EdgeCycle& cycle, const CycleSides& sides, double error, bool components) {
    std::array<std::vector<Index>, 3> right;
    for (std::size_t i = 0; i < 3; ++i)
      for (const StarFace& f : sides.right[i])
        right[i].push_back(f.face);
    const EdgeCycle copies = surface_.cut(cycle, right);
    for (Index v : copies)
      components_.add_vertex(v);
    surface_.run().count_cut(error, components);
    surface_.progress().count(surface_.scratch().counters);
    updates_.follow_cut({cycle[0], cycle[1], cycle[2], copies[0], copies[1], copies[2]});
  }

  // A vertex inside the surface, that may get another place.
  bool may_be_cut(Index v) const {
    const auto& state = surface_.state();
    return state.link_condition.is_oriented(v) && !state.geometry.is_fixed(v) &&
           !state.complex.high_valence_vertices().has(v);
  }

  // In the sense in which the lowest number is followed by the next: one cycle, one entry.
  void propose(Index a, Index b, Index c) {
    EdgeCycle cycle{a, b, c};
    std::sort(cycle.begin(), cycle.end());
    if (!may_be_cut(c) || has_face(surface_.complex(), cycle) || !is_narrow(cycle))
      return;
    const float price = price_(cycle);
    const auto known = prices_.find(cycle);
    if (known == prices_.end() || price < known->second)
      list(price, cycle);
  }

  void list(float price, const EdgeCycle& cycle) {
    prices_[cycle] = price;
    heap_.emplace_back(price, cycle);
    std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
  }
  void take() {
    std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
    heap_.pop_back();
  }

  bool is_listed(float price, const EdgeCycle& cycle) const {
    const auto known = prices_.find(cycle);
    return known != prices_.end() && known->second == price;
  }
  bool is_allowed(const EdgeCycle& cycle) const {
    return std::all_of(cycle.begin(), cycle.end(), [this](Index v) { return may_be_cut(v); }) &&
           is_open_cycle(surface_.complex(), cycle) && is_narrow(cycle);
  }
  bool is_narrow(const EdgeCycle& cycle) const { return price_.width(cycle) <= greatest_; }

  WorkingSurface<Policies>& surface_;
  PairUpdates<Policies>& updates_;
  VanishingComponents<Policies>& components_;
  CutPrice<Policies> price_;
  CostStop<Policies> cost_stop_;
  double greatest_; // width, in the engine's unit
  std::vector<Entry> heap_;
  std::map<EdgeCycle, float> prices_; // of the cycles that wait; other entries are outdated
};

template <class Policies>
std::unique_ptr<HandleCutter<Policies>> make_cutter(const CutterNeeds<Policies>& needs) {
  return std::make_unique<HandleCuts<Policies>>(needs);
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ORDER_HANDLE_CUTS_H
