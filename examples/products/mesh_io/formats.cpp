// The table of formats, whose readers and writers are in headers of their own, and how meshes go to
// files.
//
// CGAL triangulates the polygons, and writes STL and GOCAD. It does not read here: the readers of
// CGAL 5.5 take indices that are out of range, NaN and files that are cut off for good, allocate
// what a header claims, and pass over texture coordinates and most colours.
#include "formats/gocad.h"
#include "formats/obj.h"
#include "formats/obj_writer.h"
#include "formats/off.h"
#include "formats/ply.h"
#include "formats/ply_writer.h"
#include "formats/stl.h"
#include "mesh/split_seams.h"
#include "mesh_io.h"
#include "replace_file.h"
#include "text.h"

#include <functional>
#include <stdexcept>

namespace quadrille_examples {

namespace {

constexpr MeshFormat mesh_formats[] = {
    {".off", [](const Source& source) { return OffReader(source).read(); }, encode_off, true, false,
     false, false, false},
    {".obj", [](const Source& source) { return ObjReader(source).read(); }, encode_obj, true, true,
     true, false, false},
    {".ply", read_ply, encode_ply, true, true, false, true, true},
    {".stl", read_stl, encode_stl, false, false, false, false, true},
    {".ts", [](const Source& source) { return GocadReader(source).read(); }, encode_gocad, false,
     false, false, false, false}};

/// Takes the names of parts of a mesh, and tells them.
void lose_parts(IndexedMesh& mesh) {
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
void lose_normals(IndexedMesh& mesh) {
  if (!mesh.corner_normals.empty())
    mesh.losses.add("normals");
  mesh.corner_normals = {};
  for (FacePart& part : mesh.parts.parts)
    part.has_normals = false;
}

/// The same of its comments and named numbers; colours of facets may be held.
void lose_numbers(IndexedMesh& mesh, bool holds_stl_colors) {
  for (const std::string& comment : mesh.texture_comments)
    mesh.losses.add("comment " + in_quotes(comment, 100));
  for (const NamedNumbers& numbers : mesh.vertex_numbers)
    mesh.losses.add("vertex property " + in_quotes(numbers.name));
  const auto is_met = [&](const NamedNumbers& numbers) {
    return holds_stl_colors && numbers.name == stl_color_name;
  };
  for (const NamedNumbers& numbers : mesh.face_numbers)
    if (numbers.name == stl_color_name && !is_met(numbers))
      mesh.losses.add("colours of facets");
    else if (!is_met(numbers))
      mesh.losses.add("face property " + in_quotes(numbers.name));
  mesh.texture_comments.clear();
  mesh.vertex_numbers.clear();
  std::erase_if(mesh.face_numbers, std::not_fn(is_met));
}

} // namespace

const MeshFormat* find_format(const std::string& extension) {
  for (const MeshFormat& format : mesh_formats)
    if (equal_ignoring_case(extension, format.extension))
      return &format;
  return nullptr;
}

bool is_gltf(const std::string& extension) {
  return equal_ignoring_case(extension, ".gltf") || equal_ignoring_case(extension, ".glb");
}

const MeshFormat& mesh_format(const std::filesystem::path& path, const char* others) {
  const std::string extension = path.extension().string();
  if (const MeshFormat* format = find_format(extension))
    return *format;
  if (std::filesystem::is_directory(path))
    fail(path, "is a folder");
  fail(path,
       "the extension " + in_quotes(extension) + " is not one of .off .obj .ply .stl .ts" + others);
}

void fit_to_format(IndexedMesh& mesh, const MeshFormat& format) {
  if (!format.holds_numbers)
    lose_numbers(mesh, format.holds_stl_colors);
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

std::string encoded(const std::filesystem::path& path, const IndexedMesh& mesh,
                    const MeshFormat& format) {
  if (!mesh.value_triangles.empty())
    return encoded(path, with_vertices_of_values(mesh), format);
  try {
    if (format.holds_attributes && !format.holds_corners && !mesh.corner_textures.empty())
      return format.encode(with_vertex_textures(mesh));
    return format.encode(mesh);
  } catch (const std::runtime_error& error) {
    fail(path, error.what());
  }
}

void write_mesh(const std::filesystem::path& path, const IndexedMesh& mesh,
                const MeshFormat& format, bool is_forced) {
  replace_file(path, encoded(path, mesh, format), is_forced);
}

void write_mesh(const std::filesystem::path& path, const IndexedMesh& mesh) {
  write_mesh(path, mesh, mesh_format(path));
}

} // namespace quadrille_examples
