#ifndef QUADRILLE_EXAMPLES_MESH_IO_STL_H
#define QUADRILLE_EXAMPLES_MESH_IO_STL_H

/// \file
/// Stereolithography files, binary or text. They give every facet points of its own.

#include "../mesh/indexed_mesh.h"
#include "../mesh/polygon_soup.h"
#include "../text.h"

#include <quadrille/internal/file/stl_facets.h>

#include <CGAL/IO/STL.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace quadrille_examples {

using quadrille::internal::is_stl_color;
using quadrille::internal::names_stl_color;
using quadrille::internal::stl_facet_size;
using quadrille::internal::stl_header_size;
using quadrille::internal::StlFacet;

/// The facets, which a file has in full, with their colours as a number of each that a mesh carries
/// along: 0 where there is none.
inline PolygonSoup read_stl_facets(std::string_view bytes, std::size_t facets) {
  PolygonSoup soup;
  NamedNumbers colors{stl_color_name, {2, true, false}, {}};
  bool is_any = false;
  for (std::size_t i = 0; i < facets; ++i) {
    const StlFacet facet(bytes.substr(stl_header_size + i * stl_facet_size, stl_facet_size));
    for (const std::array<float, 3>& p : facet.points) {
      soup.corners.push_back(static_cast<std::uint32_t>(soup.points.size()));
      soup.points.emplace_back(p[0], p[1], p[2]);
    }
    soup.end_polygon();
    const bool is_color = is_stl_color(facet.attribute, names_stl_color(bytes));
    colors.values.push_back(is_color ? facet.attribute : 0);
    is_any |= is_color;
    if (facet.attribute != 0 && !is_color)
      soup.losses.add("attributes of facets that are not colours");
  }
  if (is_any) {
    soup.face_numbers.push_back(std::move(colors));
    if (names_stl_color(bytes))
      soup.stl_header = bytes.substr(0, stl_header_size - 4);
  }
  return soup;
}

inline PolygonSoup read_binary_stl(const Source& source) {
  const std::string_view bytes = source.content;
  if (bytes.size() < stl_header_size)
    fail(source.path, "neither a text STL file nor long enough for a binary one");
  const std::uint64_t facets = quadrille::internal::stl_facet_count(bytes);
  const std::uint64_t held = (bytes.size() - stl_header_size) / stl_facet_size;
  if (held < facets)
    fail(source.path, ends_before("facet", held, facets));
  if (held > facets) // they would be lost in silence
    fail(source.path, "the file goes on after the last of " + std::to_string(facets) + " facets");

  PolygonSoup soup = read_stl_facets(bytes, facets);
  if (bytes.size() != stl_header_size + facets * stl_facet_size)
    soup.remarks.push_back("the bytes after the last facet are left out");
  return soup;
}

/// Goes by the words, in any case of letters and however they are spread over lines. `endloop`,
/// `endfacet` and `endsolid` may be two words. What follows a keyword in its line and is none
/// itself is passed over.
class StlTextReader {
public:
  explicit StlTextReader(const Source& source) : lines_(source, Comments::absent) {
    require_text(source);
  }

  PolygonSoup read() {
    while (lines_.next_line())
      read_line();
    if (is_in_solid_)
      lines_.fail("the file ends before 'endsolid'");
    if (solids_ > 1)
      soup_.losses.add("solids");
    return std::move(soup_);
  }

private:
  void read_line() {
    if (lines_.peek_word().starts_with('#'))
      return;
    const std::string_view first = next_keyword();
    if (!read_keyword(first))
      lines_.fail("unknown keyword " + in_quotes(first));
    while (!lines_.at_line_end())
      read_keyword(next_keyword());
  }

  /// A word, or `end` with the word behind it.
  std::string_view next_keyword() {
    const std::string_view word = lines_.next_word();
    ended_ = equal_ignoring_case(word, "end")                ? lines_.next_word()
             : equal_ignoring_case(word.substr(0, 3), "end") ? word.substr(3)
                                                             : std::string_view();
    return word;
  }

  /// False if the word is no keyword.
  bool read_keyword(std::string_view word) {
    if (!ended_.empty())
      return read_end();
    if (equal_ignoring_case(word, "vertex"))
      read_vertex();
    else if (equal_ignoring_case(word, "facet"))
      enter_facet(word);
    else if (equal_ignoring_case(word, "solid"))
      enter_solid(word);
    else
      return equal_ignoring_case(word, "outer") || equal_ignoring_case(word, "loop");
    return true;
  }

  bool read_end() {
    if (equal_ignoring_case(ended_, "solid")) {
      leave(is_in_solid_, !is_in_facet_, "'endsolid'");
      skip_name();
    } else if (equal_ignoring_case(ended_, "facet"))
      end_facet();
    else
      return equal_ignoring_case(ended_, "loop");
    return true;
  }

  void enter_solid(std::string_view word) {
    enter(is_in_solid_, !is_in_solid_, word);
    ++solids_;
    skip_name();
  }

  /// The words of a name, to the end of the line or to what can be none: the next solid or facet.
  void skip_name() {
    while (!lines_.at_line_end()) {
      LineReader ahead = lines_;
      const std::string_view word = ahead.next_word();
      const bool begins_facet =
          equal_ignoring_case(word, "facet") && equal_ignoring_case(ahead.peek_word(), "normal");
      const bool ends_solid =
          equal_ignoring_case(word, "endsolid") ||
          (equal_ignoring_case(word, "end") && equal_ignoring_case(ahead.peek_word(), "solid"));
      if (begins_facet || (is_in_solid_ && ends_solid) ||
          (!is_in_solid_ && equal_ignoring_case(word, "solid") && has_facet(ahead)))
        return;
      lines_.next_word();
    }
  }

  /// Does a facet begin in the rest of the line?
  static bool has_facet(LineReader line) {
    while (!line.at_line_end())
      if (equal_ignoring_case(line.next_word(), "facet") &&
          equal_ignoring_case(line.peek_word(), "normal"))
        return true;
    return false;
  }

  /// The normal follows from the vertices; where there is none, some programs write words.
  void enter_facet(std::string_view word) {
    enter(is_in_facet_, is_in_solid_, word);
    if (!equal_ignoring_case(lines_.peek_word(), "normal"))
      return;
    for (int i = 0; i < 4; ++i)
      lines_.next_word();
  }

  void enter(bool& state, bool is_allowed, std::string_view word) {
    if (state || !is_allowed)
      lines_.fail(in_quotes(word) + " is out of place");
    state = true;
  }

  void leave(bool& state, bool is_allowed, const std::string& word) {
    if (!state || !is_allowed)
      lines_.fail(word + " is out of place");
    state = false;
  }

  void end_facet() {
    leave(is_in_facet_, true, "'endfacet'");
    if (corners_of_facet_ < 3)
      lines_.fail("a facet of " + std::to_string(corners_of_facet_) + " vertices");
    corners_of_facet_ = 0;
    soup_.end_polygon();
  }

  void read_vertex() {
    if (!is_in_facet_)
      lines_.fail("a vertex outside of a facet");
    const double x = lines_.next_number("coordinate");
    const double y = lines_.next_number("coordinate");
    soup_.corners.push_back(static_cast<std::uint32_t>(soup_.points.size()));
    soup_.points.emplace_back(x, y, lines_.next_number("coordinate"));
    ++corners_of_facet_;
  }

  LineReader lines_;
  std::string_view ended_; // what the last word says the end of, if so
  bool is_in_solid_ = false;
  bool is_in_facet_ = false;
  std::size_t solids_ = 0;
  std::size_t corners_of_facet_ = 0;
  PolygonSoup soup_;
};

/// Some binary files start with `solid` too, but there is a zero byte in the facet count.
inline bool is_binary_stl(const Source& source) {
  LineReader lines(source);
  lines.next_line();
  return source.content.find('\0') != std::string::npos ||
         !equal_ignoring_case(lines.peek_word(), "solid");
}

inline PolygonSoup read_stl(const Source& source) {
  return is_binary_stl(source) ? read_binary_stl(source) : StlTextReader(source).read();
}

/// Writes the header and the attributes of facets into a binary file: colours, and 0 where there is
/// none.
inline void put_stl_colors(const IndexedMesh& mesh, std::string& bytes) {
  const NamedNumbers* const colors = stl_colors(mesh);
  if (colors && !mesh.stl_header.empty())
    bytes.replace(0, mesh.stl_header.size(), mesh.stl_header);
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
    std::string attribute;
    append_little_endian(attribute, static_cast<std::uint16_t>(colors ? colors->values[face] : 0));
    bytes.replace(stl_header_size + (face + 1) * stl_facet_size - 2, 2, attribute);
  }
}

/// Binary, hence with coordinates of type `float`.
inline std::string encode_stl(const IndexedMesh& mesh) {
  std::vector<Point> rounded; // beforehand, lest CGAL divide by lengths that underflow
  const auto round = [](double coordinate) {
    if (std::abs(coordinate) > std::numeric_limits<float>::max())
      throw std::runtime_error("a coordinate is too large for STL, which uses single precision");
    return double{static_cast<float>(coordinate)};
  };
  for (const Point& p : mesh.points)
    rounded.emplace_back(round(p.x()), round(p.y()), round(p.z()));
  std::ostringstream stream;
  CGAL::IO::set_binary_mode(stream);
  CGAL::IO::write_STL(stream, rounded, mesh.triangles);
  std::string bytes = std::move(stream).str();
  put_stl_colors(mesh, bytes);
  return bytes;
}

} // namespace quadrille_examples

#endif
