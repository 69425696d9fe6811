#ifndef QUADRILLE_EXAMPLES_SOUP_ARRAYS_H
#define QUADRILLE_EXAMPLES_SOUP_ARRAYS_H

/// \file
/// What meshes of files have, as `quadrille::simplified_soup` takes it and gives it.

#include "../mesh/indexed_mesh.h"

#include <quadrille/compiled.h>

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace quadrille_examples {

inline quadrille::SoupPoints soup_points(const std::vector<Point>& points) {
  quadrille::SoupPoints result;
  result.reserve(points.size());
  for (const Point& p : points)
    result.push_back({p.x(), p.y(), p.z()});
  return result;
}

inline std::vector<Point> mesh_points(const quadrille::SoupPoints& points) {
  std::vector<Point> result;
  result.reserve(points.size());
  for (const auto& [x, y, z] : points)
    result.emplace_back(x, y, z);
  return result;
}

/// Takes the surface with which a run has begun from its result: without points and triangles, if
/// it is the input.
inline quadrille::PreparedSurface begun_surface(quadrille::SoupResult& result) {
  quadrille::PreparedSurface begun = std::move(result.prepared);
  if (begun.points.empty())
    begun.vertex_map = std::move(result.vertex_map);
  return begun;
}

/// A channel of values of corners, which it looks at.
template <std::size_t N>
quadrille::SoupChannelView view_of(const CornerValues<N>& corners,
                                   quadrille::SoupChannelView::Kind kind,
                                   quadrille::ChannelOptions options) {
  const double* const numbers = corners.values.empty() ? nullptr : corners.values.front().data();
  return {.kind = kind,
          .components = N,
          .values = std::span(numbers, N * corners.values.size()),
          .triangles = corners.triples,
          .options = std::move(options)};
}

/// Gives corners the values of a channel.
template <std::size_t N>
void take(CornerValues<N>& corners, quadrille::SoupChannel channel) {
  corners.values.resize(channel.values.size() / N);
  for (std::size_t i = 0; i < channel.values.size(); ++i)
    corners.values[i / N][i % N] = channel.values[i];
  corners.triples = std::move(channel.triangles);
}

} // namespace quadrille_examples

#endif
