#ifndef QUADRILLE_EXAMPLES_MESH_IO_PLY_WRITER_H
#define QUADRILLE_EXAMPLES_MESH_IO_PLY_WRITER_H

#include "indexed_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>

namespace quadrille_examples {

/// Appends the bytes of `value`, the lowest first.
template <class Value>
void append_little_endian(std::string& bytes, Value value) {
  auto raw = std::bit_cast<std::array<char, sizeof(Value)>>(value);
  if constexpr (std::endian::native == std::endian::big)
    std::reverse(raw.begin(), raw.end());
  bytes.append(raw.data(), raw.size());
}

inline const char* ply_type_name(const ColorType& type) {
  if (type.is_whole)
    return type.full == 255 ? "uchar" : "ushort";
  return type.is_single ? "float" : "double";
}

inline void append_ply_color(std::string& bytes, const Color& color, const ColorType& type) {
  for (std::size_t i = 0; i < (type.has_alpha ? 4U : 3U); ++i)
    if (type.is_whole && type.full == 255)
      append_little_endian(bytes, static_cast<std::uint8_t>(color[i]));
    else if (type.is_whole)
      append_little_endian(bytes, static_cast<std::uint16_t>(color[i]));
    else if (type.is_single)
      append_little_endian(bytes, static_cast<float>(color[i]));
    else
      append_little_endian(bytes, color[i]);
}

inline std::string ply_header(const IndexedMesh& mesh) {
  static constexpr const char* channels[] = {"red", "green", "blue", "alpha"};
  std::string text = "ply\nformat binary_little_endian 1.0\n";
  text += "element vertex " + std::to_string(mesh.points.size()) + "\n";
  text += "property double x\nproperty double y\nproperty double z\n";
  if (!mesh.colors.empty())
    for (std::size_t i = 0; i < (mesh.color_type.has_alpha ? 4U : 3U); ++i)
      text += std::string("property ") + ply_type_name(mesh.color_type) + ' ' + channels[i] + '\n';
  if (!mesh.texture_coordinates.empty())
    text += "property double s\nproperty double t\n";
  text += "element face " + std::to_string(mesh.triangles.size()) + "\n";
  return text + "property list uchar uint vertex_indices\nend_header\n";
}

inline std::string encode_ply(const IndexedMesh& mesh) {
  std::string bytes = ply_header(mesh);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Point& p = mesh.points[i];
    for (const double coordinate : {p.x(), p.y(), p.z()})
      append_little_endian(bytes, coordinate);
    if (!mesh.colors.empty())
      append_ply_color(bytes, mesh.colors[i], mesh.color_type);
    if (!mesh.texture_coordinates.empty())
      for (const double coordinate : mesh.texture_coordinates[i])
        append_little_endian(bytes, coordinate);
  }
  for (const auto& triangle : mesh.triangles) {
    append_little_endian(bytes, std::uint8_t{3});
    for (const std::uint32_t index : triangle)
      append_little_endian(bytes, index);
  }
  return bytes;
}

} // namespace quadrille_examples

#endif
