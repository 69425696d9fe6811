// Vertex clustering of a binary PLY file, in memory: a row of benchmark/out_of_core_peers.py.
//   clustered IN.ply OUT.ply FACES
#include <quadrille/cluster.h>
#include <quadrille/internal/file/chunk_merge.h>
#include <quadrille/internal/file/ply_input.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace {

using namespace quadrille;
using Points = std::vector<std::array<float, 3>>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

void write(const char* path, const Points& points, const Triangles& triangles) {
  internal::WholeFile file(path);
  internal::PlyBytes bytes(file);
  bytes.put_text(
      "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(points.size()) +
      "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
      std::to_string(triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n");
  for (const auto& p : points)
    for (const float x : p)
      bytes.put(x);
  for (const auto& t : triangles) {
    bytes.put(static_cast<unsigned char>(3));
    for (const std::uint32_t v : t)
      bytes.put(v);
  }
  bytes.flush();
  file.finish();
}

} // namespace

int main(int argc, char* argv[]) {
  try {
    if (argc != 4)
      throw std::runtime_error("clustered IN.ply OUT.ply FACES");
    Points points;
    Triangles triangles;
    {
      const internal::PlyInput ply(argv[1], true);
      ply.for_vertices([&](internal::VertexId, const Vector<3>& p) {
        points.push_back(
            {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
      });
      ply.for_faces(
          [&](std::uint64_t, const internal::FaceRow& f, const auto&) { triangles.push_back(f); });
    }
    cluster_vertices(points, triangles, FaceCount{static_cast<std::size_t>(std::stod(argv[3]))});
    write(argv[2], points, triangles);
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
