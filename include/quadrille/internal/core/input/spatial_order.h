#ifndef QUADRILLE_INTERNAL_CORE_INPUT_SPATIAL_ORDER_H
#define QUADRILLE_INTERNAL_CORE_INPUT_SPATIAL_ORDER_H

#include <quadrille/internal/core/base/digit_sort.h>
#include <quadrille/internal/core/base/ranges.h>
#include <quadrille/internal/core/base/threads.h>
#include <quadrille/internal/core/complex/triangle_complex.h>
#include <quadrille/internal/core/input/surface_input.h>
#include <quadrille/internal/core/memory/array.h>
#include <quadrille/internal/core/memory/packing.h>
#include <quadrille/quadric_form.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <utility>
#include <vector>

namespace quadrille::internal {

/// Numbers the vertices and faces of a large surface along a Z-order curve, if neighbours lie far
/// apart in memory: costs look at the two ends of a pair, and most of their time would be spent
/// waiting. A small or well-ordered surface keeps its numbers.
class SpatialOrder {
public:
  /// Renumbers the surface if that is worth it.
  template <std::size_t N>
  static void apply(SurfaceInput<N>& surface, const Box<N>& box, Threads threads) {
    if (surface.positions.size() < least_vertices || is_coherent(surface.triangles))
      return;
    const Array<Index>& order = surface.input_vertices =
        sorted(keyed_vertices(surface.positions, box, threads));
    renumber(surface.triangles, places(order, order.size()), threads);
    sort_faces(surface, threads);
    permute(surface.positions, order, threads);
    if (!surface.tolerances.empty())
      permute(surface.tolerances, order, threads);
    for (auto* of_vertices : {&surface.is_fixed, &surface.is_shared})
      if (!of_vertices->empty())
        permute(*of_vertices, order, Threads()); // of bits, which threads can't write side by side
    if (!surface.importances.empty())
      permute(surface.importances, order, threads);
  }

private:
  using Triangle = TriangleComplex::Triangle;

  struct KeyedVertex {
    std::uint32_t key; // 30 bits
    Index vertex;
  };

  static constexpr std::size_t least_vertices = 1 << 12; // what fits into a cache needs no order

  // Is the distance of the numbers along an edge that of a good order, a few √n, for most edges?
  static bool is_coherent(const Array<Triangle>& triangles) {
    constexpr std::size_t samples = 1024;
    constexpr std::int64_t near = 1024;
    const std::size_t step = (std::max<std::size_t>)(1, triangles.size() / samples);
    std::size_t far = 0, seen = 0;
    for (std::size_t f = 0; f < triangles.size(); f += step, ++seen)
      far += std::abs(std::int64_t{triangles[f][0]} - std::int64_t{triangles[f][1]}) > near;
    return 4 * far < seen;
  }

  template <std::size_t N>
  static Array<KeyedVertex> keyed_vertices(const Array<Vector<N>>& positions, const Box<N>& box,
                                           Threads threads) {
    double extent = 0;
    for (std::size_t i = 0; i < 3; ++i)
      extent = (std::max)(extent, box.half_extent(i));
    Array<KeyedVertex> vertices(positions.size(), positions.get_allocator());
    for_each_range(threads, positions.size(), [&](const auto& range, std::size_t) {
      for (Index v = range.begin; v < range.end; ++v) {
        std::uint32_t key = 0;
        for (std::size_t i = 0; i < 3; ++i) {
          const double half = 0.5 * positions[v][i] - 0.5 * box.low[i];
          const double cell = extent > 0 ? std::clamp(half / extent, 0.0, 1.0) * 1023 : 0;
          key |= spread(static_cast<std::uint32_t>(cell)) << i;
        }
        vertices[v] = {key, v};
      }
    });
    return vertices;
  }

  // Ten bits, each followed by two zeros.
  static std::uint32_t spread(std::uint32_t x) {
    x = (x | x << 16) & 0x030000FF;
    x = (x | x << 8) & 0x0300F00F;
    x = (x | x << 4) & 0x030C30C3;
    return (x | x << 2) & 0x09249249;
  }

  // A radix sort, which keeps ties in order.
  static Array<Index> sorted(Array<KeyedVertex> vertices) {
    Array<KeyedVertex> next(vertices.size(), vertices.get_allocator());
    for (int shift = 0; shift < 30; shift += 10) {
      sort_by_digit<10>(vertices.data(), vertices.size(), next.data(),
                        [shift](const KeyedVertex& v) { return (v.key >> shift) & 1023; });
      vertices.swap(next);
    }
    Array<Index> order(vertices.size(), vertices.get_allocator());
    for (std::size_t i = 0; i < order.size(); ++i)
      order[i] = vertices[i].vertex;
    return order;
  }

  static void renumber(Array<Triangle>& triangles, const Array<Index>& rank, Threads threads) {
    for_each_range(threads, triangles.size(), [&](const auto& range, std::size_t) {
      for (Index face = range.begin; face < range.end; ++face)
        for (Index& v : triangles[face])
          v = rank[v];
    });
  }

  struct PlacedFace {
    Triangle corners;
    Index input;

    PlacedFace() {} // a new one is not written to before it is used
    PlacedFace(const Triangle& c, Index o) : corners(c), input(o) {}
  };

  // Sorts by their lowest vertices: first into ranges that fit into a cache, then inside each.
  template <std::size_t N>
  static void sort_faces(SurfaceInput<N>& surface, Threads threads) {
    constexpr unsigned bucket_bits = 12;
    const auto lowest = [](const Triangle& t) { return (std::min)({t[0], t[1], t[2]}); };
    Array<Triangle>& triangles = surface.triangles;
    const std::size_t buckets = (surface.positions.size() >> bucket_bits) + 1;
    std::vector<Index> begin(buckets + 1);
    for (const Triangle& triangle : triangles)
      ++begin[(lowest(triangle) >> bucket_bits) + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<Index> end = begin;
    UninitializedArray<PlacedFace> faces(triangles.size(), triangles.get_allocator());
    for (Index face = 0; face < triangles.size(); ++face)
      faces[end[lowest(triangles[face]) >> bucket_bits]++] = {triangles[face], face};

    surface.input_faces.resize(triangles.size());
    std::vector<std::vector<PlacedFace>> sorted(unsigned{threads});
    parallel_for(threads, buckets, [&](std::size_t bucket, std::size_t worker) {
      const std::size_t first = begin[bucket], count = begin[bucket + 1] - first;
      sorted[worker].resize((std::max)(count, sorted[worker].size()));
      sort_by_digit<bucket_bits>(
          faces.data() + first, count, sorted[worker].data(),
          [&](const PlacedFace& face) { return lowest(face.corners) % (Index{1} << bucket_bits); });
      for (std::size_t i = 0; i < count; ++i) {
        triangles[first + i] = sorted[worker][i].corners;
        surface.input_faces[first + i] = sorted[worker][i].input;
      }
    });
  }

  template <class Values>
  static void permute(Values& values, const Array<Index>& order, Threads threads) {
    Values permuted(values.size(), values.get_allocator());
    for_each_range(threads, values.size(), [&](const auto& range, std::size_t) {
      for (Index i = range.begin; i < range.end; ++i)
        permuted[i] = values[order[i]];
    });
    values = std::move(permuted);
  }
};

} // namespace quadrille::internal

#endif // QUADRILLE_INTERNAL_CORE_INPUT_SPATIAL_ORDER_H
