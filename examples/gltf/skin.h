#ifndef QUADRILLE_EXAMPLES_GLTF_SKIN_H
#define QUADRILLE_EXAMPLES_GLTF_SKIN_H

#include "../nearest_vertices.h"
#include "primitive.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// The joints and weights of a mesh's points. There is nothing between two joints, so a point that
/// is left has those of the nearest of the vertices that have become it.
class GltfSkin {
public:
  /// Throws if a value cannot go from one primitive to another one as it is stored.
  static void require_one_kind(const std::vector<GltfPrimitive>& primitives) {
    for (const GltfPrimitive& primitive : primitives)
      if (types(primitive) != types(primitives.front()))
        throw std::runtime_error("the primitives of a mesh differ in what joints and weights they "
                                 "have, or in their types");
  }

  /// Takes a vertex of a primitive in. Of several ones at a point the first tells, lest the surface
  /// tear where it moves.
  void add(std::uint32_t point, const GltfPrimitive& primitive, std::size_t number,
           std::size_t vertex) {
    if (point == sources_.size() && !types(primitive).empty())
      sources_.push_back({number, vertex});
  }

  /// The points that are left have those of the nearest vertices.
  template <class Point>
  void follow(const std::vector<Point>& before, const std::vector<std::size_t>& images,
              const std::vector<Point>& left) {
    if (sources_.empty())
      return;
    std::vector<Source> sources;
    for (const std::uint32_t v : nearest_vertices(before, images, left))
      sources.push_back(sources_[v]);
    sources_ = std::move(sources);
  }

  Element value(const std::vector<GltfPrimitive>& primitives, const std::string& name,
                std::uint32_t point) const {
    const auto& [primitive, vertex] = sources_[point];
    for (const GltfAttribute& attribute : primitives[primitive].attributes)
      if (attribute.kind == AttributeKind::skin && attribute.name == name)
        return attribute.elements[vertex];
    return {};
  }

private:
  struct Source {
    std::size_t primitive, vertex;
  };

  /// The component types of joints and weights by their names.
  static std::map<std::string, std::size_t> types(const GltfPrimitive& primitive) {
    std::map<std::string, std::size_t> types;
    for (const GltfAttribute& attribute : primitive.attributes)
      if (attribute.kind == AttributeKind::skin)
        types[attribute.name] = attribute.elements.type().component.code;
    return types;
  }

  std::vector<Source> sources_; // of each point; none without joints
};

} // namespace quadrille_examples

#endif
