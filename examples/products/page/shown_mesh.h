#ifndef QUADRILLE_EXAMPLES_PAGE_SHOWN_MESH_H
#define QUADRILLE_EXAMPLES_PAGE_SHOWN_MESH_H

#include "../mesh_io/linear_light.h"
#include "../mesh_io/mesh/indexed_mesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace quadrille_examples {

/// What a page shows upon faces.
struct PageMaterial {
  std::array<double, 3> color = {1, 1, 1}; ///< linear, from 0 to 1
  std::optional<std::size_t> image = {};   ///< of PageMaterials::images, times the colour
  double cutoff = 0;                       ///< parts of the image of less opacity are not there

  friend bool operator==(const PageMaterial&, const PageMaterial&) = default;
};

struct PageMaterials {
  std::vector<PageMaterial> materials = {PageMaterial{}};
  std::vector<std::uint32_t> of_faces; ///< of the input, or empty: all have the first
  std::vector<std::string> images;     ///< data URIs
  std::vector<std::string> notes;      ///< what is not shown

  bool has_images() const {
    return std::any_of(materials.begin(), materials.end(),
                       [](const PageMaterial& material) { return material.image.has_value(); });
  }
};

/// A mesh with what it looks like.
struct ShownMesh {
  IndexedMesh mesh;
  PageMaterials looks;
  bool has_linear_colors = false; ///< as glTF has them; else sRGB
};

} // namespace quadrille_examples

#endif
