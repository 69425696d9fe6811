#ifndef QUADRILLE_EXAMPLES_GLTF_TWINS_H
#define QUADRILLE_EXAMPLES_GLTF_TWINS_H

#include "json.h"

#include <cstddef>
#include <map>
#include <string>

namespace quadrille_examples {

/// Meshes of the same accessors, as chairs of several colours: one is simplified, and all of them
/// go on sharing what it has then.
class GltfTwins {
public:
  /// Of each mesh that has a twin before it, the first one.
  using Firsts = std::map<std::size_t, std::size_t>;

  static Firsts of(const Json& document) {
    Firsts firsts;
    std::map<std::string, std::size_t> known;
    for (std::size_t mesh = 0; mesh < size_of(document, "meshes"); ++mesh) {
      const auto [place, is_new] =
          known.try_emplace(geometry_of(element_of(document, "meshes", mesh)), mesh);
      if (!is_new)
        firsts.emplace(mesh, place->second);
    }
    return firsts;
  }

  /// Gives a primitive the geometry of its twin.
  static void copy(const Json& from, Json& to) {
    for (const char* const key : keys)
      if (const Json* const value = member(from, key))
        to[key] = *value;
  }

private:
  static constexpr const char* keys[] = {"attributes", "indices", "targets", "mode"};

  static std::string geometry_of(const Json& mesh) {
    std::string text;
    for_each_element(mesh, "primitives", [&](const Json& primitive) {
      for (const char* const key : keys) {
        const Json* const value = member(primitive, key);
        text += (value ? value->dump() : std::string()) + ';';
      }
    });
    return text;
  }
};

} // namespace quadrille_examples

#endif
