#ifndef QUADRILLE_INTERNAL_CORE_BASE_JOINED_VECTOR_H
#define QUADRILLE_INTERNAL_CORE_BASE_JOINED_VECTOR_H

#include <quadrille/quadric_form.h>

#include <algorithm>
#include <cstddef>

namespace quadrille::internal {

/// A position and its attributes as one point, and the attributes of such a point.
template <std::size_t N>
Vector<3 + N> join(const Vector<3>& position, const Vector<N>& attributes) {
  Vector<3 + N> joined;
  std::copy(position.coordinates.begin(), position.coordinates.end(), joined.coordinates.begin());
  std::copy(attributes.coordinates.begin(), attributes.coordinates.end(),
            joined.coordinates.begin() + 3);
  return joined;
}

template <std::size_t D>
Vector<D - 3> attributes_of(const Vector<D>& joined) {
  Vector<D - 3> attributes;
  std::copy(joined.coordinates.begin() + 3, joined.coordinates.end(),
            attributes.coordinates.begin());
  return attributes;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_BASE_JOINED_VECTOR_H
