#ifndef QUADRILLE_INTERNAL_ATTRIBUTES_WEDGE_RECORDS_H
#define QUADRILLE_INTERNAL_ATTRIBUTES_WEDGE_RECORDS_H

#include <quadrille/internal/attributes/affine_maps.h>
#include <quadrille/internal/attributes/wedge_table.h>
#include <quadrille/internal/core/appearance/channel_input.h>
#include <quadrille/internal/core/base/compiler.h>
#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/lanes.h>
#include <quadrille/internal/core/base/prefetch.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Returns a vector of three floats.
inline Vector<3> in_doubles(float x, float y, float z) {
  return {{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)}};
}

/// The difference of the maps of two wedges, in lengths, for four components: (x, y, z) · p + off
/// at a place p from the first.
struct FourDifferences {
  FourFloats x, y, z, off;
};

/// Calls visit(four, count) for each four components that there are, of which `count`, a constant,
/// is less than four at the end.
template <class Visit>
QUADRILLE_ALWAYS_INLINE inline void for_each_four(std::size_t components, Visit visit) {
  std::size_t four = 0;
  for (; 4 * four + 4 <= components; ++four)
    visit(four, std::integral_constant<std::size_t, 4>());
  switch (components % 4) {
  case 1:
    return visit(four, std::integral_constant<std::size_t, 1>());
  case 2:
    return visit(four, std::integral_constant<std::size_t, 2>());
  case 3:
    return visit(four, std::integral_constant<std::size_t, 3>());
  }
}

/// The wedge that two become, for four components: gradients in lengths, and values at a target.
struct FourJoined {
  FourFloats x, y, z;
  std::array<Lanes, 2> values;
};

/// The record of each wedge of a channel, in columns: a weight, the value and the gradient of each
/// component about its vertex, and the input value from which they come.
///
/// Gradients are lengths for each length, as floats: the rounding of a value that they lead to is
/// 10⁻⁷ of how much the attribute changes on the way. Components are computed with two or four at a
/// time; those that fill up the last four are 0.
class WedgeRecords {
public:
  /// `squared_weights`: the squares of the lengths that a step of 1 in each component counts as.
  WedgeRecords(const std::vector<double>& squared_weights, Arena* arena)
      : components_(squared_weights.size()), gradients_of_wedge_(12 * fours()),
        values_of_wedge_(components_ + components_ % 2), lengths_(values_of_wedge_),
        weights_(arena), values_(arena), gradients_(arena), boundaries_(arena), origins_(arena),
        identities_(arena), existing_(arena) {
    std::transform(squared_weights.begin(), squared_weights.end(), lengths_.begin(),
                   [](double squared) { return std::sqrt(squared); });
    for (double length : lengths_)
      inverse_lengths_.push_back(length > 0 ? 1 / length : 0);
  }

  std::size_t components() const { return components_; }
  /// Returns how many times four components there are, where the last four may not be complete.
  std::size_t fours() const { return (components_ + 3) / 4; }
  double weight(Index wedge) const { return weights_[wedge]; }
  /// The values of a wedge, an even number of them.
  const double* values(Index wedge) const { return values(wedge, values_of_wedge_); }
  /// Returns them, too; `stride`: the number of values of a wedge, which the caller may know.
  const double* values(Index wedge, std::size_t stride) const {
    return values_.data() + wedge * stride;
  }
  /// Returns the lengths that a step of 1 in each component counts as.
  const double* lengths() const { return lengths_.data(); }
  double value(Index wedge, std::size_t component) const { return values(wedge)[component]; }
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
    values_.resize(origins_.size() * values_of_wedge_);
    gradients_.resize(origins_.size() * gradients_of_wedge_); // set_gradients() fills them
    for (Index w = 0; w < origins_.size(); ++w)
      for (std::size_t c = 0; c < values_of_wedge_; ++c)
        value_of(w, c) = c < components_ && origins_[w] != none ? input.value(origins_[w], c) : 0;
  }
  /// Values that are not of the input.
  void set_values(Index wedge, const std::vector<double>& values) {
    origins_[wedge] = none;
    for (std::size_t c = 0; c < components_; ++c)
      value_of(wedge, c) = values[c];
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
        value_of(wedge, c) = final_value(wedge, c);
  }

  void forget_boundaries() { std::fill(boundaries_.begin(), boundaries_.end(), Matrix2{}); }
  void set_weight(Index wedge, double weight) { weights_[wedge] = weight; }
  /// Sets the gradients of four components, in lengths, two and two: those that there are not are
  /// 0.
  QUADRILLE_ALWAYS_INLINE void set_gradients(Index wedge, std::size_t four,
                                             const Vector<3, Lanes>& low,
                                             const Vector<3, Lanes>& high) {
    for (std::size_t i = 0; i < 3; ++i)
      store_four(gradients_of(wedge, four) + 4 * i, four_floats(low[i], high[i]));
  }

  const Matrix2& boundary(Index wedge) const { return boundaries_[wedge]; }
  /// Returns what the texture coordinates of two wedges disagree about, about the first.
  std::array<AffineMap, 2> texture_difference(Index first, Index second,
                                              const Vector<3>& to_second) const {
    const auto [x, y, z, off] = differences<2>(first, second, to_second, 0);
    std::array<AffineMap, 2> difference;
    for (std::size_t c = 0; c < 2; ++c)
      difference[c] = {inverse_lengths_[c] * in_doubles(x[c], y[c], z[c]),
                       inverse_lengths_[c] * static_cast<double>(off[c])};
    return difference;
  }
  /// Returns what two wedges `to_second` apart disagree about in `count` components of four.
  template <std::size_t count>
  QUADRILLE_ALWAYS_INLINE FourDifferences differences(Index first, Index second,
                                                      const Vector<3>& to_second,
                                                      std::size_t four) const {
    const FourGradients p = gradients(first, four), q = gradients(second, four);
    const auto apart = [&](std::size_t i) QUADRILLE_ALWAYS_INLINE_LAMBDA {
      const std::size_t c = 4 * four + 2 * i;
      return load_two(&lengths_[c]) * (load_two(values(second) + c) - load_two(values(first) + c));
    };
    const FourFloats off = four_floats(apart(0), count > 2 ? apart(1) : Lanes{});
    return {q.x - p.x, q.y - p.y, q.z - p.z, off - q.along(to_second)};
  }
  /// Joins four components of the wedges of two ends without boundaries, `to_second` apart, and
  /// moves them to a target, given from the first. Equal values stay what they are.
  QUADRILLE_ALWAYS_INLINE FourJoined joined(Index first, Index second, const Vector<3>& to_second,
                                            const Vector<3>& target, std::size_t four) const {
    const double sum = weights_[first] + weights_[second];
    const double fraction = sum > 0 ? weights_[second] / sum : 0;
    const auto share = static_cast<float>(fraction);
    const FourGradients p = gradients(first, four), q = gradients(second, four);
    const FourGradients both{p.x + share * (q.x - p.x), p.y + share * (q.y - p.y),
                             p.z + share * (q.z - p.z)};
    const FourFloats back = q.along(to_second), on = both.along(target);
    FourJoined joined{both.x, both.y, both.z, {}};
    const std::array<Lanes, 2> from = values_of_four(first, four),
                               to = values_of_four(second, four);
    const std::array<Lanes, 2> inverse = two_lanes(inverse_lengths_.data(), four);
    for (std::size_t i = 0; i < 2; ++i)
      joined.values[i] = from[i] + fraction * (to[i] - inverse[i] * lanes(back, i) - from[i]) +
                         inverse[i] * lanes(on, i);
    return joined;
  }
  /// Joins those wedges: the result is stored in `kept`, which is one of them.
  void join(Index first, Index second, const Vector<3>& to_second, const Vector<3>& target,
            Index kept, const std::vector<double>& squared_weights) {
    bool is_first = origins_[first] != none, is_second = origins_[second] != none;
    for (std::size_t four = 0; four < fours(); ++four) {
      const FourJoined both = joined(first, second, to_second, target, four);
      is_first = is_first && are_equal(both.values, values_of_four(first, four));
      is_second = is_second && are_equal(both.values, values_of_four(second, four));
      float* const gradients = gradients_of(kept, four);
      store_four(gradients, both.x);
      store_four(gradients + 4, both.y);
      store_four(gradients + 8, both.z);
      double* const values = values_.data() + kept * values_of_wedge_ + 4 * four;
      store_two(values, both.values[0]);
      if (has_upper_two(four))
        store_two(values + 2, both.values[1]);
    }
    weights_[kept] = weights_[first] + weights_[second];
    if (existing_.empty())
      origins_[kept] = is_first ? origins_[first] : is_second ? origins_[second] : none;
    else
      origins_[kept] = closest({origins_[first], origins_[second]}, values(kept), squared_weights);
  }
  void constrain_boundaries() { boundaries_.resize(weights_.size()); }

  WedgeMap map(Index wedge) const {
    WedgeMap map;
    map.weight = weights_[wedge];
    if (!boundaries_.empty())
      map.boundary = boundaries_[wedge];
    for (std::size_t c = 0; c < components_; ++c) {
      const float* const gradient = gradients_of(wedge, c / 4) + c % 4;
      map.maps.push_back({inverse_lengths_[c] * in_doubles(gradient[0], gradient[4], gradient[8]),
                          value(wedge, c)});
    }
    return map;
  }
  void write(Index wedge, const WedgeMap& map) {
    weights_[wedge] = map.weight;
    if (!boundaries_.empty())
      boundaries_[wedge] = map.boundary;
    for (std::size_t c = 0; c < components_; ++c) {
      value_of(wedge, c) = map.maps[c].value;
      for (std::size_t i = 0; i < 3; ++i)
        gradients_of(wedge, c / 4)[4 * i + c % 4] =
            static_cast<float>(lengths_[c] * map.maps[c].gradient[i]);
    }
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
      std::vector<double> values;
      for (const AffineMap& component : map.maps)
        values.push_back(component.value);
      return closest(origins, values.data(), squared_weights);
    }
    const auto is_left = [&](Index wedge) { return has_values_of(wedge, map); };
    const auto found = std::find_if(wedges.begin(), wedges.end(), is_left);
    return found == wedges.end() ? none : origins_[*found];
  }
  /// Leaves out all wedges but those of a list, which get the numbers 0, 1, …
  void pack(const Array<Index>& left) {
    pack<1>(weights_, left, 1);
    pack<2>(values_, left, values_of_wedge_);
    pack<4>(gradients_, left, gradients_of_wedge_);
    pack<1>(boundaries_, left, 1);
    pack<1>(origins_, left, 1);
    pack<1>(identities_, left, 1);
  }

  QUADRILLE_ALWAYS_INLINE void prefetch(Index wedge) const {
    internal::prefetch(&weights_[wedge]);
    internal::prefetch(values(wedge));
    internal::prefetch(gradients_of(wedge, 0));
  }

private:
  struct FourGradients {
    FourFloats x, y, z;

    FourFloats along(const Vector<3>& displacement) const {
      return static_cast<float>(displacement[0]) * x + static_cast<float>(displacement[1]) * y +
             static_cast<float>(displacement[2]) * z;
    }
  };

  const float* gradients_of(Index wedge, std::size_t four) const {
    return gradients_.data() + wedge * gradients_of_wedge_ + 12 * four;
  }
  float* gradients_of(Index wedge, std::size_t four) {
    return gradients_.data() + wedge * gradients_of_wedge_ + 12 * four;
  }
  double& value_of(Index wedge, std::size_t c) { return values_[wedge * values_of_wedge_ + c]; }

  QUADRILLE_ALWAYS_INLINE FourGradients gradients(Index wedge, std::size_t four) const {
    const float* const xyz = gradients_of(wedge, four);
    return {load_four(xyz), load_four(xyz + 4), load_four(xyz + 8)};
  }
  // Have the four components more than two?
  bool has_upper_two(std::size_t four) const { return 4 * four + 2 < values_of_wedge_; }
  QUADRILLE_ALWAYS_INLINE std::array<Lanes, 2> two_lanes(const double* numbers,
                                                         std::size_t four) const {
    return {load_two(numbers + 4 * four),
            has_upper_two(four) ? load_two(numbers + 4 * four + 2) : Lanes{}};
  }
  QUADRILLE_ALWAYS_INLINE std::array<Lanes, 2> values_of_four(Index wedge, std::size_t four) const {
    return two_lanes(values(wedge), four);
  }
  static Lanes lanes(const FourFloats& four, std::size_t i) {
    return Lanes{static_cast<double>(four[2 * i]), static_cast<double>(four[2 * i + 1])};
  }
  static bool are_equal(const std::array<Lanes, 2>& a, const std::array<Lanes, 2>& b) {
    return a[0][0] == b[0][0] && a[0][1] == b[0][1] && a[1][0] == b[1][0] && a[1][1] == b[1][1];
  }

  // Returns the value of the input that is closest to some values. It is used if only existing
  // values are allowed.
  Index closest(const WedgeList& origins, const double* values,
                const std::vector<double>& squared_weights) const {
    const auto distance = [&](Index origin) {
      double sum = 0;
      for (std::size_t c = 0; c < components_; ++c) {
        const double off = existing_[origin * components_ + c] - values[c];
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

  // Each wedge has `size` values, which are copied `step` at a time.
  template <std::size_t step, class Values>
  static void pack(Values& values, const Array<Index>& left, std::size_t size) {
    if (values.empty())
      return;
    Values packed(values.get_allocator());
    packed.resize(left.size() * size);
    auto* to = packed.data();
    for (const Index wedge : left) {
      const auto* const from = values.data() + wedge * size;
      for (std::size_t k = 0; k < size; k += step, to += step)
        std::copy_n(from + k, step, to);
    }
    values = std::move(packed);
  }

  std::size_t components_;
  std::size_t gradients_of_wedge_, values_of_wedge_; // floats, doubles
  std::vector<double> lengths_, inverse_lengths_;    // of an even number of components
  Array<double> weights_;
  UninitializedArray<double> values_;
  UninitializedArray<float> gradients_; // x of four components, then y and z
  Array<Matrix2> boundaries_;           // empty if no chart is constrained
  Array<Index> origins_;
  Array<Index> identities_; // empty if they are not needed
  Array<double> existing_;  // the values of the input, if only these may be
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_ATTRIBUTES_WEDGE_RECORDS_H
