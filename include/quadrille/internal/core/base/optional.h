#ifndef QUADRILLE_INTERNAL_CORE_BASE_OPTIONAL_H
#define QUADRILLE_INTERNAL_CORE_BASE_OPTIONAL_H

#include <concepts>
#include <optional>
#include <type_traits>

/// Policies and maps that may be a std::optional: whether they are given is known at run time.

namespace quadrille::internal {

template <class T>
struct ContainedIn : std::type_identity<T> {};
template <class T>
struct ContainedIn<std::optional<T>> : std::type_identity<T> {};

/// The value type of a std::optional; any other type is left as it is.
template <class T>
using Contained = typename ContainedIn<std::remove_cvref_t<T>>::type;

template <class T>
concept IsOptional = !std::same_as<Contained<T>, std::remove_cvref_t<T>>;

/// Calls use(value), unless the value is an empty std::optional.
template <class T, class Use>
void if_given(const T& value, Use use) {
  if constexpr (!IsOptional<T>)
    use(value);
  else if (value)
    use(*value);
}

/// Returns use(value), or use(Default{}) for an empty std::optional.
template <class Default, class T, class Use>
auto use_or_default(const T& value, Use use) {
  if constexpr (!IsOptional<T>)
    return use(value);
  else
    return value ? use(*value) : use(Default{});
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_BASE_OPTIONAL_H
