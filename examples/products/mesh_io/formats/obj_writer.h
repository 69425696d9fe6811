#ifndef QUADRILLE_EXAMPLES_MESH_IO_OBJ_WRITER_H
#define QUADRILLE_EXAMPLES_MESH_IO_OBJ_WRITER_H

#include "../mesh/face_parts.h"
#include "../mesh/indexed_mesh.h"
#include "../number_text.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace quadrille_examples {

class ObjWriter {
public:
  static std::string text(const IndexedMesh& mesh) {
    ObjWriter writer(mesh);
    writer.append_head();
    writer.append_vertices();
    writer.append_values("vt", mesh.texture_coordinates);
    writer.append_values("vt", mesh.corner_textures.values);
    writer.append_values("vn", mesh.corner_normals.values);
    for (std::size_t face = 0; face < mesh.triangles.size(); ++face)
      writer.append_face(face);
    return std::move(writer.text_);
  }

private:
  explicit ObjWriter(const IndexedMesh& mesh) : mesh_(mesh) {}

  void append_head() {
    text_ = "# " + std::to_string(mesh_.points.size()) + " vertices, " +
            std::to_string(mesh_.triangles.size()) + " faces\n";
    for (const std::string& library : mesh_.parts.libraries)
      append_line("mtllib", library);
  }

  void append_line(const char* keyword, const std::string& name) {
    text_ += keyword;
    text_ += (name.empty() ? "" : " ") + name + '\n';
  }

  void append_vertices() {
    const std::size_t channels = mesh_.colors.empty() ? 0 : mesh_.color_type.has_alpha ? 4 : 3;
    for (std::size_t v = 0; v < mesh_.points.size(); ++v) {
      const Point& p = mesh_.points[v];
      append_numbers(text_ += 'v', p.x(), p.y(), p.z());
      for (std::size_t channel = 0; channel < channels; ++channel)
        append_fraction(text_ += ' ', mesh_.colors[v][channel], mesh_.color_type);
      text_ += '\n';
    }
  }

  template <std::size_t N>
  void append_values(const char* keyword, const std::vector<std::array<double, N>>& values) {
    for (const std::array<double, N>& value : values) {
      text_ += keyword;
      for (const double number : value)
        append_numbers(text_, number);
      text_ += '\n';
    }
  }

  void append_face(std::size_t face) {
    if (!mesh_.parts.of_faces.empty())
      enter(mesh_.parts.of(face));
    text_ += 'f';
    for (std::size_t corner = 0; corner < 3; ++corner)
      append_corner(face, corner);
    text_ += '\n';
  }

  /// Tells in what the part differs from that of the face before.
  void enter(const FacePart& part) {
    const auto tell = [&](const char* keyword, std::uint32_t FacePart::*member) {
      if (part.*member != part_.*member)
        append_line(keyword, mesh_.parts.names[part.*member]);
    };
    tell("o", &FacePart::object);
    tell("g", &FacePart::group);
    tell("usemtl", &FacePart::material);
    if (part.smoothing == 0 && part_.smoothing != 0)
      append_line("s", "off");
    else
      tell("s", &FacePart::smoothing);
    part_ = part;
  }

  /// `vertex`, `vertex/texture`, `vertex//normal` or `vertex/texture/normal`.
  void append_corner(std::size_t face, std::size_t corner) {
    const std::uint32_t vertex = mesh_.triangles[face][corner];
    const bool has_normal = !mesh_.corner_normals.empty() && part_.has_normals;
    append_numbers(text_, vertex + 1);
    if (!mesh_.texture_coordinates.empty())
      append_number(text_ += '/', vertex + 1);
    else if (!mesh_.corner_textures.empty() && part_.has_textures)
      append_number(text_ += '/', mesh_.corner_textures.triples[face][corner] + 1);
    else if (has_normal)
      text_ += '/';
    if (has_normal)
      append_number(text_ += '/', mesh_.corner_normals.triples[face][corner] + 1);
  }

  const IndexedMesh& mesh_;
  std::string text_;
  FacePart part_; // of the face written last
};

inline std::string encode_obj(const IndexedMesh& mesh) {
  return ObjWriter::text(mesh);
}

} // namespace quadrille_examples

#endif
