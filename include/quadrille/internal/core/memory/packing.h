#ifndef QUADRILLE_INTERNAL_CORE_MEMORY_PACKING_H
#define QUADRILLE_INTERNAL_CORE_MEMORY_PACKING_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/memory/array.h>

#include <algorithm>
#include <cstddef>

namespace quadrille::internal {

/// Returns the indices of the values that satisfy condition(value).
template <class Values, class Condition>
Array<Index> indices_of(const Values& values, Condition condition) {
  const auto count =
      static_cast<std::size_t>(std::count_if(values.begin(), values.end(), condition));
  Array<Index> indices(count + 1, values.get_allocator());
  std::size_t found = 0;
  for (std::size_t i = 0; i < values.size();
       ++i) { // without a branch, which would be hard to predict
    indices[found] = static_cast<Index>(i);
    found += condition(values[i]);
  }
  indices.pop_back();
  return indices;
}

/// Moves the values of numbers that satisfy is_left(number) to the front. No memory is released.
template <class Values, class IsLeft>
void pack_if(Values& values, IsLeft is_left) {
  std::size_t left = 0;
  for (std::size_t i = 0; i < values.size();
       ++i) { // without a branch, which would be hard to predict
    values[left] = values[i];
    left += is_left(static_cast<Index>(i));
  }
  values.resize(left);
}

/// Moves the values of what is left (ascending indices) to the front. No memory is given back.
template <class Values>
void pack(Values& values, const Array<Index>& left) {
  if (values.empty())
    return;
  for (std::size_t i = 0; i < left.size(); ++i)
    values[i] = values[left[i]];
  values.resize(left.size());
}

/// Returns the place in a list of each number below `count`; `none` for numbers that are not in it.
inline Array<Index> places(const Array<Index>& numbers, std::size_t count) {
  Array<Index> places(count, none, numbers.get_allocator());
  for (Index i = 0; i < numbers.size(); ++i)
    places[numbers[i]] = i;
  return places;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_MEMORY_PACKING_H
