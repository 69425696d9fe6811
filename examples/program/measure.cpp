// SPDX-License-Identifier: MIT
// It includes <quadrille/distance.h>, which includes GPL parts of CGAL.
#include "measure.h"

#include "../mesh_io/indexed_mesh.h"

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
    soup.points.push_back({p.x(), p.y(), p.z()});
  const bool has_corners = !mesh.corner_textures.empty();
  for (const auto& [u, v] : has_corners ? mesh.corner_textures.values : mesh.texture_coordinates)
    soup.coordinates.push_back({u, v});
  const FaceParts& parts = mesh.parts;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const FacePart* const part = parts.of_faces.empty() ? nullptr : &parts.parts[parts.of_faces[t]];
    if (has_corners && part && !part->has_textures)
      continue;
    const auto& [a, b, c] = mesh.triangles[t];
    const auto& [p, q, r] =
        has_corners ? mesh.corner_textures.triples[t] : value_triangles(mesh)[t];
    soup.triangles.push_back({a, b, c});
    soup.coordinate_triangles.push_back({p, q, r});
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
  if (has_textures(input) && has_textures(result))
    measured.texture = quadrille::texture_deviation(textured_soup(result), textured_soup(input));
  return measured;
}

Measurement united(const std::vector<Measurement>& surfaces) {
  Measurement sum;
  quadrille::TextureDeviation texture;
  double textured_area = 0;
  for (const Measurement& one : surfaces) {
    sum.area += one.area;
    sum.rms += one.area * one.rms * one.rms;
    sum.greatest = std::max(sum.greatest, one.greatest);
    sum.to_input = std::max(sum.to_input, one.to_input);
    sum.from_input = std::max(sum.from_input, one.from_input);
    if (!one.texture)
      continue;
    textured_area += one.area;
    texture.rms += one.area * one.texture->rms * one.texture->rms;
    texture.bleeding += one.area * one.texture->bleeding;
    texture.flipped += one.area * one.texture->flipped;
    texture.greatest = std::max(texture.greatest, one.texture->greatest);
    texture.percentile_99 = std::max(texture.percentile_99, one.texture->percentile_99);
  }
  if (sum.area > 0)
    sum.rms = std::sqrt(sum.rms / sum.area);
  if (textured_area > 0) {
    texture.rms = std::sqrt(texture.rms / textured_area);
    texture.bleeding /= textured_area;
    texture.flipped /= textured_area;
    sum.texture = texture;
  }
  return sum;
}

} // namespace quadrille_examples
