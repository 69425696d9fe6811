#ifndef QUADRILLE_EXAMPLES_GLTF_COMPRESSION_H
#define QUADRILLE_EXAMPLES_GLTF_COMPRESSION_H

#include "document.h"

#include <string>

namespace quadrille_examples {

/// How the geometry of a document is compressed when it is written.
enum class GltfCompression {
  none,
  meshopt, ///< EXT_meshopt_compression: bit for bit, also animations
  draco    ///< KHR_draco_mesh_compression: triangles, whose floats are rounded
};

/// That of a word, "meshopt" or "draco". Throws `std::runtime_error` where the library was not
/// found when this was compiled, with a tool that does it.
GltfCompression compression_of(const std::string& word);

/// Compresses what is in the buffers, as far as it is geometry and the extension takes it; the rest
/// stays as it is. `is_exact` says that Draco must not round floats.
void compress(GltfDocument& document, GltfCompression how, bool is_exact);

} // namespace quadrille_examples

#endif
