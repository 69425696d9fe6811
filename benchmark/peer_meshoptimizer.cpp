// SPDX-License-Identifier: MIT
//
// meshoptimizer works on float positions and keeps input positions: its answer names input
// vertices.

#include "contender.h"

#ifndef BENCH_WITH_MESHOPTIMIZER
std::vector<bench::Contender> bench::meshoptimizer_contenders() {
  return {};
}
#else

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <meshoptimizer.h>

namespace bench {
namespace {

/// Indexed triangles over float positions, as meshoptimizer wants them. Positions are relative to
/// the centre of the box, so that no digit goes into where the model lies.
struct Arrays {
  std::vector<float> positions;
  std::vector<unsigned int> indices;
};

Arrays to_arrays(const Soup& soup) {
  const CGAL::Bbox_3 box = CGAL::bbox_3(soup.points.begin(), soup.points.end());
  Arrays arrays;
  arrays.positions.reserve(soup.points.size() * 3);
  arrays.indices.reserve(soup.triangles.size() * 3);
  for (const Point& p : soup.points)
    for (int i = 0; i < 3; ++i)
      arrays.positions.push_back(static_cast<float>(p[i] - (box.min(i) + box.max(i)) / 2));
  for (const auto& triangle : soup.triangles)
    arrays.indices.insert(arrays.indices.end(), triangle.begin(), triangle.end());
  return arrays;
}

/// The triangles named by `indices`, with those of the input points that they use.
Soup used_part(const Soup& input, const std::vector<unsigned int>& indices) {
  constexpr auto unused = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> number(input.points.size(), unused);
  Soup part;
  part.triangles.resize(indices.size() / 3);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    std::uint32_t& n = number[indices[i]];
    if (n == unused) {
      n = static_cast<std::uint32_t>(part.points.size());
      part.points.push_back(input.points[indices[i]]);
    }
    part.triangles[i / 3][i % 3] = n;
  }
  return part;
}

/// `simplify` is called as meshopt_simplify() is but for its last arguments.
template <class Simplify>
Answer simplify_by(Mesh& mesh, const Simplify& simplify) {
  const Soup input = to_soup(mesh);
  const Arrays arrays = to_arrays(input);
  std::vector<unsigned int> result(arrays.indices.size());
  const Stopwatch stopwatch;
  const std::size_t size =
      simplify(result.data(), arrays.indices.data(), arrays.indices.size(), arrays.positions.data(),
               arrays.positions.size() / 3, 3 * sizeof(float));
  const double seconds = stopwatch.seconds();
  result.resize(size);
  Soup output = used_part(input, result);
  to_mesh(output, mesh);
  return {.own_seconds = seconds, .soup = std::move(output)};
}

constexpr float any_error = 1e6f;

Answer simplify(Mesh& mesh, std::size_t faces) {
  return simplify_by(mesh, [=](auto... arguments) {
    return meshopt_simplify(arguments..., faces * 3, any_error, 0, nullptr);
  });
}

Answer simplify_sloppily(Mesh& mesh, std::size_t faces) {
  return simplify_by(mesh, [=](auto... arguments) {
    return meshopt_simplifySloppy(arguments..., faces * 3, any_error, nullptr);
  });
}

} // namespace

std::vector<Contender> meshoptimizer_contenders() {
  return {{"meshoptimizer", "meshopt_simplify, options 0, no error limit; float, input positions",
           simplify},
          {"meshoptimizer sloppy", "meshopt_simplifySloppy, no error limit; float, input positions",
           simplify_sloppily}};
}

} // namespace bench

#endif
