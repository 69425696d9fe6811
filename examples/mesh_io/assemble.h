#ifndef QUADRILLE_EXAMPLES_MESH_IO_ASSEMBLE_H
#define QUADRILLE_EXAMPLES_MESH_IO_ASSEMBLE_H

/// \file
/// From what a file says to a triangle soup: checked, triangulated, cleaned.

#include "indexed_mesh.h"
#include "polygon_soup.h"
#include "text.h"
#include "triangulate.h"
#include "weld.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace quadrille_examples {

class Assembly {
public:
  Assembly(PolygonSoup soup, const std::filesystem::path& path)
      : soup_(std::move(soup)), path_(path) {}

  IndexedMesh mesh(Weld weld) {
    mesh_.remarks = std::move(soup_.remarks);
    mesh_.losses = std::move(soup_.losses);
    mesh_.points = std::move(soup_.points);
    mesh_.is_blank = mesh_.points.empty() && soup_.polygon_ends.empty();
    if (mesh_.points.size() > most_points)
      fail(path_, "more vertices than 32-bit indices can tell apart");
    require_finite_corners();
    convert_colors();
    convert_textures();
    triangulate();
    drop_points_that_are_not_finite();
    if (weld == Weld::always || is_loose()) {
      const Welded welded = weld_points(mesh_, weld);
      remark(welded.vertices, "vertices welded to another at the same place");
      if (welded.unlike > 0)
        mesh_.losses.add("colours or texture coordinates of welded vertices that differ from the "
                         "first's: " +
                         std::to_string(welded.unlike));
    } else if (soup_.has_normals) {
      remark(weld_split_normals(mesh_),
             "vertices that differed by their normals only, which are not kept, made one");
    }
    drop_degenerate_triangles();
    return std::move(mesh_);
  }

private:
  static bool is_finite(const Point& p) {
    return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
  }

  void remark(std::size_t count, const char* what) {
    if (count > 0)
      mesh_.remarks.push_back(what + (": " + std::to_string(count)));
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
      if (const auto guess = guess_unit(mesh_.colors, mesh_.color_type))
        mesh_.remarks.push_back(*guess);
    const auto [not_numbers, out_of_range] = mend_colors(mesh_.colors, mesh_.color_type);
    remark(not_numbers, "colour values that are not numbers, taken as 0");
    remark(out_of_range, "colour values out of range, taken as its nearest end");
  }

  void convert_textures() {
    mesh_.texture_coordinates = std::move(soup_.texture_coordinates);
    if (!soup_.corner_textures.empty())
      gather_corner_textures();
    std::size_t not_finite = 0;
    for (auto& [u, v] : mesh_.texture_coordinates)
      if (!std::isfinite(u) || !std::isfinite(v)) {
        u = v = 0;
        ++not_finite;
      }
    remark(not_finite, "texture coordinates that are not finite, taken as 0");
  }

  /// A vertex on a seam has one texture coordinate on each side. Splitting it would cut the surface
  /// open, so it stays one vertex and keeps the first.
  void gather_corner_textures() {
    constexpr std::array<double, 2> none = {0, 0};
    std::vector<bool> is_set(mesh_.points.size());
    std::vector<bool> is_on_seam(mesh_.points.size());
    mesh_.texture_coordinates.assign(mesh_.points.size(), none);
    for (std::size_t i = 0; i < soup_.corner_textures.size(); ++i) {
      if (soup_.corner_textures[i] == PolygonSoup::no_texture)
        continue;
      const std::uint32_t point = soup_.corners[i];
      const std::array<double, 2>& texture = soup_.texture_table[soup_.corner_textures[i]];
      if (!is_set[point])
        mesh_.texture_coordinates[point] = texture;
      else if (texture != mesh_.texture_coordinates[point])
        is_on_seam[point] = true;
      is_set[point] = true;
    }
    const auto count = std::count(is_on_seam.begin(), is_on_seam.end(), true);
    if (count > 0)
      mesh_.losses.add("all but one of the texture coordinates of vertices on seams: " +
                       std::to_string(count));
  }

  void triangulate() {
    std::size_t too_few_corners = 0, not_simple = 0;
    std::vector<std::uint32_t> polygon;
    mesh_.triangles.reserve(soup_.polygon_ends.size());
    for (std::size_t i = 0; i < soup_.polygon_ends.size(); ++i) {
      const std::span<const std::uint32_t> written = soup_.polygon(i);
      polygon.assign(written.begin(), written.end());
      polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
      while (polygon.size() > 1 && polygon.front() == polygon.back())
        polygon.pop_back();
      if (polygon.size() < 3)
        ++too_few_corners;
      else if (polygon.size() == 3)
        mesh_.triangles.push_back({polygon[0], polygon[1], polygon[2]});
      else if (!PolygonTriangulation(mesh_.points, polygon).append_to(mesh_.triangles)) {
        ++not_simple;
        append_fan(polygon);
      }
    }
    remark(too_few_corners, "faces left out for having fewer than three different corners");
    remark(not_simple, "polygons cut into fans for being flat or crossing themselves");
  }

  void append_fan(const std::vector<std::uint32_t>& polygon) {
    for (std::size_t i = 2; i < polygon.size(); ++i)
      mesh_.triangles.push_back({polygon[0], polygon[i - 1], polygon[i]});
  }

  void drop_points_that_are_not_finite() {
    std::vector<bool> kept(mesh_.points.size());
    std::transform(mesh_.points.begin(), mesh_.points.end(), kept.begin(), is_finite);
    const auto dropped = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), false));
    if (dropped == 0)
      return;
    keep_points(mesh_, kept);
    remark(dropped, "vertices without a face left out for not being finite");
  }

  /// No two polygons share a vertex, as in a file of a format, or from a program, that knows no
  /// indices.
  bool is_loose() const {
    std::vector<bool> is_used(mesh_.points.size());
    for (const std::uint32_t corner : soup_.corners) {
      if (is_used[corner])
        return false;
      is_used[corner] = true;
    }
    return soup_.polygon_ends.size() > 1;
  }

  void drop_degenerate_triangles() {
    const auto is_degenerate = [](const std::array<std::uint32_t, 3>& t) {
      return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
    };
    remark(std::erase_if(mesh_.triangles, is_degenerate),
           "triangles left out for having two equal corners");
  }

  PolygonSoup soup_;
  const std::filesystem::path& path_;
  IndexedMesh mesh_;
};

} // namespace quadrille_examples

#endif
