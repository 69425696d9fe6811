// SPDX-License-Identifier: MIT
#include "measure.h"

#include "../mesh_io/mesh/indexed_mesh.h"

#include <quadrille/distance.h>

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace quadrille_examples {

namespace {

bool has_textures(const IndexedMesh& mesh) {
  return !mesh.corner_textures.empty() || !mesh.texture_coordinates.empty();
}

/// Of the faces that have a texture; materials are labels.
quadrille::TexturedSoup textured_soup(const IndexedMesh& mesh) {
  quadrille::TexturedSoup soup;
  for (const Point& p : mesh.points)
    soup.shape.points.push_back({p.x(), p.y(), p.z()});
  const bool has_corners = !mesh.corner_textures.empty();
  for (const auto& [u, v] : has_corners ? mesh.corner_textures.values : mesh.texture_coordinates)
    soup.texture.points.push_back({u, v});
  const FaceParts& parts = mesh.parts;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const FacePart* const part = parts.of_faces.empty() ? nullptr : &parts.parts[parts.of_faces[t]];
    if (has_corners && part && !part->has_textures)
      continue;
    soup.shape.triangles.push_back(mesh.triangles[t]);
    soup.texture.triangles.push_back(has_corners ? mesh.corner_textures.triples[t]
                                                 : value_triangles(mesh)[t]);
    soup.labels.push_back(part ? part->material : 0);
  }
  return soup;
}

double area(const IndexedMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += std::sqrt(CGAL::squared_area(mesh.points[a], mesh.points[b], mesh.points[c]));
  return sum;
}

} // namespace

std::optional<Measurement> measure(const IndexedMesh& input, const IndexedMesh& result) {
  if (input.triangles.empty() || result.triangles.empty())
    return std::nullopt;
  const quadrille::SurfaceDistance distance =
      quadrille::surface_distance(result.points, result.triangles, input.points, input.triangles);
  Measurement measured{.area = area(result),
                       .rms = distance.rms,
                       .greatest = distance.hausdorff,
                       .to_input = distance.hausdorff_a_to_b,
                       .from_input = distance.hausdorff_b_to_a,
                       .texture = std::nullopt};
  if (const auto texture = measure_texture(input, result))
    measured.texture = texture->deviation;
  return measured;
}

std::optional<TextureMeasurement> measure_texture(const IndexedMesh& input,
                                                  const IndexedMesh& result) {
  if (!has_textures(input) || !has_textures(result))
    return std::nullopt;
  const quadrille::TexturedSoup before = textured_soup(input), after = textured_soup(result);
  if (before.shape.triangles.empty() || after.shape.triangles.empty())
    return std::nullopt;
  return TextureMeasurement{area(result), quadrille::texture_deviation(after, before)};
}

std::optional<quadrille::TextureDeviation> united(const std::vector<TextureMeasurement>& surfaces) {
  quadrille::TextureDeviation texture;
  double sum = 0;
  for (const auto& [area, one] : surfaces) {
    sum += area;
    texture.rms += area * one.rms * one.rms;
    texture.bleeding += area * one.bleeding;
    texture.flipped += area * one.flipped;
    texture.greatest = std::max(texture.greatest, one.greatest);
    texture.percentile_99 = std::max(texture.percentile_99, one.percentile_99);
  }
  if (!(sum > 0))
    return std::nullopt;
  texture.rms = std::sqrt(texture.rms / sum);
  texture.bleeding /= sum;
  texture.flipped /= sum;
  return texture;
}

} // namespace quadrille_examples
