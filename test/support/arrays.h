#ifndef QUADRILLE_TEST_ARRAYS_H
#define QUADRILLE_TEST_ARRAYS_H

#include <quadrille/internal/core/memory/array.h>

#include <vector>

namespace test {

/// As the engine wants it.
template <class T>
quadrille::internal::Array<T> array_of(const std::vector<T>& values) {
  return {values.begin(), values.end()};
}

} // namespace test

#endif
