#ifndef QUADRILLE_INTERNAL_FILE_PLY_OUTPUT_H
#define QUADRILLE_INTERNAL_FILE_PLY_OUTPUT_H

#include <quadrille/internal/core/base/little_endian.h>
#include <quadrille/internal/file/disk_file.h>
#include <quadrille/internal/file/ply_header.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace quadrille::internal {

/// A buffer of bytes to be written to a file, little-endian.
class PlyBytes {
public:
  explicit PlyBytes(WholeFile& file) : file_(file) {}

  void put_text(const std::string& text) {
    buffer_.insert(buffer_.end(), text.begin(), text.end());
  }
  template <class Number>
  void put(Number number) {
    append_little_endian(buffer_, number);
    if (buffer_.size() >= (1 << 20))
      flush();
  }
  /// Adds a number as a property of that type.
  void put_as(const PlyType& type, double value) {
    if (type.is_integer)
      put_integer(type, std::llround(value));
    else if (type.size == 8)
      put(value);
    else
      put(static_cast<float>(value));
  }
  void put_integer(const PlyType& type, std::int64_t value) {
    if (type.size == 1)
      put(static_cast<std::uint8_t>(value));
    else if (type.size == 2)
      put(static_cast<std::uint16_t>(value));
    else
      put(static_cast<std::uint32_t>(value));
  }
  void put_corners(const std::array<std::uint64_t, 3>& corners) {
    put(static_cast<unsigned char>(3));
    for (const std::uint64_t corner : corners)
      put(static_cast<std::uint32_t>(corner));
  }
  void flush() {
    file_.write(buffer_.data(), buffer_.size());
    buffer_.clear();
  }

private:
  WholeFile& file_;
  std::vector<char> buffer_;
};

inline std::string ply_properties(const std::vector<PlyProperty>& list) {
  std::string text;
  for (const PlyProperty& p : list)
    text += "property " + p.type.name() + " " + p.name + "\n";
  return text;
}

/// Returns the beginning of a file of positions and triangles, with these additional properties and
/// with whole lines of comments.
inline std::string ply_header(std::uint64_t vertices, bool has_doubles,
                              const std::vector<PlyProperty>& of_vertices, std::uint64_t faces,
                              const std::vector<PlyProperty>& of_faces,
                              const std::string& comments = {}) {
  const std::string number = has_doubles ? "double" : "float";
  const std::string index = vertices > 0x7FFFFFFFU ? "uint" : "int";
  return "ply\nformat binary_little_endian 1.0\n" + comments + "element vertex " +
         std::to_string(vertices) + "\nproperty " + number + " x\nproperty " + number +
         " y\nproperty " + number + " z\n" + ply_properties(of_vertices) + "element face " +
         std::to_string(faces) + "\nproperty list uchar " + index + " vertex_indices\n" +
         ply_properties(of_faces) + "end_header\n";
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_PLY_OUTPUT_H
