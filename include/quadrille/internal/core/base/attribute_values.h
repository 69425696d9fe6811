#ifndef QUADRILLE_INTERNAL_CORE_BASE_ATTRIBUTE_VALUES_H
#define QUADRILLE_INTERNAL_CORE_BASE_ATTRIBUTE_VALUES_H

#include <quadrille/quadric_form.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/IO/Color.h>
#include <CGAL/Real_embeddable_traits.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <tuple>
#include <type_traits>

/// The values of an attribute map: numbers, or several of them by index.

namespace quadrille::internal {

/// Is a type a number, of C++ or of CGAL, and no character?
template <class T>
inline constexpr bool is_number =
    std::is_arithmetic_v<T> || CGAL::Real_embeddable_traits<T>::Is_real_embeddable::value;
template <class T>
requires std::same_as<T, char> || std::same_as<T, wchar_t> || std::same_as<T, char8_t> ||
    std::same_as<T, char16_t> || std::same_as<T, char32_t>
inline constexpr bool is_number<T> = false;

/// Component i of a value, which is a number itself if it has no [].
template <class V>
decltype(auto) component(V& value, [[maybe_unused]] std::size_t i) {
  if constexpr (requires { typename std::remove_cvref_t<V>::R; })
    return value[static_cast<int>(i)]; // a point or vector of a CGAL kernel
  else if constexpr (requires { value[i]; })
    return value[i];
  else
    return value;
}

template <class V>
using ComponentOf = std::remove_cvref_t<decltype(component(std::declval<V&>(), 0))>;

/// Returns how many components each value of a type has, as far as the type determines it; no limit
/// otherwise.
template <class V>
constexpr std::size_t component_count() {
  if constexpr (is_number<V>)
    return 1;
  else if constexpr (requires { V::Ambient_dimension::value; })
    return V::Ambient_dimension::value; // a point or vector of a CGAL kernel
  else if constexpr (std::same_as<V, CGAL::IO::Color>)
    return 4;
  else if constexpr (std::is_array_v<V>)
    return std::extent_v<V>;
  else if constexpr (requires { std::tuple_size<V>::value; })
    return std::tuple_size<V>::value;
  else if constexpr (requires { std::tuple_size<decltype(V::coordinates)>::value; })
    return std::tuple_size<decltype(V::coordinates)>::value; // a Vector
  else if constexpr (requires {
                       requires V::SizeAtCompileTime >
                       0;
                     })
    return V::SizeAtCompileTime; // of Eigen
  else if constexpr (requires { std::integral_constant<std::size_t, std::size_t(V::size())>(); })
    return V::size(); // of OpenMesh
  else if constexpr (requires { std::integral_constant<std::size_t, std::size_t(V::length())>(); })
    return V::length(); // of GLM
  else
    return (std::numeric_limits<std::size_t>::max)();
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_BASE_ATTRIBUTE_VALUES_H
