#ifndef QUADRILLE_INTERNAL_CALL_NORMAL_CHOICE_H
#define QUADRILLE_INTERNAL_CALL_NORMAL_CHOICE_H

#include <concepts>

namespace quadrille::internal {

/// Where normals may turn as they like, but for filters.
struct AnyNormals {};

/// Is it NormalDeviation? That has a header of its own.
template <class T>
concept IsNormalLimit = requires(const T limit) {
  { limit.degrees } -> std::convertible_to<double>;
  limit.validate();
  &T::template make_normal_check<3>;
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CALL_NORMAL_CHOICE_H
