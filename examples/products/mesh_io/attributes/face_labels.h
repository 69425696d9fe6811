#ifndef QUADRILLE_EXAMPLES_FACE_LABELS_H
#define QUADRILLE_EXAMPLES_FACE_LABELS_H

#include "../mesh/face_parts.h"
#include "../mesh/indexed_mesh.h"
#include "../mesh/named_numbers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// To which region each face belongs. Regions are what differs by parts, by integers or by colours
/// of faces, as segmentations have them. Where integers are different for more than every second
/// face they are numbers of faces, and more than a few colours are a picture: their borders would
/// hold every vertex. `flags` of MeshLab tell what lies on a border. Other numbers are measured,
/// and tell nothing apart. Whatever it is, each face keeps its own.
class FaceRegions {
public:
  explicit FaceRegions(const IndexedMesh& mesh) : regions_(mesh.triangles.size()) {
    if (!mesh.parts.of_faces.empty()) {
      const std::vector<std::uint32_t> of_components = mesh.parts.regions();
      for (std::size_t face = 0; face < regions_.size(); ++face)
        regions_[face] = of_components[mesh.parts.of_faces[face]];
    }
    std::vector<std::uint32_t> colors(regions_.size());
    for (const NamedNumbers& numbers : mesh.face_numbers)
      if (is_color(numbers.name))
        divide(colors, numbers.values);
      else if (numbers.type.is_integer && numbers.name != "flags")
        is_segmented_ |=
            divide_by(numbers.values, regions_.size() / 2) && numbers.name != "texnumber";
    divide_by(colors, std::min(most_colors, regions_.size() / 2));
  }

  /// The region of each face; empty if there is only one.
  std::vector<std::uint32_t> labels() const {
    const bool is_one = std::all_of(regions_.begin(), regions_.end(),
                                    [&](std::uint32_t region) { return region == regions_[0]; });
    return is_one ? std::vector<std::uint32_t>() : regions_;
  }

  /// Do integers tell regions apart that are no materials, as those of a segmentation?
  bool is_segmented() const { return is_segmented_; }

private:
  static constexpr std::size_t most_colors = 64;

  static bool is_color(std::string_view name) {
    constexpr std::array<std::string_view, 5> names = {"red", "green", "blue", "alpha",
                                                       stl_color_name};
    return std::find(names.begin(), names.end(), name) != names.end();
  }

  /// Divides each region by the values of its faces. Returns how many there are then.
  template <class Value>
  static std::size_t divide(std::vector<std::uint32_t>& regions, const std::vector<Value>& values) {
    std::map<std::pair<std::uint32_t, std::uint64_t>, std::uint32_t> numbers;
    for (std::size_t face = 0; face < regions.size(); ++face) {
      const auto next = static_cast<std::uint32_t>(numbers.size());
      regions[face] =
          numbers.try_emplace({regions[face], key_of(values[face])}, next).first->second;
    }
    return numbers.size();
  }

  /// What is no number has no order by itself.
  static std::uint64_t key_of(double value) { return std::bit_cast<std::uint64_t>(value); }
  static std::uint64_t key_of(std::uint32_t value) { return value; }

  /// The same, unless there are more values than `most`. Are there several, and no more?
  template <class Value>
  bool divide_by(const std::vector<Value>& values, std::size_t most) {
    std::vector<std::uint32_t> alone(regions_.size());
    const std::size_t count = divide(alone, values);
    if (count <= most)
      divide(regions_, values);
    return count > 1 && count <= most;
  }

  std::vector<std::uint32_t> regions_; // of the faces
  bool is_segmented_ = false;
};

/// Gives the faces of a mesh that are left what they had of their own: which ones they were, in
/// ascending order.
inline void take_faces(IndexedMesh& mesh, const std::vector<std::uint32_t>& were) {
  const auto take = [&](auto& values) {
    // A face goes to the front or stays, so nothing is overwritten that is still needed.
    for (std::size_t face = 0; face < mesh.triangles.size() && !values.empty(); ++face)
      values[face] = values[were[face]];
    values.resize(std::min(values.size(), mesh.triangles.size()));
  };
  take(mesh.parts.of_faces);
  for (NamedNumbers& numbers : mesh.face_numbers)
    take(numbers.values);
}

} // namespace quadrille_examples

#endif
