#ifndef QUADRILLE_INTERNAL_CORE_ADAPTER_LABEL_NUMBERS_H
#define QUADRILLE_INTERNAL_CORE_ADAPTER_LABEL_NUMBERS_H

#include <quadrille/internal/core/base/index.h>
#include <quadrille/internal/core/base/optional.h>
#include <quadrille/internal/core/memory/array.h>

#include <boost/property_map/property_map.hpp>

#include <map>

namespace quadrille::internal {

/// The label of each face of a range as a number, 0, 1, … in the order in which labels are met.
template <class Map, class Faces>
Array<Index> numbers_of_labels(Map map, const Faces& faces, Arena& arena) {
  std::map<typename boost::property_traits<Map>::value_type, Index> number_of;
  Array<Index> numbers(&arena);
  for (const auto& face : faces)
    numbers.push_back(
        number_of.try_emplace(get(map, face), static_cast<Index>(number_of.size())).first->second);
  return numbers;
}

/// Reads the labels of faces, if there are any. They are in the order of the input.
template <class Carried, class Faces, class Input>
void read_labels([[maybe_unused]] const Carried& carried, [[maybe_unused]] const Faces& faces,
                 [[maybe_unused]] Input& input, [[maybe_unused]] Arena& arena) {
  if constexpr (Carried::has_labels)
    if_given(carried.labels, [&](const auto& labels) {
      input.labels = numbers_of_labels(labels.map, faces, arena);
    });
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_ADAPTER_LABEL_NUMBERS_H
