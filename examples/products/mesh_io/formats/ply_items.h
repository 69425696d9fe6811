#ifndef QUADRILLE_EXAMPLES_MESH_IO_PLY_ITEMS_H
#define QUADRILLE_EXAMPLES_MESH_IO_PLY_ITEMS_H

#include "../mesh/named_numbers.h"
#include "ply_columns.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace quadrille_examples {

/// Reads the items of an element, one after the other, from the values of a file.
template <class Values>
class PlyItems {
public:
  explicit PlyItems(Values& values) : values_(values) {}

  /// Goes to an element, of which `size` scalars have a column.
  void begin(const PlyElement& element, std::size_t size) {
    row_.assign(size, 0);
    lists_.assign(element.properties.size(), {});
  }

  /// Reads the scalars that have a column to the row, and the lists.
  void read(const PlyElement& element, std::uint64_t item, const PlyColumns& columns) {
    values_.begin_item(element, item);
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (property.is_list())
        read_list(property, lists_[i]);
      else if (const double value = values_.next(property.type); columns.of(i))
        row_[*columns.of(i)] = value;
    }
    values_.end_item();
  }

  /// The scalars of the item, by their columns.
  std::vector<double>& row() { return row_; }
  /// A list of the item, by the place of its property.
  const std::vector<double>& list(std::size_t property) const { return lists_[property]; }

  /// Appends the scalars of the columns from `first` on.
  void append_to(std::vector<NamedNumbers>& numbers, std::size_t first) const {
    for (NamedNumbers& column : numbers)
      column.values.push_back(row_[first++]);
  }

private:
  /// Grows with the values that are there, not by the count that is claimed.
  void read_list(const PlyProperty& property, std::vector<double>& list) {
    const double count = values_.next(*property.count_type);
    if (count < 0)
      values_.fail("a list of " + std::to_string(static_cast<std::int64_t>(count)) + " values");
    list.clear();
    while (static_cast<double>(list.size()) < count)
      list.push_back(values_.next(property.type));
  }

  Values& values_;
  std::vector<double> row_;
  std::vector<std::vector<double>> lists_;
};

} // namespace quadrille_examples

#endif
