#ifndef QUADRILLE_INTERNAL_ATTRIBUTES_WEDGE_RECORDS_H
#define QUADRILLE_INTERNAL_ATTRIBUTES_WEDGE_RECORDS_H

#include <quadrille/internal/attributes/affine_maps.h>
#include <quadrille/internal/attributes/wedge_table.h>
#include <quadrille/internal/core/appearance/channel_input.h>
#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/prefetch.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// The record of each wedge of a channel: a weight, a map of its attributes about its vertex, and
/// the input value from which they come.
class WedgeRecords {
public:
  WedgeRecords(std::size_t components, Arena* arena)
      : components_(components), weights_(arena), maps_(arena), boundaries_(arena), origins_(arena),
        identities_(arena), existing_(arena) {}

  std::size_t components() const { return components_; }
  double weight(Index wedge) const { return weights_[wedge]; }
  const AffineMap* maps(Index wedge) const { return maps_.data() + wedge * components_; }
  double value(Index wedge, std::size_t component) const {
    return maps_[wedge * components_ + component].value;
  }
  Vector<2> texture_at(Index wedge) const { return {value(wedge, 0), value(wedge, 1)}; }
  bool have_equal_values(Index w, Index x) const {
    for (std::size_t c = 0; c < components_; ++c)
      if (value(w, c) != value(x, c))
        return false;
    return true;
  }
  /// The index of the value that an adapter has read and that the wedge still has, or is to have at
  /// the end; or none.
  Index origin(Index wedge) const { return origins_[wedge]; }
  /// Gives each wedge an identity, which stays while wedges are renumbered.
  void identify() {
    identities_.resize(weights_.size());
    std::iota(identities_.begin(), identities_.end(), Index{0});
  }
  Index& identity(Index wedge) { return identities_[wedge]; }

  /// Does a wedge constrain the boundary of a chart?
  bool has_constrained_boundary(Index wedge) const {
    return !boundaries_.empty() && boundaries_[wedge][0] + boundaries_[wedge][2] > 0;
  }

  /// Wedges with the values of an input that `origins` names, or `none` for no value.
  void read(const ChannelInput& input, Array<Index> origins) {
    origins_ = std::move(origins);
    if (input.new_values == NewValues::existing)
      existing_ = input.values;
    weights_.assign(origins_.size(), 0);
    maps_.resize(origins_.size() * components_);
    for (std::size_t w = 0; w < origins_.size(); ++w)
      for (std::size_t c = 0; c < components_ && origins_[w] != none; ++c)
        maps_[w * components_ + c].value = input.value(origins_[w], c);
  }
  /// Values that are not of the input.
  void set_values(Index wedge, const std::vector<double>& values) {
    origins_[wedge] = none;
    for (std::size_t c = 0; c < components_; ++c)
      maps_[wedge * components_ + c].value = values[c];
  }
  /// Sets the normals of wedges, of three components, instead of the values; a wedge whose normal
  /// has no length keeps its value.
  void set_normals(const std::vector<Vector<3>>& normals) {
    for (Index wedge = 0; wedge < normals.size(); ++wedge)
      if (squared_length(normals[wedge]) > 0)
        set_values(wedge, {normals[wedge][0], normals[wedge][1], normals[wedge][2]});
  }
  /// Returns the final value of a component of a wedge.
  double final_value(Index wedge, std::size_t c) const {
    return existing_.empty() || origins_[wedge] == none
               ? value(wedge, c)
               : existing_[origins_[wedge] * components_ + c];
  }
  /// Replaces all values by those of their origins. It is used if only existing values are allowed.
  void restore_existing() {
    for (Index wedge = 0; wedge < origins_.size(); ++wedge)
      for (std::size_t c = 0; c < components_; ++c)
        maps_[wedge * components_ + c].value = final_value(wedge, c);
  }

  /// Leaves nothing but values.
  void forget_faces() {
    std::fill(weights_.begin(), weights_.end(), 0.0);
    std::fill(boundaries_.begin(), boundaries_.end(), Matrix2{});
    for (AffineMap& map : maps_)
      map.gradient = {};
  }
  /// Joins a face to a wedge, at which it has the same values. Returns what they disagree about.
  SymmetricMatrix<3> join_face(Index wedge, double weight, const std::vector<Vector<3>>& gradients,
                               const std::vector<double>& squared_weights) {
    SymmetricMatrix<3> difference;
    if (weights_[wedge] == 0) { // the first one agrees with itself
      for (std::size_t c = 0; c < components_; ++c)
        maps_[wedge * components_ + c].gradient = gradients[c];
      weights_[wedge] = weight;
      return difference;
    }
    const double fraction = weight / (weights_[wedge] + weight);
    for (std::size_t c = 0; c < components_; ++c) {
      Vector<3>& gradient = maps_[wedge * components_ + c].gradient;
      const Vector<3> off = gradients[c] - gradient;
      difference +=
          SymmetricMatrix<3>::outer_product(off, weights_[wedge] * fraction * squared_weights[c]);
      gradient += fraction * off;
    }
    weights_[wedge] += weight;
    return difference;
  }
  /// The map of both, about the first, of one component.
  AffineMap joined(Index first, Index second, const Vector<3>& to_second, std::size_t c) const {
    const double sum = weights_[first] + weights_[second];
    const double fraction = sum > 0 ? weights_[second] / sum : 0;
    const AffineMap &one = maps(first)[c], &other = maps(second)[c];
    return {one.gradient + fraction * (other.gradient - one.gradient),
            one.value + fraction * (other.at(-1.0 * to_second) - one.value)};
  }
  /// Joins the wedges of two ends without boundaries, `to_second` apart, and moves the map to a
  /// target, given from the first: it is stored in `kept`, which is one of them.
  void join(Index first, Index second, const Vector<3>& to_second, const Vector<3>& target,
            Index kept, const std::vector<double>& squared_weights) {
    bool is_first = origins_[first] != none, is_second = origins_[second] != none;
    for (std::size_t c = 0; c < components_; ++c) {
      AffineMap map = joined(first, second, to_second, c);
      map.value = map.at(target);
      is_first = is_first && map.value == value(first, c);
      is_second = is_second && map.value == value(second, c);
      maps_[kept * components_ + c] = map;
    }
    weights_[kept] = weights_[first] + weights_[second];
    if (existing_.empty())
      origins_[kept] = is_first ? origins_[first] : is_second ? origins_[second] : none;
    else
      origins_[kept] = closest({origins_[first], origins_[second]}, maps(kept), squared_weights);
  }
  void constrain_boundaries() { boundaries_.resize(weights_.size()); }

  WedgeMap map(Index wedge) const {
    WedgeMap map;
    map.weight = weights_[wedge];
    if (!boundaries_.empty())
      map.boundary = boundaries_[wedge];
    map.maps.assign(maps(wedge), maps(wedge) + components_);
    return map;
  }
  void write(Index wedge, const WedgeMap& map) {
    weights_[wedge] = map.weight;
    if (!boundaries_.empty())
      boundaries_[wedge] = map.boundary;
    std::copy(map.maps.begin(), map.maps.end(), maps_.data() + wedge * components_);
  }
  void write(Index wedge, const WedgeMap& map, Index origin) {
    write(wedge, map);
    origins_[wedge] = origin;
  }

  /// The origin of what some wedges become: a value that has not changed has the index that it had.
  Index origin_of(const WedgeList& wedges, const WedgeMap& map,
                  const std::vector<double>& squared_weights) const {
    if (!existing_.empty()) {
      WedgeList origins;
      for (Index wedge : wedges)
        origins.push_back(origins_[wedge]);
      return closest(origins, map.maps.data(), squared_weights);
    }
    const auto is_left = [&](Index wedge) { return has_values_of(wedge, map); };
    const auto found = std::find_if(wedges.begin(), wedges.end(), is_left);
    return found == wedges.end() ? none : origins_[*found];
  }
  /// Leaves out all wedges but those of a list, which get the numbers 0, 1, …
  void pack(const Array<Index>& left) {
    pack(weights_, left, 1);
    pack(maps_, left, components_);
    pack(boundaries_, left, 1);
    pack(origins_, left, 1);
    pack(identities_, left, 1);
  }

  QUADRILLE_ALWAYS_INLINE void prefetch(Index wedge) const {
    internal::prefetch(&weights_[wedge]);
    internal::prefetch(maps(wedge));
  }

private:
  // Returns the value of the input that is closest to those of maps. It is used if only existing
  // values are allowed.
  Index closest(const WedgeList& origins, const AffineMap* maps,
                const std::vector<double>& squared_weights) const {
    const auto distance = [&](Index origin) {
      double sum = 0;
      for (std::size_t c = 0; c < components_; ++c) {
        const double off = existing_[origin * components_ + c] - maps[c].value;
        sum += squared_weights[c] * off * off;
      }
      return sum;
    };
    return *std::min_element(origins.begin(), origins.end(),
                             [&](Index i, Index j) { return distance(i) < distance(j); });
  }

  bool has_values_of(Index wedge, const WedgeMap& map) const {
    if (origins_[wedge] == none)
      return false;
    for (std::size_t c = 0; c < components_; ++c)
      if (value(wedge, c) != map.maps[c].value)
        return false;
    return true;
  }

  template <class Values>
  static void pack(Values& values, const Array<Index>& left, std::size_t size) {
    if (values.empty())
      return;
    Values packed(left.size() * size, values.get_allocator());
    for (std::size_t i = 0; i < left.size(); ++i)
      std::copy_n(&values[left[i] * size], size, &packed[i * size]);
    values = std::move(packed);
  }

  std::size_t components_;
  Array<double> weights_;
  Array<AffineMap> maps_;  // one a component
  Array<Matrix2> boundaries_; // empty if no chart is constrained
  Array<Index> origins_;
  Array<Index> identities_; // empty if they are not needed
  Array<double> existing_;  // the values of the input, if only these may be
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ATTRIBUTES_WEDGE_RECORDS_H
