#ifndef QUADRILLE_EXAMPLES_PROGRAM_REGION_H
#define QUADRILLE_EXAMPLES_PROGRAM_REGION_H

/// \file
/// The part of a mesh that is simplified, by the names that its file has for faces.

#include "../mesh_io/mesh/indexed_mesh.h"
#include "../mesh_io/text.h"
#include "target.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace quadrille_examples {

/// The faces that a list of names and of scalars tells, separated by commas: `head,label=3`. A name
/// is that of an object, a group or a material, or of a scalar of faces, which is not 0 then.
class Region {
public:
  Region(const IndexedMesh& mesh, const std::string& list)
      : mesh_(mesh), is_selected_(mesh.triangles.size()) {
    std::istringstream items(list);
    for (std::string item; std::getline(items, item, ',');)
      if (!select_part(item) && !select_scalar(item))
        refuse(item);
  }

  /// Of each face. Throws std::invalid_argument where none is.
  std::vector<bool> faces() const {
    for (const bool is_selected : is_selected_)
      if (is_selected)
        return is_selected_;
    throw std::invalid_argument("no face of IN is in the region");
  }

private:
  const std::string& name(std::uint32_t number) const { return mesh_.parts.names[number]; }

  void select(const auto& is_meant) {
    for (std::size_t face = 0; face < is_selected_.size(); ++face)
      if (is_meant(face))
        is_selected_[face] = true;
  }

  bool select_part(const std::string& wanted) {
    const auto is_of = [&](const FacePart& part) {
      return name(part.object) == wanted || name(part.group) == wanted ||
             name(part.material) == wanted;
    };
    const auto& parts = mesh_.parts;
    if (wanted.empty() || std::none_of(parts.parts.begin(), parts.parts.end(), is_of))
      return false;
    select([&](std::size_t face) { return !parts.of_faces.empty() && is_of(parts.of(face)); });
    return true;
  }

  bool select_scalar(const std::string& item) {
    const std::size_t equals = item.rfind('=');
    std::optional<Amount> value;
    if (equals != std::string::npos && !(value = parse_amount(item.substr(equals + 1))))
      return false;
    for (const NamedNumbers& numbers : mesh_.face_numbers)
      if (numbers.name == item.substr(0, equals)) {
        select([&](std::size_t face) {
          return value ? numbers.values[face] == value->value : numbers.values[face] != 0;
        });
        return true;
      }
    return false;
  }

  [[noreturn]] void refuse(const std::string& item) const {
    std::set<std::string> known;
    for (const FacePart& part : mesh_.parts.parts)
      known.insert({name(part.object), name(part.group), name(part.material)});
    for (const NamedNumbers& numbers : mesh_.face_numbers)
      known.insert(numbers.name);
    known.erase("");
    std::string names;
    for (const std::string& name : known)
      names += (names.empty() ? "; they have " : ", ") + in_quotes(name);
    throw std::invalid_argument(
        "the faces of IN have no " + in_quotes(item) +
        (names.empty() ? "; they have no names at all, but those of OBJ and PLY files can"
                       : names));
  }

  const IndexedMesh& mesh_;
  std::vector<bool> is_selected_;
};

} // namespace quadrille_examples

#endif
