#ifndef QUADRILLE_EXAMPLES_MESH_IO_H
#define QUADRILLE_EXAMPLES_MESH_IO_H

/// \file
/// Reads and writes triangle soups: OFF, OBJ, PLY, STL and GOCAD (.ts), told apart by the
/// extension.
///
/// CGAL triangulates the polygons, and writes STL and GOCAD. It does not read here: the readers of
/// CGAL 5.5 take indices that are out of range, NaN and files that are cut off for good, allocate
/// what a header claims, and pass over texture coordinates and most colours.

#include "amount.h"
#include "mesh_io/assemble.h"
#include "mesh_io/gocad.h"
#include "mesh_io/indexed_mesh.h"
#include "mesh_io/obj.h"
#include "mesh_io/obj_writer.h"
#include "mesh_io/off.h"
#include "mesh_io/ply.h"
#include "mesh_io/ply_writer.h"
#include "mesh_io/replace_file.h"
#include "mesh_io/split_seams.h"
#include "mesh_io/stl.h"
#include "mesh_io/text.h"
#include "mesh_io/weld.h"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>

namespace quadrille_examples {

struct MeshFormat {
  const char* extension;
  PolygonSoup (*read)(const Source&);
  std::string (*encode)(const IndexedMesh&);
  bool holds_attributes; ///< colours and texture coordinates
  bool holds_corners;    ///< several texture coordinates at a vertex, normals
  bool holds_parts;      ///< materials, groups and objects
  bool holds_numbers;    ///< numbers of vertices and faces by any name, comments
};

inline constexpr MeshFormat mesh_formats[] = {
    {".off", [](const Source& source) { return OffReader(source).read(); }, encode_off, true, false,
     false, false},
    {".obj", [](const Source& source) { return ObjReader(source).read(); }, encode_obj, true, true,
     true, false},
    {".ply", read_ply, encode_ply, true, true, false, true},
    {".stl", read_stl, encode_stl, false, false, false, false},
    {".ts", [](const Source& source) { return GocadReader(source).read(); }, encode_gocad, false,
     false, false, false}};

/// The format of an extension, in any case of letters; nothing if there is none.
inline const MeshFormat* find_format(const std::string& extension) {
  for (const MeshFormat& format : mesh_formats)
    if (equal_ignoring_case(extension, format.extension))
      return &format;
  return nullptr;
}

/// The format that the extension of a path names. Throws if it names none; the message lists all,
/// and others that a caller knows.
inline const MeshFormat& mesh_format(const std::filesystem::path& path, const char* others = "") {
  const std::string extension = path.extension().string();
  if (const MeshFormat* format = find_format(extension))
    return *format;
  if (std::filesystem::is_directory(path))
    fail(path, "is a folder");
  fail(path,
       "the extension " + in_quotes(extension) + " is none of .off .obj .ply .stl .ts" + others);
}

/// Reads a mesh, from standard input if the path is "-"; polygons are triangulated. Throws
/// `std::runtime_error` with one line, "FILE: what" or "FILE:LINE: what", if the file is missing,
/// cut off or broken: nothing is read in part. What can be left out without harm is left out, and
/// told in `IndexedMesh::remarks`: faces of fewer than three corners, vertices that are not finite
/// and that no face uses. What an IndexedMesh has no place for is told in `IndexedMesh::losses`.
inline IndexedMesh read_mesh(const std::filesystem::path& path, const MeshFormat& format,
                             Weld weld = Weld::loose_faces, const Amount& tolerance = {}) {
  PolygonSoup soup = format.read(read_source(path));
  return Assembly(std::move(soup), path).mesh(weld, tolerance);
}
inline IndexedMesh read_mesh(const std::filesystem::path& path, Weld weld = Weld::loose_faces) {
  return read_mesh(path, mesh_format(path), weld);
}

/// May a file be written? Throws if not.
inline void require_replaceable(const std::filesystem::path& path, bool is_forced) {
  try {
    FileReplacement(path, is_forced);
  } catch (const std::runtime_error& error) {
    fail(path, error.what());
  }
}

/// Takes the names of parts of a mesh, and tells them.
inline void lose_parts(IndexedMesh& mesh) {
  const auto lose = [&](bool has, const char* what) {
    if (has)
      mesh.losses.add(what);
  };
  lose(!mesh.parts.libraries.empty(), "material libraries (mtllib)");
  lose(mesh.parts.has(&FacePart::material), "materials (usemtl)");
  lose(mesh.parts.has(&FacePart::object), "objects");
  lose(mesh.parts.has(&FacePart::group), "groups");
  lose(mesh.parts.has(&FacePart::smoothing), "smoothing groups");
  mesh.parts.forget_names();
}

/// The same of the normals of its corners.
inline void lose_normals(IndexedMesh& mesh) {
  if (!mesh.corner_normals.empty())
    mesh.losses.add("normals");
  mesh.corner_normals = {};
  for (FacePart& part : mesh.parts.parts)
    part.has_normals = false;
}

/// The same of its comments and named numbers.
inline void lose_numbers(IndexedMesh& mesh) {
  for (const std::string& comment : mesh.texture_comments)
    mesh.losses.add("comment " + in_quotes(comment, 100));
  for (const NamedNumbers& numbers : mesh.vertex_numbers)
    mesh.losses.add("vertex property " + in_quotes(numbers.name));
  for (const NamedNumbers& numbers : mesh.face_numbers)
    mesh.losses.add("face property " + in_quotes(numbers.name));
  mesh.texture_comments.clear();
  mesh.vertex_numbers.clear();
  mesh.face_numbers.clear();
}

/// Takes out of a mesh what a format does not hold, and tells it in `IndexedMesh::losses`; but
/// colours and texture coordinates, which are told, stay.
inline void fit_to_format(IndexedMesh& mesh, const MeshFormat& format) {
  if (!format.holds_numbers)
    lose_numbers(mesh);
  if (!format.holds_attributes) {
    if (!mesh.colors.empty())
      mesh.losses.add("colours");
    if (!mesh.texture_coordinates.empty() || !mesh.corner_textures.empty())
      mesh.losses.add("texture coordinates");
  }
  if (!format.holds_corners)
    lose_normals(mesh);
  if (!format.holds_parts)
    lose_parts(mesh);
}

/// A mesh as the content of a file, of which is told what cannot be.
inline std::string encoded(const std::filesystem::path& path, const IndexedMesh& mesh,
                           const MeshFormat& format) {
  try {
    if (format.holds_attributes && !format.holds_corners && !mesh.corner_textures.empty())
      return format.encode(with_vertex_textures(mesh));
    return format.encode(mesh);
  } catch (const std::runtime_error& error) {
    fail(path, error.what());
  }
}

/// Gives a file a content: see FileReplacement.
inline void replace_file(const std::filesystem::path& path, const std::string& content,
                         bool is_forced = false) {
  try {
    FileReplacement(path, is_forced).write(content);
  } catch (const std::runtime_error& error) {
    fail(path, error.what());
  }
}

/// Writes a mesh, to standard output if the path is "-": all of it, or, throwing
/// `std::runtime_error`, nothing, in which case a file that was there stays. See FileReplacement.
/// Coordinates read back as they are, but for STL, which is of single precision. Colours are
/// written to OFF, OBJ and PLY, texture coordinates too, in OFF with a vertex for each side of a
/// seam; normals to OBJ and PLY, in PLY with a vertex for each; parts of faces to OBJ; named
/// numbers to PLY. Of what is at corners PLY gets single precision, unless it was read as double.
inline void write_mesh(const std::filesystem::path& path, const IndexedMesh& mesh,
                       const MeshFormat& format, bool is_forced = false) {
  replace_file(path, encoded(path, mesh, format), is_forced);
}
inline void write_mesh(const std::filesystem::path& path, const IndexedMesh& mesh) {
  write_mesh(path, mesh, mesh_format(path));
}

} // namespace quadrille_examples

#endif
