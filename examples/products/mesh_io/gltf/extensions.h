#ifndef QUADRILLE_EXAMPLES_GLTF_EXTENSIONS_H
#define QUADRILLE_EXAMPLES_GLTF_EXTENSIONS_H

#include "json.h"

#include <cstddef>
#include <utility>

namespace quadrille_examples {

/// Null if the value has no such extension.
inline const Json* extension_of(const Json& json, const char* name) {
  const Json* const extensions = member(json, "extensions");
  return extensions ? member(*extensions, name) : nullptr;
}

inline void erase_extension(Json& json, const char* name) {
  json["extensions"].erase(name);
  if (json["extensions"].empty())
    json.erase("extensions");
}

/// The document no longer uses it.
inline void forget_extension(Json& document, const char* name) {
  for (const char* const list : {"extensionsUsed", "extensionsRequired"}) {
    if (size_of(document, list) == 0)
      continue;
    Json rest = Json::array();
    for (const Json& one : document[list])
      if (one != Json(name))
        rest.push_back(one);
    if (rest.empty())
      document.erase(list);
    else
      document[list] = std::move(rest);
  }
}

/// Puts a name into a list of the document, unless it is there.
inline void list_extension(Json& document, const char* list, const char* name) {
  for (std::size_t i = 0; i < size_of(document, list); ++i)
    if (document[list][i] == Json(name))
      return;
  document[list].push_back(name);
}

} // namespace quadrille_examples

#endif
