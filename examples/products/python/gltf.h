#ifndef QUADRILLE_EXAMPLES_PYTHON_GLTF_H
#define QUADRILLE_EXAMPLES_PYTHON_GLTF_H

/// \file
/// glTF documents for Python.

#include <pybind11/pybind11.h>

#include <filesystem>

namespace quadrille_examples {

struct IndexedMesh;
struct MeshFormat;

void add_gltf(pybind11::module_& m);

/// What a document can hold of a mesh.
const MeshFormat& format_of_gltf();

/// The geometry of a document's scene: see GltfSceneMesh.
IndexedMesh read_gltf_mesh(const std::filesystem::path& path);

/// A mesh as a document; what is missing of its materials is added to its losses.
void write_gltf_mesh(const std::filesystem::path& path, IndexedMesh& mesh);

} // namespace quadrille_examples

#endif
