#ifndef QUADRILLE_EXAMPLES_MESH_IO_PLY_COLUMNS_H
#define QUADRILLE_EXAMPLES_MESH_IO_PLY_COLUMNS_H

#include "../mesh/named_numbers.h"

#include <quadrille/internal/file/ply_header.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace quadrille_examples {

using quadrille::internal::PlyElement;
using quadrille::internal::PlyProperty;

/// Where the scalar properties of an element stand in a row of numbers: first those that a reader
/// knows, in its order, then the others in that of the file.
class PlyColumns {
public:
  using Names = std::initializer_list<std::string_view>;

  PlyColumns(const PlyElement& element, std::size_t known)
      : element_(element), known_(known), columns_(element.properties.size()) {}

  static bool is_one_of(const std::string& name, Names names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  }

  /// Gives the columns from `first` on to properties, each of which has one of some names. False,
  /// and none is given, if one of them is missing or a list.
  bool assign(std::size_t first, std::initializer_list<Names> names) {
    std::vector<std::size_t> properties;
    for (const Names& aliases : names) {
      const std::optional<std::size_t> place = element_.find(aliases);
      if (!place || element_.properties[*place].is_list())
        return false;
      properties.push_back(*place);
    }
    for (const std::size_t property : properties)
      columns_[property] = first++;
    return true;
  }

  /// Gives a column to each of the other scalar properties, but for those of names that are taken.
  /// Returns what these columns hold, without its values.
  template <class IsTaken>
  std::vector<NamedNumbers> assign_others(IsTaken is_taken) {
    std::vector<NamedNumbers> numbers;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const PlyProperty& property = element_.properties[i];
      if (columns_[i] || property.is_list() || is_taken(property.name))
        continue;
      columns_[i] = known_ + numbers.size();
      numbers.push_back({property.name, property.type, {}});
    }
    return numbers;
  }

  /// The column of a property, if it has any.
  const std::optional<std::size_t>& of(std::size_t property) const { return columns_[property]; }

private:
  const PlyElement& element_;
  std::size_t known_;
  std::vector<std::optional<std::size_t>> columns_; // of the properties
};

} // namespace quadrille_examples

#endif
