#ifndef QUADRILLE_EXAMPLES_GLTF_PLACEMENT_H
#define QUADRILLE_EXAMPLES_GLTF_PLACEMENT_H

#include "accessor.h"
#include "document.h"
#include "json.h"
#include "skeleton.h"
#include "transform.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// Where a mesh is in the scene.
struct GltfPlacement {
  std::vector<Transform> instances; ///< all places at which nodes show it; none if none does
  /// That of the largest instance, by which errors of the mesh are lengths in the scene. It can be
  /// inverted.
  Transform largest, inverse;
  std::optional<GltfSkeleton> skeleton; ///< that moves it

  bool is_single() const { return instances.size() == 1 && instances.front() == largest; }
  bool is_mirrored() const { return largest.determinant() < 0; }
};

/// Finds the places of meshes: through their nodes and all that are above these, or, of meshes with
/// a skin, whose nodes do not count, through the joints as they are at rest.
class GltfPlacements {
public:
  /// Those of all meshes, by their numbers.
  static std::vector<GltfPlacement> of(const GltfDocument& document) {
    const GltfPlacements nodes(document);
    std::vector<GltfPlacement> placements(size_of(document.json, "meshes"));
    for (std::size_t i = 0; i < nodes.worlds_.size(); ++i) {
      const Json& node = element_of(document.json, "nodes", i);
      if (member(node, "mesh"))
        nodes.add(i, placements.at(require_below(count_of(node, "mesh"), placements.size())));
    }
    for (GltfPlacement& placement : placements)
      choose_largest(placement);
    return placements;
  }

  /// A mesh is also where another one is.
  static void add(const GltfPlacement& from, GltfPlacement& to) {
    to.instances.insert(to.instances.end(), from.instances.begin(), from.instances.end());
    if (!to.skeleton)
      to.skeleton = from.skeleton;
    to.largest = to.inverse = Transform();
    choose_largest(to);
  }

private:
  explicit GltfPlacements(const GltfDocument& document)
      : document_(document), parents_(size_of(document.json, "nodes"), none) {
    for (std::size_t i = 0; i < parents_.size(); ++i)
      if (const Json& node = element_of(document.json, "nodes", i); size_of(node, "children") > 0)
        for (const Json& child : *member(node, "children"))
          parents_[require_below(index_of(child), parents_.size())] = i;
    std::vector<bool> is_known(parents_.size());
    worlds_.resize(parents_.size());
    for (std::size_t i = 0; i < parents_.size(); ++i)
      find_world(i, is_known);
  }

  static std::size_t index_of(const Json& number) {
    if (!number.is_number_integer() || number < 0)
      throw std::runtime_error("a node has a value that is not a number");
    return number.get<std::size_t>();
  }
  static std::size_t require_below(std::size_t index, std::size_t count) {
    if (index >= count)
      throw std::runtime_error("a node refers to an element that does not exist");
    return index;
  }

  /// The way up to a node whose place is known, and down again.
  void find_world(std::size_t node, std::vector<bool>& is_known) {
    std::vector<std::size_t> way;
    for (std::size_t i = node; i != none && !is_known[i]; i = parents_[i]) {
      way.push_back(i);
      if (way.size() > parents_.size())
        throw std::runtime_error("its nodes are children of each other");
    }
    for (; !way.empty(); way.pop_back()) {
      const std::size_t i = way.back();
      worlds_[i] = transform_of_node(element_of(document_.json, "nodes", i));
      if (parents_[i] != none)
        worlds_[i] = worlds_[parents_[i]] * worlds_[i];
      is_known[i] = true;
    }
  }

  void add(std::size_t number, GltfPlacement& placement) const {
    const Json& node = element_of(document_.json, "nodes", number);
    if (member(node, "skin")) {
      const GltfSkeleton skeleton(document_, count_of(node, "skin"), parents_);
      placement.instances.push_back(skeleton.place(worlds_));
      if (!placement.skeleton)
        placement.skeleton = skeleton;
      return;
    }
    for (const Transform& instance : instances_of(node))
      placement.instances.push_back(worlds_[number] * instance);
  }

  /// Those that EXT_mesh_gpu_instancing says below a node; else the node itself.
  std::vector<Transform> instances_of(const Json& node) const {
    const Json* const extensions = member(node, "extensions");
    const Json* const instancing =
        extensions ? member(*extensions, "EXT_mesh_gpu_instancing") : nullptr;
    const Json* const attributes = instancing ? member(*instancing, "attributes") : nullptr;
    if (!attributes)
      return {Transform()};
    const auto read = [&](const char* name) {
      return member(*attributes, name)
                 ? std::optional(Elements(document_, count_of(*attributes, name)))
                 : std::nullopt;
    };
    const auto translations = read("TRANSLATION"), rotations = read("ROTATION"),
               scales = read("SCALE");
    std::vector<Transform> instances;
    for (const auto* const elements : {&translations, &rotations, &scales})
      if (*elements)
        instances.resize(std::max(instances.size(), (*elements)->size()));
    for (std::size_t i = 0; i < instances.size(); ++i) {
      const auto at = [&](const std::optional<Elements>& elements, const Element& otherwise) {
        return elements && i < elements->size() ? (*elements)[i] : otherwise;
      };
      const Element move = at(translations, {}), scale = at(scales, {1, 1, 1});
      instances[i] = Transform::of_components(
          {move[0], move[1], move[2]}, at(rotations, {0, 0, 0, 1}), {scale[0], scale[1], scale[2]});
    }
    return instances;
  }

  /// A mesh that is shown flat or as a point (and grows, perhaps) keeps its shape, at the size that
  /// it has there, if any.
  static void choose_largest(GltfPlacement& placement) {
    double largest = 0;
    std::optional<Transform> inverse;
    for (const Transform& instance : placement.instances)
      if (const auto found = instance.inverse(); found && instance.stretch() > largest) {
        placement.largest = instance;
        inverse = found;
        largest = instance.stretch();
      }
    if (!inverse) {
      for (const Transform& instance : placement.instances)
        largest = std::max(largest, instance.stretch());
      if (largest > 0)
        placement.largest = Transform::uniform(largest);
      inverse = placement.largest.inverse();
    }
    placement.inverse = inverse.value_or(Transform());
  }

  static constexpr auto none = static_cast<std::size_t>(-1);

  const GltfDocument& document_;
  std::vector<std::size_t> parents_; // of nodes
  std::vector<Transform> worlds_;
};

} // namespace quadrille_examples

#endif
