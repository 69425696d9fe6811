// SPDX-License-Identifier: MIT

#include "contender.h"

#include <cstdint>
#include <random>

namespace bench {

Soup to_soup(const Mesh& mesh) {
  Soup soup;
  soup.points.reserve(mesh.number_of_vertices());
  soup.triangles.reserve(mesh.number_of_faces());
  std::vector<std::uint32_t> number(mesh.num_vertices());
  for (const auto v : mesh.vertices()) {
    number[v] = static_cast<std::uint32_t>(soup.points.size());
    soup.points.push_back(mesh.point(v));
  }
  for (const auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    soup.triangles.push_back(
        {number[mesh.source(h)], number[mesh.target(h)], number[mesh.target(mesh.next(h))]});
  }
  return soup;
}

void to_mesh(const Soup& soup, Mesh& mesh) {
  using Vertex = Mesh::Vertex_index;
  mesh.clear();
  mesh.reserve(static_cast<Mesh::size_type>(soup.points.size()),
               static_cast<Mesh::size_type>(soup.triangles.size() * 3 / 2),
               static_cast<Mesh::size_type>(soup.triangles.size()));
  for (const Point& p : soup.points)
    mesh.add_vertex(p);
  for (const auto& [a, b, c] : soup.triangles) {
    if (mesh.add_face(Vertex(a), Vertex(b), Vertex(c)) == Mesh::null_face())
      mesh.add_face(mesh.add_vertex(soup.points[a]), mesh.add_vertex(soup.points[b]),
                    mesh.add_vertex(soup.points[c]));
  }
}

double mean_edge_length(const Mesh& mesh) {
  double sum = 0;
  for (const auto e : mesh.edges())
    sum += std::sqrt(
        CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  return mesh.number_of_edges() == 0 ? 0 : sum / static_cast<double>(mesh.number_of_edges());
}

void add_noise(Mesh& mesh, double edges, std::uint64_t seed) {
  const double amplitude = edges * mean_edge_length(mesh);
  std::mt19937_64 generator(seed);
  const auto next = [&] {
    return amplitude * (static_cast<double>(generator() >> 11) * 0x1p-52 - 1);
  };
  for (const auto v : mesh.vertices()) {
    const double x = next(), y = next(), z = next();
    mesh.point(v) = mesh.point(v) + Kernel::Vector_3(x, y, z);
  }
}

} // namespace bench
