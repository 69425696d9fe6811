#ifndef QUADRILLE_EXAMPLES_FIGURES_GENERATE_H
#define QUADRILLE_EXAMPLES_FIGURES_GENERATE_H

#include "surfaces.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

/// Surfaces for the figures whose models are not to be had.

namespace figures {

/// Adds columns × rows squares, each cut into two triangles; position(s, t) is the point at s and t
/// from 0 to 1. Returns the vertices, row by row.
inline std::vector<Vertex> add_grid(Mesh& mesh, std::size_t columns, std::size_t rows,
                                    const auto& position) {
  std::vector<Vertex> vertices;
  for (std::size_t j = 0; j <= rows; ++j)
    for (std::size_t i = 0; i <= columns; ++i)
      vertices.push_back(
          mesh.add_vertex(position(static_cast<double>(i) / static_cast<double>(columns),
                                   static_cast<double>(j) / static_cast<double>(rows))));
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      const std::size_t at = j * (columns + 1) + i, above = at + columns + 1;
      mesh.add_face(vertices[at], vertices[at + 1], vertices[above + 1]);
      mesh.add_face(vertices[at], vertices[above + 1], vertices[above]);
    }
  return vertices;
}

/// A tube of columns × rows squares that closes after its columns; position(angle, t) is the point
/// at an angle, and at t from 0 to 1 along the tube.
inline Mesh tube(std::size_t columns, std::size_t rows, const auto& position) {
  Mesh mesh;
  std::vector<Vertex> vertices;
  for (std::size_t j = 0; j <= rows; ++j)
    for (std::size_t i = 0; i < columns; ++i)
      vertices.push_back(mesh.add_vertex(
          position(2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(columns),
                   static_cast<double>(j) / static_cast<double>(rows))));
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      const std::size_t at = j * columns + i, right = j * columns + (i + 1) % columns;
      mesh.add_face(vertices[at], vertices[right], vertices[right + columns]);
      mesh.add_face(vertices[at], vertices[right + columns], vertices[at + columns]);
    }
  return mesh;
}

/// The wall of a cylinder of radius 1 around the z axis, open at z = 0 and z = height. Each row is
/// turned by half a column against the one below, so that no edge runs along the wall.
inline Mesh cylinder_wall(std::size_t columns, std::size_t rows, double height) {
  const double turn = std::numbers::pi * static_cast<double>(rows) / static_cast<double>(columns);
  return tube(columns, rows, [=](double angle, double t) {
    return Point(std::cos(angle - turn * t), std::sin(angle - turn * t), height * t);
  });
}

/// A ball of `columns` × `rows` squares, with triangles around both poles: 2 · columns · (rows − 1)
/// faces. radius(direction) is how far the surface is from the centre in a direction.
inline Mesh ball(std::size_t columns, std::size_t rows, const auto& radius) {
  const auto place = [&](double angle, double polar) {
    const Point direction(std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle),
                          -std::cos(polar));
    return CGAL::ORIGIN + radius(direction) * (direction - CGAL::ORIGIN);
  };
  const double step = std::numbers::pi / static_cast<double>(rows);
  Mesh mesh = tube(columns, rows - 2, [&](double angle, double t) {
    return place(angle, step + (std::numbers::pi - 2 * step) * t);
  });
  const std::size_t last = columns * (rows - 2);
  const auto vertex = [](std::size_t i) { return Vertex(static_cast<Vertex::size_type>(i)); };
  const Vertex south = mesh.add_vertex(place(0, 0));
  const Vertex north = mesh.add_vertex(place(0, std::numbers::pi));
  for (std::size_t i = 0; i < columns; ++i) {
    const std::size_t next = (i + 1) % columns;
    mesh.add_face(south, vertex(next), vertex(i));
    mesh.add_face(north, vertex(last + i), vertex(last + next));
  }
  return mesh;
}

inline Mesh sphere(std::size_t columns, std::size_t rows) {
  return ball(columns, rows, [](const Point&) { return 1.0; });
}

/// columns × rows separate cubes of edge 1 in a layer, `gap` apart. Opposite sides are cut into
/// triangles alike, so that neighbours can grow together without a trace.
inline Soup cubes(std::size_t columns, std::size_t rows, double gap) {
  // Corner i is at the bits of i; each diagonal runs from the lowest to the highest corner.
  constexpr std::array<std::array<std::size_t, 3>, 12> triangles = {{{0, 6, 2},
                                                                     {0, 4, 6},
                                                                     {1, 3, 7},
                                                                     {1, 7, 5},
                                                                     {0, 1, 5},
                                                                     {0, 5, 4},
                                                                     {2, 7, 3},
                                                                     {2, 6, 7},
                                                                     {0, 3, 1},
                                                                     {0, 2, 3},
                                                                     {4, 5, 7},
                                                                     {4, 7, 6}}};
  Soup soup;
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      const std::size_t first = soup.points.size();
      for (std::size_t corner = 0; corner < 8; ++corner)
        soup.points.emplace_back(static_cast<double>(i) * (1 + gap) + (corner & 1 ? 1 : 0),
                                 static_cast<double>(j) * (1 + gap) + (corner & 2 ? 1 : 0),
                                 corner & 4 ? 1 : 0);
      for (const auto& [a, b, c] : triangles)
        soup.triangles.push_back({first + a, first + b, first + c});
    }
  return soup;
}

} // namespace figures

#endif
