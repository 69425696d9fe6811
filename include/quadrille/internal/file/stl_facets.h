#ifndef QUADRILLE_INTERNAL_FILE_STL_FACETS_H
#define QUADRILLE_INTERNAL_FILE_STL_FACETS_H

#include <quadrille/internal/core/base/little_endian.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

/// \file
/// The layout of a binary STL file. It gives every facet points of its own.

namespace quadrille::internal {

inline constexpr std::size_t stl_header_size = 84; ///< 80 arbitrary bytes and the facet count
inline constexpr std::size_t stl_facet_size = 50;  ///< a normal, three points and an attribute

/// Reads the number of facets from the header.
inline std::uint64_t stl_facet_count(std::string_view header) {
  return little_endian_at<std::uint32_t>(header, stl_header_size - 4);
}

/// A facet without its normal, which follows from its points.
struct StlFacet {
  explicit StlFacet(std::string_view bytes)
      : attribute(little_endian_at<std::uint16_t>(bytes, stl_facet_size - 2)) {
    for (std::size_t corner = 0; corner < 3; ++corner)
      for (std::size_t axis = 0; axis < 3; ++axis)
        points[corner][axis] = little_endian_at<float>(bytes, 12 * (corner + 1) + 4 * axis);
  }

  std::array<std::array<float, 3>, 3> points;
  std::uint16_t attribute;
};

/// Does a facet have its own colour, with five bits for each component? If the header names a
/// colour for all facets, as Magics does, each attribute is a colour; otherwise, as in VisCAM and
/// SolidView, it is one if its highest bit is set.
inline bool names_stl_color(std::string_view header) {
  return header.substr(0, stl_header_size - 4).find("COLOR=") != std::string_view::npos;
}
inline bool is_stl_color(std::uint16_t attribute, bool header_names_color) {
  return header_names_color || (attribute & 0x8000) != 0;
}

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_FILE_STL_FACETS_H
