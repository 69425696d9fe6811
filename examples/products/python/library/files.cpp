// Files of meshes: what they hold as arrays, and what write_mesh() takes of a file that was read.
#include "jobs.h"

#include "../../mesh_io/attributes/face_labels.h"
#include "../../mesh_io/mesh/split_seams.h"
#include "../../mesh_io/mesh_io.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace quadrille_examples {

namespace {

using Triples = std::vector<std::array<std::uint32_t, 3>>;

/// A type as numpy names it: i2, u1, f4, …
std::string name_of(const NumberType& type) {
  const char letter = type.is_integer ? (type.is_signed ? 'i' : 'u') : 'f';
  return std::string(1, letter) + std::to_string(type.size);
}
NumberType number_type(const std::string& name) {
  return {static_cast<std::size_t>(name.at(1) - '0'), name[0] != 'f', name[0] != 'u'};
}

// --- What a mesh has, into a bag

template <std::size_t N>
void give_corners(quadrille_bag& bag, const std::string& name, const CornerValues<N>& corners) {
  if (corners.empty())
    return;
  bag.give(name, corners.values);
  bag.give(name + ".indices", Triples(corners.triples.begin(), corners.triples.end()));
}

/// Numbers in [0, full] of three or four channels, with their unit.
void give_colors(quadrille_bag& bag, const IndexedMesh& mesh) {
  if (mesh.colors.empty())
    return;
  const std::size_t channels = mesh.color_type.has_alpha ? 4 : 3;
  std::vector<double> values;
  for (const Color& color : mesh.colors)
    values.insert(values.end(), color.begin(),
                  color.begin() + static_cast<std::ptrdiff_t>(channels));
  bag.give("colors", std::move(values), channels);
  bag.give_numbers("colors.unit", mesh.color_type.full, mesh.color_type.is_whole);
}

/// Names of numbers, their types, and each column by its number.
void give_columns(quadrille_bag& bag, const std::string& name,
                  const std::vector<NamedNumbers>& columns) {
  std::vector<std::string> names, types;
  for (const NamedNumbers& column : columns) {
    bag.give(name + '.' + std::to_string(names.size()), column.values);
    names.push_back(column.name);
    types.push_back(name_of(column.type));
  }
  bag.give_texts(name, names);
  bag.give_texts(name + ".types", types);
}
std::vector<NamedNumbers> columns_of(const quadrille_bag& bag, const std::string& name) {
  if (!bag.has(name))
    return {};
  const std::vector<std::string> names = bag.texts(name), types = bag.texts(name + ".types");
  std::vector<NamedNumbers> columns;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto values = bag.numbers<double>(name + '.' + std::to_string(i));
    columns.push_back({names[i], number_type(types[i]), {values.begin(), values.end()}});
  }
  return columns;
}

/// What write_mesh() takes of the file again, by names that begin with `source`.
void give_source(quadrille_bag& bag, const IndexedMesh& mesh) {
  bag.give_texts("source.libraries", mesh.parts.libraries);
  bag.give_texts("source.names", mesh.parts.names);
  std::vector<std::uint32_t> parts;
  for (const FacePart& part : mesh.parts.parts)
    parts.insert(parts.end(), {part.object, part.group, part.material, part.smoothing,
                               part.has_textures, part.has_normals});
  bag.give("source.parts", std::move(parts), 6);
  bag.give("source.of_faces", mesh.parts.of_faces);
  give_columns(bag, "source.columns", mesh.face_numbers);
  bag.give_texts("source.comments", mesh.texture_comments);
  bag.give_text("source.header", mesh.stl_header);
  bag.give_numbers("source.doubles", mesh.corner_textures.are_double,
                   mesh.corner_normals.are_double);
}

void give_mesh(quadrille_bag& bag, const IndexedMesh& mesh) {
  std::vector<std::array<double, 3>> points;
  for (const Point& p : mesh.points)
    points.push_back({p.x(), p.y(), p.z()});
  bag.give("points", std::move(points));
  bag.give("faces", Triples(mesh.triangles.begin(), mesh.triangles.end()));
  bag.give("vertex_uv", mesh.texture_coordinates);
  give_corners(bag, "uv", mesh.corner_textures);
  give_corners(bag, "normals", mesh.corner_normals);
  give_colors(bag, mesh);
  if (std::vector<std::uint32_t> labels = FaceRegions(mesh).labels(); !labels.empty())
    bag.give("labels", std::move(labels));
  give_columns(bag, "vertex_numbers", mesh.vertex_numbers);
  std::vector<std::string> remarks = mesh.remarks;
  if (!mesh.losses.empty())
    remarks.push_back("not kept: " + mesh.losses.text());
  bag.give_texts("remarks", remarks);
  give_source(bag, mesh);
}

// --- A mesh, of what a bag has

template <std::size_t N>
void set_corners(CornerValues<N>& corners, const quadrille_bag& bag, const std::string& name) {
  if (!bag.has(name))
    return;
  const auto values = bag.rows<double, N>(name);
  const auto triples = bag.rows<std::uint32_t, 3>(name + ".indices");
  corners.values.assign(values.begin(), values.end());
  corners.triples.assign(triples.begin(), triples.end());
}

void set_colors(IndexedMesh& mesh, const quadrille_bag& bag) {
  if (!bag.has("colors"))
    return;
  const auto colors = bag.rows<double, 4>("colors");
  mesh.colors.assign(colors.begin(), colors.end());
  const auto unit = bag.numbers<double>("colors.unit"); // full, whole, with alpha
  mesh.color_type = {unit[0], unit[1] != 0, false, unit[2] != 0};
}

IndexedMesh mesh_in(const quadrille_bag& bag) {
  IndexedMesh mesh;
  for (const auto& [x, y, z] : bag.rows<double, 3>("points"))
    mesh.points.emplace_back(x, y, z);
  const auto triangles = bag.rows<std::uint32_t, 3>("faces");
  mesh.triangles.assign(triangles.begin(), triangles.end());
  set_corners(mesh.corner_textures, bag, "uv");
  set_corners(mesh.corner_normals, bag, "normals");
  set_colors(mesh, bag);
  mesh.vertex_numbers = columns_of(bag, "vertex_numbers");
  return mesh;
}

/// What the faces of a file had of their own, of those that are left: see face_labels.h.
void set_source(IndexedMesh& mesh, const quadrille_bag& bag) {
  mesh.parts.libraries = bag.texts("source.libraries");
  mesh.parts.names = bag.texts("source.names");
  mesh.parts.parts.clear();
  for (const auto& part : bag.rows<std::uint32_t, 6>("source.parts"))
    mesh.parts.parts.push_back({part[0], part[1], part[2], part[3], part[4] != 0, part[5] != 0});
  const auto of_faces = bag.numbers<std::uint32_t>("source.of_faces");
  mesh.parts.of_faces.assign(of_faces.begin(), of_faces.end());
  mesh.face_numbers = columns_of(bag, "source.columns");
  mesh.texture_comments = bag.texts("source.comments");
  mesh.stl_header = bag.text("source.header");
  const auto are_double = bag.numbers<double>("source.doubles");
  mesh.corner_textures.are_double = are_double[0] != 0;
  mesh.corner_normals.are_double = are_double[1] != 0;
  const auto take = [&](auto& values) {
    std::remove_reference_t<decltype(values)> taken;
    for (const std::uint32_t face : bag.numbers<std::uint32_t>("source.faces"))
      taken.push_back(values.at(face));
    values = std::move(taken);
  };
  if (!mesh.parts.of_faces.empty())
    take(mesh.parts.of_faces);
  for (NamedNumbers& column : mesh.face_numbers)
    take(column.values);
}

/// All faces have what corners have, where no file says otherwise.
void set_one_part(IndexedMesh& mesh) {
  mesh.parts = {};
  mesh.parts.parts = {
      {.has_textures = !mesh.corner_textures.empty(), .has_normals = !mesh.corner_normals.empty()}};
  mesh.parts.of_faces.assign(mesh.triangles.size(), 0);
}

} // namespace

void read_file(const Work& work) {
  const std::filesystem::path path = work.bag.path("path");
  IndexedMesh mesh = is_gltf_file(path.extension().string())
                         ? read_gltf_mesh(path)
                         : read_mesh(path, mesh_format(path, " .gltf .glb"),
                                     work.bag.flag("welds") ? Weld::places : Weld::surfaces);
  const bool has_seams = !mesh.value_triangles.empty(); // at which points are there twice
  give_mesh(work.bag, with_vertices_of_values(std::move(mesh)));
  work.bag.give_numbers("is_split", has_seams);
}

/// Gives what could not be written.
void write_file(const Work& work) {
  const std::filesystem::path path = work.bag.path("path");
  const std::string extension = path.extension().string();
  const MeshFormat& format =
      is_gltf_file(extension) ? format_of_gltf() : mesh_format(path, " .gltf .glb");
  IndexedMesh mesh = mesh_in(work.bag);
  if (work.bag.has("source.faces"))
    set_source(mesh, work.bag);
  if (mesh.parts.of_faces.empty())
    set_one_part(mesh);
  fit_to_format(mesh, format);
  if (is_gltf_file(extension))
    write_gltf_mesh(path, mesh);
  else
    write_mesh(path, mesh, format);
  work.bag.give_text("losses", mesh.losses.text());
}

} // namespace quadrille_examples
