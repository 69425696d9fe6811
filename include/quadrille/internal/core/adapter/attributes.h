#ifndef QUADRILLE_INTERNAL_CORE_ADAPTER_ATTRIBUTES_H
#define QUADRILLE_INTERNAL_CORE_ADAPTER_ATTRIBUTES_H

#include <quadrille/channel_options.h>
#include <quadrille/internal/core/base/attribute_values.h>
#include <quadrille/internal/core/base/joined_vector.h>
#include <quadrille/internal/core/base/points.h>
#include <quadrille/quadric_form.h>

#include <CGAL/number_utils.h>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace quadrille::internal {

/// Attributes of the vertices, for a cost that looks at positions only.
struct NoAttributes {
  static constexpr std::size_t size = 0;
};

/// N attributes of the vertices, in a property map of the user's: its values are indexed with []
/// (colours, arrays, points and vectors) or, for N = 1, numbers.
template <class Map, std::size_t N, Attribute A>
class AttributeMap {
public:
  static_assert(
      requires { typename boost::property_traits<Map>::value_type; },
      "quadrille: attributes are passed as a property map; for a vector, pass "
      "CGAL::make_property_map(vector)");
  static constexpr std::size_t size = N;
  using Value = typename boost::property_traits<Map>::value_type;
  static_assert(
      is_number<ComponentOf<Value>>,
      "quadrille: the values of an attribute map have to be numbers, or have numbers by [].");
  static_assert(component_count<Value>() >= N,
                "quadrille: the values of this attribute map have fewer components than the cost "
                "reads: choose an AttributeQuadric<N> that fits them.");

  explicit AttributeMap(Map map) : map_(map) {}

  template <class Key>
  Vector<N> read(const Key& key) const {
    return components(get(map_, key));
  }
  static Vector<N> components(const Value& value) {
    Vector<N> attributes;
    require_components(value);
    for (std::size_t i = 0; i < N; ++i)
      attributes[i] = to_double(component(value, i));
    return attributes;
  }

  /// Colours and texture coordinates will stay in the range of those that faces use, colours in
  /// [0, 1] where these lie there.
  template <class Surface>
  void limit([[maybe_unused]] const Surface& surface) {
    if constexpr (A == Attribute::color || A == Attribute::texture) {
      const auto box = surface.box();
      limit_to(attributes_of(box.low), attributes_of(box.high));
    }
  }
  void limit_to(const Vector<N>& lowest, const Vector<N>& highest) {
    if constexpr (A == Attribute::color || A == Attribute::texture) {
      low_ = lowest;
      high_ = highest;
    }
    if constexpr (A == Attribute::color) {
      const auto &low = low_.coordinates, &high = high_.coordinates;
      if (*std::min_element(low.begin(), low.end()) >= 0 &&
          *std::max_element(high.begin(), high.end()) <= 1) {
        low_.coordinates.fill(0);
        high_.coordinates.fill(1);
      }
    }
  }

  /// Attributes in the range of their type: colours and texture coordinates stay in their limits, a
  /// normal gets length 1.
  template <class Key>
  void write(const Key& key, const Vector<N>& attributes) {
    put(map_, key, changed(get(map_, key), attributes));
  }
  Value changed(const Value& old, const Vector<N>& attributes) const {
    const std::optional<Vector<N>> inside = in_range(attributes);
    return inside ? value(old, *inside) : old;
  }
  /// Nothing where opposite normals have met, so that the old one is left.
  std::optional<Vector<N>> in_range(Vector<N> attributes) const {
    if constexpr (A == Attribute::color || A == Attribute::texture)
      for (std::size_t i = 0; i < N; ++i)
        attributes[i] = std::clamp(attributes[i], low_[i], high_[i]);
    if constexpr (A == Attribute::normal) {
      const double squared = squared_length(attributes);
      if (!(squared > 0))
        return std::nullopt;
      attributes *= 1 / std::sqrt(squared);
    }
    return attributes;
  }

  Value raw(const auto& key) const { return get(map_, key); }
  void put_raw(const auto& key, const Value& value) { put(map_, key, value); }

  /// With what else an old value has.
  static Value value(Value old, const Vector<N>& attributes) {
    if constexpr (std::is_arithmetic_v<Value>) {
      return rounded<Value>(attributes[0]);
    } else if constexpr (std::is_assignable_v<decltype(component(old, 0)), double>) {
      using T = std::remove_cvref_t<decltype(component(old, 0))>;
      for (std::size_t i = 0; i < N; ++i)
        component(old, i) = rounded<T>(attributes[i]);
      return old;
    } else {
      return [&]<std::size_t... I>(std::index_sequence<I...>) {
        return Value(attributes[I]...);
      }
      (std::make_index_sequence<N>{});
    }
  }

private:
  // Checks the components of a value whose type does not determine their number.
  static void require_components([[maybe_unused]] const Value& value) {
    if constexpr (component_count<Value>() == (std::numeric_limits<std::size_t>::max)() &&
                  requires { static_cast<std::size_t>(value.size()); })
      if (static_cast<std::size_t>(value.size()) < N)
        throw std::invalid_argument("quadrille::simplify: the attributes of a vertex have " +
                                    std::to_string(value.size()) + " components of " +
                                    std::to_string(N) + " that the cost reads");
  }

  template <class T>
  static double to_double(const T& x) {
    if constexpr (std::is_arithmetic_v<T>)
      return static_cast<double>(x);
    else
      return CGAL::to_double(x);
  }

  template <class T>
  static T rounded(double x) {
    if constexpr (std::integral<T>) {
      using Limits = std::numeric_limits<T>; // as a double max() of 64 bits is one too many
      const double whole = std::round(x);
      if (!(whole > static_cast<double>((Limits::min)())))
        return (Limits::min)();
      if (whole >= static_cast<double>((Limits::max)()))
        return (Limits::max)();
      return static_cast<T>(whole);
    } else {
      return to_number<T>(x);
    }
  }

  Map map_;
  Vector<N> low_, high_;
};

template <class Attributes>
struct AttributeValueOf {
  using type = typename Attributes::Value;
};
template <>
struct AttributeValueOf<NoAttributes> {
  using type = NoAttributes;
};
template <class Attributes>
using AttributeValue = typename AttributeValueOf<Attributes>::type;

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ADAPTER_ATTRIBUTES_H
