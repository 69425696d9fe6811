#ifndef QUADRILLE_EXAMPLES_MESH_IO_PLY_WRITER_H
#define QUADRILLE_EXAMPLES_MESH_IO_PLY_WRITER_H

#include "../mesh/indexed_mesh.h"
#include "../mesh/named_numbers.h"
#include "../mesh/split_seams.h"
#include "../text.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quadrille_examples {

/// Writes bytes, the lowest first. Properties are in the order of MeshLab, which reads coordinates
/// and normals of both precisions, but texture coordinates of faces as `float` only.
class PlyWriter {
public:
  /// `normals`: none, or one for each point.
  static std::string bytes(const IndexedMesh& mesh,
                           const std::vector<std::array<double, 3>>& normals) {
    PlyWriter writer(mesh, normals);
    writer.append_header();
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      writer.append_vertex(v);
    for (std::size_t face = 0; face < mesh.triangles.size(); ++face)
      writer.append_face(face);
    return std::move(writer.bytes_);
  }

private:
  static constexpr NumberType single_type = {4, false, true}, double_type = {8, false, true};

  PlyWriter(const IndexedMesh& mesh, const std::vector<std::array<double, 3>>& normals)
      : mesh_(mesh), normals_(normals),
        normal_type_(mesh.corner_normals.are_double ? double_type : single_type),
        texture_type_(mesh.corner_textures.are_double ? double_type : single_type),
        color_type_(number_type(mesh.color_type)), channels_(mesh.color_type.has_alpha ? 4 : 3) {}

  static NumberType number_type(const ColorType& type) {
    if (type.is_whole)
      return {type.full == 255 ? 1U : 2U, true, false};
    return type.is_single ? single_type : double_type;
  }

  void append_header() {
    bytes_ = "ply\nformat binary_little_endian 1.0\n";
    for (const std::string& comment : mesh_.texture_comments)
      bytes_ += "comment " + comment + '\n';
    bytes_ += "element vertex " + std::to_string(mesh_.points.size()) + '\n';
    declare(double_type, {"x", "y", "z"});
    if (!normals_.empty())
      declare(normal_type_, {"nx", "ny", "nz"});
    if (!mesh_.colors.empty())
      declare(color_type_, {"red", "green", "blue"});
    if (!mesh_.colors.empty() && channels_ == 4)
      declare(color_type_, {"alpha"});
    if (!mesh_.texture_coordinates.empty())
      declare(double_type, {"s", "t"});
    declare(mesh_.vertex_numbers);
    bytes_ += "element face " + std::to_string(mesh_.triangles.size()) + '\n';
    bytes_ += "property list uchar uint vertex_indices\n";
    if (!mesh_.corner_textures.empty())
      bytes_ += "property list uchar " + texture_type_.name() + " texcoord\n";
    declare(mesh_.face_numbers);
    bytes_ += "end_header\n";
  }

  void declare(const NumberType& type, std::initializer_list<const char*> names) {
    for (const char* name : names)
      bytes_ += "property " + type.name() + ' ' + name + '\n';
  }
  void declare(const std::vector<NamedNumbers>& numbers) {
    for (const NamedNumbers& column : numbers)
      declare(column.type, {column.name.c_str()});
  }

  void append_vertex(std::size_t v) {
    const Point& p = mesh_.points[v];
    append(double_type, std::array{p.x(), p.y(), p.z()}, 3);
    if (!normals_.empty())
      append(normal_type_, normals_[v], 3);
    if (!mesh_.colors.empty())
      append(color_type_, mesh_.colors[v], channels_);
    if (!mesh_.texture_coordinates.empty())
      append(double_type, mesh_.texture_coordinates[v], 2);
    append_row(mesh_.vertex_numbers, v);
  }

  void append_face(std::size_t face) {
    append_little_endian(bytes_, std::uint8_t{3});
    for (const std::uint32_t index : mesh_.triangles[face])
      append_little_endian(bytes_, index);
    if (!mesh_.corner_textures.empty())
      append_textures(face);
    append_row(mesh_.face_numbers, face);
  }

  /// A face without texture coordinates has an empty list.
  void append_textures(std::size_t face) {
    const bool has_textures = mesh_.parts.of(face).has_textures;
    append_little_endian(bytes_, static_cast<std::uint8_t>(has_textures ? 6 : 0));
    for (std::size_t i = 0; i < 3 && has_textures; ++i)
      append(texture_type_, mesh_.corner_textures.values[mesh_.corner_textures.triples[face][i]],
             2);
  }

  void append_row(const std::vector<NamedNumbers>& numbers, std::size_t i) {
    for (const NamedNumbers& column : numbers)
      append(column.type, column.values[i]);
  }

  template <std::size_t N>
  void append(const NumberType& type, const std::array<double, N>& values, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
      append(type, values[i]);
  }

  void append(const NumberType& type, double value) {
    const double nearest = nearest_of(type, value);
    if (type.is_integer) {
      append_little_endian(bytes_, static_cast<std::int64_t>(nearest));
      bytes_.resize(bytes_.size() - sizeof(std::int64_t) + type.size); // of smaller types the same
    } else if (type.size == 4) {
      append_little_endian(bytes_, static_cast<float>(nearest));
    } else {
      append_little_endian(bytes_, nearest);
    }
  }

  const IndexedMesh& mesh_;
  const std::vector<std::array<double, 3>>& normals_;
  NumberType normal_type_, texture_type_, color_type_;
  std::size_t channels_; // of a colour
  std::string bytes_;
};

/// PLY has one normal a vertex, so those at which normals differ are split.
inline std::string encode_ply(const IndexedMesh& mesh) {
  if (mesh.corner_normals.empty())
    return PlyWriter::bytes(mesh, {});
  const auto split = SeamSplitter<3>::split(mesh, mesh.corner_normals, &FacePart::has_normals);
  return PlyWriter::bytes(split.mesh, split.values);
}

} // namespace quadrille_examples

#endif
