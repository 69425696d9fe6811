#ifndef QUADRILLE_INTERNAL_PACKING_H
#define QUADRILLE_INTERNAL_PACKING_H

#include <quadrille/internal/index.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace quadrille::internal {

/// Where values are of which condition(value) holds.
template <class Values, class Condition>
std::vector<Index> indices_of(const Values& values, Condition condition) {
  const auto count =
      static_cast<std::size_t>(std::count_if(values.begin(), values.end(), condition));
  std::vector<Index> indices(count + 1);
  std::size_t found = 0;
  for (std::size_t i = 0; i < values.size(); ++i) { // without a branch: it is hard to guess
    indices[found] = static_cast<Index>(i);
    found += condition(values[i]);
  }
  indices.pop_back();
  return indices;
}

/// Moves the values of what is left (ascending indices) to the front. No memory is given back.
template <class Values>
void pack(Values& values, const std::vector<Index>& left) {
  if (values.empty())
    return;
  for (std::size_t i = 0; i < left.size(); ++i)
    values[i] = values[left[i]];
  values.resize(left.size());
}

/// Moves them back. The values of what is not left are any.
template <class Values>
void unpack(Values& values, const std::vector<Index>& left, std::size_t size) {
  if (values.empty())
    return;
  values.resize(size);
  for (std::size_t i = left.size(); i-- > 0;)
    values[left[i]] = values[i];
}

/// The same, with a value for these.
template <class Values>
void unpack(Values& values, const std::vector<Index>& left, std::size_t size,
            const typename Values::value_type& other) {
  unpack(values, left, size);
  for (std::size_t i = 0, next = 0; i < size; ++i)
    if (next < left.size() && left[next] == i)
      ++next;
    else
      values[i] = other;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_PACKING_H
