#ifndef QUADRILLE_EXAMPLES_GLTF_DECOMPRESSION_H
#define QUADRILLE_EXAMPLES_GLTF_DECOMPRESSION_H

namespace quadrille_examples {

struct GltfDocument;

/// Decodes what KHR_draco_mesh_compression, EXT_meshopt_compression and KHR_meshopt_compression
/// have compressed, where the libraries draco and meshoptimizer were found when this was compiled:
/// the document is then one that knows nothing of it. Throws `std::runtime_error` for what is
/// broken, and where a library is missing, with what decodes it instead.
void decompress(GltfDocument& document);

} // namespace quadrille_examples

#endif
