#ifndef QUADRILLE_TEST_SURFACE_FILES_H
#define QUADRILLE_TEST_SURFACE_FILES_H

#include "soups.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

/// \file
/// Soups as PLY and STL files, and back, by code of its own.

namespace test {

/// Appends the bytes of a number in an order.
template <class Number>
void put_number(std::string& to, Number number, bool is_big = false) {
  auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if (is_big != (std::endian::native == std::endian::big))
    std::reverse(bytes.begin(), bytes.end());
  to.append(bytes.data(), bytes.size());
}

/// A binary PLY file of positions and triangles.
template <class Number = float>
std::string ply_of(const Soup& soup, bool is_big = false) {
  const std::string type = sizeof(Number) == 8 ? "double" : "float";
  std::string ply = "ply\nformat binary_" + std::string(is_big ? "big" : "little") +
                    "_endian 1.0\nelement vertex " + std::to_string(soup.points.size()) +
                    "\nproperty " + type + " x\nproperty " + type + " y\nproperty " + type +
                    " z\nelement face " + std::to_string(soup.triangles.size()) +
                    "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Position& p : soup.points)
    for (const double x : p.coordinates)
      put_number(ply, static_cast<Number>(x), is_big);
  for (const Triangle& t : soup.triangles) {
    ply += '\3';
    for (const std::uint32_t v : t)
      put_number(ply, static_cast<std::int32_t>(v), is_big);
  }
  return ply;
}

/// The same of doubles, with a number of each vertex.
inline std::string ply_with(const Soup& soup, const std::string& name,
                            const std::vector<double>& values) {
  const std::string plain = ply_of<double>(soup);
  const std::size_t header = plain.find("end_header\n") + 11;
  std::string ply = plain.substr(0, header);
  ply.insert(ply.find("element face"), "property double " + name + "\n");
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    ply += plain.substr(header + 24 * v, 24);
    put_number(ply, values[v]);
  }
  return ply + plain.substr(header + 24 * soup.points.size());
}

/// The same as text, of polygons.
inline std::string text_ply_of(const std::vector<Position>& points,
                               const std::vector<std::vector<std::uint32_t>>& polygons) {
  std::ostringstream ply;
  ply.precision(17);
  ply << "ply\nformat ascii 1.0\nelement vertex " << points.size()
      << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << polygons.size()
      << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Position& p : points)
    ply << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for (const std::vector<std::uint32_t>& polygon : polygons) {
    ply << polygon.size();
    for (const std::uint32_t v : polygon)
      ply << ' ' << v;
    ply << '\n';
  }
  return ply.str();
}

/// A binary STL file.
inline std::string stl_of(const Soup& soup) {
  std::string stl(80, ' ');
  put_number(stl, static_cast<std::uint32_t>(soup.triangles.size()));
  for (const Triangle& t : soup.triangles) {
    stl.append(12, '\0');
    for (const std::uint32_t v : t)
      for (const double x : soup.points[v].coordinates)
        put_number(stl, static_cast<float>(x));
    stl.append(2, '\0');
  }
  return stl;
}

inline std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Of a PLY file as simplify_file writes it: little-endian.
inline Soup read_ply(const std::filesystem::path& path) {
  const std::string content = content_of(path);
  const std::size_t end = content.find("end_header\n") + 11;
  std::istringstream header(content.substr(0, end));
  std::size_t vertices = 0, faces = 0;
  bool has_doubles = false;
  for (std::string line, word, name; std::getline(header, line);) {
    std::istringstream words(line);
    words >> word >> name;
    if (word == "element")
      words >> (name == "vertex" ? vertices : faces);
    has_doubles = has_doubles || name == "double";
  }
  const char* at = content.data() + end;
  const auto next = [&]<class Number>(Number number) {
    std::memcpy(&number, at, sizeof(number));
    at += sizeof(number);
    return number;
  };
  Soup soup;
  for (std::size_t v = 0; v < vertices; ++v) {
    soup.points.emplace_back();
    for (double& x : soup.points.back().coordinates)
      x = has_doubles ? next(0.0) : static_cast<double>(next(0.0F));
  }
  for (std::size_t f = 0; f < faces; ++f) {
    ++at;
    soup.triangles.emplace_back();
    for (std::uint32_t& v : soup.triangles.back())
      v = next(std::uint32_t{});
  }
  return soup;
}

} // namespace test

#endif // QUADRILLE_TEST_SURFACE_FILES_H
