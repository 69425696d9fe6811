#ifndef QUADRILLE_EXAMPLES_MESH_IO_ASSEMBLE_H
#define QUADRILLE_EXAMPLES_MESH_IO_ASSEMBLE_H

/// \file
/// From what a file says to a triangle soup: checked, triangulated, cleaned.

#include "../mesh_io.h"
#include "../text.h"
#include "bounding_box.h"
#include "indexed_mesh.h"
#include "polygon_soup.h"
#include "snap.h"
#include "surface_joining.h"
#include "weld.h"

#include <quadrille/internal/core/surface/polygon_cut.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace quadrille_examples {

class Assembly {
public:
  Assembly(PolygonSoup soup, const std::filesystem::path& path)
      : soup_(std::move(soup)), path_(path), keeps_corners_(!soup_.parts.of_faces.empty()) {}

  /// See read_mesh().
  IndexedMesh mesh(Weld weld, const Amount& tolerance) {
    mesh_.remarks = std::move(soup_.remarks);
    mesh_.losses = std::move(soup_.losses);
    mesh_.texture_comments = std::move(soup_.texture_comments);
    mesh_.stl_header = std::move(soup_.stl_header);
    mesh_.points = std::move(soup_.points);
    if (mesh_.points.size() > most_points)
      fail(path_, "more vertices than 32-bit indices can number");
    require_finite_corners();
    convert_colors();
    convert_textures();
    convert_normals();
    convert_numbers();
    triangulate();
    drop_degenerate_triangles();
    drop_points_that_are_not_finite();
    if (weld == Weld::places && tolerance.value > 0)
      snap(length_of(tolerance, diagonal(mesh_.points, mesh_.triangles)));
    const std::vector<std::uint32_t> firsts =
        weld == Weld::places ? first_at_places(mesh_.points)
                             : SurfaceJoining::first_vertices(mesh_.points, mesh_.triangles);
    remark(VertexJoining::join(mesh_, firsts),
           "vertices merged with another one at the same place");
    drop_degenerate_triangles();
    remark(degenerate_triangles_, "triangles left out (two equal corners)");
    return std::move(mesh_);
  }

private:
  using Triangle = std::array<std::uint32_t, 3>;

  static bool is_finite(const Point& p) {
    return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
  }

  void remark(std::size_t count, const char* what) {
    if (count > 0)
      mesh_.remarks.push_back(what + (": " + std::to_string(count)));
  }

  void snap(double tolerance) {
    if (tolerance > 0) // as a part of a diagonal it may be 0
      snap_points(mesh_.points, tolerance);
  }

  void require_finite_corners() const {
    for (const std::uint32_t corner : soup_.corners)
      if (!is_finite(mesh_.points[corner]))
        fail(path_, "vertex " + std::to_string(corner) + ", counted from 0, is not finite");
  }

  void convert_colors() {
    mesh_.colors = std::move(soup_.colors);
    mesh_.color_type = soup_.color_type;
    if (mesh_.colors.empty())
      return;
    if (!soup_.is_color_unit_certain)
      if (const auto guess = estimate_unit(mesh_.colors, mesh_.color_type))
        mesh_.remarks.push_back(*guess);
    const auto [not_numbers, out_of_range] = mend_colors(mesh_.colors, mesh_.color_type);
    remark(not_numbers, "colour values that are not numbers, replaced by 0");
    remark(out_of_range, "colour values out of range, clamped");
  }

  void convert_textures() {
    mesh_.texture_coordinates = std::move(soup_.texture_coordinates);
    mesh_.corner_textures.are_double = soup_.are_textures_double;
    if (soup_.parts.has(&FacePart::has_textures))
      mesh_.corner_textures.values = std::move(soup_.texture_table);
    remark(replace_not_finite(mesh_.texture_coordinates, {0, 0}) +
               replace_not_finite(mesh_.corner_textures.values, {0, 0}),
           "texture coordinates that are not finite, replaced by 0");
  }

  void convert_normals() {
    mesh_.corner_normals.are_double = soup_.are_normals_double;
    if (soup_.parts.has(&FacePart::has_normals))
      mesh_.corner_normals.values = std::move(soup_.normal_table);
    remark(replace_not_finite(mesh_.corner_normals.values, {0, 0, 1}),
           "normals that are not finite, replaced by (0, 0, 1)");
  }

  template <std::size_t N>
  static std::size_t replace_not_finite(std::vector<std::array<double, N>>& values,
                                        const std::array<double, N>& replacement) {
    std::size_t count = 0;
    for (std::array<double, N>& value : values)
      if (!std::all_of(value.begin(), value.end(), [](double x) { return std::isfinite(x); })) {
        value = replacement;
        ++count;
      }
    return count;
  }

  void convert_numbers() {
    mesh_.vertex_numbers = std::move(soup_.vertex_numbers);
    for (const NamedNumbers& numbers : soup_.face_numbers)
      mesh_.face_numbers.push_back({numbers.name, numbers.type, {}});
    remark(mend_numbers(mesh_.vertex_numbers) + mend_numbers(soup_.face_numbers),
           "integers out of the range of their type, clamped");
  }

  void triangulate() {
    std::size_t too_few_corners = 0, not_simple = 0;
    mesh_.triangles.reserve(soup_.polygon_ends.size());
    for (std::size_t i = 0; i < soup_.polygon_ends.size(); ++i) {
      find_corners(i);
      if (corners_.size() < 3)
        ++too_few_corners;
      else
        not_simple += !append_polygon(i);
    }
    remark(too_few_corners, "faces left out (fewer than three different corners)");
    remark(not_simple, "polygons cut into fans (without area, or crossing themselves)");
    soup_.parts.of_faces = std::move(mesh_.parts.of_faces);
    mesh_.parts = std::move(soup_.parts);
  }

  /// The corners of a polygon without those at the same point as the one before.
  void find_corners(std::size_t polygon) {
    const auto are_same = [this](std::size_t a, std::size_t b) {
      return soup_.corners[a] == soup_.corners[b];
    };
    const std::size_t begin = soup_.begin_of(polygon);
    corners_.resize(soup_.polygon_ends[polygon] - begin);
    std::iota(corners_.begin(), corners_.end(), begin);
    corners_.erase(std::unique(corners_.begin(), corners_.end(), are_same), corners_.end());
    while (corners_.size() > 1 && are_same(corners_.front(), corners_.back()))
      corners_.pop_back();
  }

  /// False if it had to be cut into a fan.
  bool append_polygon(std::size_t polygon) {
    outline_.clear();
    for (const std::size_t corner : corners_) {
      const Point& p = mesh_.points[soup_.corners[corner]];
      outline_.push_back({{p.x(), p.y(), p.z()}});
    }
    std::uint64_t fans = 0;
    for (const Triangle& triangle : quadrille::internal::PolygonCut::triangles(outline_, &fans))
      append_triangle(triangle, polygon);
    return fans == 0;
  }

  /// What has no value at its corners gets a constant one, that no face is written with.
  void append_triangle(const Triangle& triangle, std::size_t polygon) {
    const auto append = [&](auto& triples, const std::vector<std::uint32_t>& indices, bool has) {
      triples.emplace_back();
      for (std::size_t i = 0; has && i < 3; ++i)
        triples.back()[i] = indices[corners_[triangle[i]]];
    };
    append(mesh_.triangles, soup_.corners, true);
    for (std::size_t i = 0; i < mesh_.face_numbers.size(); ++i)
      mesh_.face_numbers[i].values.push_back(soup_.face_numbers[i].values[polygon]);
    if (!keeps_corners_)
      return;
    const std::uint32_t number = soup_.parts.of_faces[polygon];
    const FacePart& part = soup_.parts.parts[number];
    mesh_.parts.of_faces.push_back(number);
    if (!mesh_.corner_textures.values.empty())
      append(mesh_.corner_textures.triples, soup_.corner_textures, part.has_textures);
    if (!mesh_.corner_normals.values.empty())
      append(mesh_.corner_normals.triples, soup_.corner_normals, part.has_normals);
  }

  void drop_points_that_are_not_finite() {
    std::vector<bool> kept(mesh_.points.size());
    std::transform(mesh_.points.begin(), mesh_.points.end(), kept.begin(), is_finite);
    const auto dropped = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), false));
    if (dropped == 0)
      return;
    keep_points(mesh_, kept);
    remark(dropped, "isolated vertices left out (not finite)");
  }

  void drop_degenerate_triangles() {
    std::vector<bool> kept;
    for (const auto& [a, b, c] : mesh_.triangles)
      kept.push_back(a != b && b != c && c != a);
    degenerate_triangles_ += keep_triangles(mesh_, kept);
  }

  PolygonSoup soup_;
  const std::filesystem::path& path_;
  std::size_t degenerate_triangles_ = 0; // that went
  bool keeps_corners_;                   // does the soup say what the corners of its polygons have?
  IndexedMesh mesh_;
  std::vector<std::size_t> corners_; // of a polygon: where they are among those of the soup
  std::vector<quadrille::Vector<3>> outline_; // of a polygon: where these are
};

} // namespace quadrille_examples

#endif
