#ifndef QUADRILLE_EXAMPLES_GLTF_TANGENTS_H
#define QUADRILLE_EXAMPLES_GLTF_TANGENTS_H

#include "accessor.h"
#include "primitive.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// Makes tangents perpendicular to normals where these are new. What a vertex of the input had
/// stays as it was.
class GltfTangents {
public:
  GltfTangents() = default;
  explicit GltfTangents(const std::vector<GltfPrimitive>& primitives) {
    for (const GltfPrimitive& primitive : primitives) {
      Frames frames;
      for (const AttributeKind kind : {AttributeKind::normal, AttributeKind::tangent})
        for (std::size_t a = 0; a < primitive.attributes.size(); ++a)
          if (primitive.attributes[a].kind == kind && !primitive.attributes[a].target)
            (kind == AttributeKind::normal ? frames.normal : frames.tangent) = a;
      if (frames.normal && frames.tangent)
        for (std::size_t v = 0; v < primitive.attributes.front().elements.size(); ++v)
          frames.known.insert(pair_of(primitive.attributes[*frames.normal].elements[v],
                                      primitive.attributes[*frames.tangent].elements[v]));
      frames_.push_back(std::move(frames));
    }
  }

  /// Of the elements of a corner of a primitive.
  void square(std::size_t primitive, const std::vector<GltfAttribute>& attributes,
              std::vector<Element>& elements) const {
    const Frames& frames = frames_[primitive];
    if (!frames.normal || !frames.tangent)
      return;
    const Element& normal = elements[*frames.normal];
    Element& tangent = elements[*frames.tangent];
    if (!frames.known.contains(pair_of(stored(attributes[*frames.normal], normal),
                                       stored(attributes[*frames.tangent], tangent))))
      make_perpendicular(tangent, normal);
  }

private:
  using Pair = std::array<double, 6>;

  /// What a primitive has of both, if it has.
  struct Frames {
    std::optional<std::size_t> normal, tangent; ///< numbers of attributes
    std::set<Pair> known;
  };

  static Pair pair_of(const Element& normal, const Element& tangent) {
    return {normal[0], normal[1], normal[2], tangent[0], tangent[1], tangent[2]};
  }

  /// As it is when it has been written and read again.
  static Element stored(const GltfAttribute& attribute, Element element) {
    const ElementType& type = attribute.elements.type();
    for (std::size_t c = 0; c < type.components; ++c)
      element[c] = type.meaning(type.stored(element[c]));
    return element;
  }

  static void make_perpendicular(Element& tangent, const Element& normal) {
    const auto dot = [](const Element& a, const Element& b) {
      return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    };
    const double square = dot(normal, normal);
    if (!(square > 0))
      return;
    const auto project = [&](Element direction) {
      const double along = dot(direction, normal) / square;
      for (std::size_t c = 0; c < 3; ++c)
        direction[c] -= along * normal[c];
      return direction;
    };
    Element result = project(tangent);
    if (!(dot(result, result) > 1e-6 * dot(tangent, tangent))) { // they were one direction
      std::size_t least = 0;
      for (std::size_t c = 1; c < 3; ++c)
        if (std::abs(normal[c]) < std::abs(normal[least]))
          least = c;
      Element axis{};
      axis[least] = 1;
      result = project(axis);
    }
    const double length = std::sqrt(dot(result, result));
    for (std::size_t c = 0; c < 3; ++c)
      tangent[c] = result[c] / length;
  }

  std::vector<Frames> frames_; // of the primitives
};

} // namespace quadrille_examples

#endif
