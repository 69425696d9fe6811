#ifndef QUADRILLE_EXAMPLES_MESH_IO_H
#define QUADRILLE_EXAMPLES_MESH_IO_H

/// \file
/// Reads and writes triangle soups. What takes its time to compile is in mesh_io/*.cpp, the library
/// quadrille_mesh_io.

#include "amount.h"
#include "format.h"
#include "mesh/indexed_mesh.h"
#include "text.h"

#include <cstddef>
#include <filesystem>
#include <string>

namespace quadrille_examples {

/// Which vertices at exactly the same place become one. Where they differ by what they have, there
/// is a seam: see IndexedMesh::value_triangles.
enum class Weld {
  surfaces, ///< those of one surface, edge by edge: see SurfaceJoining
  places    ///< all of them
};

/// Reads a mesh, from standard input if the path is "-"; polygons are triangulated. Throws
/// `std::runtime_error` with one line, "FILE: what" or "FILE:LINE: what", if the file is missing,
/// cut off or broken: nothing is read in part. What can be left out without harm is left out, and
/// told in `IndexedMesh::remarks`: faces of fewer than three corners, vertices that are not finite
/// and that no face uses. What an IndexedMesh has no place for is told in `IndexedMesh::losses`.
/// With Weld::places vertices are also one if they are no further from each other than the
/// tolerance.
IndexedMesh read_mesh(const std::filesystem::path& path, const MeshFormat& format,
                      Weld weld = Weld::surfaces, const Amount& tolerance = {});
IndexedMesh read_mesh(const std::filesystem::path& path, Weld weld = Weld::surfaces);

/// The same of a file that is in memory.
IndexedMesh read_mesh(const Source& source, const MeshFormat& format, Weld weld = Weld::surfaces,
                      const Amount& tolerance = {});

/// Takes out of a mesh what a format does not hold, and tells it in `IndexedMesh::losses`; but
/// colours and texture coordinates, which are told, stay.
void fit_to_format(IndexedMesh& mesh, const MeshFormat& format);

/// A mesh as the content of a file, of which is told what cannot be.
std::string encoded(const std::filesystem::path& path, const IndexedMesh& mesh,
                    const MeshFormat& format);

/// Writes a mesh, to standard output if the path is "-": all of it, or, throwing
/// `std::runtime_error`, nothing, in which case a file that was there stays. See FileReplacement.
/// Coordinates read back as they are, but for STL, which is of single precision. Colours are
/// written to OFF, OBJ and PLY, texture coordinates too, in OFF with a vertex for each side of a
/// seam; normals to OBJ and PLY, in PLY with a vertex for each; parts of faces to OBJ; named
/// numbers to PLY. Of what is at corners PLY gets single precision, unless it was read as double.
void write_mesh(const std::filesystem::path& path, const IndexedMesh& mesh,
                const MeshFormat& format, bool is_forced = false);
void write_mesh(const std::filesystem::path& path, const IndexedMesh& mesh);

} // namespace quadrille_examples

#endif
