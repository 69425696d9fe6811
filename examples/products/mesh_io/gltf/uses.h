#ifndef QUADRILLE_EXAMPLES_GLTF_USES_H
#define QUADRILLE_EXAMPLES_GLTF_USES_H

#include "json.h"

#include <cstddef>
#include <map>
#include <vector>

namespace quadrille_examples {

/// Which primitives and others use an accessor, and which accessors and others a buffer view.
class GltfUses {
public:
  enum class Kind { none, vertices, indices, other };

  explicit GltfUses(const Json& document) {
    accessors_.resize(size_of(document, "accessors"));
    for_each_element(document, "meshes", [&](const Json& mesh) {
      for_each_element(mesh, "primitives", [&](const Json& primitive) { add(primitive); });
    });
    add_views(document);
    for (std::size_t i = 0; i < accessors_.size(); ++i) {
      const Json& accessor = element_of(document, "accessors", i);
      if (!member(accessor, "bufferView"))
        continue;
      const std::size_t view = count_of(accessor, "bufferView");
      users_of_views_[view].push_back(i);
      if (member(accessor, "sparse"))
        ++mentions_of_views_[view]; // its elements are not those of the view
    }
  }

  /// The accessors of a view that nothing else uses, else none.
  std::vector<std::size_t> users_of_view(std::size_t view) const {
    const auto users = users_of_views_.find(view);
    if (users == users_of_views_.end() || mentions_of_views_.at(view) != users->second.size())
      return {};
    return users->second;
  }
  Kind kind(std::size_t accessor) const { return accessors_.at(accessor); }

  /// The accessors that the attributes of a primitive, or of a morph target, name.
  static std::vector<std::size_t> accessors_of(const Json& attributes) {
    std::vector<std::size_t> accessors;
    for (const auto& [name, index] : attributes.items())
      accessors.push_back(count_of(attributes, name.c_str()));
    return accessors;
  }

private:
  void add(const Json& primitive) {
    const auto use = [&](std::size_t accessor, Kind kind) {
      Kind& known = accessors_.at(accessor);
      known = known == Kind::none || known == kind ? kind : Kind::other;
    };
    if (const Json* const attributes = member(primitive, "attributes"))
      for (const std::size_t accessor : accessors_of(*attributes))
        use(accessor, Kind::vertices);
    for_each_element(primitive, "targets", [&](const Json& target) {
      for (const std::size_t accessor : accessors_of(target))
        use(accessor, Kind::vertices);
    });
    if (member(primitive, "indices"))
      use(count_of(primitive, "indices"),
          count_of(primitive, "mode", 4) == 4 ? Kind::indices : Kind::other);
  }

  void add_views(const Json& json) {
    if (member(json, "bufferView"))
      ++mentions_of_views_[count_of(json, "bufferView")];
    for (const Json& part : json)
      if (part.is_structured())
        add_views(part);
  }

  std::vector<Kind> accessors_;
  std::map<std::size_t, std::vector<std::size_t>> users_of_views_;
  std::map<std::size_t, std::size_t> mentions_of_views_;
};

} // namespace quadrille_examples

#endif
