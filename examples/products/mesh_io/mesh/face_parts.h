#ifndef QUADRILLE_EXAMPLES_MESH_IO_FACE_PARTS_H
#define QUADRILLE_EXAMPLES_MESH_IO_FACE_PARTS_H

/// \file
/// To what the faces of a file belong (objects, groups, materials of OBJ), and what their corners
/// have.

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// What is said of a face, as numbers of names, and what its corners have.
struct FacePart {
  std::uint32_t object = 0, group = 0, material = 0, smoothing = 0;
  bool has_textures = false;
  bool has_normals = false;

  friend auto operator<=>(const FacePart&, const FacePart&) = default;
};

/// All parts, and that of each face.
struct FaceParts {
  std::vector<std::string> libraries;    ///< of materials: what the file says behind `mtllib`
  std::vector<std::string> names = {""}; ///< the first is that of what has none
  std::vector<FacePart> parts;
  std::vector<std::uint32_t> of_faces; ///< a number of a part; empty, or one for each face

  /// Does any part have what `member` says?
  template <class Value>
  bool has(Value FacePart::*member) const {
    return std::any_of(parts.begin(), parts.end(),
                       [&](const FacePart& part) { return part.*member != Value{}; });
  }

  /// Do any two differ?
  bool differ() const {
    return std::any_of(parts.begin(), parts.end(),
                       [&](const FacePart& part) { return part != parts.front(); });
  }

  const FacePart& of(std::size_t face) const { return parts[of_faces[face]]; }

  /// The region of each part. Parts that differ by smoothing groups only are one region: what has
  /// normals needs none, and many programs number them at will.
  std::vector<std::uint32_t> regions() const {
    std::map<FacePart, std::uint32_t> numbers;
    std::vector<std::uint32_t> result;
    for (FacePart part : parts) {
      part.smoothing = 0;
      const auto next = static_cast<std::uint32_t>(numbers.size());
      result.push_back(numbers.try_emplace(part, next).first->second);
    }
    return result;
  }

  /// Leaves of each part what its corners have.
  void forget_names() {
    libraries.clear();
    for (FacePart& part : parts)
      part = {.has_textures = part.has_textures, .has_normals = part.has_normals};
  }
};

/// Gives names and parts their numbers, while a file is read.
class PartNumbers {
public:
  std::uint32_t name(std::string_view name) {
    const auto next = static_cast<std::uint32_t>(result_.names.size());
    const auto [place, is_new] = names_.try_emplace(std::string(name), next);
    if (is_new)
      result_.names.emplace_back(name);
    return place->second;
  }

  void add_library(std::string_view name) {
    if (std::find(result_.libraries.begin(), result_.libraries.end(), name) ==
        result_.libraries.end())
      result_.libraries.emplace_back(name);
  }

  /// The next face belongs to `part`.
  void add_face(const FacePart& part) {
    if (result_.of_faces.empty() || part != result_.parts[result_.of_faces.back()])
      last_ = number(part);
    result_.of_faces.push_back(last_);
  }

  FaceParts take() { return std::move(result_); }

private:
  std::uint32_t number(const FacePart& part) {
    const auto next = static_cast<std::uint32_t>(result_.parts.size());
    const auto [place, is_new] = parts_.try_emplace(part, next);
    if (is_new)
      result_.parts.push_back(part);
    return place->second;
  }

  FaceParts result_;
  std::map<std::string, std::uint32_t> names_ = {{"", 0}};
  std::map<FacePart, std::uint32_t> parts_;
  std::uint32_t last_ = 0; // of the face added last
};

} // namespace quadrille_examples

#endif
