#ifndef QUADRILLE_EXAMPLES_MESH_IO_GOCAD_H
#define QUADRILLE_EXAMPLES_MESH_IO_GOCAD_H

/// \file
/// The triangulated surfaces (TSurf) of GOCAD. A file may hold several, each with vertex numbers of
/// its own. Properties of vertices and all that is no surface are passed over, and told.

#include "../mesh/indexed_mesh.h"
#include "../mesh/polygon_soup.h"
#include "../text.h"

#include <CGAL/IO/GOCAD.h>

#include <cstdint>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace quadrille_examples {

class GocadReader {
public:
  explicit GocadReader(const Source& source) : lines_(source) { require_text(source); }

  PolygonSoup read() {
    if (!lines_.next_line() || lines_.next_word() != "GOCAD")
      lines_.fail("not a GOCAD file: its first word is not 'GOCAD'");
    while (lines_.next_line())
      read_line(lines_.next_word());
    if (is_in_object_)
      lines_.fail("the file ends before 'END'");
    return std::move(soup_);
  }

private:
  void read_line(std::string_view keyword) {
    if (keyword == "VRTX" || keyword == "PVRTX")
      read_vertex();
    else if (keyword == "ATOM" || keyword == "PATOM")
      read_alias();
    else if (keyword == "TRGL")
      read_triangle();
    else if (keyword == "TFACE")
      has_surface_ = true;
    else if (keyword == "END")
      end_object();
    else if (keyword == "GOCAD")
      begin_object();
    else if (keyword == "HEADER")
      skip_header();
    else
      soup_.losses.add("lines that begin with " + in_quotes(keyword));
  }

  /// Names and looks, in braces.
  void skip_header() {
    std::string_view line = lines_.rest_of_line();
    while (line.find('}') == std::string_view::npos && lines_.next_line())
      line = lines_.rest_of_line();
  }

  void begin_object() {
    is_in_object_ = true;
    vertices_.clear();
    soup_.losses.add("the separation into surfaces");
  }

  void end_object() {
    if (!has_surface_)
      lines_.fail("'END' before 'TFACE'");
    is_in_object_ = has_surface_ = false;
  }

  void read_vertex() {
    define(lines_.next_integer("vertex number"), static_cast<std::uint32_t>(soup_.points.size()));
    const double x = lines_.next_number("coordinate");
    const double y = lines_.next_number("coordinate");
    soup_.points.emplace_back(x, y, lines_.next_number("coordinate"));
    if (!lines_.at_line_end())
      soup_.losses.add("properties of vertices");
  }

  /// Another number for a vertex.
  void read_alias() {
    const std::int64_t number = lines_.next_integer("vertex number");
    define(number, next_vertex());
  }

  void read_triangle() {
    for (int corner = 0; corner < 3; ++corner)
      soup_.corners.push_back(next_vertex());
    soup_.end_polygon();
  }

  void define(std::int64_t number, std::uint32_t point) {
    if (!vertices_.emplace(number, point).second)
      lines_.fail("vertex number " + std::to_string(number) + " is defined twice");
  }

  std::uint32_t next_vertex() {
    const std::int64_t number = lines_.next_integer("vertex number");
    const auto vertex = vertices_.find(number);
    if (vertex == vertices_.end())
      lines_.fail("vertex number " + std::to_string(number) + " is not defined");
    return vertex->second;
  }

  LineReader lines_;
  bool is_in_object_ = true;
  bool has_surface_ = false;                                 // this object
  std::unordered_map<std::int64_t, std::uint32_t> vertices_; // of this object, by their numbers
  PolygonSoup soup_;
};

inline std::string encode_gocad(const IndexedMesh& mesh) {
  std::ostringstream stream;
  stream.precision(std::numeric_limits<double>::max_digits10);
  CGAL::IO::write_GOCAD(stream, mesh.points, mesh.triangles);
  return std::move(stream).str();
}

} // namespace quadrille_examples

#endif
