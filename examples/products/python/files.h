#ifndef QUADRILLE_EXAMPLES_PYTHON_FILES_H
#define QUADRILLE_EXAMPLES_PYTHON_FILES_H

/// \file
/// Files of meshes for Python.

#include "../mesh_io/attributes/face_labels.h"
#include "../mesh_io/mesh/split_seams.h"
#include "../mesh_io/mesh_io.h"
#include "arrays.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace quadrille_examples {

inline Numbers<double> points_of(const IndexedMesh& mesh) {
  std::vector<std::array<double, 3>> points;
  for (const Point& p : mesh.points)
    points.push_back({p.x(), p.y(), p.z()});
  return array_of_rows(std::move(points));
}

/// Values and the indices of corners, or None.
template <std::size_t N>
py::object corners_of(const CornerValues<N>& corners) {
  if (corners.empty())
    return py::none();
  return py::make_tuple(array_of_rows(corners.values), array_of_rows(corners.triples));
}

/// Numbers in [0, full] of three or four channels, with their unit; or None.
inline py::object colors_of(const IndexedMesh& mesh) {
  if (mesh.colors.empty())
    return py::none();
  const std::size_t channels = mesh.color_type.has_alpha ? 4 : 3;
  std::vector<double> values;
  for (const Color& color : mesh.colors)
    values.insert(values.end(), color.begin(),
                  color.begin() + static_cast<std::ptrdiff_t>(channels));
  return py::make_tuple(array_of_values(std::move(values), channels), mesh.color_type.full,
                        mesh.color_type.is_whole);
}

/// The regions of faces, if there are several; or None.
inline py::object labels_of(const IndexedMesh& mesh) {
  std::vector<std::uint32_t> labels = FaceRegions(mesh).labels();
  if (labels.empty())
    return py::none();
  return array_of_numbers(std::move(labels));
}

/// A type as numpy names it: i2, u1, f4, …
inline std::string name_of(const NumberType& type) {
  const char letter = type.is_integer ? (type.is_signed ? 'i' : 'u') : 'f';
  return std::string(1, letter) + std::to_string(type.size);
}
inline NumberType number_type(const std::string& name) {
  return {static_cast<std::size_t>(name.at(1) - '0'), name[0] != 'f', name[0] != 'u'};
}

/// Names of numbers of vertices, their values and types.
inline py::list vertex_numbers_of(const IndexedMesh& mesh) {
  py::list result;
  for (const NamedNumbers& numbers : mesh.vertex_numbers)
    result.append(
        py::make_tuple(numbers.name, array_of_numbers(numbers.values), name_of(numbers.type)));
  return result;
}

/// What is written to a file, as arrays.
struct WrittenArrays {
  Numbers<double> points;
  Numbers<std::uint32_t> faces;
  using Corners = std::optional<std::pair<Numbers<double>, Numbers<std::uint32_t>>>;
  Corners uv, normals;
  std::optional<std::tuple<Numbers<double>, double, bool>> colors; // of four channels
  bool has_alpha = false;
  std::vector<std::tuple<std::string, Numbers<double>, std::string>> vertex_numbers;
};

template <std::size_t N>
void set_corners(CornerValues<N>& corners, const WrittenArrays::Corners& arrays) {
  if (!arrays)
    return;
  const auto values = rows<N>(arrays->first);
  const auto triples = rows<3>(arrays->second);
  corners.values.assign(values.begin(), values.end());
  corners.triples.assign(triples.begin(), triples.end());
}

/// What the faces of a file had of their own, of those that are left: see face_labels.h.
inline void set_faces(IndexedMesh& mesh, const IndexedMesh& source,
                      const Numbers<std::uint32_t>& faces) {
  mesh.parts = source.parts;
  mesh.face_numbers = source.face_numbers;
  mesh.texture_comments = source.texture_comments;
  mesh.stl_header = source.stl_header;
  mesh.corner_textures.are_double = source.corner_textures.are_double;
  mesh.corner_normals.are_double = source.corner_normals.are_double;
  const auto take = [&](auto& values) {
    std::remove_reference_t<decltype(values)> taken;
    for (const std::uint32_t face : numbers(faces))
      taken.push_back(values.at(face));
    values = std::move(taken);
  };
  if (!mesh.parts.of_faces.empty())
    take(mesh.parts.of_faces);
  for (NamedNumbers& column : mesh.face_numbers)
    take(column.values);
}

/// All faces have what corners have, where no file says otherwise.
inline void set_one_chunk(IndexedMesh& mesh) {
  mesh.parts = {};
  mesh.parts.parts = {
      {.has_textures = !mesh.corner_textures.empty(), .has_normals = !mesh.corner_normals.empty()}};
  mesh.parts.of_faces.assign(mesh.triangles.size(), 0);
}

inline IndexedMesh mesh_of(const WrittenArrays& arrays) {
  IndexedMesh mesh;
  for (const auto& [x, y, z] : rows<3>(arrays.points))
    mesh.points.emplace_back(x, y, z);
  const auto triangles = rows<3>(arrays.faces);
  mesh.triangles.assign(triangles.begin(), triangles.end());
  set_corners(mesh.corner_textures, arrays.uv);
  set_corners(mesh.corner_normals, arrays.normals);
  if (arrays.colors) {
    const auto& [values, full, is_whole] = *arrays.colors;
    const auto colors = rows<4>(values);
    mesh.colors.assign(colors.begin(), colors.end());
    mesh.color_type = {full, is_whole, false, arrays.has_alpha};
  }
  for (const auto& [name, values, type] : arrays.vertex_numbers) {
    const auto column = numbers(values);
    mesh.vertex_numbers.push_back({name, number_type(type), {column.begin(), column.end()}});
  }
  return mesh;
}

/// What write_mesh() takes of the file that a mesh was read from, for `pickle`; the rest is in
/// arrays by then.
struct FileNumbers {
  using Part = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t, bool, bool>;
  using Column = std::tuple<std::string, std::string, std::vector<double>>;
  using State = std::tuple<std::vector<std::string>, std::vector<std::string>, std::vector<Part>,
                           std::vector<std::uint32_t>, std::vector<Column>,
                           std::vector<std::string>, std::string, bool, bool>;

  static State of(const IndexedMesh& mesh) {
    std::vector<Part> parts;
    for (const FacePart& part : mesh.parts.parts)
      parts.emplace_back(part.object, part.group, part.material, part.smoothing, part.has_textures,
                         part.has_normals);
    std::vector<Column> columns;
    for (const NamedNumbers& column : mesh.face_numbers)
      columns.emplace_back(column.name, name_of(column.type), column.values);
    return {mesh.parts.libraries,
            mesh.parts.names,
            std::move(parts),
            mesh.parts.of_faces,
            std::move(columns),
            mesh.texture_comments,
            mesh.stl_header,
            mesh.corner_textures.are_double,
            mesh.corner_normals.are_double};
  }

  static IndexedMesh mesh(const State& state) {
    IndexedMesh mesh;
    const auto& [libraries, names, parts, of_faces, columns, comments, header, textures_are_double,
                 normals_are_double] = state;
    mesh.parts.libraries = libraries;
    mesh.parts.names = names;
    for (const auto& [object, group, material, smoothing, has_textures, has_normals] : parts)
      mesh.parts.parts.push_back({object, group, material, smoothing, has_textures, has_normals});
    mesh.parts.of_faces = of_faces;
    for (const auto& [name, type, values] : columns)
      mesh.face_numbers.push_back({name, number_type(type), values});
    mesh.texture_comments = comments;
    mesh.stl_header = header;
    mesh.corner_textures.are_double = textures_are_double;
    mesh.corner_normals.are_double = normals_are_double;
    return mesh;
  }
};

} // namespace quadrille_examples

#endif
