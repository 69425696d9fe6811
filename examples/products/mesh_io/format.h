#ifndef QUADRILLE_EXAMPLES_MESH_IO_FORMAT_H
#define QUADRILLE_EXAMPLES_MESH_IO_FORMAT_H

/// \file
/// The formats of meshes: OFF, OBJ, PLY, STL and GOCAD (.ts), told apart by the extension.

#include "text.h"

#include <filesystem>
#include <string>

namespace quadrille_examples {

struct IndexedMesh;
struct PolygonSoup;

struct MeshFormat {
  const char* extension;
  PolygonSoup (*read)(const Source&);
  std::string (*encode)(const IndexedMesh&);
  bool holds_attributes; ///< colours and texture coordinates
  bool holds_corners;    ///< several texture coordinates at a vertex, normals
  bool holds_parts;      ///< materials, groups and objects
  bool holds_numbers;    ///< numbers of vertices and faces by any name, comments
  bool holds_stl_colors; ///< of these at least the colours of facets
};

/// The format of an extension, in any case of letters; nothing if there is none.
const MeshFormat* find_format(const std::string& extension);

/// Is it the extension of glTF, which is no such format? It goes to meshes and back by gltf/.
bool is_gltf(const std::string& extension);

/// The format that the extension of a path names. Throws if it names none; the message lists all,
/// and others that a caller knows.
const MeshFormat& mesh_format(const std::filesystem::path& path, const char* others = "");

} // namespace quadrille_examples

#endif
