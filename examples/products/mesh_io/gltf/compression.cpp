#include "compression.h"

#include "document.h"

#ifdef QUADRILLE_WITH_DRACO
#include "draco_compression.h"
#endif
#ifdef QUADRILLE_WITH_MESHOPT
#include "meshopt_compression.h"
#endif

#include <stdexcept>
#include <string>

namespace quadrille_examples {

namespace {

[[noreturn, maybe_unused]] void refuse(const std::string& library, const std::string& tool) {
  throw std::runtime_error(
      "this program was built without " + library +
      ", which this compression needs; compress OUT with another tool: " + tool);
}

} // namespace

GltfCompression compression_of(const std::string& word) {
#ifndef QUADRILLE_WITH_MESHOPT
  if (word == "meshopt")
    refuse("libmeshoptimizer", "gltfpack -noq -c -i OUT -o OUT");
#endif
#ifndef QUADRILLE_WITH_DRACO
  if (word == "draco")
    refuse("libdraco", "gltf-transform draco OUT OUT");
#endif
  return word.empty()      ? GltfCompression::none
         : word == "draco" ? GltfCompression::draco
                           : GltfCompression::meshopt;
}

void compress([[maybe_unused]] GltfDocument& document, [[maybe_unused]] GltfCompression how,
              [[maybe_unused]] bool is_exact) {
#ifdef QUADRILLE_WITH_MESHOPT
  if (how == GltfCompression::meshopt)
    MeshoptCompression::compress(document);
#endif
#ifdef QUADRILLE_WITH_DRACO
  if (how == GltfCompression::draco)
    DracoCompression::compress(document, is_exact);
#endif
}

} // namespace quadrille_examples
