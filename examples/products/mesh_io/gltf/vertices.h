#ifndef QUADRILLE_EXAMPLES_GLTF_VERTICES_H
#define QUADRILLE_EXAMPLES_GLTF_VERTICES_H

#include "accessor.h"
#include "primitive.h"
#include "surface.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace quadrille_examples {

/// The vertices of a primitive as they are stored: one for each combination of a position and
/// attributes that differs from the others, in the order of the faces.
class GltfVertices {
public:
  explicit GltfVertices(const GltfPrimitive& primitive)
      : primitive_(primitive), columns_(primitive.attributes.size()) {}

  void add_face(const GltfSurface& surface, std::size_t face) {
    for (std::size_t i = 0; i < 3; ++i)
      add_corner(surface.corner(face, i));
  }

  /// A face without area, for a primitive that has lost all others and must not be empty.
  void add_nothing() {
    std::vector<Element> elements;
    for (const GltfAttribute& attribute : primitive_.attributes)
      elements.push_back(attribute.elements[0]);
    for (std::size_t i = 0; i < 3; ++i)
      add_corner(elements);
  }

  std::size_t size() const { return numbers_.size(); }
  const std::vector<std::uint32_t>& corners() const { return corners_; }
  /// The values of an attribute, each as long as stride() says.
  const std::string& column(std::size_t attribute) const { return columns_[attribute]; }
  /// glTF asks for elements at multiples of four bytes.
  std::size_t stride(std::size_t attribute) const { return (type(attribute).size() + 3) / 4 * 4; }

private:
  const ElementType& type(std::size_t attribute) const {
    return primitive_.attributes[attribute].written;
  }

  void add_corner(const std::vector<Element>& elements) {
    std::string vertex;
    for (std::size_t a = 0; a < elements.size(); ++a) {
      const std::size_t end = vertex.size() + stride(a);
      for (std::size_t c = 0; c < type(a).components; ++c)
        type(a).append(type(a).stored(elements[a][c]), vertex);
      vertex.resize(end, '\0');
    }
    const auto next = static_cast<std::uint32_t>(numbers_.size());
    const auto [place, is_new] = numbers_.try_emplace(vertex, next);
    corners_.push_back(place->second);
    std::size_t at = 0;
    for (std::size_t a = 0; a < elements.size() && is_new; at += stride(a), ++a)
      columns_[a] += vertex.substr(at, stride(a));
  }

  const GltfPrimitive& primitive_;
  std::vector<std::string> columns_;
  std::unordered_map<std::string, std::uint32_t> numbers_; // of vertices, by what is stored
  std::vector<std::uint32_t> corners_;
};

} // namespace quadrille_examples

#endif
